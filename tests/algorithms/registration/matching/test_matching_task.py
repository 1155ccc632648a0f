"""The task of matching: which targets may match which points."""

import numpy as np
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.tests.algorithms.registration.hall import HALL, labels, listed, scanned


def test_control_points_at_one_place_are_used_once():
    control = np.concatenate([HALL, HALL[2:3] + 0.004])
    registration = register_scans(listed("control", control, prefix="P"), [listed("scan", scanned(HALL)[0])])

    assert len(labels(registration.scans[0])) == 8
    assert any("P3 and P9" in warning or "P9 and P3" in warning for warning in registration.warnings)
