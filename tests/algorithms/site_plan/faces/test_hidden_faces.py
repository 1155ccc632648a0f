"""Of a face that was seen from one side, the hidden back lies behind the front."""

import numpy as np
import pytest
from affine import Affine
from ichnograph.algorithms.geometry.curves import Line
from ichnograph.algorithms.site_plan.faces.face import Face
from ichnograph.algorithms.site_plan.faces.hidden_faces import move_hidden_faces
from ichnograph.algorithms.site_plan.faces.ring_faces import RingFaces

EAST = np.array([1.0, 0.0])
TRANSFORM = Affine(0.1, 0, 0, 0, -0.1, 6)
"""Of an image of 6 x 6 m."""


def face(north, direction, rms=0.004):
    """Return a face of 4 m at y = north; the wall is to the left of its direction."""
    curve = Line(np.array([3.0, north]), direction)
    ridge = curve.at(np.arange(-2, 2.01, 0.05))
    return Face(curve, np.arange(len(ridge)), ridge, -2.0, 2.0, rms)


def held(south=True, north=True):
    """Return the pixels that hold points, south and north of y = 3."""
    image = np.zeros((60, 60), bool)
    image[30:], image[:30] = south, north
    return image


def moved(faces, image):
    (ring,) = move_hidden_faces([RingFaces(None, 0.05, tuple(faces))], image, TRANSFORM)
    return ring.faces


@pytest.mark.parametrize("from_south", [True, False])
def test_the_back_is_on_the_side_without_points(from_south):
    # Left of east is north: the face that runs east is seen from the south.
    both = face(3.0, EAST), face(3.0, -EAST)
    south, north = moved(both, held(from_south, not from_south))
    assert (south.hidden, north.hidden) == (not from_south, from_south)


def test_the_back_lies_behind_the_front_by_twice_the_scatter():
    front, back = moved((face(3.0, EAST, 0.02), face(3.0, -EAST)), held(north=False))
    assert back.curve.point[1] - front.curve.point[1] == pytest.approx(0.04)
    assert back.length == pytest.approx(4.0)


def test_the_two_faces_of_a_wall_are_both_seen():
    faces = face(2.9, EAST), face(3.1, -EAST)
    assert moved(faces, held()) == faces


def test_faces_that_run_the_same_way_do_not_hide_each_other():
    assert not any(one.hidden for one in moved((face(3.0, EAST), face(3.01, EAST)), held(north=False)))


def test_a_front_is_not_moved_behind_the_next_face_of_a_bent_wall():
    back, front = face(3.0, EAST), face(3.0, -EAST)
    # The wall continues, bent by 6 degrees, and shares the last ridge points of the front.
    bend = np.array([np.cos(0.1), np.sin(0.1)])
    curve = Line(np.array([4.9, 3.0]), bend)
    ridge = curve.at(np.arange(0, 1.01, 0.05))
    following = Face(curve, np.arange(len(ridge)), ridge, 0.0, 1.0, 0.004)
    back, following, front = moved((back, following, front), held(south=False))
    assert (back.hidden, front.hidden) == (True, False)
    assert front.curve.point[1] == pytest.approx(3.0)
