"""Real scans tied by surfaces from rough poses, and placed by surfaces without any."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.settings import Settings
from ichnograph.tests.algorithms.registration.hall import listed
from ichnograph.tests.scenes.real_scans import HALL, hall_surfaces, room_surfaces

pytestmark = pytest.mark.skipif(not HALL.exists(), reason="the shared test data are not here")

SIGMA = 0.05


@pytest.fixture(scope="module")
def registered():
    """Return the scans by their targets, six as exact as the poses are, and tied by surfaces."""
    random = np.random.default_rng(0)
    places = random.uniform((0, -3, 0), (8, 3, 3), (6, 3))
    scans, matrices = hall_surfaces()
    lists, surfaces = [], {f"s{number}": scan for number, scan in enumerate(scans)}
    for number, matrix in enumerate(matrices):
        own = (places - matrix[:3, 3]) @ matrix[:3, :3] + random.normal(0, SIGMA, places.shape)
        lists.append(listed(f"s{number}", own))
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


def placed(surfaces):
    """Return the registration of scans without any target."""
    lists = [listed(name, np.zeros((0, 3))) for name in surfaces]
    return register_scans(listed("control", np.zeros((0, 3))), lists, Settings(), surfaces=surfaces)


def test_the_scans_of_a_robot_are_placed_without_targets_where_its_wheels_say():
    scans, matrices = hall_surfaces()
    surfaces = {f"s{number}": scan for number, scan in enumerate(scans)}

    for scan, matrix in zip(placed(surfaces).scans, matrices):
        assert scan.registered
        assert np.linalg.norm(scan.matrix[:3, 3] - matrix[:3, 3]) < 0.1


def test_two_scans_of_a_room_are_placed_by_their_surfaces():
    surfaces = {f"scan{number}": scan for number, scan in enumerate(room_surfaces(), start=1)}
    second = placed(surfaces).scans[1]

    assert second.placement.contradicting < 0.05 * second.placement.agreeing
    assert second.placement.next_share < 0.5
    assert second.matrix[:2, 3] == pytest.approx([1.97, 0.06], abs=0.05)
