"""One plan of a site: under a roof the storey decides, in the open the density image does."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from affine import Affine
from ichnograph.algorithms.errors import CancelledError
from ichnograph.algorithms.progress import Progress
from ichnograph.algorithms.site_plan.density.density_image import sort_and_image
from ichnograph.algorithms.site_plan.rooms.rooms import Room
from ichnograph.algorithms.site_plan.storeys.evidence.levels import Storey
from ichnograph.algorithms.site_plan.storeys.evidence.sheets import Sheet
from ichnograph.algorithms.site_plan.storeys.joining import (
    bodies,
    join_rooms,
    join_walls,
    plan_storey,
    under_roof,
)
from ichnograph.algorithms.site_plan.storeys.rooms.room_cells import Room as StoreyRoom
from ichnograph.algorithms.site_plan.storeys.settings import JoiningSettings, StoreySettings
from ichnograph.algorithms.site_plan.storeys.storey_plan import StoreyPlan
from ichnograph.algorithms.site_plan.storeys.walls.left_out import LeftOut
from ichnograph.algorithms.site_plan.storeys.walls.walls import Wall as StoreyWall
from ichnograph.algorithms.site_plan.walls.wall import Wall
from ichnograph.tests.algorithms.site_plan.storeys.scans import flat, room, scanned, upright
from ichnograph.tests.algorithms.site_plan.surfaces import ORIGIN, SHIFT, cloud_of
from shapely.affinity import translate
from shapely.geometry import LineString, Polygon, box
from shapely.ops import unary_union

JOINING = JoiningSettings()

HOUSE = box(0, 0, 4, 3)

GRID = Affine(0.1, 0, -2, 0, -0.1, 10)
"""Pixels of a density image 20 m wide and 12 m high."""


def storey_wall(outline, kind="wall", body=1):
    return StoreyWall(outline, kind, body, 0.2, 0.0, 2.6, 0.9)


def storey_room(outline):
    return StoreyRoom(outline, 0.0, 2.6, 0.98)


def storey_of(rooms=(HOUSE,), walls=(), region=HOUSE, limits=(), left_out=()):
    return StoreyPlan(
        tuple(map(storey_wall, walls)),
        tuple(map(storey_room, rooms)),
        tuple(limits),
        tuple(left_out),
        (),
        region,
        Storey(0.0, 2.6),
        0.02,
        0.002,
    )


def site_wall(number, outline):
    length = (outline.bounds[2] - outline.bounds[0]) + (outline.bounds[3] - outline.bounds[1])
    return Wall(number, outline, "straight", length, 0.0, 2.0, 2.0, 90.0, 30.0, 5)


def image_of(*walls):
    """Return the pixels of a density image, 40 points and 7 votes on walls."""
    gated, votes = np.zeros((120, 200)), np.zeros((120, 200), int)
    for wall in walls:
        x0, y0, x1, y1 = (round(10 * value) for value in wall.bounds)
        inside = np.s_[100 - y1 : 100 - y0, 20 + x0 : 20 + x1]
        gated[inside], votes[inside] = 40.0, 7
    return SimpleNamespace(gated=gated, votes=votes)


def joined(walls, storey, image=image_of()):
    return join_walls(walls, storey, image, GRID, JOINING)


def test_rooms_and_walls_under_the_roof_are_kept_and_those_in_the_open_are_not():
    yard, facade, fence = box(10, 0, 14, 4), box(0, -0.2, 4, 0), box(10, -0.2, 14, 0)
    found = under_roof(storey_of((HOUSE, yard), (facade, fence)), JOINING)
    assert [one.outline for one in found.rooms] == [HOUSE]
    assert [one.outline for one in found.walls] == [facade]


def test_a_room_half_under_a_canopy_is_in_the_open():
    terrace = box(4.2, 0, 8, 3)
    found = under_roof(storey_of((HOUSE, terrace), region=box(0, 0, 5, 3)), JOINING)
    assert [one.outline for one in found.rooms] == [HOUSE]


def test_limits_and_what_was_left_out_are_those_under_the_roof():
    near, far = LineString([(4, 1), (4, 2)]), LineString([(9, 1), (9, 2)])
    found = under_roof(
        storey_of(limits=(near, far), left_out=(LeftOut(near, "a", 2.0), LeftOut(far, "b", 2.0))), JOINING
    )
    assert found.limits == (near,)
    assert [item.reason for item in found.left_out] == ["a"]


def test_the_region_reaches_half_a_metre_beyond_rooms_and_walls():
    found = under_roof(storey_of(walls=(box(4, 0, 4.3, 3),)), JOINING)
    assert found.region.bounds == pytest.approx((-0.5, -0.5, 4.8, 3.5))


def test_without_a_room_under_the_roof_there_is_no_storey():
    assert under_roof(storey_of((), (box(0, -0.2, 4, 0),)), JOINING) is None
    assert under_roof(storey_of(region=Polygon()), JOINING) is None


def test_crowns_of_trees_over_a_small_room_are_no_ceiling():
    crowns = box(-10, -10, 10, 10)
    assert under_roof(storey_of(region=crowns), JOINING) is None
    assert under_roof(storey_of((HOUSE, box(-9, -9, 9, -1)), region=crowns), JOINING) is not None


def test_walls_of_the_storey_take_the_place_of_those_of_the_density_image():
    inner, crude, garden = box(0, -0.2, 4, 0), box(-0.1, -0.3, 4.1, 0.1), box(8, 0, 12, 0.3)
    storey = under_roof(storey_of(walls=(inner,)), JOINING)
    first, second = joined([site_wall(1, crude), site_wall(2, garden)], storey)
    assert (first.wall_id, first.kind, first.outline) == (1, "wall", inner)
    assert (second.wall_id, second.kind, second.outline) == (2, "straight", garden)
    assert (first.body, second.body) == (1, None)


def test_a_wall_that_runs_from_a_house_into_its_yard_begins_outside_of_the_region():
    storey = under_roof(storey_of(), JOINING)
    (rest,) = joined([site_wall(1, box(3, 1, 12, 1.3))], storey)
    assert rest.outline.bounds == pytest.approx((4.5, 1, 12, 1.3))
    assert rest.length == pytest.approx(7.5, abs=0.3)


def test_a_short_rest_of_a_wall_is_dropped():
    storey = under_roof(storey_of(), JOINING)
    assert joined([site_wall(1, box(3, 1, 4.8, 1.3))], storey) == ()


def test_a_wall_cut_in_two_gets_two_numbers():
    storey = under_roof(storey_of(), JOINING)
    found = joined([site_wall(1, box(-3, 1, 9, 1.3))], storey)
    assert [wall.wall_id for wall in found] == [1, 2]
    assert unary_union([wall.outline for wall in found]).area == pytest.approx((2.5 + 4.5) * 0.3)


def column_of(x, y, levels):
    """Return a column of the density image, and the sheets on two of its sides."""
    sides = [((x, y), (x + 0.4, y)), ((x, y), (x, y + 0.4))]
    sheets = tuple(Sheet(np.array(a, float), np.array(b, float), levels, 0.002) for a, b in sides)
    return replace(site_wall(1, box(x, y, x + 0.4, y + 0.4)), kind="column", coverage=0.5), sheets


@pytest.mark.parametrize(("levels", "kept"), [(24.0, 1), (8.0, 0)], ids=["a column", "a cupboard"])
def test_a_column_seen_from_two_sides_is_kept_in_a_room_if_it_is_higher_than_furniture(levels, kept):
    column, sheets = column_of(1.0, 1.0, levels)
    storey = replace(under_roof(storey_of(), JOINING), sheets=sheets)
    assert len(joined([column], storey)) == kept


def test_a_strip_along_the_front_of_a_high_cupboard_is_no_column():
    sheet = Sheet(np.array([1.0, 1.0]), np.array([2.5, 1.0]), 20.0, 0.002)
    storey = replace(under_roof(storey_of(), JOINING), sheets=(sheet,))
    assert joined([site_wall(1, box(1, 0.99, 2.5, 1.01))], storey) == ()


def test_pixels_without_a_sheet_are_no_column():
    column, _ = column_of(1.0, 1.0, 24.0)
    assert joined([column], under_roof(storey_of(), JOINING)) == ()


def test_density_and_votes_are_those_of_the_pixels_and_null_where_there_are_none():
    seen, unseen = box(0, -0.2, 4, 0), box(0, 3, 4, 3.2)
    first, second = joined([], under_roof(storey_of(walls=(seen, unseen)), JOINING), image_of(seen))
    assert (first.density, first.votes) == (40.0, 7)
    assert (second.density, second.votes) == (None, None)


def test_walls_of_a_storey_have_height_and_azimuth_and_columns_have_none():
    storey = under_roof(storey_of(walls=(box(0, -0.2, 4, 0),)), JOINING)
    column = replace(storey, walls=(storey_wall(box(1, 1, 1.4, 1.4), "column"),))
    (wall,), (free,) = joined([], storey), joined([], column)
    assert (wall.height, wall.azimuth) == pytest.approx((2.6, 90.0))
    assert free.azimuth is None
    (unseen,) = joined([], replace(storey, walls=(replace(storey.walls[0], z_base=None, z_top=None),)))
    assert unseen.height is None


def test_rooms_of_the_storey_and_closed_spaces_in_the_open_are_one_list_the_largest_first():
    storey = under_roof(storey_of(), JOINING)
    yard, same = Room(1, box(8, 0, 14, 5), 1, 0.1), Room(2, box(0.1, 0.1, 3.9, 2.9), 1)
    found = join_rooms((yard, same), storey, JOINING)
    assert [one.room_id for one in found] == [1, 2]
    assert [one.outline for one in found] == [yard.outline, HOUSE]
    assert (found[0].openings, found[0].seen) == (1, None)
    assert (found[1].openings, found[1].seen, found[1].z_ceiling) == (None, 0.98, 2.6)


def test_a_closed_space_in_the_open_ends_at_the_rooms_of_the_storey():
    storey = under_roof(storey_of(), JOINING)
    around = Room(1, box(2, -6, 14, 6), 1)
    found = join_rooms((around,), storey, JOINING)
    assert [one.outline.area for one in found] == pytest.approx([144 - 2 * 3, 12])
    assert found[0].outline.intersection(found[1].outline).area < 1e-9


def test_pieces_of_one_body_are_one_outline_and_other_walls_stand_alone():
    pieces = [box(0, 0, 4, 0.2), box(4, 0, 4.2, 3)]
    storey = under_roof(storey_of(walls=pieces), JOINING)
    walls = joined([site_wall(1, box(9, 0, 12, 0.3)), site_wall(2, box(9, 5, 12, 5.3))], storey)
    found = bodies(walls)
    assert [number for number, _ in found] == [1, 3, 4]
    assert [outline.area for _, outline in found] == pytest.approx([1.4, 0.9, 0.9])


def test_parapets_which_are_in_no_body_are_not_joined():
    parapets = tuple(storey_wall(outline, "parapet", 0) for outline in (box(0, 0, 1, 0.2), box(1, 0, 2, 0.2)))
    walls = joined([], replace(under_roof(storey_of(), JOINING), walls=parapets))
    assert [number for number, _ in bodies(walls)] == [1, 2]


def test_no_walls_have_no_bodies():
    assert bodies([]) == []
    assert joined([], under_roof(storey_of(), JOINING)) == ()


def planned(*surfaces, progress=Progress()):
    with sort_and_image(cloud_of(scanned(*surfaces))) as (_, points):
        return plan_storey(points, StoreySettings(), progress)


def test_the_plan_of_a_storey_is_in_world_coordinates():
    found = planned(room(0, 0, 4, 3, spacing=0.04))
    x, y, _ = ORIGIN + SHIFT
    (one,) = found.rooms
    assert one.outline.symmetric_difference(translate(HOUSE, x, y)).area < 0.05
    assert one.z_floor == pytest.approx(0.0, abs=0.01)
    assert found.region.contains(one.outline)


@pytest.mark.parametrize(
    "surfaces",
    [
        [flat(0, 0, 4, 3, 0.0), upright((0, 0), (4, 0)), upright((0, 0), (0, 3))],
        [upright((0, 0), (4, 0), 1.0, 1.4), upright((0, 0), (0, 3), 1.0, 1.4)],
        [flat(0, 0, 4, 3, 0.0)],
        [upright((0, 0), (4, 0))],
    ],
    ids=["no ceiling", "a slice", "a floor", "a wall"],
)
def test_without_rooms_under_a_ceiling_there_is_no_storey(surfaces):
    assert planned(*surfaces) is None


def test_the_user_can_stop():
    with pytest.raises(CancelledError):
        planned(room(0, 0, 2, 2, spacing=0.05), progress=Progress(is_cancelled=lambda: True))
