"""Curves are fitted to voxels; clutter does not move them."""

import numpy as np
import pytest
from ichnograph.algorithms.geometry.circles import arc_through
from ichnograph.algorithms.geometry.curves import Line, line_through
from ichnograph.algorithms.site_plan.faces.face_fit import fit_curve


def straight(count=500, seed=0):
    random = np.random.default_rng(seed)
    return np.column_stack([random.uniform(0, 4, count), random.normal(0, 0.003, count)])


def test_clutter_does_not_move_a_line():
    random = np.random.default_rng(1)
    clutter = np.column_stack([random.uniform(1, 2, 200), random.uniform(0.02, 0.05, 200)])
    xy = np.concatenate([straight(), clutter])
    guess = Line(np.array([0.0, 0.01]), np.array([1.0, 0.003]) / np.hypot(1, 0.003))
    fit = fit_curve(guess, xy, np.ones(len(xy)))
    assert np.abs(fit.curve.offset(np.array([[0.0, 0.0], [4.0, 0.0]]))).max() < 0.001


def test_the_rms_is_that_of_the_points_of_the_face():
    fit = fit_curve(line_through(np.array([[0.0, 0.0], [4.0, 0.0]])), straight(), np.ones(500))
    assert fit.rms == pytest.approx(0.003, rel=0.1)


def test_a_voxel_counts_by_its_area():
    xy = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 0.004], [1.0, 0.004]])
    fit = fit_curve(line_through(xy[:2]), xy, np.array([1.0, 1.0, 3.0, 3.0]))
    assert fit.curve.offset(np.array([[0.5, 0.0]]))[0] == pytest.approx(-0.003, abs=0.0005)


def test_nothing_is_fitted_where_no_voxel_is_near():
    line = line_through(np.array([[0.0, 0.0], [1.0, 0.0]]))
    assert fit_curve(line, np.array([[0.5, 0.3], [0.6, 0.4]]), np.ones(2)) is None


@pytest.mark.parametrize("sense", [1, -1])
def test_a_circle_is_found_from_part_of_it(sense):
    angle = np.radians(sense * np.linspace(0, 90, 400))
    row = 2.0 * np.column_stack([np.cos(angle), np.sin(angle)]) + (5.0, 7.0)
    xy = row + np.random.default_rng(0).normal(0, 0.003, row.shape)
    fit = fit_curve(arc_through(xy[::20]), xy, np.ones(len(xy)))
    assert fit.curve.centre == pytest.approx((5, 7), abs=0.005)
    assert fit.curve.radius == pytest.approx(2.0, abs=0.005)
    assert fit.curve.sense == sense
    assert fit.curve.ends(xy) == pytest.approx(fit.curve.station(xy[[0, -1]]))
