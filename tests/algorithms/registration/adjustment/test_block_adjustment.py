"""The adjustment of all scans in one block."""

import numpy as np
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.settings import Settings
from ichnograph.tests.algorithms.registration.hall import (
    ANNEX,
    GRID,
    HALL,
    labels,
    listed,
    scanned,
    several_scans,
)


def test_outliers_never_leave_a_scan_of_the_block_without_support():
    # Seen by two scans each, these points carry the second scan; blunders make all of them suspicious.
    places = np.concatenate([HALL, ANNEX])
    first, _ = scanned(places, noise=0.002, seed=1)
    second, _ = scanned(ANNEX, heading=200, noise=0.002, seed=2)
    second[:2] += [[0.012, 0, 0], [0, -0.012, 0]]
    registration = register_scans(
        listed("control", HALL), [listed("a", first), listed("b", second)], Settings(sigma=0.001)
    )

    for scan in registration.registered:
        assert len(labels(scan)) >= 3


def test_surveyed_points_never_move_unless_they_have_a_standard_deviation():
    seen = several_scans()
    scans = [listed(name, xyz) for name, (xyz, _) in seen.items()]
    control = listed("control", HALL + GRID)
    held = register_scans(control, scans)
    moved = register_scans(control, scans, Settings(control_sigma=0.002))

    for point, given_place in zip(held.points, HALL + GRID):
        assert np.array_equal(point.position, given_place)
        assert not point.covariance.any()
    shifts = [np.abs(point.position - place).max() for point, place in zip(moved.points, HALL + GRID)]
    assert 0 < max(shifts) < 0.004
    assert all(0 < np.sqrt(point.covariance[0, 0]) < 0.002 for point in moved.points[: len(HALL)])
