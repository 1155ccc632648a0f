"""The targets of one station."""

from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.targets.checkerboards.checkerboard import TILES, WIDTH
from ichnograph.algorithms.targets.results import Kind, Rejection
from ichnograph.algorithms.targets.settings import TargetSettings, Wanted
from ichnograph.algorithms.targets.station_search import search_station, without_tiles
from ichnograph.tests.algorithms.targets.made_targets import SCANNER, image_of_simulated, target
from ichnograph.tests.scenes.stations.layout import cluttered_station, target_station

PLACES = (
    ("black and white", 0.15, 5.0, 0.0),
    ("black and white", 0.3, 12.0, 45.0),
    ("black and white", 0.075, 3.0, 30.0),
    ("sphere", 0.145, 6.0, 0.0),
    ("sphere", 0.2, 10.0, 0.0),
)


@pytest.fixture(scope="module")
def scan():
    return target_station(SCANNER, PLACES, seed=5)


@pytest.fixture(scope="module")
def found(scan):
    return search_station("scan", image_of_simulated(scan), TargetSettings())


def test_every_target_is_found_once_and_nothing_else(scan, found):
    assert len(found.sure) == len(scan.targets)
    for truth in scan.targets:
        near = [item for item in found.sure if np.linalg.norm(item.xyz - truth.centre) < 0.01]
        assert [item.kind.value for item in near] == [truth.kind]


def test_centres_are_exact_to_a_millimetre(scan, found):
    for truth in scan.targets:
        assert min(np.linalg.norm(item.xyz - truth.centre) for item in found.sure) < 0.001


def test_sizes_are_found(scan, found):
    for truth in scan.targets:
        near = min(found.sure, key=lambda item: np.linalg.norm(item.xyz - truth.centre))
        assert near.size == pytest.approx(truth.size, rel=0.1)


def test_every_target_has_its_picture(found):
    assert len(found.views) == len(found.targets)


@pytest.mark.parametrize(
    ("wanted", "kind"), [(Wanted.SPHERES, Kind.SPHERE), (Wanted.CHECKERBOARDS, Kind.CHECKERBOARD)]
)
def test_only_the_kind_that_is_wanted_is_found(scan, wanted, kind):
    found = search_station("scan", image_of_simulated(scan), TargetSettings(wanted=wanted))

    assert {item.kind for item in found.sure} == {kind}


def test_without_intensity_only_spheres_are_found(scan):
    found = search_station("scan", image_of_simulated(scan, intensity=False), TargetSettings())

    assert {item.kind for item in found.sure} == {Kind.SPHERE}


def test_a_size_excludes_the_other_ones(scan):
    found = search_station("scan", image_of_simulated(scan), TargetSettings(size=0.2))

    assert [round(item.size, 2) for item in found.sure] == [0.2]


def test_posters_tiles_windows_lamps_balls_pipes_and_painted_walls_are_no_targets():
    scan = cluttered_station(SCANNER, (4.0,), seed=2)
    found = search_station("scan", image_of_simulated(scan), TargetSettings())

    assert found.sure == ()
    assert found.rejections


def kept(*found, failed=()):
    return without_tiles(list(found), list(failed), TargetSettings())


def corner_of_tiles(y):
    return Rejection(Kind.CHECKERBOARD, np.array([4.0, y, 0.0]), TILES, 9, 0.9, 0.5)


def test_patterns_in_a_row_are_tiles_and_two_beside_each_other_are_targets():
    row = [target((4.0, 0.25 * number, 0.0)) for number in range(4)]

    assert kept(*row[:2])[0] == row[:2]
    inner, failed = kept(*row)
    assert [item.xyz[1] for item in inner] == [0.0, 0.75], "those at the ends have one neighbour each"
    assert {item.test for item in failed} == {"crossings nearby"}


def test_a_pattern_among_corners_of_tiles_is_no_target():
    assert kept(target(), failed=[corner_of_tiles(-0.2), corner_of_tiles(0.2)])[0] == []
    assert len(kept(target(), failed=[corner_of_tiles(0.2)])[0]) == 1


def large_crossing(y, z=0.0):
    return Rejection(Kind.CHECKERBOARD, np.array([4.0, y, z]), WIDTH, 9, np.inf, 0.34)


def test_a_pattern_among_several_crossings_of_large_fields_is_no_target():
    around = [large_crossing(y, z) for y, z in ((-0.2, 0.0), (0.2, 0.0), (0.0, 0.2))]

    assert kept(target(), failed=around)[0] == []
    assert len(kept(target(), failed=around[:2])[0]) == 1


def test_a_crossing_that_several_candidates_see_counts_once():
    assert len(kept(target(), failed=[large_crossing(0.2 + 0.01 * number) for number in range(5)])[0]) == 1


def test_other_candidates_at_a_target_do_not_speak_against_it():
    own = [corner_of_tiles(y) for y in (-0.03, 0.0, 0.03)]

    assert len(kept(target(), failed=own)[0]) == 1


def test_a_large_target_beside_two_small_ones_is_not_tiled():
    large = replace(target(), size=0.3)
    small = [replace(target((4.0, y, 0.0)), size=0.075) for y in (-0.4, 0.4)]

    assert len(kept(large, *small)[0]) == 3
