"""A wall is measured by its faces."""

import numpy as np
import pytest
from ichnograph.algorithms.geometry.curves import Arc, Line
from ichnograph.algorithms.site_plan.faces.face import Face
from ichnograph.algorithms.site_plan.faces.wall_measures import measure
from shapely.geometry import Point, box

EAST = np.array([1.0, 0.0])


def straight(x, y, direction, length=4.0, rms=0.003, hidden=False):
    """Return a face with its middle at x, y."""
    curve = Line(np.array([x, y]), direction)
    ridge = curve.at(np.arange(-length / 2, length / 2 + 0.01, 0.05))
    return Face(curve, np.arange(len(ridge)), ridge, -length / 2, length / 2, rms, hidden)


def faces_of_wall(thickness=0.4, length=4.0, **north):
    return [
        straight(3, 3, EAST, length),
        straight(3, 3 + thickness, -EAST, length, **north),
    ]


def outline(thickness=0.4, length=4.0):
    return box(3 - length / 2, 3, 3 + length / 2, 3 + thickness)


def test_the_thickness_is_the_distance_of_opposite_faces():
    measures = measure(faces_of_wall(), outline())
    assert measures.thickness == pytest.approx(0.4)
    assert measures.thick_sd == pytest.approx(0.0, abs=1e-9)
    assert measures.azimuth == pytest.approx(90.0)
    assert measures.radius is None


def test_the_coverage_is_the_share_of_the_outline_with_points():
    assert measure(faces_of_wall(), outline()).coverage == pytest.approx(8 / 8.8)
    assert measure(faces_of_wall()[:1], outline()).coverage == pytest.approx(4 / 8.8)


def test_the_rms_is_that_of_both_faces():
    expected = np.sqrt((0.003**2 + 0.009**2) / 2)
    assert measure(faces_of_wall(rms=0.009), outline()).rms == pytest.approx(expected)


def test_a_hidden_face_is_not_measured():
    measures = measure(faces_of_wall(hidden=True), outline())
    assert measures.thickness is None
    assert measures.coverage == pytest.approx(4 / 8.8)


def test_without_faces_nothing_is_known():
    measures = measure([], outline())
    assert measures.coverage == 0
    assert (measures.thickness, measures.rms, measures.azimuth, measures.radius) == (None,) * 4


def test_faces_of_two_walls_give_no_thickness():
    # The space between them is a room: it is not inside the outline, nor to the left of the faces.
    walls = [straight(3, 3, -EAST), straight(3, 5, EAST)]
    assert measure(walls, outline(2.0)).thickness is None


def test_the_two_ends_of_a_wall_are_not_its_faces():
    assert measure(faces_of_wall(2.0, 1.0), outline(2.0, 1.0)).thickness is None
    assert measure(faces_of_wall(4.0, 9.0), outline(4.0, 9.0)).thickness is None


def test_a_round_wall_has_the_radius_of_its_middle():
    def arc(radius, sense):
        curve = Arc(np.array([5.0, 5.0]), radius, sense, 0.0)
        stations = np.arange(-2.0, 2.01, 0.05) * radius / 2
        return Face(curve, np.arange(len(stations)), curve.at(stations), -radius, radius, 0.003)

    ring = Point(5, 5).buffer(2.2, 64).difference(Point(5, 5).buffer(1.8, 64))
    measures = measure([arc(2.2, 1), arc(1.8, -1)], ring)
    assert measures.radius == pytest.approx(2.0)
    assert measures.thickness == pytest.approx(0.4)
    assert measures.azimuth is None
