"""A row of ridge points is cut into straight and curved segments."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.faces.ridge_segments import cut_into_segments, scatter_of

SIGMA = 0.01


def row(*corners, step=0.05):
    """Return points `step` apart along corners, and their directions."""
    points, directions = [], []
    for start, stop in zip(np.array(corners[:-1], float), np.array(corners[1:], float)):
        way = np.hypot(*(stop - start))
        along = np.arange(step / 2, way, step)
        points.append(start + along[:, None] * (stop - start) / way)
        directions.append(np.tile((stop - start) / way, (len(along), 1)))
    return np.concatenate(points), np.concatenate(directions)


def arc(radius, start, stop, count):
    turn = np.radians(np.linspace(start, stop, count))
    return (
        radius * np.column_stack([np.cos(turn), np.sin(turn)]),
        np.column_stack([-np.sin(turn), np.cos(turn)]),
    )


def noisy(points, seed=0, scatter=0.004):
    return points + np.random.default_rng(seed).normal(0, scatter, points.shape)


def test_a_straight_row_is_one_piece():
    points, directions = row((0, 0), (10, 3))
    (segment,) = cut_into_segments(noisy(points), directions, SIGMA)
    assert (segment.first, segment.last, segment.curved) == (0, len(points) - 1, False)


@pytest.mark.parametrize("jamb", [0.15, 0.5])
def test_the_end_of_a_wall_is_three_pieces(jamb):
    points, directions = row((0, 0), (3, 0), (3, jamb), (0, jamb))
    segments = cut_into_segments(noisy(points), directions, SIGMA)
    assert [segment.curved for segment in segments] == [False] * 3
    assert [segment.first for segment in segments] == pytest.approx([0, 60, 60 + jamb / 0.05], abs=1)


def test_both_ways_along_one_line_are_two_pieces():
    points, directions = row((0, 0), (3, 0), (0, 0))
    segments = cut_into_segments(noisy(points), directions, SIGMA)
    assert [(segment.first, segment.last) for segment in segments] == [(0, 59), (60, 119)]


@pytest.mark.parametrize("radius", [0.2, 1.0, 4.0])
def test_a_round_row_is_one_curved_piece(radius):
    points, directions = arc(radius, 10, 250, max(int(radius * 80), 20))
    (segment,) = cut_into_segments(noisy(points), directions, SIGMA)
    assert segment.curved
    assert (segment.first, segment.last) == (0, len(points) - 1)


def test_a_point_that_fits_nowhere_is_left_out():
    points, directions = row((0, 0), (4, 0))
    points[40] += (0, 0.2)
    segments = cut_into_segments(points, directions, SIGMA)
    assert all(not segment.first <= 40 <= segment.last for segment in segments)
    assert sum(segment.last - segment.first + 1 for segment in segments) == len(points) - 1


def test_the_scatter_of_a_row_is_that_of_its_points_not_of_its_bends():
    points, _ = row((0, 0), (10, 0), (10, 10))
    assert scatter_of(noisy(points, scatter=0.02)) == pytest.approx(0.02, rel=0.25)
