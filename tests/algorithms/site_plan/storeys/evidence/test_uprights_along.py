"""How much upright surface stands along a line."""

import numpy as np
import pytest
from ichnograph.tests.algorithms.site_plan.storeys.drawn import Face, along


def lines(*ends):
    return np.array(ends, float)


def test_a_line_on_a_wall_has_all_its_levels():
    found = along(Face((0, 0), (4, 0), 0, 26)).mean_levels(lines((0, 0, 4, 0), (1, 0, 2, 0)))
    assert found == pytest.approx([26, 26])


def test_where_half_of_a_line_is_bare_the_mean_is_half():
    found = along(Face((0, 0), (2, 0), 0, 20)).mean_levels(lines((0, 0, 4, 0)))
    assert found == pytest.approx([10], abs=0.5)


def test_only_the_levels_of_a_mask_count():
    faces = along(Face((0, 0), (4, 0), 3, 23))
    assert faces.mean_levels(lines((0, 0, 4, 0)), (1 << 10) - 1) == pytest.approx([7])
    assert faces.mean_levels(lines((0, 0, 4, 0)), -1 << 19) == pytest.approx([4])


def test_surface_beside_a_line_belongs_to_it_only_if_it_is_near():
    faces = along(Face((0, 0), (4, 0)))
    assert faces.mean_levels(lines((0, 0.03, 4, 0.03))) == pytest.approx([26])
    assert faces.mean_levels(lines((0, 0.06, 4, 0.06))) == pytest.approx([0])


def test_surface_across_a_line_does_not_count():
    faces = along(Face((2, -1), (2, 1)))
    assert faces.mean_levels(lines((0, 0, 4, 0))) == pytest.approx([0])


def test_surface_around_the_corner_is_seen_from_the_end_of_a_line():
    faces = along(Face((0, 0), (4, 0)))
    near, far = faces.mean_levels(lines((4.01, 0, 4.06, 0), (4.3, 0, 4.5, 0)))
    assert (near, far) == (26, 0)


def test_every_line_has_a_station():
    bits, line = along(Face((0, 0), (4, 0))).stations(lines((1, 0, 1.001, 0), (0, 0, 4, 0), (1, 0, 1, 0)))
    assert np.bincount(line).tolist() == [1, 80, 1]
    assert len(bits) == 82


def test_outside_of_the_frame_there_is_nothing():
    assert along(Face((0, 0), (4, 0))).mean_levels(lines((-9, 0, -5, 0), (50, 50, 60, 50))) == pytest.approx(
        [0, 0]
    )


def test_no_lines_and_no_surface_are_no_error():
    assert along(Face((0, 0), (4, 0))).mean_levels(np.zeros((0, 4))).tolist() == []
    assert along().mean_levels(lines((0, 0, 4, 0))).tolist() == [0]
