"""Lines and arcs have stations along them, and a left side."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from ichnograph.algorithms.geometry.curves import Arc, Line, crossing, line_through

CHORD = 0.002
EAST = Line(np.zeros(2), np.array([1.0, 0.0]))
COLUMN = Arc(np.array([5.0, 7.0]), 2.0, -1, 0.4)


def test_offsets_and_moves_are_positive_to_the_left():
    east = Line(np.zeros(2), np.array([1.0, 0.0]))
    column = Arc(np.zeros(2), 1.0, 1, 0.0)
    assert east.offset(np.array([[3.0, 0.2]]))[0] == pytest.approx(0.2)
    assert column.offset(np.array([[0.8, 0.0]]))[0] == pytest.approx(0.2)
    assert east.moved(0.1).offset(np.array([[0.0, 0.1]]))[0] == pytest.approx(0.0)
    assert column.moved(0.1).radius == pytest.approx(0.9)


@pytest.mark.parametrize("radius", [0.2, 3.0])
def test_the_chords_of_an_arc_are_near_it(radius):
    arc = Arc(np.zeros(2), radius, 1, 0.0)
    run = arc.run(-radius, radius, CHORD)
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


@pytest.mark.parametrize("curve", [EAST, COLUMN, COLUMN.reversed()])
def test_stations_lead_to_points_and_back(curve):
    stations = np.linspace(-5.0, 5.0, 11)
    points = curve.at(stations)
    np.testing.assert_allclose(curve.station(points), stations, atol=1e-12)
    np.testing.assert_allclose(curve.offset(points), 0.0, atol=1e-12)
    np.testing.assert_allclose(curve.ends(points), [-5.0, 5.0], atol=1e-12)


@pytest.mark.parametrize("curve", [EAST, COLUMN, COLUMN.reversed()])
def test_the_heading_is_the_way_of_the_stations_and_the_normal_is_to_its_left(curve):
    point, ahead = curve.at(np.array([1.0, 1.0 + 1e-6]))
    np.testing.assert_allclose(curve.heading(point), (ahead - point) / 1e-6, atol=1e-5)
    assert curve.offset(point + 0.1 * curve.normal(point)) == pytest.approx(0.1)
    assert curve.tangent(point).direction == pytest.approx(curve.heading(point))


@given(st.floats(-9, 9), st.floats(-9, 9))
def test_the_foot_is_the_nearest_point(x, y):
    point = np.array([x, y])
    for curve in (EAST, COLUMN):
        nearest = np.linalg.norm(curve.foot(point) - point)
        assert nearest == pytest.approx(curve.distances(point[None])[0], abs=1e-9)
        assert nearest <= np.linalg.norm(curve.at(np.linspace(-9, 9, 50)) - point, axis=1).min() + 1e-9


def test_a_curve_between_points_runs_from_foot_to_foot():
    row = COLUMN.at(np.array([-1.0, 0.3, 2.0])) + 0.01
    drawn = COLUMN.between(row, CHORD)
    assert drawn[[0, -1]] == pytest.approx(np.array([COLUMN.foot(row[0]), COLUMN.foot(row[-1])]))
    assert len(EAST.between(np.array([[0.0, 1.0], [3.0, 1.0]]), CHORD)) == 2


def test_the_line_through_a_row_runs_as_the_row_does():
    row = np.array([[3.0, 1.01], [2.0, 0.99], [1.0, 0.99], [0.0, 1.01]])
    line = line_through(row)
    assert line.direction == pytest.approx([-1, 0], abs=1e-9)
    assert line.point == pytest.approx([1.5, 1.0])
