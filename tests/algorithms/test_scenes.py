"""The simulator that other tests rely on: what it returns is where its truth says."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.tests.scenes import SCENES, Scene
from ichnograph.tests.scenes.things import Ground, Plant, Prism
from shapely.geometry import LineString, Point, box

COARSE = 2.0


def hundredths(low, high):
    return st.integers(low, high).map(lambda number: number / 100)


def scene_of(*prisms, scanners=((0.0, 0.0, 1.6),), **more):
    return Scene("test", prisms, np.array(scanners), **more)


def block_at(x, y, size, **more):
    return Prism(box(x - size / 2, y - size / 2, x + size / 2, y + size / 2), **more)


def distances(points, boundary):
    return np.array([boundary.distance(Point(x, y)) for x, y in points[:, :2]])


def off_the_ground(points):
    return points[(points[:, 2] > 0.2) & (points[:, 2] < 1.9)]


@pytest.fixture(params=sorted(SCENES))
def scene(request):
    return SCENES[request.param](seed=1)


def test_noise_free_wall_points_lie_exactly_on_the_true_boundary():
    scene = scene_of(block_at(5, 1, 2, top=3.0), block_at(-4, 2, 1, top=2.5))
    points = off_the_ground(scene.scan(COARSE, range_noise=0.0).points)
    assert len(points) > 50
    assert distances(points, scene.truth.boundary).max() < 1e-6


def test_wall_points_scatter_about_the_true_boundary_by_the_range_noise():
    scene = scene_of(Prism(box(5, -20, 6, 20), top=3.0))
    points = scene.scan(0.5, range_noise=0.01).points
    frontal = points[(np.abs(points[:, 1]) < 1) & (points[:, 2] > 0.3) & (points[:, 2] < 2.5)]
    assert frontal[:, 0].mean() == pytest.approx(5.0, abs=0.002)
    assert frontal[:, 0].std() == pytest.approx(0.01, rel=0.2)


@settings(max_examples=25, deadline=None)
@given(
    x=hundredths(200, 2000),
    y=hundredths(-2000, 2000),
    size=hundredths(20, 300),
    top=hundredths(30, 500),
    slope=hundredths(-10, 10),
)
def test_nothing_returns_from_within_a_prism_or_below_the_ground(x, y, size, top, slope):
    ground = Ground(slope_x=slope, roughness=0.0)
    wall = block_at(x, y, size, top=ground.height(x, y) + top)
    points = scene_of(wall, ground=ground).scan(COARSE, range_noise=0.0).points
    assert (points[:, 2] > ground.height(points[:, 0], points[:, 1]) - 1e-9).all()
    inner = wall.footprint.buffer(-1e-6).bounds
    within = ((points[:, :2] > inner[:2]) & (points[:, :2] < inner[2:])).all(axis=1)
    assert (points[within, 2] > wall.top - 1e-9).all()


def test_a_wall_behind_a_higher_wall_is_neither_hit_nor_seen():
    front, hidden = Prism(box(3, -4, 3.3, 4), top=3.0), Prism(box(6, -2, 6.3, 2), top=2.0)
    scan = scene_of(front, hidden).scan(COARSE)
    assert scan.seen_boundary.distance(hidden.footprint) > 1
    shadow = scan.points[(scan.points[:, 0] > 3.4) & (np.abs(scan.points[:, 1]) < 4)]
    assert len(shadow) == 0
    assert front.footprint.boundary.buffer(1e-6).contains(scan.seen_boundary)


def test_only_the_faces_towards_the_scanner_are_seen():
    scene = scene_of(block_at(5, 0, 1, top=3.0))
    face = LineString([(4.5, -0.5), (4.5, 0.5)])
    assert scene.scan(0.5).seen_boundary.equals(face)


def test_a_ring_wall_around_the_scanner_is_seen_all_around_inside():
    inner = Point(0, 0).buffer(3.0)
    ring = Point(0, 0).buffer(3.6).difference(inner)
    seen = scene_of(Prism(ring, top=3.0)).scan(0.5).seen_boundary
    assert seen.length == pytest.approx(inner.length)


def test_the_top_of_a_wall_lower_than_the_scanner_is_hit():
    wall = Prism(box(3, -2, 3.6, 2), top=1.0)
    points = scene_of(wall).scan(0.5, range_noise=0.0).points
    on_top = points[np.abs(points[:, 2] - 1.0) < 1e-9]
    assert len(on_top) > 20
    assert distances(on_top, wall.footprint).max() < 1e-9


def test_rays_pass_below_a_lintel_and_hit_its_lower_face():
    lintel = Prism(box(2, -2, 2.5, 2), top=3.0, bottom=2.1, material="lintel")
    behind = Prism(box(6, -3, 6.3, 3), top=3.0)
    points = scene_of(lintel, behind).scan(0.5, range_noise=0.0).points
    assert (np.abs(points[:, 2] - 2.1) < 1e-9).any()
    assert (np.abs(points[:, 0] - 6.0) < 1e-9).any()
    assert not ((np.abs(points[:, 0] - 2.0) < 1e-9) & (points[:, 2] < 2.1 - 1e-9)).any()


def test_a_ceiling_over_the_scanner_closes_the_sky():
    points = scene_of(block_at(0, 0, 8, top=3.0, bottom=2.8, material="slab")).scan(COARSE).points
    assert points[:, 2].max() == pytest.approx(2.8, abs=0.02)


@pytest.mark.parametrize("density", [0.1, 0.4])
def test_foliage_stops_rays_with_exponential_free_paths(density):
    bush = Plant((6.0, 0.0, 1.6), (2.0, 2.0, 2.0), density)
    wall = Prism(box(10, -0.35, 10.3, 0.35), top=2.0)
    scene = scene_of(wall, plants=(bush,))
    x, y, z = scene.scan(0.1).points.T
    through_the_middle = (np.abs(y) < 0.03 * x) & (np.abs(z - 1.6) < 0.03 * x)
    assert (x[through_the_middle] > 9.9).mean() == pytest.approx(np.exp(-density * 4.0), abs=0.05)


def test_the_ground_slopes_undulates_and_is_rough():
    ground = Ground(0.08, -0.03, undulation=0.05, roughness=0.005)
    scene = scene_of(block_at(90, 0, 1, top=9.0), ground=ground)
    points = scene.scan(COARSE, range_noise=0.0).points
    x, y, z = points[points[:, 0] < 50].T
    residual = z - ground.height(x, y) - ground.lift(x, y)
    assert residual.std() == pytest.approx(0.005, rel=0.1)
    assert np.abs(residual).max() < 0.03


def test_rough_masonry_is_smooth_over_centimetres_about_its_mean_face():
    scene = scene_of(Prism(box(5, -20, 6, 20), top=3.0, relief=0.02))
    points = scene.scan(0.25, range_noise=0.0).points
    face = points[(np.abs(points[:, 1]) < 8) & (points[:, 2] > 0.3) & (points[:, 2] < 2.9)]
    assert face[:, 0].mean() == pytest.approx(5.0, abs=0.005)
    assert face[:, 0].std() == pytest.approx(0.02, rel=0.3)
    frontal = face[np.abs(face[:, 1]) < 1]
    apart = np.linalg.norm(frontal[:, None, 1:] - frontal[None, :, 1:], axis=2)
    steps = np.abs(frontal[:, None, 0] - frontal[None, :, 0])
    assert steps[(apart < 0.03)].max() < 0.03


def test_a_leaning_wall_is_where_its_footprint_says_at_the_height_of_the_plan():
    scene = scene_of(Prism(box(5, -20, 6, 20), top=3.0, lean=(0.02, 0.0)))
    x, y, z = scene.scan(0.5, range_noise=0.0).points.T
    face = (np.abs(y) < 5) & (z > 0.1) & (z < 2.9)
    np.testing.assert_allclose(x[face], 5 + 0.02 * (z[face] - 1.3), atol=1e-9)


def test_what_stands_on_the_terrace_is_higher():
    walls = Prism(box(-1, 5, 1, 6), top=2.0), Prism(box(-1, -6, 1, -5), top=2.0)
    points = scene_of(*walls, ground=Ground(terrace=0.9, terrace_from=3.0)).scan(0.5, 0.0).points
    assert points[points[:, 1] > 5, 2].max() == pytest.approx(2.9, abs=0.05)
    assert points[points[:, 1] < -5, 2].max() == pytest.approx(2.0, abs=0.05)
    assert points[(points[:, 1] > 3.5) & (points[:, 1] < 4.9), 2].mean() == pytest.approx(0.9, abs=0.01)


def test_stations_may_be_left_out_and_the_others_return_the_same(scene):
    whole, part = scene.scan(4.0), scene.scan(4.0, without=(0, 2))
    kept = ~np.isin(whole.station, (0, 2))
    np.testing.assert_array_equal(part.points, whole.points[kept])
    np.testing.assert_array_equal(part.station, whole.station[kept])
    assert part.seen_boundary.length < whole.seen_boundary.length


def test_nothing_returns_from_beyond_the_range_unless_reflected(scene):
    scan = scene.scan(COARSE, range_noise=0.0)
    reach = np.linalg.norm(scan.points - scene.stations[scan.station], axis=1)
    beyond = reach > scene.max_range + 0.2
    assert beyond.mean() < 5 * scene.ghosts + 1e-12
    assert reach.max() < 501


def test_far_reflections_have_the_share_the_scene_asks_for():
    walls = [Prism(box(-4, -4, 4, 4).difference(box(-3, -3, 3, 3)), top=4.0)]
    ceiling = block_at(0, 0, 8, top=5.0, bottom=4.0, material="slab")
    points = scene_of(*walls, ceiling, ghosts=0.01).scan(1.0).points
    far = np.abs(points[:, :2]).max(axis=1) > 5
    from_prisms = (points[:, 2] > 0.1).sum() + (points[far, 2] < 0).sum()
    assert far.sum() / from_prisms == pytest.approx(0.01, rel=0.3)


@pytest.mark.parametrize("rise, found", [(0.85, True), (0.75, False), (0.08, False)])
def test_only_walls_that_rise_high_above_local_ground_are_truth(rise, found):
    ground = Ground(slope_x=0.1)
    wall = block_at(20, 0, 1, top=2.0 + rise)
    scene = scene_of(wall, ground=ground)
    assert scene.truth.area == pytest.approx(1.0 if found else 0.0)
    assert scene.footings.area == pytest.approx(0.0 if found else 1.0)


def test_furniture_is_not_truth():
    cupboard = block_at(5, 0, 1, top=2.0, material="furniture")
    scene = scene_of(cupboard)
    assert scene.truth.is_empty
    assert scene.scan(COARSE).seen_boundary.is_empty


def test_abutting_pieces_of_differing_height_are_one_true_wall():
    scene = scene_of(Prism(box(3, 0, 4, 0.5), top=1.0), Prism(box(4, 0, 6, 0.5), top=1.4))
    assert len(scene.truth.geoms) == 1
    assert scene.truth.area == pytest.approx(1.5)
    seen = scene_of(*scene.prisms, scanners=((1.0, -2.0, 1.6),)).scan(0.5).seen_boundary
    assert seen.within(scene.truth.boundary.buffer(1e-5))


def test_a_seed_gives_the_same_points_again_and_another_gives_others(scene):
    first, again = scene.scan(4.0, seed=3), scene.scan(4.0, seed=3)
    assert np.array_equal(first.points, again.points)
    assert np.array_equal(first.intensity, again.intensity)
    other = scene.scan(4.0, seed=4).points
    assert first.points.shape != other.shape or not np.array_equal(first.points, other)


def test_a_seed_gives_the_same_scene_again_and_another_varies_it(scene):
    make = SCENES[scene.name]
    assert make(1).truth.equals(scene.truth)
    assert not make(2).truth.equals(scene.truth)


def test_a_moved_scene_is_scanned_exactly_the_same(scene):
    angle, shift = 37.0, np.array([389_123.25, 5_820_456.5, 34.125])
    moved, turn = scene.moved(angle, shift), np.radians(angle)
    still, shifted = scene.scan(4.0), moved.scan(4.0)
    east = np.cos(turn) * still.points[:, 0] - np.sin(turn) * still.points[:, 1]
    north = np.sin(turn) * still.points[:, 0] + np.cos(turn) * still.points[:, 1]
    expected = np.column_stack([east, north, still.points[:, 2]]) + shift
    assert np.abs(shifted.points - expected).max() < 1e-6
    assert moved.truth.area == pytest.approx(scene.truth.area, abs=1e-6)
    back = moved.moved(0, -shift).moved(-angle, (0, 0, 0))
    assert back.truth.symmetric_difference(scene.truth).area < 1e-6
    assert np.abs(back.stations - scene.stations).max() < 1e-6
    assert shifted.seen_boundary.length == pytest.approx(still.seen_boundary.length, abs=1e-5)
    assert moved.truth.buffer(1e-4).contains(shifted.seen_boundary)


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("name", sorted(SCENES))
def test_every_scene_is_sound(name, seed):
    scene = SCENES[name](seed)
    assert scene.truth.is_valid
    assert all(wall.area > 0.01 for wall in scene.truth.geoms)
    assert all(prism.footprint.is_valid for prism in scene.prisms)
    assert len(scene.stations) >= 5
    for x, y, z in scene.scanners:
        assert 1.5 < z - scene.ground.height(x, y) < 1.8
        solids = [prism for prism in scene.prisms if prism.bottom < z and prism.rise(scene.ground) > 0.3]
        assert all(prism.footprint.distance(Point(x, y)) > 0.2 for prism in solids)


def test_a_scan_has_points_stations_and_intensities_and_sees_most_walls(scene):
    scan = scene.scan(1.0)
    count = len(scan.points)
    assert scan.points.shape == (count, 3)
    assert scan.points.dtype == np.float64
    assert scan.intensity.dtype == np.uint16
    assert scan.intensity.shape == scan.station.shape == (count,)
    assert set(scan.station) == set(range(len(scene.stations)))
    assert 0.1 < scan.seen_boundary.length / scene.truth.boundary.length <= 1.0
    assert scene.truth.boundary.buffer(1e-4).contains(scan.seen_boundary)
