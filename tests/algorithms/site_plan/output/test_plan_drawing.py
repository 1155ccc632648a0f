"""The plan as a drawing: what lies on which layer."""

from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.axes.axes import find_axes
from ichnograph.algorithms.site_plan.output.plan_drawing import LAYERS, faces, write_plan_drawing
from ichnograph.algorithms.site_plan.rooms.rooms import Room
from ichnograph.algorithms.site_plan.storeys.evidence.sheets import Sheet
from ichnograph.algorithms.site_plan.storeys.storey_plan import StoreyPlan
from ichnograph.algorithms.site_plan.storeys.walls.left_out import LeftOut
from ichnograph.tests.algorithms.site_plan.house import plan_of_house
from shapely.geometry import LineString, Polygon, box

HOUSE = box(0, 0, 6.6, 4.6).difference(box(0.3, 0.3, 6.3, 4.3))
KITCHEN = Room(1, box(0.3, 0.3, 6.3, 4.3), None)


def sheet(start, stop):
    return Sheet(np.array(start, float), np.array(stop, float), 20.0, 0.002)


def house():
    """Return a house of one room, with a cupboard and a column."""
    plan = plan_of_house()
    wall = replace(plan.walls[0], outline=HOUSE, kind="wall")
    column = replace(wall, outline=box(3, 2, 3.4, 2.4), kind="column")
    storey = StoreyPlan(
        walls=(),
        rooms=(),
        limits=(LineString([(0, 8), (3, 8)]),),
        left_out=(LeftOut(LineString([(1, 1), (2, 1)]), "furniture", 2.0),),
        sheets=(sheet((0.3, 0.3), (6.3, 0.3)), sheet((1, 1), (2, 1)), sheet((0.2, 2), (1.5, 2))),
        region=Polygon(),
        storey=None,
        spacing_m=0.03,
        noise_m=0.002,
    )
    return replace(plan, walls=(wall, column), storey=storey, rooms=(KITCHEN,), axes=find_axes([(1, HOUSE)]))


@pytest.fixture
def document(tmp_path):
    ezdxf = pytest.importorskip("ezdxf", reason="ezdxf is not installed")
    write_plan_drawing(tmp_path / "plan.dxf", house())
    return ezdxf.readfile(tmp_path / "plan.dxf")


def lines_on(document, layer):
    found = document.modelspace().query(f'LWPOLYLINE[layer=="{layer}"]')
    return [np.array(line.get_points("xy")) for line in found]


def test_every_part_of_the_plan_is_on_its_layer(document):
    counts = {layer: len(lines_on(document, layer)) for layer in LAYERS}

    assert counts["WALL"] == 2, "the outer and the inner ring"
    assert (counts["COLUMN"], counts["ROOM"], counts["LIMIT"], counts["LEFT_OUT"]) == (1, 1, 1, 1)
    assert counts["AXIS"] == 4
    assert not document.audit().errors


def test_walls_are_true_to_scale(document):
    outer, inner = lines_on(document, "WALL")
    np.testing.assert_allclose(np.ptp(outer, axis=0), (6.6, 4.6))
    np.testing.assert_allclose(np.ptp(inner, axis=0), (6.0, 4.0))


def test_rooms_have_their_name_and_area_inside(document):
    texts = {text.dxf.layer: text for text in document.modelspace().query("TEXT")}

    assert texts["ROOM_NAME"].dxf.text == "Room 1"
    assert texts["ROOM_AREA"].dxf.text == "24.00 m²"
    for text in texts.values():
        x, y, _ = text.dxf.align_point
        assert 0.3 < x < 6.3 and 0.3 < y < 4.3


def test_a_face_lies_on_the_outline_of_a_wall_and_furniture_and_crossings_are_not_faces():
    (face,) = faces(house())
    assert face.length == pytest.approx(6.0)


def test_without_a_storey_there_are_no_faces():
    assert list(faces(replace(house(), storey=None))) == []
