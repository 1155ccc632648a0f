"""The plan of a storey from points: rooms, walls, and what is neither."""

import numpy as np
import pytest
from ichnograph.algorithms.progress import Progress
from ichnograph.algorithms.site_plan.storeys.storey_plan import make_storey_plan
from ichnograph.tests.algorithms.site_plan.storeys.scans import flat, room, scanned, upright, without
from shapely.geometry import LineString, Point, box
from shapely.ops import unary_union

DOOR = (2.0, 2.9)


def plan_of(points):
    return make_storey_plan([points])


def walls_of(plan):
    return unary_union([wall.outline for wall in plan.walls])


def two_rooms(door_high=2.1, thickness=0.12):
    """Return two rooms with a partition between them, and a door in it as high as is told."""
    west, east = room(0, 0, 4, 3), room(4 + thickness, 0, 8, 3)
    low, high = (3.9, 0.5, 0.0), (4.2 + thickness, 1.4, door_high)
    reveals = [upright((4, y), (4 + thickness, y), 0, door_high) for y in (0.5, 1.4)]
    sill = [flat(4, 0.5, 4 + thickness, 1.4, z) for z in (0.0, door_high)]
    hole = without(np.concatenate([west, east]), low, (high[0], high[1], door_high))
    floor = np.concatenate([flat(3.9, 0.5, 4, 1.4, 0.0), flat(4 + thickness, 0.5, 4.2 + thickness, 1.4, 0.0)])
    return [hole, floor, *reveals, *sill]


def test_one_room_is_outlined_along_its_faces_to_millimetres():
    plan = plan_of(scanned(room(0, 0, 4, 3)))
    (found,) = plan.rooms
    assert found.outline.symmetric_difference(box(0, 0, 4, 3)).area < 0.03
    assert found.z_floor == pytest.approx(0.0, abs=0.005)
    assert found.z_ceiling == pytest.approx(2.6, abs=0.005)
    assert found.seen > 0.99


def test_a_wall_seen_from_one_side_has_no_thickness():
    plan = plan_of(scanned(room(0, 0, 4, 3)))
    assert {wall.thickness for wall in plan.walls} == {None}
    assert walls_of(plan).intersection(box(0, 0, 4, 3)).area < 0.02
    assert all(wall.z_top > 2.4 for wall in plan.walls)


def test_walls_are_cut_at_corners_share_edges_and_do_not_overlap():
    plan = plan_of(scanned(room(0, 0, 4, 3)))
    assert len(plan.walls) == 4
    assert sum(wall.outline.area for wall in plan.walls) == pytest.approx(walls_of(plan).area, abs=1e-6)
    assert len({wall.body for wall in plan.walls}) == 1


def test_a_door_parts_two_rooms_and_belongs_to_neither():
    plan = plan_of(scanned(*two_rooms()))
    areas = sorted(found.outline.area for found in plan.rooms)
    assert areas == pytest.approx([3.88 * 3, 4 * 3], rel=0.01)


def test_a_door_up_to_the_ceiling_is_a_narrow_place():
    plan = plan_of(scanned(*two_rooms(door_high=2.6)))
    assert len(plan.rooms) == 2


def test_a_thin_wall_seen_from_one_side_parts_two_rooms():
    # The floor and the ceiling of the other room were seen through the door.
    west = room(0, 0, 3, 3)
    east = [flat(3, 0, 7, 3, z) for z in (0.0, 2.6)]
    around = [upright((7, 0), (7, 3)), upright((3, 0), (7, 0)), upright((3, 3), (7, 3))]
    seen = without(np.concatenate([west, *east, *around]), (2.9, 0.5, 0.0), (3.1, 1.4, 2.1))
    plan = plan_of(scanned(seen))
    assert sorted(found.outline.area for found in plan.rooms) == pytest.approx([9, 12], abs=0.1)
    assert walls_of(plan).distance(Point(3, 2.2)) < 0.03


def test_a_partition_has_the_distance_of_its_faces_as_thickness():
    plan = plan_of(scanned(*two_rooms()))
    between = [wall for wall in plan.walls if wall.outline.contains(Point(4.06, 2.2))]
    assert [wall.thickness for wall in between] == pytest.approx([0.12], abs=0.006)


def test_a_column_is_a_column():
    corners = [(1.8, 1.3), (2.2, 1.3), (2.2, 1.7), (1.8, 1.7)]
    sides = [upright(a, b) for a, b in zip(corners, corners[1:] + corners[:1])]
    clear = without(room(0, 0, 4, 3), (1.8, 1.3, -1), (2.2, 1.7, 9))
    plan = plan_of(scanned(clear, *sides))
    (column,) = [wall for wall in plan.walls if wall.kind == "column"]
    assert column.outline.symmetric_difference(box(1.8, 1.3, 2.2, 1.7)).area < 0.01
    (found,) = plan.rooms
    assert found.outline.area == pytest.approx(12 - 0.16, rel=0.005)


def test_a_core_that_was_not_scanned_is_no_room():
    west, east = room(0, 0, 4, 6), room(5, 0, 9, 6)
    south = [flat(3.5, -1.5, 5.5, 0, 0), flat(3.5, -1.5, 5.5, 0, 2.6), upright((4, 0), (5, 0))]
    plan = plan_of(scanned(west, east, *south))
    assert not any(found.outline.contains(Point(4.5, 3)) for found in plan.rooms)


def test_furniture_before_a_wall_does_not_hide_the_wall():
    cupboard = [upright((1, 0.6), (2.5, 0.6), 0, 1.9), upright((1, 0), (1, 0.6), 0, 1.9)]
    cupboard += [upright((2.5, 0), (2.5, 0.6), 0, 1.9), flat(1, 0, 2.5, 0.6, 1.9)]
    clear = without(room(0, 0, 4, 3), (1.0, -0.1, -0.1), (2.5, 0.6, 1.9))
    plan = plan_of(scanned(clear, *cupboard))
    (found,) = plan.rooms
    assert found.outline.symmetric_difference(box(0, 0, 4, 3)).area < 0.05
    assert walls_of(plan).distance(Point(1.75, 0.6)) > 0.5
    assert any("furniture" in part.reason for part in plan.left_out)


def test_an_open_leaf_is_no_wall():
    leaf = upright((4.0, 1.4), (3.3, 1.95), 0, 2.1)
    plan = plan_of(scanned(*two_rooms(), leaf))
    assert walls_of(plan).intersection(LineString([(3.35, 1.9), (3.8, 1.56)])).length < 0.05
    assert len(plan.rooms) == 2


def test_where_the_scan_ends_is_a_limit_and_no_wall():
    points = without(room(0, 0, 6, 3), (4.0, -1, -1), (9, 9, 9))
    plan = plan_of(scanned(points))
    assert sum(limit.length for limit in plan.limits) == pytest.approx(3.0, abs=0.4)
    assert walls_of(plan).distance(Point(4.0, 1.5)) > 1.0


def test_a_balustrade_below_the_cut_is_no_wall():
    points = without(room(0, 0, 6, 3), (4.0, -1, -1), (9, 9, 9))
    plan = plan_of(scanned(points, upright((4, 0), (4, 3), 0, 1.0)))
    assert walls_of(plan).distance(Point(4.0, 1.5)) > 1.0


def test_a_beam_is_no_wall():
    beam = [upright((2, 0), (2, 3), 2.2, 2.6), upright((2.2, 0), (2.2, 3), 2.2, 2.6), flat(2, 0, 2.2, 3, 2.2)]
    clear = without(room(0, 0, 4, 3), (2, -0.1, 2.2), (2.2, 3.1, 2.7))
    plan = plan_of(scanned(clear, *beam))
    assert walls_of(plan).distance(Point(2.1, 1.5)) > 1.0
    assert len(plan.rooms) == 1


def test_a_parapet_stands_below_a_window():
    clear = without(room(0, 0, 4, 3), (1.0, -0.1, 0.9), (2.2, 0.01, 2.2))
    niche = [upright((1, -0.25), (1, 0), 0.9, 2.2), upright((2.2, -0.25), (2.2, 0), 0.9, 2.2)]
    niche += [
        flat(1, -0.25, 2.2, 0, 0.9),
        flat(1, -0.25, 2.2, 0, 2.2),
        upright((1, -0.25), (2.2, -0.25), 0.9, 2.2),
    ]
    plan = plan_of(scanned(clear, *niche))
    (parapet,) = [wall for wall in plan.walls if wall.kind == "parapet"]
    assert parapet.outline.symmetric_difference(box(1, -0.25, 2.2, 0)).area < 0.02
    (found,) = plan.rooms
    assert found.outline.area == pytest.approx(12, rel=0.01)


def test_outlines_have_no_tiny_edges_and_no_idle_corners():
    plan = plan_of(scanned(*two_rooms()))
    for outline in [found.outline for found in plan.rooms]:
        corners = np.asarray(outline.exterior.coords)
        assert np.hypot(*np.diff(corners, axis=0).T).min() > 0.005


def test_a_turned_and_shifted_room_gives_the_same_plan():
    points = scanned(*two_rooms())
    turn = np.radians(27)
    matrix = np.array([[np.cos(turn), np.sin(turn), 0], [-np.sin(turn), np.cos(turn), 0], [0, 0, 1]])
    plan = plan_of(points @ matrix + (31.3, -7.7, 104.2))
    areas = sorted(found.outline.area for found in plan.rooms)
    assert areas == pytest.approx([3.88 * 3, 4 * 3], rel=0.015)


def test_chunks_make_no_difference():
    points = scanned(*two_rooms())
    whole, parts = plan_of(points), make_storey_plan(np.array_split(points, 7))
    assert walls_of(whole).symmetric_difference(walls_of(parts)).area < 1e-6


def test_without_floor_and_ceiling_nothing_is_decided():
    plan = plan_of(scanned(upright((0, 0), (4, 0)), upright((0, 0), (0, 3))))
    assert (plan.rooms, plan.walls, plan.storey) == ((), (), None)
    assert plan.region.is_empty


@pytest.mark.parametrize(
    "points",
    [
        np.zeros((0, 3)),
        np.zeros((1, 3)),
        np.tile([[1.0, 2.0, 3.0]], (50, 1)),
        np.random.default_rng(1).uniform(0, 3, (40, 3)),
        scanned(upright((0, 0), (4, 0))),
        scanned(upright((0, 0), (4, 0), 1.0, 1.4), upright((4, 0), (4, 3), 1.0, 1.4)),
    ],
    ids=["nothing", "one point", "one place", "scattered points", "one wall", "a slice"],
)
def test_odd_input_gives_an_empty_plan(points):
    plan = plan_of(points)
    assert (plan.walls, plan.rooms, plan.limits, plan.left_out, plan.storey) == ((), (), (), (), None)


def test_no_chunks_give_an_empty_plan():
    assert make_storey_plan([]).storey is None


def test_a_floor_alone_bounds_no_room_by_walls():
    plan = plan_of(scanned(flat(0, 0, 4, 3, 0.0)))
    assert (plan.walls, plan.rooms) == ((), ())


def test_only_under_a_ceiling_nothing_is_looked_for_in_the_open():
    points = scanned(flat(0, 0, 4, 3, 0.0), upright((0, 0), (4, 0)))
    assert make_storey_plan([points], under_ceiling=True).storey is None
    assert make_storey_plan([scanned(room(0, 0, 4, 3))], under_ceiling=True).rooms


def test_one_wall_and_its_floor_are_a_wall_and_no_crash():
    plan = plan_of(scanned(flat(0, 0, 4, 3, 0.0), upright((0, 0), (4, 0))))
    assert plan.storey.ceiling is None
    assert walls_of(plan).intersection(box(0.1, -0.1, 3.9, 0.1)).area > 0.05


def test_a_slice_through_a_room_bounds_no_rooms():
    points = scanned(room(0, 0, 4, 3))
    plan = plan_of(points[(points[:, 2] > 0.9) & (points[:, 2] < 1.3)])
    assert plan.rooms == ()


def test_a_moved_plan_is_moved_as_a_whole():
    board = upright((1.5, 1.5), (2.3, 1.5), 0, 1.6)
    plan = plan_of(scanned(without(room(0, 0, 6, 3), (4.0, -1, -1), (9, 9, 9)), board))
    moved = plan.moved(100.0, -20.0)
    assert plan.left_out
    assert plan.limits
    for name in ("walls", "rooms"):
        for one, other in zip(getattr(plan, name), getattr(moved, name)):
            assert np.subtract(other.outline.bounds, one.outline.bounds) == pytest.approx([100, -20] * 2)
    for one, other in zip(plan.limits, moved.limits):
        assert np.subtract(other.bounds, one.bounds) == pytest.approx([100, -20] * 2)
    for one, other in zip(plan.left_out, moved.left_out):
        assert np.subtract(other.line.bounds, one.line.bounds) == pytest.approx([100, -20] * 2)
        assert other.reason == one.reason
    for one, other in zip(plan.sheets, moved.sheets):
        assert other.start - one.start == pytest.approx([100, -20])
        assert other.stop - one.stop == pytest.approx([100, -20])
    assert np.subtract(moved.region.bounds, plan.region.bounds) == pytest.approx([100, -20] * 2)
    assert (moved.storey, moved.noise_m) == (plan.storey, plan.noise_m)


def test_the_user_can_stop():
    from ichnograph.algorithms.errors import CancelledError

    with pytest.raises(CancelledError):
        make_storey_plan([scanned(room(0, 0, 4, 3))], progress=Progress(is_cancelled=lambda: True))
