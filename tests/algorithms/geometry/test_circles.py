"""Circles are fitted to points."""

import numpy as np
import pytest
from ichnograph.algorithms.geometry.circles import arc_through, fit_circle_on_axis


def row(start, stop, radius=2.0, centre=(412_300.0, 5_812_700.0), count=30):
    """Return points of a circle from one angle to another, degrees."""
    angle = np.radians(np.linspace(start, stop, count))
    return radius * np.column_stack([np.cos(angle), np.sin(angle)]) + centre


@pytest.mark.parametrize("stop", [40, 200, 350])
def test_a_circle_is_fitted_at_grid_coordinates(stop):
    arc = arc_through(row(0, stop))
    assert arc.centre == pytest.approx([412_300.0, 5_812_700.0], abs=1e-6)
    assert arc.radius == pytest.approx(2.0, abs=1e-6)


def test_points_on_a_line_have_no_circle():
    assert arc_through(np.column_stack([np.arange(5.0), 2 * np.arange(5.0)])) is None


@pytest.mark.parametrize(("start", "stop", "sense"), [(170, 250, 1), (250, 170, -1)])
def test_an_arc_runs_as_its_row_does_with_its_zero_in_the_middle(start, stop, sense):
    points = row(start, stop)
    arc = arc_through(points)
    assert arc.sense == sense
    assert arc.station(points[[0, -1]]) == pytest.approx([-1.4, 1.4], abs=0.06)
    assert np.all(np.diff(arc.station(points)) > 0)


def test_a_circle_about_an_axis_is_not_moved_by_a_gross_error():
    points = row(10, 170, centre=(1.0, 3.0))
    points[7] += (0.0, 0.5)
    centre, radius = fit_circle_on_axis(points, 1.0, np.array([2.5, 1.5]), 0.002)
    assert (centre, radius) == pytest.approx((3.0, 2.0), abs=0.002)
