"""Real scans of a hall by a robot, tied by surfaces from poses that were only counted from its wheels."""

import zipfile
from pathlib import Path

import numpy as np
import pytest
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.settings import Settings
from ichnograph.algorithms.registration.surfaces.patches import surfaces_of
from ichnograph.tests.algorithms.registration.hall import listed
from scipy.spatial.transform import Rotation

HALL = Path(__file__).resolve().parents[5] / "shared" / "data" / "hall_3dtk_three_scans" / "dat.zip"
pytestmark = pytest.mark.skipif(not HALL.exists(), reason="the shared test data are not here")

TO_METRES = np.array([[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]) / 100
"""From centimetres in a left-handed frame with y up."""

NO_RETURN = 30.0
"""Points beyond are rays without an echo (m)."""

SIGMA = 0.05


def read(file, number):
    """Return the points of a scan (m), and the matrix of its pose."""
    points = np.loadtxt(file.open(f"scan00{number}.3d")) @ TO_METRES.T
    position, angles = np.loadtxt(file.open(f"scan00{number}.pose"))
    matrix = np.eye(4)
    turn = TO_METRES * 100
    matrix[:3, :3] = turn @ Rotation.from_euler("XYZ", angles, degrees=True).as_matrix() @ turn.T
    matrix[:3, 3] = TO_METRES @ position
    return points[np.linalg.norm(points, axis=1) < NO_RETURN], matrix


@pytest.fixture(scope="module")
def registered():
    """Return the scans by their targets, six as exact as the poses are, and tied by surfaces."""
    random = np.random.default_rng(0)
    places = random.uniform((0, -3, 0), (8, 3, 3), (6, 3))
    lists, surfaces = [], {}
    with zipfile.ZipFile(HALL) as file:
        for number in range(3):
            points, matrix = read(file, number)
            own = (places - matrix[:3, 3]) @ matrix[:3, :3] + random.normal(0, SIGMA, places.shape)
            lists.append(listed(f"s{number}", own))
            surfaces[f"s{number}"] = surfaces_of([points]).seen_from(np.zeros(3))
    return [
        register_scans(listed("control", places, prefix="P"), lists, Settings(sigma=SIGMA), surfaces=own)
        for own in ({}, surfaces)
    ]


def test_the_scans_of_a_robot_are_tied_by_the_surfaces_of_a_hall(registered):
    _, tied = registered

    assert {("s0", "s1"), ("s1", "s2")} <= {item.scans for item in tied.surfaces}
    for item in tied.surfaces:
        assert item.patches >= 12
        assert item.rms < 0.03


def test_surfaces_stay_within_what_the_targets_allow(registered):
    alone, tied = registered

    for before, after in zip(alone.scans, tied.scans):
        assert after.surfaces.used
        assert after.std < before.std
