"""Simulated buildings in use: what stands in them, and what their truth says."""

from dataclasses import replace

import numpy as np
import pytest
from ichnograph.tests.scenes.lived_in import LIVED_IN
from ichnograph.tests.scenes.lived_in.furniture import Room, bookcase, curtain
from ichnograph.tests.scenes.scene import Scene
from ichnograph.tests.scenes.things import Mirror, Prism
from shapely.geometry import LineString, Point, box

COARSE = 3.0


@pytest.fixture(params=sorted(LIVED_IN))
def scene(request):
    return LIVED_IN[request.param](seed=2)


def test_no_room_overlaps_a_wall_and_every_room_is_entered_by_a_scanner(scene):
    overlap = sum(room.intersection(scene.truth).area for room in scene.rooms)
    columns = 1.0
    assert overlap < columns
    for room in scene.rooms:
        assert any(room.contains(Point(x, y)) for x, y, _ in scene.stations)


def test_the_same_seed_gives_the_same_scene(scene):
    again = LIVED_IN[scene.name](seed=2)
    assert again.truth.equals(scene.truth)
    assert np.array_equal(again.stations, scene.stations)


def test_openings_interrupt_the_faces_of_walls(scene):
    for opening in scene.openings:
        assert scene.truth.distance(opening.interpolate(0.0, normalized=True)) < 0.05


def test_a_large_flat_has_a_core_that_no_scanner_entered():
    scene = LIVED_IN["flat"](seed=1)
    enclosed = [box(*ring.bounds) for part in scene.truth.geoms for ring in part.interiors]
    assert len(enclosed) >= 1


def test_rays_pass_through_glass_as_often_as_it_says():
    wall = Prism(box(4, -5, 4.2, 5), 3.0)
    pane = Prism(box(2, -5, 2.02, 5), 3.0, material="glass", passing=0.8)
    points = Scene("test", (wall, pane), np.array([[0.0, 0.0, 1.5]])).scan(1.0, range_noise=0.0).points
    # In the same directions the wall behind is seen.
    x, y, z = (points - [0.0, 0.0, 1.5]).T
    ahead = (x > 0) & (np.abs(y) < 0.3 * x) & (np.abs(z) < 0.3 * x)
    on_pane = np.abs(x[ahead] - 2.0) < 0.03
    assert on_pane.mean() == pytest.approx(0.2, abs=0.06)


def test_a_mirror_returns_the_room_behind_itself():
    front = Mirror((2.0, -0.5), (2.0, 0.5), 0.5, 2.0)
    room = np.array([[-1.0, 0.0, 1.2], [1.0, 0.0, 1.2], [3.0, 0.0, 1.2]])
    images = front.images(np.array([0.0, 0.0, 1.5]), room)
    # The room is on the left of the front, here at smaller x.
    assert images == pytest.approx(np.array([[5.0, 0.0, 1.2], [3.0, 0.0, 1.2]]))


def test_the_second_pass_of_a_hand_held_scan_is_three_centimetres_off():
    scene = LIVED_IN["handheld"](seed=0)
    apart = np.hypot(*(scene.drifts[-1] - scene.drifts[0])[:2])
    assert apart == pytest.approx(0.03)
    assert scene.range_noise > 0.01


def test_a_loft_has_no_ceiling():
    scene = LIVED_IN["loft"](seed=0)
    points = scene.scan(COARSE, seed=0).points
    assert points[:, 2].max() < 3.7
    middle = np.hypot(*(points[:, :2] - np.array(scene.truth.centroid.coords[0])).T) < 2
    assert points[middle, 2].max() < 3.7


def test_partitions_of_an_office_are_thinner_than_its_points_are_close():
    scene = LIVED_IN["office"](seed=1)
    corridor = scene.rooms[0]
    for room in scene.rooms[1:]:
        assert 0.07 < room.distance(corridor) < 0.13
    assert scene.thinned > 0.05


def test_a_thinned_cloud_has_one_point_in_each_cube():
    wall = Prism(box(4, -5, 4.2, 5), 3.0)
    scene = Scene("test", (wall,), np.array([[0.0, 0.0, 1.5]]))
    every = scene.scan(0.5, range_noise=0.0)
    thin = replace(scene, thinned=0.2).scan(0.5, range_noise=0.0)
    cubes = np.floor((thin.points - every.points.min(axis=0)) / 0.2)
    assert len(np.unique(cubes, axis=0)) == len(thin.points) == len(thin.intensity) == len(thin.station)
    assert len(thin.points) < len(every.points) / 4


def test_the_cell_of_a_depot_has_a_ceiling_of_its_own():
    scene = LIVED_IN["depot"](seed=3)
    cell = scene.rooms[2]
    assert cell.area < 8
    scan = scene.scan(COARSE, seed=0)
    x, y, z = scan.points.T
    over = (np.hypot(x - cell.centroid.x, y - cell.centroid.y) < 0.3) & (z > 1.5)
    from_cell = scan.station == len(scene.stations) - 1
    assert z[over & from_cell].max() < 2.6 < z[over & ~from_cell].max() - 1.0


def test_a_flight_rises_through_the_ceiling_of_a_terraced_house():
    scene = LIVED_IN["terraced_house"](seed=0)
    points = scene.scan(COARSE, seed=0).points
    assert points[:, 2].max() > 5.0
    hall = scene.doubtful_rooms[0]
    above = points[points[:, 2] > 3.0]
    from_hall = [hall.buffer(1.5).contains(Point(x, y)) for x, y, _ in above]
    assert np.mean(from_hall) > 0.9


def test_furniture_stands_clear_of_doors_and_of_other_furniture():
    room = Room(box(0, 0, 4, 3), 2.7, doorways=[box(0, 0, 1, 1)])
    random = np.random.default_rng(0)
    things = [prism for _ in range(5) for prism in bookcase(random, room)]
    assert len(things) >= 2
    for number, thing in enumerate(things):
        assert not thing.footprint.intersects(box(0, 0, 1, 1))
        assert not any(thing.footprint.intersects(other.footprint) for other in things[number + 1 :])


def test_only_furniture_that_reaches_the_ceiling_may_be_taken_for_wall():
    random = np.random.default_rng(0)
    for _ in range(20):
        (case,) = bookcase(random, Room(box(0, 0, 5, 5), 2.7))
        assert (case.material == "fitted") == (case.top > 2.65)
        scene = Scene("test", (case,), np.array([[2.5, 2.5, 1.5]]))
        assert len(scene.fitted) == (case.material == "fitted")


def test_at_a_window_parapet_reveals_and_pane_may_be_drawn():
    ends = (Prism(box(0, 0, 2, 0.4), 2.7), Prism(box(3, 0, 5, 0.4), 2.7))
    parapet, pane = Prism(box(2, 0, 3, 0.4), 0.9), Prism(box(2, 0.2, 3, 0.22), 2.2, 0.9, "glass")
    scene = Scene("test", (*ends, parapet, pane), np.array([[2.5, -2.0, 1.5]]))
    for line in ([(2, 0), (3, 0)], [(2, 0), (2, 0.4)], [(2, 0.2), (3, 0.2)]):
        assert LineString(line).difference(scene.faces.buffer(1e-5)).is_empty
    assert scene.truth.boundary.distance(Point(2, 0.2)) > 0.1


def test_a_curtain_hangs_in_folds():
    cloth = curtain(np.random.default_rng(0), LineString([(0, 0), (2, 0)]), 2.4)
    south, north = cloth.footprint.bounds[1::2]
    assert 0.05 < north - south < 0.09
    assert cloth.passing > 0
