"""The planes of a facade: apart from each other and from what stands before them."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.errors import NothingFoundError
from ichnograph.algorithms.facade.planes.front import EAST, WEST
from ichnograph.algorithms.facade.planes.segmentation import find_planes
from ichnograph.algorithms.facade.planes.settings import PlaneSettings
from ichnograph.tests.algorithms.facade.samples import bare, lattice, upright
from ichnograph.tests.scenes.facades import FACADES

DISTANCE = 0.05


def street(step=0.03):
    uv = lattice(-2, -8, 8, 0, step)
    return np.column_stack([uv, np.zeros(len(uv))])


def side_wall(step=0.03):
    uv = lattice(-1.5, 0, 0, 4, step)
    return np.column_stack([np.full(len(uv), 6.0), uv])


def tree(count=5000):
    return np.random.default_rng(1).normal((2.0, -2.0, 2.0), 0.5, (count, 3))


def site():
    """Return a wall, a panel before it, street, side wall and tree, and which is which from 0."""
    parts = [upright(6, 4), upright(1.5, 0.8, w=0.12, seed=1) + (2, 0, 1), street(), side_wall(), tree()]
    return np.concatenate(parts), np.repeat(np.arange(len(parts)), [len(part) for part in parts])


def test_the_largest_upright_plane_is_the_main_one_even_beside_a_larger_street():
    xyz, which = site()
    found = find_planes(bare(xyz), DISTANCE)

    assert np.sum(which == 2) * 0.03**2 > np.sum(which == 0) * 0.02**2
    assert abs(found.planes[0].normal @ (0, -1, 0)) > 0.99999
    assert np.mean(found.labels[which == 0] == 1) > 0.97


def test_street_side_wall_and_tree_are_outside_the_planes_of_the_facade():
    xyz, which = site()
    labels = find_planes(bare(xyz), DISTANCE).labels
    away = np.abs(xyz[:, 1]) > 2 * DISTANCE

    assert (labels[away & (which == 2)] < 0).mean() > 0.99
    assert (labels[away & (which == 3) & (xyz[:, 2] > 0.1)] < 0).mean() > 0.99
    assert (labels[(which == 4)] > 0).mean() < 0.01


@pytest.mark.parametrize(("side", "east"), [(EAST, 1), (WEST, -1)])
def test_a_given_side_is_taken(side, east):
    xyz, _ = site()
    turned = np.column_stack([-xyz[:, 1], xyz[:, 0], xyz[:, 2]])
    found = find_planes(bare(turned), DISTANCE, side=side)

    assert found.planes[0].normal @ (east, 0, 0) > 0.999


def test_the_position_of_the_scanner_decides_the_side():
    xyz, _ = site()
    for y in (-9.0, 9.0):
        points = replace(bare(xyz), stations=np.array([(3.0, y, 1.7)]))
        assert np.sign(find_planes(points, DISTANCE).planes[0].normal[1]) == np.sign(y)


def test_a_panel_before_the_wall_is_a_plane_of_its_own():
    xyz, which = site()
    found = find_planes(bare(xyz), DISTANCE)

    assert len(found.planes) == 2
    assert np.mean(found.labels[which == 1] == 2) > 0.95
    assert found.planes[0].distances(found.planes[1].centre) == pytest.approx(0.12, abs=0.001)


def test_planes_6_cm_apart_stay_two():
    xyz = np.concatenate([upright(6, 4), upright(2, 2, w=0.06, seed=1) + (2, 0, 1)])
    found = find_planes(bare(xyz), DISTANCE)

    assert len(found.planes) == 2
    assert found.planes[0].rms < 0.0015 and found.planes[1].rms < 0.0015
    between = found.planes[0].distances(found.planes[1].centre)
    assert abs(between) == pytest.approx(0.06, abs=0.001)


def test_a_narrow_string_course_does_not_lean_towards_windows_below():
    frames = [upright(1, 0.5, w=-0.15, seed=seed) + (x, 0, 1.0) for seed, x in ((2, 1), (3, 4))]
    wall = upright(6, 4)
    seen = ~((wall[:, 2] > 1) & (wall[:, 2] < 1.5) & (np.abs(wall[:, 0] % 3 - 1.5) < 0.5))
    course = upright(6, 0.16, w=0.07, seed=1) + (0, 0, 2.3)
    found = find_planes(bare(np.concatenate([wall[seen], course, *frames])), DISTANCE)

    before = [plane for plane in found.planes if abs(plane.centre[2] - 2.38) < 0.02]
    assert len(before) == 1
    assert before[0].normal @ found.planes[0].normal > np.cos(2e-3)
    assert before[0].rms < 0.0015


@settings(max_examples=10, deadline=None)
@given(distance=st.floats(0.01, 0.1), noise=st.floats(0.0, 0.02))
def test_no_point_is_farther_from_its_plane_than_the_distance(distance, noise):
    xyz = np.concatenate([upright(3, 3, noise=noise, step=0.03), tree(500)])
    found = find_planes(bare(xyz), distance)

    for number, plane in enumerate(found.planes, start=1):
        own = np.abs(plane.distances(xyz[found.labels == number]))
        assert own.max() <= distance + 1e-9
        assert plane.rms == pytest.approx(np.sqrt(np.mean(own**2)))
        assert plane.points == len(own)


def test_the_order_of_the_points_does_not_matter():
    xyz, _ = site()
    order = np.random.default_rng(5).permutation(len(xyz))
    found, shuffled = find_planes(bare(xyz), DISTANCE), find_planes(bare(xyz[order]), DISTANCE)

    assert np.mean(shuffled.labels == found.labels[order]) == 1.0
    assert found.planes[0].normal @ shuffled.planes[0].normal == pytest.approx(1, abs=1e-14)


@pytest.mark.parametrize("angle", [17, 90, 200])
def test_a_turned_site_has_the_turned_planes(angle):
    xyz, _ = site()
    turn = np.radians(angle)
    rotation = np.array([[np.cos(turn), -np.sin(turn), 0], [np.sin(turn), np.cos(turn), 0], [0, 0, 1]])
    found, turned = find_planes(bare(xyz), DISTANCE), find_planes(bare(xyz @ rotation.T), DISTANCE)

    assert len(turned.planes) == len(found.planes)
    for plane, other in zip(found.planes, turned.planes):
        assert other.normal @ rotation @ plane.normal > np.cos(2e-4)


def test_planes_of_a_simulated_facade_at_grid_coordinates_are_those_that_were_built():
    scene = FACADES["medina"](0).moved(31, (412345.67, 5812345.71, 71.3))
    scan = scene.scan(0.02)
    origin = np.floor(scan.points.min(axis=0))
    found = find_planes(bare(scan.points - origin, origin), DISTANCE)
    frame = scene.frame
    depths = [frame.local(plane.centre[None], origin)[0, 2] for plane in found.planes]

    assert depths[0] == pytest.approx(0, abs=0.001)
    assert found.planes[0].normal @ frame.axes[2] > np.cos(2e-4)
    for true in scene.details:
        if true.kind == "projection" or true.outline.bounds[1] == 0:
            assert min(abs(depth - true.depth) for depth in depths) < 0.004


def test_planes_are_numbered_by_their_points_and_the_small_ones_left_out():
    xyz = np.concatenate([
        upright(6, 4), upright(1, 1, w=0.15, seed=1) + (1, 0, 1), upright(2, 1, w=0.3, seed=2) + (3, 0, 1)
    ])  # fmt: skip
    found = find_planes(bare(xyz), DISTANCE)
    assert [plane.points for plane in found.planes[1:]] == sorted(
        (plane.points for plane in found.planes[1:]), reverse=True
    )
    assert len(found.planes) == 3
    assert len(find_planes(bare(xyz), DISTANCE, PlaneSettings(min_points=3000)).planes) == 2
    assert len(find_planes(bare(xyz), DISTANCE, PlaneSettings(max_planes=1)).planes) == 1


def test_level_ground_is_not_a_facade():
    with pytest.raises(NothingFoundError, match="No upright plane"):
        find_planes(bare(street()), DISTANCE)


def test_coordinates_in_millimetres_are_named_as_the_reason():
    with pytest.raises(NothingFoundError, match="millimetres"):
        find_planes(bare(1000 * upright(3, 3)), DISTANCE)
