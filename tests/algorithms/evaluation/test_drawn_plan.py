"""Plans drawn by hand: what a plan must have, may have, and what nobody judges."""

import json

import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.evaluation.drawn_plan import (
    compare_rooms,
    compare_with_drawn,
    drawn_plan,
    read_drawn_plan,
)
from shapely.geometry import LineString, Point, box, mapping

TOLERANCE = 0.05
JUDGED = (box(-1, -1, 11, 6), {"kind": "judged"})


def drawn(*features):
    return drawn_plan([JUDGED, *((geometry, {"kind": kind, **more}) for geometry, kind, more in features)])


def face(*corners, kind="wall"):
    return LineString(corners), kind, {}


def room(geometry, note=""):
    return geometry, "room", {"note": note}


def strip(south, north):
    return box(0, south, 10, north)


def compared(plan, *walls):
    found = compare_with_drawn(walls, plan, TOLERANCE)
    return found.completeness, found.correctness


def test_a_wall_on_both_faces_is_complete_and_nearly_correct():
    plan = drawn(face((0, 0), (10, 0)), face((0, 0.3), (10, 0.3)))
    complete, correct = compared(plan, strip(0, 0.3))
    assert complete == 1.0
    # The two ends run across the faces.
    assert correct == pytest.approx(20 / 20.6, abs=0.02)


def test_a_line_across_a_face_does_not_stand_for_it():
    plan = drawn(face((5, -0.04), (5, 0.04)))
    assert compared(plan, strip(0, 0.01))[0] == 0.0


def test_the_back_of_a_thin_strip_is_not_judged():
    plan = drawn(face((0, 0), (10, 0)))
    assert compared(plan, strip(0, 0.07))[1] == pytest.approx(1.0, abs=0.02)
    # The back of a thick wall is a face of its own.
    assert compared(plan, strip(0, 0.3))[1] == pytest.approx(0.5, abs=0.03)


def test_what_runs_along_an_opening_is_neither_right_nor_wrong():
    wall = face((0, 0), (4, 0)), face((6, 0), (10, 0))
    leaf = box(4.1, -0.12, 5.9, -0.10)
    with_opening = drawn(*wall, (LineString([(4, 0), (6, 0)]), "opening", {}))
    assert compared(with_opening, strip(0, 0.06), leaf)[1] == pytest.approx(1.0, abs=0.03)
    assert compared(drawn(*wall), strip(0, 0.06), leaf)[1] < 0.95


def test_glazing_may_be_drawn_or_not():
    plan = drawn(face((0, 0), (5, 0)), face((5, 0), (10, 0), kind="glazing"))
    assert compared(plan, box(0, 0, 5, 0.06))[0] == pytest.approx(1.0, abs=0.01)
    assert compared(plan, strip(0, 0.06)) == pytest.approx((1.0, 1.0), abs=0.02)


def test_nothing_is_judged_outside_of_the_region():
    plan = drawn(face((0, 0), (10, 0)), face((0, 20), (10, 20)))
    assert compared(plan, strip(0, 0.06), box(0, 30, 10, 30.3)) == pytest.approx((1.0, 1.0), abs=0.02)


def test_rooms_are_found_missed_and_invented():
    plan = drawn(room(box(0, 0, 4, 4)), room(box(5, 0, 9, 4)), room(box(0, 4.5, 2, 5.5), "optional: a niche"))
    agreement = compare_rooms([box(0, 0, 4, 3.96), box(5, 0, 7, 4), box(0, 4.5, 2, 5.5)], plan)
    assert (agreement.found, agreement.missed, agreement.invented) == (1, 1, 1)
    assert agreement.median_area_error == pytest.approx(0.01)


def test_one_room_stands_for_one_true_room():
    plan = drawn(room(box(0, 0, 4, 4)))
    agreement = compare_rooms([box(0, 0, 4, 4), box(0, 0, 4, 3.9)], plan)
    assert (agreement.found, agreement.invented) == (1, 1)


def test_without_rooms_there_is_no_area_error():
    assert np.isnan(compare_rooms([], drawn()).median_area_error)


def test_a_layer_is_read(tmp_path):
    features = [(box(0, 0, 5, 5), {"kind": "judged"}), (LineString([(0, 0), (5, 0)]), {"kind": "wall"})]
    items = [{"type": "Feature", "geometry": mapping(g), "properties": p} for g, p in features]
    path = tmp_path / "reference.geojson"
    path.write_text(json.dumps({"type": "FeatureCollection", "features": items}))
    plan = read_drawn_plan(path)
    assert plan.judged.contains(Point(1, 1))
    assert plan.demanded.length == 5


def test_a_layer_without_a_judged_region_is_refused(tmp_path):
    item = {"type": "Feature", "geometry": mapping(Point(0, 0)), "properties": {"kind": "wall"}}
    path = tmp_path / "reference.geojson"
    path.write_text(json.dumps({"type": "FeatureCollection", "features": [item]}))
    with pytest.raises(InputError, match="kind judged"):
        read_drawn_plan(path)
    with pytest.raises(InputError, match="cannot be read"):
        read_drawn_plan(tmp_path / "missing.geojson")
