"""Faces are fitted to voxels; strangers do no harm."""

import numpy as np
import pytest
from ichnograph.algorithms.geometry.circles import arc_through
from ichnograph.algorithms.geometry.curves import CHORD, Arc, Line, line_through
from ichnograph.algorithms.site_plan.faces.face_fit import crossing, fit_face


def straight(count=500, seed=0):
    random = np.random.default_rng(seed)
    return np.column_stack([random.uniform(0, 4, count), random.normal(0, 0.003, count)])


def test_strangers_do_not_move_a_line():
    random = np.random.default_rng(1)
    strangers = np.column_stack([random.uniform(1, 2, 200), random.uniform(0.02, 0.05, 200)])
    xy = np.concatenate([straight(), strangers])
    guess = Line(np.array([0.0, 0.01]), np.array([1.0, 0.003]) / np.hypot(1, 0.003))
    fit = fit_face(guess, xy, np.ones(len(xy)))
    assert np.abs(fit.curve.offset(np.array([[0.0, 0.0], [4.0, 0.0]]))).max() < 0.001


def test_the_rms_is_that_of_the_points_of_the_face():
    fit = fit_face(line_through(np.array([[0.0, 0.0], [4.0, 0.0]])), straight(), np.ones(500))
    assert fit.rms == pytest.approx(0.003, rel=0.1)


def test_a_voxel_counts_by_its_area():
    xy = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 0.004], [1.0, 0.004]])
    fit = fit_face(line_through(xy[:2]), xy, np.array([1.0, 1.0, 3.0, 3.0]))
    assert fit.curve.offset(np.array([[0.5, 0.0]]))[0] == pytest.approx(-0.003, abs=0.0005)


def test_nothing_is_fitted_where_no_voxel_is_near():
    line = line_through(np.array([[0.0, 0.0], [1.0, 0.0]]))
    assert fit_face(line, np.array([[0.5, 0.3], [0.6, 0.4]]), np.ones(2)) is None


@pytest.mark.parametrize("turn", [1, -1])
def test_a_circle_is_found_from_part_of_it(turn):
    angle = np.radians(turn * np.linspace(0, 90, 400))
    row = 2.0 * np.column_stack([np.cos(angle), np.sin(angle)]) + (5.0, 7.0)
    xy = row + np.random.default_rng(0).normal(0, 0.003, row.shape)
    fit = fit_face(arc_through(xy[::20]), xy, np.ones(len(xy)))
    assert fit.curve.centre == pytest.approx((5, 7), abs=0.005)
    assert fit.curve.radius == pytest.approx(2.0, abs=0.005)
    assert fit.curve.sense == turn
    assert fit.curve.ends(xy) == pytest.approx(fit.curve.station(xy[[0, -1]]))


def test_left_is_towards_the_core():
    east = Line(np.zeros(2), np.array([1.0, 0.0]))
    column = Arc(np.zeros(2), 1.0, 1, 0.0)
    assert east.offset(np.array([[3.0, 0.2]]))[0] == pytest.approx(0.2)
    assert column.offset(np.array([[0.8, 0.0]]))[0] == pytest.approx(0.2)
    assert east.moved(0.1).offset(np.array([[0.0, 0.1]]))[0] == pytest.approx(0.0)
    assert column.moved(0.1).radius == pytest.approx(0.9)


@pytest.mark.parametrize("radius", [0.2, 3.0])
def test_the_chords_of_an_arc_are_near_it(radius):
    arc = Arc(np.zeros(2), radius, 1, 0.0)
    run = arc.run(-radius, radius)
    middles = (run[1:] + run[:-1]) / 2
    assert np.abs(arc.offset(run)).max() < 1e-9
    assert 0 < arc.offset(middles).max() <= CHORD


def test_a_line_and_an_arc_cross_at_the_nearer_of_two_points():
    line, arc = Line(np.zeros(2), np.array([1.0, 0.0])), Arc(np.zeros(2), 2.0, 1, 0.0)
    assert crossing(line, arc, np.array([1.8, 0.1])) == pytest.approx((2, 0))
    assert crossing(line, arc, np.array([-1.8, 0.1])) == pytest.approx((-2, 0))


def test_parallel_lines_do_not_cross():
    line = Line(np.zeros(2), np.array([1.0, 0.0]))
    assert crossing(line, line.moved(0.1), np.zeros(2)) is None
