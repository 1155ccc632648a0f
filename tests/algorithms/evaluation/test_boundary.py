"""Boundaries in pieces, and their distances from each other."""

import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.evaluation.boundary import Boundary, Pieces, cut_boundary, measure_boundary
from ichnograph.algorithms.evaluation.settings import ComparisonSettings
from shapely.geometry import LineString, MultiPolygon, Polygon, box
from shapely.geometry.polygon import orient

SETTINGS = ComparisonSettings()
EDGE = Pieces(np.array([[0.0, 0.0]]), np.array([[2.0, 0.0]]), np.array([0]))


def lengths(pieces):
    return np.hypot(*(pieces.ends - pieces.starts).T)


def test_pieces_are_a_step_long_at_most_and_make_up_the_boundary():
    pieces = cut_boundary(box(0, 0, 1, 0.07), 0.02)

    assert lengths(pieces).max() <= 0.02 + 1e-12
    assert lengths(pieces).sum() == pytest.approx(2.14)
    np.testing.assert_allclose(pieces.ends, np.roll(pieces.starts, -1, axis=0), atol=1e-12)


def test_corners_stay_corners():
    pieces = cut_boundary(box(0, 0, 1, 0.07), 0.02)

    for corner in ((0, 0), (1, 0), (1, 0.07), (0, 0.07)):
        assert np.linalg.norm(pieces.starts - corner, axis=1).min() < 1e-12


@pytest.mark.parametrize("clockwise", [1, -1])
def test_polygons_are_on_the_left_of_their_pieces(clockwise):
    ring = orient(box(0, 0, 4, 4).difference(box(1, 1, 3, 3)), clockwise)
    starts, ends, line = cut_boundary(ring, 0.5)
    along = ends - starts
    left = (starts + ends) / 2 + 0.1 * np.column_stack([-along[:, 1], along[:, 0]])

    inside = (np.abs(left - 2) < 2).all(axis=1) & ~(np.abs(left - 2) < 1).all(axis=1)
    assert inside.all()
    assert set(line) == {0, 1}


def test_lines_are_cut_as_they_run_and_nothing_has_no_pieces():
    pieces = cut_boundary(LineString([(0, 0), (0, 1)]), 0.5)

    np.testing.assert_allclose(pieces.starts, [[0, 0], [0, 0.5]])
    assert len(cut_boundary(Polygon(), 0.5).starts) == 0


def test_the_distance_is_that_of_the_middle_from_the_nearest_piece():
    given = cut_boundary(MultiPolygon([box(0, 0, 2, 1), box(0, 5, 2, 6)]), 0.02)
    asked = Pieces(np.array([[0.5, 3.9], [3.0, -1.1]]), np.array([[0.5, 4.1], [3.0, -0.9]]), np.array([0, 1]))

    np.testing.assert_allclose(measure_boundary(asked, given, SETTINGS).offsets, [1.0, 2**0.5])


def test_distances_from_nothing_are_infinite():
    nothing = cut_boundary(Polygon(), 0.02)

    assert measure_boundary(EDGE, nothing, SETTINGS).offsets.tolist() == [np.inf]
    assert len(measure_boundary(nothing, EDGE, SETTINGS).offsets) == 0


def test_shares_and_quantiles_are_weighted_by_length():
    starts = np.array([[0.0, 0.0], [1.0, 0.0], [4.0, 0.0]])
    ends = np.array([[1.0, 0.0], [4.0, 0.0], [5.0, 0.0]])
    boundary = Boundary(Pieces(starts, ends, np.zeros(3, int)), np.array([0.01, 0.02, 0.5]))

    assert boundary.share_within(0.02) == pytest.approx(4 / 5)
    assert boundary.quantile(0.2, 0.1) == 0.01
    assert boundary.quantile(0.5, 0.1) == 0.02
    assert np.isnan(boundary.quantile(0.5, 0.001))
    assert boundary.share_within(0.001) == 0


def test_outlines_of_a_country_are_refused():
    with pytest.raises(InputError, match="are 4000 km long, more than 100 km"):
        cut_boundary(box(0, 0, 1e6, 1e6), 0.02)
