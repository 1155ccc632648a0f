"""Plane cells of a scan."""

import numpy as np
import pytest
from ichnograph.algorithms.clouds.cloud import open_scans
from ichnograph.algorithms.registration.surfaces.patches import read_surfaces, surfaces_of
from ichnograph.tests.scenes.surface_rooms import box, seen


def wall(step=0.03, noise=0.002, seed=0, height=2.0):
    """Points of a wall in the plane y = 3."""
    x, z = (axis.ravel() for axis in np.meshgrid(np.arange(-2, 2, step), np.arange(0, height, step)))
    y = 3.03 + np.random.default_rng(seed).normal(0, noise, x.size)
    return np.column_stack([x, y, z])


def test_a_wall_is_plane_cells_with_normals_towards_the_scanner():
    found = surfaces_of([wall()]).seen_from(np.zeros(3))

    assert len(found) == pytest.approx(4 * 2 / 0.2**2, abs=12)
    assert found.facing
    np.testing.assert_allclose(found.normals, np.broadcast_to([0, -1, 0], found.normals.shape), atol=0.002)
    scatter = (found.centres[:, 1] - 3.03) / np.sqrt(found.variances)
    assert np.std(scatter) == pytest.approx(1.0, abs=0.2)


def test_cells_of_one_wall_have_one_normal_so_that_noise_holds_nothing_along_it():
    found = surfaces_of([wall(noise=0.003)])

    assert np.ptp(found.normals[:, 0]) < 1e-12


def test_a_curved_wall_keeps_the_normals_of_its_cells():
    angle, z = (axis.ravel() for axis in np.meshgrid(np.linspace(0, np.pi, 400), np.arange(0, 2, 0.03)))
    found = surfaces_of([np.column_stack([4 * np.cos(angle), 4 * np.sin(angle), z])])
    outwards = found.centres * [1, 1, 0] / np.linalg.norm(found.centres[:, :2], axis=1)[:, None]

    assert (np.abs(np.einsum("ij,ij->i", outwards, found.normals)) > 0.99).all()


def test_foliage_is_not_plane():
    assert not len(surfaces_of([np.random.default_rng(0).uniform(0, 2, (20_000, 3))]))


def test_cells_that_hold_the_edge_of_something_before_the_wall_are_left_out():
    board = wall() * [0.1, 1, 0.5] - [0, 0.03, 0]
    found = surfaces_of([wall(), board])

    off = np.abs(found.centres[:, 1, None] - [3.03, 3.0]).min(axis=1)
    assert off.max() < 0.003


def test_sparse_points_give_larger_cells():
    dense, sparse = surfaces_of([wall()]), surfaces_of([wall(step=0.12)])

    assert set(dense.edges) == {0.2}
    assert sparse.edges.min() == 0.4


def test_an_origin_far_from_the_points_was_not_the_scanner():
    assert surfaces_of([wall()]).can_be_seen_from(np.zeros(3))
    assert not surfaces_of([wall() + [5000, 0, 0]]).can_be_seen_from(np.zeros(3))


def test_a_file_whose_origin_is_in_the_next_room_does_not_show_its_scanner(tmp_path):
    path, station = tmp_path / "room.xyz", np.array([9.0, 2.0, 1.5])
    np.savetxt(path, seen(box((6.1, 0, 0), (12, 5, 3)), station, step_deg=1.2) + station, fmt="%.4f")
    (source,) = open_scans([path]).sources

    assert not read_surfaces(source).facing


def test_a_scanner_that_the_file_states_is_believed(tmp_path):
    # The wall that is nearer to the origin hides the other from it, but not from the scanner between them.
    points = np.concatenate([wall(), wall() + [0, 2, 0]])
    rows = "\n".join(f"{x:.4f} {y:.4f} {z:.4f} 0.5" for x, y, z in points - [0, 4, 0])
    axes = "1 0 0\n0 1 0\n0 0 1"
    pose = "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 4 0 1"
    path = tmp_path / "walls.ptx"
    path.write_text(f"{len(points)}\n1\n0 4 0\n{axes}\n{pose}\n{rows}\n")
    (source,) = open_scans([path]).sources
    found = read_surfaces(source)

    assert found.facing
    np.testing.assert_array_equal(found.normals[:, 1] > 0, found.centres[:, 1] < 4)


def test_the_order_of_the_points_does_not_matter():
    points = wall()
    one, other = surfaces_of([points]), surfaces_of([points[::-1]])

    np.testing.assert_array_equal(one.centres, other.centres)
    np.testing.assert_array_equal(one.normals, other.normals)


def test_a_file_is_read_in_its_own_coordinates(tmp_path):
    path = tmp_path / "wall.xyz"
    np.savetxt(path, wall(), fmt="%.4f")
    (source,) = open_scans([path]).sources
    found = read_surfaces(source)

    assert found.facing
    assert found.centres[:, 1] == pytest.approx(3.03, abs=0.003)
    assert (found.normals[:, 1] < 0).all()


def test_the_mirror_image_of_surfaces_faces_its_scanner():
    found = surfaces_of([wall()]).seen_from(np.array([0.0, 2.0, 0.0])).mirrored()
    towards = found.station - found.centres

    assert found.station == pytest.approx([0.0, -2.0, 0.0])
    assert (np.einsum("ij,ij->i", towards, found.normals) > 0).all()
