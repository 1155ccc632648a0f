"""A cloud becomes the plan of a site in one call."""

from dataclasses import fields, is_dataclass, replace
from functools import lru_cache

import numpy as np
import pytest
from ichnograph.algorithms.errors import CancelledError, NothingFoundError
from ichnograph.algorithms.progress import Progress
from ichnograph.algorithms.site_plan.density.density_image import density_image
from ichnograph.algorithms.site_plan.density.density_raster import (
    NO_CRS,
    read_density,
    write_density,
)
from ichnograph.algorithms.site_plan.density.height_range import HeightRange
from ichnograph.algorithms.site_plan.rooms.settings import RoomSettings
from ichnograph.algorithms.site_plan.settings import SitePlanSettings
from ichnograph.algorithms.site_plan.site_plan import NO_ROOM, extract_walls, make_site_plan
from ichnograph.algorithms.site_plan.storeys.settings import CutSettings, StoreySettings
from ichnograph.algorithms.site_plan.walls.extraction import WallParameters
from ichnograph.tests.algorithms.site_plan.house import (
    ROOMS,
    THICKNESS,
    plan_of_house,
    points_of_house,
    points_under_ceiling,
    walls_of_house,
)
from ichnograph.tests.algorithms.site_plan.masonry import offset
from ichnograph.tests.algorithms.site_plan.rasters import wall_tower_and_beam
from ichnograph.tests.algorithms.site_plan.surfaces import ORIGIN, SHIFT, cloud_of, level
from ichnograph.tests.algorithms.site_plan.surfaces import box as sides_of
from shapely.affinity import translate
from shapely.geometry import box
from shapely.ops import unary_union

EVERYTHING = SitePlanSettings(with_axes=True, with_rooms=True)
GATE = box(1.0, -0.3, 3.0, 0.0)


def test_the_outlines_of_walls_lie_on_their_faces():
    (wall,) = plan_of_house().walls
    assert offset(wall.outline, walls_of_house()) < 0.03
    assert wall.thickness == pytest.approx(THICKNESS, abs=0.01)
    assert wall.z_base == pytest.approx(0.0, abs=0.05)
    assert wall.z_top == pytest.approx(2.4, abs=0.05)


def test_the_outlines_of_pixels_are_kept_beside_those_on_the_faces():
    plan = plan_of_house()
    (wall,) = plan.pixel_walls
    assert 0.05 < offset(wall.outline, walls_of_house()) < 0.3
    assert wall.thickness is None


@pytest.mark.parametrize(
    "cuts, seed", [((7, 900, 5000), None), ((), 1), ((4000,), 2), (range(0, 9000, 700), 3)]
)
def test_the_plan_is_the_same_bytes_however_its_points_are_cut_and_ordered(cuts, seed):
    points = points_under_ceiling(sides_of((1.0, 1.6), (2.0, 2.6), 0.0, 0.8))
    points = points + np.random.default_rng(0).normal(0, 0.002, points.shape)
    order = np.arange(len(points)) if seed is None else np.random.default_rng(seed).permutation(len(points))
    plan = make_site_plan(cloud_of(points[order], list(cuts)), EVERYTHING)
    assert plan.storey is not None
    assert bytes_of(plan) == bytes_of(make_site_plan(cloud_of(points), EVERYTHING))


def bytes_of(value):
    """Return all that a result consists of, arrays and outlines as bytes."""
    if is_dataclass(value):
        return {item.name: bytes_of(getattr(value, item.name)) for item in fields(value)}
    if isinstance(value, (tuple, list)):
        return [bytes_of(item) for item in value]
    if isinstance(value, np.ndarray):
        return value.shape, value.tobytes()
    return getattr(value, "wkb", repr(value))


def test_without_refinement_the_walls_are_those_of_pixels():
    plan = make_site_plan(cloud_of(points_of_house()), SitePlanSettings(refine=False))
    assert plan.walls == plan.pixel_walls == plan_of_house().pixel_walls
    assert plan.coverage == 0.0


def test_rooms_lie_between_the_faces_and_know_their_floor():
    large, small = plan_of_house().rooms
    assert (large.area, small.area) == pytest.approx([room.area for room in ROOMS], rel=0.02)
    assert (large.openings, small.openings) == (1, 1)
    assert large.z_floor == pytest.approx(0.0, abs=0.03)
    assert plan_of_house().room_area == large.area + small.area


def test_axes_run_along_every_wall():
    plan = plan_of_house()
    assert plan.axes_length == pytest.approx(sum(axis.length for axis in plan.axes))
    # Around the house, and the partition on both sides of its door.
    assert plan.axes_length == pytest.approx(2 * (7.6 + 4.3) + 3.4, abs=0.2)
    assert {axis.wall_id for axis in plan.axes} == {1}


def test_axes_and_rooms_are_looked_for_only_if_they_are_wanted():
    plan = make_site_plan(cloud_of(points_of_house()))
    assert (plan.axes, plan.rooms) == (None, None)
    assert plan.walls == plan_of_house().walls


def test_the_density_image_is_that_of_the_cloud():
    points = points_of_house()
    plan, image = plan_of_house(), density_image(cloud_of(points))
    assert (plan.density.points_in, plan.density.points_kept) == (len(points), image.points_kept)
    assert plan.transform == image.transform
    np.testing.assert_array_equal(plan.density.density, image.density)


def test_the_settings_reach_the_density_image_and_the_walls():
    walls = WallParameters(threshold_steps=4, closing=0.5)
    settings = SitePlanSettings(0.08, 0.2, 0, HeightRange(0.5, 1.5, above_ground=True), walls)
    plan = make_site_plan(cloud_of(points_of_house()), settings)
    image = density_image(cloud_of(points_of_house()), 0.08, 0.2, 0, heights=settings.height_range)
    np.testing.assert_array_equal(plan.density.density, image.density)
    assert (len(plan.image.steps), plan.image.gap) == (4, 0.5)
    assert plan.settings is settings


def test_the_width_of_doors_decides_which_rooms_are_closed():
    cloud = cloud_of(points_of_house(GATE))
    assert len(make_site_plan(cloud, EVERYTHING).rooms) == 1
    wider = make_site_plan(cloud, replace(EVERYTHING, rooms=RoomSettings(door_width_m=2.1)))
    assert len(wider.rooms) == 2


def test_a_house_without_a_closed_room_is_a_warning():
    plan = make_site_plan(cloud_of(points_of_house(GATE, box(5, -0.3, 7, 0))), EVERYTHING)
    assert plan.rooms == ()
    assert plan.warnings == (NO_ROOM,)


def with_stray(points):
    return np.concatenate([points, [[900.0, 40.0, 2.0]]])


def test_what_was_noticed_on_the_way_is_a_warning():
    plan = make_site_plan(cloud_of(with_stray(points_of_house())), SitePlanSettings(spacing_m=0.12))
    stray, sparse = plan.warnings
    assert "lie far away" in stray
    assert sparse.startswith("SPACING 0.12 m is wider")


def test_warnings_are_not_lost_if_no_wall_is_found():
    with pytest.raises(NothingFoundError, match="No wall found") as caught:
        make_site_plan(cloud_of(with_stray(level((0, 8), (0, 8), 0.0))))
    (warning,) = caught.value.warnings
    assert "lie far away" in warning


def test_progress_rises_from_step_to_step():
    reports = []
    progress = Progress(lambda fraction, message: reports.append((fraction, message)))
    make_site_plan(cloud_of(points_of_house()), EVERYTHING, progress)
    fractions = [fraction for fraction, _ in reports]
    assert fractions == sorted(fractions)
    assert fractions[-1] == 1.0
    messages = list(dict.fromkeys(message for _, message in reports if message))
    steps = ("Thinning", "Tracing outlines", "Fitting faces", "Finding axes", "Outlining rooms")
    assert [message for message in messages if message in steps] == list(steps)


@pytest.mark.parametrize("step", ["Thinning", "Tracing outlines", "Fitting faces", "Finding axes"])
def test_it_stops_when_the_caller_asks(step):
    seen = []
    progress = Progress(lambda _, message: seen.append(message), lambda: step in seen)
    with pytest.raises(CancelledError):
        make_site_plan(cloud_of(points_of_house()), EVERYTHING, progress)


def test_the_raster_alone_gives_the_walls_of_pixels(tmp_path):
    plan = plan_of_house()
    write_density(tmp_path / "density.tif", plan.density)
    found = extract_walls(read_density(tmp_path / "density.tif"), WallParameters())
    assert found.walls == plan.pixel_walls
    assert found.transform == plan.transform
    assert found.warnings == (NO_CRS,)


def test_the_warnings_of_the_raster_come_before_those_of_the_gate():
    raster, *_ = wall_tower_and_beam()
    blind = replace(raster, heights=None, warnings=("A warning of the raster.",))
    first, second = extract_walls(blind, WallParameters()).warnings
    assert first == "A warning of the raster."
    assert "MIN_HEIGHT is not applied" in second


@lru_cache(maxsize=1)
def plan_under_ceiling():
    return make_site_plan(cloud_of(points_under_ceiling()), EVERYTHING)


def in_world(outline):
    return translate(outline, *(ORIGIN + SHIFT)[:2])


def test_without_a_ceiling_there_is_no_storey():
    assert plan_of_house().storey is None
    assert {wall.body for wall in plan_of_house().walls} == {None}


def test_under_a_ceiling_walls_are_pieces_between_corners():
    walls = plan_under_ceiling().walls
    assert [(wall.wall_id, wall.kind, wall.body) for wall in walls] == [(i, "wall", 1) for i in (1, 2, 3, 4)]
    assert {wall.thickness for wall in walls} == {None}
    assert all(wall.z_top == pytest.approx(2.6, abs=0.11) for wall in walls)
    assert sorted(wall.azimuth for wall in walls) == pytest.approx([0, 0, 90, 90], abs=0.5)


def test_under_a_ceiling_the_room_is_what_was_seen_between_faces():
    (room,) = plan_under_ceiling().rooms
    assert room.outline.symmetric_difference(in_world(box(0, 0, 4, 3))).area < 0.03
    assert (room.room_id, room.openings) == (1, None)
    assert (room.z_floor, room.z_ceiling) == pytest.approx((0.0, 2.6), abs=0.005)
    assert room.seen > 0.99


def test_the_axes_lie_within_the_walls():
    plan = plan_under_ceiling()
    walls = unary_union([wall.outline for wall in plan.walls]).buffer(0.001)
    # The walls were seen from inside: strips of 2.5 cm, whose axes lie half of that behind the faces.
    assert plan.axes_length == pytest.approx(14 + 8 * 0.0125, abs=0.002)
    assert all(walls.contains(axis.line) for axis in plan.axes)
    assert {axis.wall_id for axis in plan.axes} == {1}


def test_walls_and_rooms_share_no_area():
    plan = plan_under_ceiling()
    walls, (room,) = unary_union([wall.outline for wall in plan.walls]), plan.rooms
    assert sum(wall.outline.area for wall in plan.walls) == pytest.approx(walls.area)
    assert walls.intersection(room.outline).area < 0.02


def test_without_refinement_a_ceiling_makes_no_storey():
    plan = make_site_plan(cloud_of(points_under_ceiling()), replace(EVERYTHING, refine=False))
    assert plan.storey is None
    assert plan.walls == plan.pixel_walls
    assert {room.seen for room in plan.rooms} <= {None}


def test_a_room_is_the_same_wherever_it_lies_in_the_grid():
    away = np.array([13.37, -5.71, 0.0])
    moved = make_site_plan(cloud_of(points_under_ceiling() + away), EVERYTHING)
    plan = plan_under_ceiling()
    for one, other in ((plan.rooms, moved.rooms), (plan.walls, moved.walls)):
        assert len(one) == len(other)
        before, after = (unary_union([item.outline for item in items]) for items in (one, other))
        assert translate(before, *away[:2]).symmetric_difference(after).area < 0.03


def test_a_house_and_its_yard_are_one_plan():
    yard = [level((4.5, 11), (-0.5, 4), 0.0), sides_of((7, 10), (1.0, 1.3), 0.0, 1.8)]
    plan = make_site_plan(cloud_of(points_under_ceiling(*yard)), EVERYTHING)
    assert [wall.wall_id for wall in plan.walls] == [*range(1, len(plan.walls) + 1)]
    inside, outside = (
        [wall for wall in plan.walls if (wall.body is None) == open_] for open_ in (False, True)
    )
    assert {wall.kind for wall in inside} == {"wall"}
    (free,) = outside
    assert free.outline.symmetric_difference(in_world(box(7, 1.0, 10, 1.3))).area < 0.1
    assert [round(room.area) for room in plan.rooms] == [12]


def test_furniture_before_a_wall_does_not_move_the_wall():
    cupboard = sides_of((1.0, 2.5), (0.03, 0.6), 0.0, 1.9)
    points = points_under_ceiling()
    behind = np.all((points > (1.03, -0.01, -0.01)) & (points < (2.47, 0.57, 1.87)), axis=1)
    plan = make_site_plan(cloud_of(np.concatenate([points[~behind], cupboard])), EVERYTHING)
    (room,) = plan.rooms
    assert room.outline.symmetric_difference(in_world(box(0, 0, 4, 3))).area < 0.05
    (reason,) = {item.reason for item in plan.storey.left_out}
    assert "furniture" in reason


@pytest.mark.parametrize(("section", "expected"), [(1.1, True), (1.5, False)])
def test_what_ends_below_the_section_is_a_limit_and_no_wall(section, expected):
    points = points_under_ceiling()
    cut_off = points[(points[:, 0] < 3.95) | (points[:, 2] < 1.3) | (points[:, 2] > 2.59)]
    storeys = StoreySettings(cut=CutSettings(section_m=section))
    plan = make_site_plan(cloud_of(cut_off), replace(EVERYTHING, storeys=storeys))
    east = in_world(box(3.9, 0.5, 4.1, 2.5))
    assert any(wall.outline.intersects(east) for wall in plan.walls) == expected
    assert any(line.intersects(east) for line in plan.storey.limits) != expected


def far_apart(*surfaces):
    """Return four copies of surfaces at the corners and in the middle of a site of 300 m."""
    corners = ((0, 0, 0), (300, 300, 0), (150, 150, 0), (0, 300, 0))
    return np.concatenate([surface + corner for surface in surfaces for corner in corners])


def test_a_site_too_large_for_a_plan_of_rooms_still_has_walls():
    wall = [level((-1, 5), (-2, 3), 0.0), sides_of((0, 4), (0, 0.3), 0.0, 2.4)]
    plan = make_site_plan(cloud_of(far_apart(*wall)))
    assert len(plan.walls) == 4
    assert (plan.storey, plan.warnings) == (None, ())


def test_a_roofed_site_too_large_for_a_plan_of_rooms_has_walls_and_a_warning():
    plan = make_site_plan(cloud_of(far_apart(points_under_ceiling())))
    assert len(plan.walls) == 4
    assert plan.storey is None
    (warning,) = plan.warnings
    assert "too large for a plan of rooms" in warning
