"""Scans placed by their surfaces alone, or refused by name."""

from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.settings import Model, Settings
from ichnograph.tests.algorithms.registration.hall import listed
from ichnograph.tests.scenes.scanned_rooms import (
    ALONG,
    CORRIDOR,
    EMPTY,
    FURNISHED,
    OTHER,
    STATIONS,
    matrix_of,
    rooms_alike,
    surfaces_from,
)

NOTHING = np.zeros((0, 3))
SIGMA = 0.002


def scans(faces, stations, **chosen):
    """Return the surfaces of scans s0, s1 and so on; of one room, or of one for each."""
    of_each = faces if isinstance(faces[0], list) else [faces] * len(stations)
    return {
        f"s{number}": surfaces_from(own, place, number, **chosen)
        for number, (own, place) in enumerate(zip(of_each, stations))
    }


def registered(surfaces, control=NOTHING, targets=None, model=Model.LEVELLED):
    """Return the registration, with control points P1, P2 and so on and the targets of some scans."""
    lists = [listed(name, (targets or {}).get(name, NOTHING)) for name in surfaces]
    points = listed("control", control, prefix="P")
    return register_scans(points, lists, Settings(sigma=SIGMA, model=model), surfaces=surfaces)


def in_scan(places, stations, number):
    matrix = matrix_of(stations[number], number)
    noise = np.random.default_rng(number).normal(0, SIGMA, np.shape(places))
    return (np.asarray(places) - matrix[:3, 3]) @ matrix[:3, :3] + noise


def error(result, stations, number, first=0):
    """Return how far a scan is from its place, as the first one sees it (m)."""
    own, before = (matrix_of(stations[each], each) for each in (number, first))
    relative = np.linalg.inv(result.scans[first].matrix) @ result.scans[number].matrix
    return np.linalg.norm((relative - np.linalg.inv(before) @ own)[:3, 3])


@pytest.fixture(scope="module")
def furnished():
    return scans(FURNISHED, STATIONS)


@pytest.mark.parametrize("model", [Model.LEVELLED, Model.RIGID])
def test_without_any_target_scans_are_placed_in_the_frame_of_the_first(furnished, model):
    result = registered(furnished, model=model)
    first, second = result.scans

    assert first.is_frame
    assert first.matrix == pytest.approx(np.eye(4), abs=1e-9)
    assert error(result, STATIONS, 1) < 0.005
    assert second.placement.scans == ("s0",)
    assert second.placement.agreeing > 100
    assert second.placement.contradicting < 0.05 * second.placement.agreeing
    assert second.placement.next_share < 0.8
    assert second.round is None
    assert second.test.redundancy == 0
    assert result.points == ()


def test_a_scan_without_targets_is_placed_beside_one_with_targets(furnished):
    control = np.array([[1, 0, 2], [7, 0, 1.2], [8, 3, 1], [3, 5, 1.5], [0, 2, 2.2]])
    targets = {"s0": in_scan(control, STATIONS, 0)}
    result = registered(furnished, control, targets)

    assert result.scans[0].round == 1
    assert error(result, STATIONS, 1) < 0.005
    assert result.scans[1].std < 5 * SIGMA


def test_the_order_of_the_scans_does_not_matter_beside_targets(furnished):
    control = np.array([[1, 0, 2], [7, 0, 1.2], [8, 3, 1], [3, 5, 1.5], [0, 2, 2.2]])
    targets = {"s0": in_scan(control, STATIONS, 0)}
    forth = registered(furnished, control, targets)
    back = registered(dict(reversed(furnished.items())), control, targets)

    assert back.scans[0].matrix == pytest.approx(forth.scans[1].matrix, abs=1e-9)


class TestEmptyRoom:
    @pytest.fixture(scope="class")
    def empty(self):
        return scans(EMPTY, STATIONS)

    CONTROL = np.array([[1, 0, 2], [7, 0, 1.2], [8, 3, 1], [3, 5, 1.5], [0, 2, 2.2]])

    def test_a_symmetric_room_is_refused(self, empty):
        first, second = registered(empty).scans

        assert second.status == "ambiguous"
        assert "s1" in second.reason and "turned by 180 degrees" in second.reason
        assert first.status == "no overlap"
        assert "No other scan could be placed beside s0" in first.reason

    def test_one_target_decides_between_its_poses(self, empty):
        targets = {
            "s0": in_scan(self.CONTROL, STATIONS, 0),
            "s1": in_scan(self.CONTROL[1:2], STATIONS, 1),
        }
        result = registered(empty, self.CONTROL, targets)

        assert error(result, STATIONS, 1) < 0.01
        assert result.scans[1].placement.targets == 1
        assert [item.control for item in result.scans[1].correspondences] == ["P2"]

    def test_a_target_that_meets_no_point_decides_nothing_and_is_said(self, empty):
        targets = {"s0": in_scan(self.CONTROL, STATIONS, 0), "s1": in_scan([[5.0, 2, 2]], STATIONS, 1)}
        second = registered(empty, self.CONTROL, targets).scans[1]

        assert second.status == "too few"
        assert second.reason.startswith("s1 has 1 target, but a levelled scan needs at least 2")
        assert "at two poses about as well" in second.reason


class TestCorridor:
    @pytest.fixture(scope="class")
    def corridor(self):
        return scans(CORRIDOR, ALONG, reach=20.0)

    CONTROL = np.array([[1, 0, 2], [3, 0, 1.2], [5, 2.2, 1.0], [-3, 2.2, 1.5], [-6, 0, 2.2]])

    @pytest.mark.parametrize("model", [Model.LEVELLED, Model.RIGID])
    def test_a_corridor_is_refused(self, corridor, model):
        second = registered(corridor, model=model).scans[1]

        assert second.status == "sliding"
        assert second.reason.startswith("s1 slides along the surfaces that it shares")

    def test_a_target_holds_a_scan_along_a_corridor(self, corridor):
        targets = {"s0": in_scan(self.CONTROL, ALONG, 0), "s1": in_scan(self.CONTROL[1:2], ALONG, 1)}
        result = registered(corridor, self.CONTROL, targets)

        assert error(result, ALONG, 1) < 0.02
        assert result.scans[1].placement.targets == 1


def test_scans_of_different_rooms_are_refused():
    for model in (Model.LEVELLED, Model.RIGID):
        result = registered(scans([FURNISHED, OTHER], [(2, 2, 1.6), (2, 2, 1.6)]), model=model)

        assert [scan.status for scan in result.scans] == ["no overlap", "no overlap"]
        assert result.scans[1].reason.startswith("The surfaces of s1 do not place it")


def test_a_mirrored_scan_is_refused(furnished):
    mirrored = furnished["s1"].mirrored()
    second = registered({**furnished, "s1": mirrored}).scans[1]

    assert second.status == "mirrored"
    assert second.reason.startswith("The surfaces of s1 fit better as in a mirror")


def test_a_cloud_that_does_not_show_its_scanner_is_refused(furnished):
    own = furnished["s1"]
    second = registered({**furnished, "s1": replace(own, station=None)}).scans[1]

    assert second.status == "no overlap"
    assert "does not show where the scanner stood" in second.reason


def test_scans_of_rooms_alike_are_placed_one_beside_the_other():
    faces, stations = rooms_alike(2, seed=2)
    result = registered(scans(faces, stations, step_deg=0.9))

    assert all(scan.registered for scan in result.scans)
    assert max(error(result, stations, number) for number in range(4)) < 0.01


def test_a_room_alike_that_shares_nothing_is_not_taken_for_the_other():
    faces, stations = rooms_alike(3, seed=2)
    apart = [stations[0], stations[4]]
    both = scans(faces, apart, step_deg=0.9, reach=8.0)

    assert not any(scan.registered for scan in registered(both).scans)
