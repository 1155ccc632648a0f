"""What a plan is compared with."""

import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.evaluation.outlines import outlines_of
from ichnograph.algorithms.evaluation.reference import (
    Reference,
    compare_drawn_rooms,
    compare_with_reference,
    drawn_reference,
)
from shapely import wkb
from shapely.geometry import LineString, MultiLineString, box

JUDGED = (box(-1, -1, 5, 11), "judged")
FACE = (LineString([(0, 0), (10, 0)]), "wall")
WALL = box(0, 0, 10, 0.02)
"""Half of the wall and its face lie in the judged region."""


def features_of(*drawn):
    return [(wkb.dumps(geometry), {"kind": kind, "note": None}) for geometry, kind in drawn]


def layer(*polygons):
    return outlines_of("WALLS", [wkb.dumps(polygon) for polygon in polygons], "")


def reference_of(*drawn):
    return drawn_reference("REFERENCE", features_of(JUDGED, *drawn), "")


def test_without_a_judged_region_a_layer_is_no_drawn_plan():
    assert drawn_reference("REFERENCE", features_of(FACE), "") is None


def test_a_drawn_plan_is_compared_in_its_judged_region_only():
    missing = (LineString([(0, 5), (5, 5)]), "wall")
    beyond = (LineString([(6, 5), (9, 5)]), "wall")
    found = compare_with_reference(layer(WALL), reference_of(FACE, missing, beyond), 0.05)
    assert found.completeness == pytest.approx(0.5, abs=0.01)
    assert found.correctness == pytest.approx(1.0, abs=0.01)


def test_parts_of_a_feature_are_faces_each():
    faces = MultiLineString([[(0, 0), (5, 0)], [(0, 5), (5, 5)]])
    found = compare_with_reference(layer(WALL), reference_of((faces, "wall")), 0.05)
    assert found.completeness == pytest.approx(0.5, abs=0.01)


def test_known_walls_have_no_rules():
    wall = layer(WALL)
    found = compare_with_reference(wall, Reference(wall, None), 0.05)
    assert (found.completeness, found.correctness, found.iou) == pytest.approx((1, 1, 1))


def test_rooms_are_compared_if_both_have_some_also_where_they_touch():
    room = (box(0, 0.1, 4, 4), "room")
    rooms = layer(box(0, 0.1, 4, 4), box(0, 4, 4, 8))
    found = compare_drawn_rooms(rooms, reference_of(FACE, room))
    assert (found.found, found.missed, found.invented) == (1, 0, 1)
    assert compare_drawn_rooms(None, reference_of(FACE, room)) is None
    assert compare_drawn_rooms(rooms, reference_of(FACE)) is None
    assert compare_drawn_rooms(rooms, Reference(rooms, None)) is None


def test_a_drawn_plan_without_faces_is_refused():
    with pytest.raises(InputError, match="REFERENCE holds no outlines"):
        reference_of()
