"""Faces that bound no room."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.storeys.walls.free_faces import clear_before, free_faces, screens
from ichnograph.tests.algorithms.site_plan.storeys.drawn import Face, along, footprint_of, sides
from shapely.geometry import Polygon, box

ROOM = box(0, 0, 4, 3)
INNER = np.array([[0, 3, 4, 3], [4, 3, 4, 0], [4, 0, 0, 0], [0, 0, 0, 3]], float)
"""The faces of the room, the solid to their left."""

NONE = np.zeros((0, 4))


def free(*faces, rooms=ROOM, bounding=INNER, footprint=footprint_of((0, 0, 4, 3))):
    sheets = [face.sheet for face in faces]
    return free_faces(sheets, rooms, bounding, along(*faces), footprint)


def test_a_facade_is_a_free_face_whose_solid_lies_towards_the_room():
    (found,) = free(Face((0, 3.3), (4, 3.3)))
    assert np.sort(found[[0, 2]]) == pytest.approx([0, 4], abs=0.06)
    # The solid lies to the left of a face: below this one if it runs west.
    assert found[2] < found[0]


def test_the_faces_of_rooms_are_not_free():
    assert len(free(*sides(0, 0, 4, 3))) == 0


def test_a_facade_farther_than_a_wall_is_thick_turns_to_where_more_was_seen():
    garden = footprint_of((0, 0, 4, 3), (-1, 6.2, 6, 9))
    (found,) = free(Face((0, 6), (4, 6)), footprint=garden)
    assert found[2] < found[0]


@pytest.mark.parametrize("low, high", [(0, 8), (18, 26)], ids=["a fence of 80 cm", "the edge of a canopy"])
def test_what_fills_few_levels_is_no_wall(low, high):
    assert len(free(Face((0, 5), (4, 5), low, high))) == 0


def test_a_gap_parts_a_face_in_two_and_short_ends_are_dropped():
    found = free(Face((0, 5), (2, 5)), Face((3, 5), (4, 5)), Face((5, 5), (5.2, 5)))
    assert sorted(abs(x1 - x0) for x0, _, x1, _ in found) == pytest.approx([1, 2], abs=0.1)


def test_a_sheet_is_free_only_beyond_the_room():
    found = free(Face((0, 3), (7, 3)))
    assert [np.sort(face[[0, 2]]).tolist() for face in found] == [pytest.approx([4.12, 7], abs=0.06)]


def screen(*faces, bounding=INNER):
    return screens([face.sheet for face in faces], ROOM, bounding, along(*faces))


def test_a_thin_wall_that_stands_free_in_a_room_is_a_screen():
    (found,) = screen(Face((1.2, 1.5), (2.8, 1.5)))
    assert np.sort(found[[0, 2]]) == pytest.approx([1.2, 2.8], abs=0.06)


@pytest.mark.parametrize(
    "face",
    [
        Face((1.5, 1.5), (2.4, 1.5)),
        Face((1.2, 0.5), (2.8, 0.5)),
        Face((1.2, 1.5), (2.8, 1.5), 0, 18),
    ],
    ids=["a door leaf", "a curtain before a wall", "a bookcase across the room"],
)
def test_what_is_short_near_a_wall_or_low_is_no_screen(face):
    assert len(screen(face)) == 0


def test_the_railing_of_a_stair_rises_above_heads_at_its_upper_end_only():
    lower, upper = Face((1.2, 1.5), (2.0, 1.5), 3, 16), Face((2.0, 1.5), (2.8, 1.5), 10, 26)
    sheet = Face((1.2, 1.5), (2.8, 1.5)).sheet
    assert len(screens([sheet], ROOM, INNER, along(lower, upper))) == 0


def test_without_walls_around_it_a_screen_is_a_screen():
    assert len(screen(Face((1.2, 0.5), (2.8, 0.5)), bounding=NONE)) == 1


def test_right_before_a_face_it_is_clear():
    found = clear_before(np.array([[0.0, 0.0, 2.0, 0.0]]), 0.3)
    assert found.symmetric_difference(box(0, -0.3, 2, 0)).area < 1e-9


def test_nothing_gives_nothing():
    assert free().shape == (0, 4)
    assert free(rooms=Polygon(), bounding=NONE).shape == (0, 4)
    assert screen().shape == (0, 4)
    assert clear_before(NONE, 0.3).is_empty
