"""The points that registered scans append."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.tests.algorithms.registration.hall import (
    ANNEX,
    HALL,
    listed,
    scanned,
)


def test_an_outlier_is_rejected_and_listed_and_does_not_become_a_control_point():
    targets, _ = scanned(HALL, noise=0.001)
    targets[4] += [0.0, 0.03, 0.0]
    registration = register_scans(listed("control", HALL, prefix="P"), [listed("scan", targets)])
    (scan,) = registration.scans

    (out,) = [item for item in scan.correspondences if not item.used]
    assert (out.target, out.control) == ("5", "P5")
    assert out.length == pytest.approx(0.03, abs=0.004)
    assert scan.unmatched == ()
    assert len(registration.points) == len(HALL)


def test_an_appended_point_never_takes_the_name_of_a_surveyed_one():
    names = [*map(str, range(1, 8)), "scan:9"]
    targets, _ = scanned(np.concatenate([HALL, ANNEX]), noise=0.001)
    registration = register_scans(listed("control", HALL, names), [listed("scan", targets)])

    known = [point.name for point in registration.points]
    assert len(known) == len(set(known)) == len(HALL) + len(ANNEX)
    assert "scan:9'" in known
