"""What of a storey is room, and what is solid."""

import pytest
from ichnograph.algorithms.site_plan.storeys.settings import CutSettings
from ichnograph.tests.algorithms.site_plan.storeys.drawn import Face, divided, footprint_of, sides
from shapely.geometry import LineString, box
from shapely.ops import unary_union

CUT = CutSettings()


def room_of(faces, *spaces):
    return divided(faces, footprint_of(*spaces)).rooms


def lines_of(ends):
    return unary_union([LineString(end.reshape(2, 2)) for end in ends])


def test_what_was_seen_between_faces_is_room_and_all_else_solid():
    division = divided(sides(0, 0, 4, 3), footprint_of((0, 0, 4, 3)))
    assert division.rooms.symmetric_difference(box(0, 0, 4, 3)).area < 1e-6
    assert division.solid.area == pytest.approx(144 - 12)


def test_the_room_ends_at_the_face_and_not_where_the_floor_was_seen_to():
    # Furniture hides a strip of the floor along one wall, and another lets through a strip beyond it.
    assert room_of(sides(0, 0, 4, 3), (0, 0.08, 4.08, 3)).symmetric_difference(box(0, 0, 4, 3)).area < 1e-6


def test_a_thin_partition_is_solid():
    faces = [*sides(0, 0, 4, 3), *sides(4.08, 0, 8, 3)]
    found = room_of(faces, (0, 0, 4, 3), (4.08, 0, 8, 3))
    assert not found.intersects(box(4.01, 0.01, 4.07, 2.99))


def test_a_core_that_was_not_scanned_is_solid():
    faces = [*sides(0, 0, 8, 6), *sides(3, 2, 5, 4)]
    around = [(0, 0, 3, 6), (3, 0, 5, 2), (3, 4, 5, 6), (5, 0, 8, 6)]
    assert (
        room_of(faces, *around).symmetric_difference(box(0, 0, 8, 6).difference(box(3, 2, 5, 4))).area < 0.01
    )


@pytest.mark.parametrize("high, filled", [(26, False), (12, True)], ids=["a column", "a table"])
def test_what_stands_free_is_solid_if_it_rises_above_the_heads_of_people(high, filled):
    faces = [*sides(0, 0, 4, 3), *sides(1.7, 1.2, 2.3, 1.8, 0, high)]
    around = [(0, 0, 1.7, 3), (1.7, 0, 2.3, 1.2), (1.7, 1.8, 2.3, 3), (2.3, 0, 4, 3)]
    assert room_of(faces, *around).contains(box(1.9, 1.4, 2.1, 1.6)) == filled


def test_faces_have_the_solid_to_their_left():
    ends, number = divided(sides(0, 0, 4, 3), footprint_of((0, 0, 4, 3))).faces(CUT)
    middle = ends.reshape(-1, 2, 2).mean(axis=1)
    way = ends[:, 2:] - ends[:, :2]
    outward = middle - (2, 1.5)
    assert (way[:, 0] * outward[:, 1] - way[:, 1] * outward[:, 0] > 0).all()
    assert lines_of(ends).length == pytest.approx(14)
    assert len(set(number.tolist())) == len(ends)


def test_where_the_scan_ends_there_is_a_border_and_no_face():
    division = divided(sides(0, 0, 4, 3)[:1] + sides(0, 0, 4, 3)[2:], footprint_of((0, 0, 4, 3)))
    ends, _ = division.faces(CUT)
    assert lines_of(ends).length == pytest.approx(11, abs=0.05)
    borders = lines_of(division.arrangement.ends[division.are_borders()])
    assert borders.length == pytest.approx(14, abs=0.1)


@pytest.mark.parametrize(
    "low, high, expected",
    [(0, 26, True), (0, 10, False), (20, 26, False), (0, 14, True)],
    ids=["a wall", "a balustrade", "a beam", "a wall whose top is hidden"],
)
def test_a_face_stands_on_both_sides_of_the_cut(low, high, expected):
    faces = [*sides(0, 0, 4, 3)[:1], *sides(0, 0, 4, 3)[2:], Face((4, 0), (4, 3), low, high)]
    ends, _ = divided(faces, footprint_of((0, 0, 4, 3))).faces(CUT)
    # Lines end a little off: the other faces reach around the corners.
    assert (lines_of(ends).intersection(box(3.9, 0.2, 4.1, 2.8)).length > 2) == expected


def test_where_nothing_was_seen_all_is_solid():
    division = divided(sides(0, 0, 4, 3), footprint_of())
    assert division.rooms.is_empty
    assert division.faces(CUT)[0].shape == (0, 4)
