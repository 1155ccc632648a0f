"""What a user should know about a scan that matches."""

from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.settings import Matching, Settings
from ichnograph.tests.algorithms.registration.hall import GRID, HALL, labels, listed, register, scanned

BY_NAMES = Settings(matching=Matching.NAMES)


def test_targets_in_one_plane_are_registered_with_a_warning_that_a_mirror_would_fit():
    floor = HALL * [1, 1, 0]
    scan = register(floor + GRID, scanned(floor)[0])

    assert scan.registered
    assert any("mirrored" in warning for warning in scan.warnings)


def test_wrong_names_are_a_warning():
    targets, _ = scanned(HALL, noise=0.001)
    names = [f"P{row + 1}" for row in range(8)]
    wrong = [*names[:2], "P6", *names[3:5], "P3", *names[6:]]
    scan = register_scans(listed("control", HALL, names), [listed("scan", targets, wrong)], BY_NAMES).scans[0]

    assert scan.registered
    assert labels(scan) == {name: name for name in names if name not in ("P3", "P6")}
    told = " ".join(scan.warnings)
    assert "Target P6 of scan lies" in told and "from P3: its name is wrong" in told
    assert {item.target for item in scan.correspondences if not item.used} == {"P3", "P6"}


def test_names_that_contradict_the_distances_are_a_warning():
    targets, _ = scanned(HALL)
    names = [f"P{row + 1}" for row in range(8)]
    scan = register_scans(
        listed("control", HALL, names), [listed("scan", targets, [*names[:6], "P8", "P7"])]
    ).scans[0]

    assert labels(scan)["P8"] == "P7"
    assert any("P8 is P7" in warning for warning in scan.warnings)
