"""Azimuths are counted clockwise from grid north."""

import numpy as np
import pytest
from ichnograph.algorithms.geometry.azimuths import line_azimuth, mean_line_azimuth


@pytest.mark.parametrize(
    ("direction", "azimuth"),
    [((0, 1), 0), ((1, 1), 45), ((1, 0), 90), ((-1, 0), 90), ((1, -1), 135), ((-1, 1), 135)],
)
def test_a_line_has_one_azimuth_whichever_way_it_runs(direction, azimuth):
    assert line_azimuth(np.array(direction, float)) == pytest.approx(azimuth)


def test_lines_either_side_of_north_have_their_mean_at_north():
    angles = np.radians([2.0, 178.0])
    directions = list(np.column_stack([np.sin(angles), np.cos(angles)]))
    assert np.sin(np.radians(mean_line_azimuth(directions, [1.0, 1.0]))) == pytest.approx(0.0, abs=1e-12)


def test_heavier_lines_draw_the_mean_to_them():
    directions = [np.array([1.0, 0.0]), np.array([np.sin(1.4), np.cos(1.4)])]
    assert mean_line_azimuth(directions, [1.0, 0.0]) == pytest.approx(90.0)
    assert mean_line_azimuth(directions, [0.0, 1.0]) == pytest.approx(np.degrees(1.4))
