"""The order in which scans are registered."""

import numpy as np
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.settings import Matching, Settings
from ichnograph.tests.algorithms.registration.hall import (
    ANNEX,
    GRID,
    HALL,
    TOWER,
    labels,
    listed,
    several_scans,
)

BY_NAMES = Settings(matching=Matching.NAMES)


def test_the_order_of_scans_is_found():
    seen = several_scans()
    scans = [listed(name, seen[name][0]) for name in "cba"]
    registration = register_scans(listed("control", HALL + GRID, prefix="P"), scans)

    assert [scan.round for scan in registration.scans] == [3, 2, 1]
    for scan in registration.scans:
        expected = seen[scan.name][1]
        assert np.abs(scan.matrix[:3, 3] - expected[:3, 3] - GRID).max() < 0.01
    appended = [point for point in registration.points if not point.surveyed]
    assert len(appended) == len(ANNEX) + len(TOWER)
    assert {point.origin for point in appended} == {"a", "b"}
    assert all(len(point.scans) == 2 for point in appended)


def test_scans_share_names_of_targets_that_were_not_surveyed():
    seen = several_scans()
    names = {
        "a": [f"P{n}" for n in range(8)] + [f"A{n}" for n in range(6)],
        "b": [f"A{n}" for n in range(6)] + [f"T{n}" for n in range(6)],
        "c": [f"T{n}" for n in range(6)],
    }
    scans = [listed(name, seen[name][0], names[name]) for name in "cab"]
    registration = register_scans(listed("control", HALL, names["a"][:8]), scans, BY_NAMES)

    assert all(scan.registered for scan in registration.scans)
    assert labels(registration.scans[0]) == {f"T{n}": f"b:T{n}" for n in range(6)}
