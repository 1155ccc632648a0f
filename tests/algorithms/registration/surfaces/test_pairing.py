"""Which patches of two scans are the same surface."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.surfaces.pairing import Placed, paired
from ichnograph.algorithms.registration.surfaces.settings import PairSettings
from ichnograph.tests.algorithms.registration.surfaces.rooms import frame, pose, room, surfaces_in
from ichnograph.tests.scenes.surface_rooms import box

HERE, THERE = frame(20, (2.0, 2.0, 1.5)), frame(130, (4.0, 3.0, 1.7), (1.0, -2.0))


def placed(matrix, faces, shift=(0.0, 0.0, 0.0), station=None, seed=0, error=0.0):
    station = matrix[:3, 3] if station is None else station
    return Placed(surfaces_in(matrix, faces, station, seed, error), pose(matrix, shift))


def tie(one, other, gate=0.25):
    return paired(one, other, (0, 1), gate, PairSettings())


def test_a_room_seen_from_two_stations_is_the_same_surface():
    found = tie(placed(HERE, room()), placed(THERE, room(), seed=1))

    assert found.overlap > 0.9
    assert len(found) > 100
    assert found.rms(pose(HERE), pose(THERE)) < 1e-6


def test_distances_are_along_the_normals_from_the_second_scan_to_the_first():
    shift = np.array([0.01, -0.02, 0.03])
    one, other = placed(HERE, room(), shift), placed(THERE, room(), seed=1)
    found = tie(one, other)

    np.testing.assert_allclose(
        found.distances(one.pose, other.pose), found.directions(one.pose, other.pose) @ shift, atol=1e-6
    )


def test_the_faces_of_a_partition_seen_from_both_sides_are_not_partners():
    # Within the gate of each other, but turned away from each other.
    next_door = room(low=(6.1, 0.0, 0.0))
    station = np.array([9.0, 2.0, 1.5])
    found = tie(placed(HERE, room()), placed(frame(0, station), next_door, station=station))

    assert found is None


def test_things_that_were_moved_are_trimmed():
    before = room() + box([1, 1, 0], [2, 2, 1.5]) + box([4, 3, 0], [5, 4, 2])
    after = room() + box([1.05, 1.08, 0], [2.05, 2.08, 1.5]) + box([4.1, 2.9, 0], [5.1, 3.9, 2])
    one, other = placed(HERE, before, error=0.001), placed(THERE, after, seed=1, error=0.001)
    found = tie(one, other)

    assert np.abs(found.distances(one.pose, other.pose)).max() < 0.012


def test_scans_that_share_little_are_not_tied():
    assert tie(placed(HERE, room()), placed(THERE, room(low=(40.0, 0.0, 0.0)))) is None


def test_the_scatter_of_the_patches_is_their_standard_deviation():
    one, other = placed(HERE, room(), error=0.002), placed(THERE, room(), seed=1, error=0.002)
    found = tie(one, other)

    assert np.sqrt(np.median(found.variances)) == pytest.approx(0.002 * np.sqrt(2), rel=0.4)


def test_exchanged_scans_give_the_same_pairs():
    one, other = placed(HERE, room(), error=0.001), placed(THERE, room(), seed=1, error=0.001)
    forth, back = tie(one, other), paired(other, one, (1, 0), 0.25, PairSettings())

    assert forth.overlap == back.overlap
    assert forth.rms(one.pose, other.pose) == pytest.approx(back.rms(other.pose, one.pose), rel=0.1)
