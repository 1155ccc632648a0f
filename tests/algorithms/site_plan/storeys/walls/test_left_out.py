"""Surfaces in rooms that are not walls, and why."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.storeys.walls.left_out import (
    CLOSE,
    HANGS,
    LOW,
    SHORT,
    SPARSE,
    find_left_out,
)
from ichnograph.tests.algorithms.site_plan.storeys.drawn import Face, along
from shapely.geometry import box

ROOM = box(0, 0, 6, 4)
FACES = np.array([[0, 4, 6, 4], [6, 4, 6, 0], [6, 0, 0, 0], [0, 0, 0, 4]], float)
"""The faces of the room, the solid to their left."""


def left_out(*faces, walls=()):
    return find_left_out([face.sheet for face in faces], ROOM, walls, FACES, along(*faces))


@pytest.mark.parametrize(
    ("face", "reason"),
    [
        (Face((2, 2), (4, 2), 20, 26), HANGS),
        (Face((2, 2), (4, 2), 0, 12), LOW),
        (Face((2, 0.5), (4, 0.5), 0, 26), CLOSE),
        (Face((2, 2), (4, 2), 15, 22), HANGS),
        (Face((2, 2), (2.9, 2), 0, 21), SHORT),
    ],
    ids=["a beam", "a desk", "a bookcase", "a hanging cupboard", "a door leaf"],
)
def test_the_reason_is_that_of_what_was_seen(face, reason):
    (found,) = left_out(face)
    assert found.reason == reason
    assert found.area == pytest.approx(found.line.length * (face.high - face.low) / 10, rel=0.02)


def test_what_fills_less_than_half_of_the_height_is_sparse():
    low, high = Face((2, 2), (4, 2), 0, 4), Face((2, 2), (4, 2), 19, 22)
    held = [low.sheet], along(low, high)
    uprights = held[1]
    uprights.levels[:] = low.bits | high.bits
    (found,) = find_left_out(held[0], ROOM, (), FACES, uprights)
    assert found.reason == SPARSE


def test_a_wall_that_stands_in_a_room_is_not_left_out():
    face = Face((2, 2), (4, 2))
    assert left_out(face, walls=[box(2, 1.98, 4, 2.02)]) == []


def test_faces_of_rooms_and_scraps_are_not_listed():
    assert left_out(Face((0, 0), (6, 0)), Face((2, 2), (2.2, 2))) == []


def test_reasons_fit_the_field_of_the_layer():
    assert max(map(len, (CLOSE, HANGS, LOW, SHORT, SPARSE))) <= 80
