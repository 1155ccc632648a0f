"""Scans tied by targets and surfaces in one block."""

from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.errors import CancelledError
from ichnograph.algorithms.progress import Progress
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.settings import Settings
from ichnograph.tests.algorithms.registration.hall import listed
from ichnograph.tests.algorithms.registration.surfaces.rooms import ROOM, frame, room, surfaces_in
from ichnograph.tests.scenes.surface_rooms import box

SIGMA = 0.003


class Rooms:
    """Rooms in a row, without walls across; each scan sees two, and only the first has surveyed points."""

    def __init__(self, scans, seed, error=0.001, targets=5, sigma=SIGMA):
        self.settings = Settings(sigma=sigma)
        random = np.random.default_rng(seed)
        lows = [np.array([ROOM[0] * number, 0.0, 0.0]) for number in range(scans + 1)]
        places = [low + random.random((targets, 3)) * ROOM for low in lows]
        self.rooms = [
            room(low, omit=("-x", "+x")) + box(low + [2, 1, 0], low + [2.9, 1.8, 1 + number % 2])
            for number, low in enumerate(lows)
        ]
        self.control = listed("control", places[0], prefix="P")
        self.matrices, self.lists, self.surfaces = {}, [], {}
        for number in range(scans):
            name, station = f"s{number}", lows[number] + ROOM * [1, 0.5, 0.5]
            matrix = frame(random.uniform(0, 360), station, random.normal(0, 1, 2))
            seen = np.concatenate(places[number : number + 2])
            own = (seen - station) @ matrix[:3, :3] + random.normal(0, sigma, seen.shape)
            self.lists.append(listed(name, own))
            self.matrices[name] = matrix
            faces = self.rooms[number] + self.rooms[number + 1]
            self.surfaces[name] = surfaces_in(matrix, faces, station, 10 * seed + number, error)

    def registered(self, surfaces=True, **chosen):
        given = self.surfaces if surfaces is True else surfaces or {}
        return register_scans(self.control, self.lists, self.settings, surfaces=given, **chosen)

    def error(self, scan):
        """Return how far the middle of a scan is from its true place."""
        return scan.matrix[:3, 3] - self.matrices[scan.name][:3, 3]

    def drift(self, registration):
        """Return how far the last scan is from its true place, as the first scan sees it (m)."""
        first, last = registration.scans[0], registration.scans[-1]
        moved = self.matrices[first.name] @ np.linalg.inv(first.matrix) @ last.matrix
        return np.linalg.norm((moved - self.matrices[last.name])[:3, 3])


@pytest.fixture(scope="module")
def rooms():
    return Rooms(4, seed=1)


@pytest.fixture(scope="module")
def refined(rooms):
    return rooms.registered()


def test_surfaces_make_the_end_of_a_chain_more_accurate(rooms, refined):
    by_targets = rooms.registered(surfaces=None)
    last, alone = refined.scans[-1], by_targets.scans[-1]

    assert alone.surfaces is None
    assert last.std < alone.std
    assert rooms.drift(refined) < rooms.drift(by_targets) / 3
    assert last.surfaces.std == pytest.approx(alone.std, rel=0.01)


def test_every_pair_shows_its_overlap_and_how_far_its_patches_lie_apart(refined):
    shared = {item.scans: item for item in refined.surfaces}

    for item in (shared["s0", "s1"], shared["s1", "s2"], shared["s2", "s3"]):
        assert 0.4 < item.overlap < 0.6
        assert 0.0005 < item.rms < 0.002
        assert item.patches > 50


def test_the_change_is_within_what_the_targets_allow(refined):
    for scan in refined.scans:
        assert scan.surfaces.used
        assert 0 < scan.surfaces.sigmas < 2
        assert scan.surfaces.shift < 4 * scan.surfaces.std


def test_stated_standard_deviations_are_those_of_the_errors():
    ratios = []
    for seed in range(12):
        rooms = Rooms(3, seed)
        scan = rooms.registered().scans[-1]
        stds = [item.std for item in scan.estimates[:3]]
        ratios += list(rooms.error(scan) / stds)

    assert np.sqrt(np.mean(np.square(ratios))) == pytest.approx(1.0, abs=0.35)


def test_surfaces_that_contradict_the_targets_are_left_out_and_it_is_said():
    exact = Rooms(3, seed=2, sigma=0.0005)
    wrong = {**exact.surfaces, "s2": exact.surfaces["s2"].shifted(np.array([0.04, 0.04, 0.04]))}
    without = {name: exact.surfaces[name] for name in ("s0", "s1")}
    result, expected = exact.registered(wrong), exact.registered(without)
    last = result.scans[-1]

    assert not last.surfaces.used
    assert last.surfaces.sigmas > 3
    np.testing.assert_allclose(last.matrix, expected.scans[-1].matrix, atol=1e-9)
    assert any(text.startswith("The surfaces that s2 shares") for text in result.warnings)


@pytest.mark.parametrize("number", [2, 5])
def test_surfaces_that_tear_scans_apart_against_shared_targets_are_left_out(number):
    chain = Rooms(6, seed=1)
    name, wrong = f"s{number}", np.array([0.08, 0.0, 0.0])
    result = chain.registered({**chain.surfaces, name: chain.surfaces[name].shifted(wrong)})

    assert [scan.name for scan in result.scans if not (scan.surfaces and scan.surfaces.used)] == [name]
    assert result.test.sigma0 < 1.3
    assert any(text.startswith(f"The surfaces that {name} shares") for text in result.warnings)


def test_a_corridor_holds_nothing_along_its_axis_and_says_so():
    corridor = Rooms(2, seed=3)
    smooth = [face for low in (0, 1, 2) for face in room((6.0 * low, 0, 0), omit=("-x", "+x"))]
    surfaces = {
        name: surfaces_in(matrix, smooth, matrix[:3, 3], number, 0.001)
        for number, (name, matrix) in enumerate(corridor.matrices.items())
    }
    result = corridor.registered(surfaces)

    (shared,) = result.surfaces
    np.testing.assert_allclose(np.abs(shared.free), [[1, 0, 0]], atol=0.01)
    (warning,) = (text for text in result.warnings if "slide" in text)
    assert warning.startswith("s0 and s1 slide along the surfaces that they share, at an azimuth of ")
    assert result.scans[-1].surfaces.used


def test_a_floor_alone_leaves_all_its_directions_free_and_names_none():
    yard = Rooms(2, seed=3)
    floor = box((0, 0, 0), (18, 5, 3))[4:5]
    surfaces = {
        name: surfaces_in(matrix, floor, matrix[:3, 3], number, 0.001)
        for number, (name, matrix) in enumerate(yard.matrices.items())
    }
    (warning,) = (text for text in yard.registered(surfaces).warnings if "slide" in text)

    assert "slide in all directions along them" in warning
    assert "azimuth" not in warning


def test_a_scan_that_shares_nothing_is_held_by_its_targets_and_it_is_said(rooms):
    few = {name: rooms.surfaces[name] for name in ("s0", "s1")}
    few["s3"] = rooms.surfaces["s3"]
    result = rooms.registered(surfaces=few)

    assert result.scans[3].surfaces is None
    assert any(text.startswith("s3 shares too few plane surfaces") for text in result.warnings)


def test_a_scan_whose_scanner_is_not_known_is_not_tied_and_it_is_said(rooms):
    unknown = {**rooms.surfaces, "s3": replace(rooms.surfaces["s3"], station=None)}
    result = rooms.registered(surfaces=unknown)

    assert result.scans[3].surfaces is None
    assert all("s3" not in item.scans for item in result.surfaces)
    (warning,) = (text for text in result.warnings if text.startswith("s3 "))
    assert warning.startswith("s3 is not tied by surfaces, because its cloud does not show where the scanner")


def test_the_order_of_the_scans_does_not_matter(rooms, refined):
    rooms_backwards = register_scans(
        rooms.control, rooms.lists[::-1], rooms.settings, surfaces=rooms.surfaces
    )

    for scan, other in zip(refined.scans, rooms_backwards.scans[::-1]):
        np.testing.assert_allclose(scan.matrix, other.matrix, atol=1e-6)


def test_it_stops_when_cancelled_and_reports_how_far_it_is(rooms):
    asked, said = [], []

    def cancelled():
        asked.append(1)
        return any("surfaces" in text for text in said)

    with pytest.raises(CancelledError):
        rooms.registered(progress=Progress(lambda share, text: said.append(text), cancelled))
    assert said[-1] == "Tying scans by their surfaces"
