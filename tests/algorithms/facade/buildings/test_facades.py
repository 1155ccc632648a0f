"""Facades of whole buildings: found, numbered, and turned towards the open air."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.buildings.facades import find_facades

from .sites import block, house, level, upright

DISTANCE = 0.05


def facades(xyz, scan=None, stations=None):
    noise = np.random.default_rng(0).normal(0, 0.002, xyz.shape)
    scan = np.zeros(len(xyz), int) if scan is None else scan
    return find_facades(xyz + noise, scan, stations, DISTANCE)


def test_both_fronts_of_a_block_are_found_and_face_away_from_it():
    found = facades(block())
    assert [facade.number for facade in found] == [1, 2]
    street, yard = found
    assert street.azimuth == pytest.approx(180, abs=0.5)
    assert np.cos(np.radians(yard.azimuth)) == pytest.approx(1, abs=1e-4)
    assert street.length == pytest.approx(12, abs=0.3) and street.height == pytest.approx(7, abs=0.3)
    assert street.ends[0] == pytest.approx((0, 0), abs=0.3)
    assert street.ends[1] == pytest.approx((12, 0), abs=0.3)
    assert street.area == pytest.approx(84, rel=0.1) and street.points > yard.points


def test_walls_of_which_only_the_rooms_were_seen_are_no_facades():
    (front,) = facades(house())
    assert front.azimuth == pytest.approx(180, abs=0.5)
    assert front.normal[1] == pytest.approx(-1, abs=1e-3)
    assert front.anchor[1] == pytest.approx(0.0, abs=0.02)


def test_the_facade_that_scanners_saw_most_is_the_first():
    xyz = block()
    scan = (xyz[:, 1] > 4).astype(int)
    crowd = np.concatenate([xyz, xyz[scan == 1], xyz[scan == 1]])
    scans = np.concatenate([scan, np.ones(2 * scan.sum(), int)])
    stations = np.array([[6.0, -8.0, 1.6], [6.0, 16.0, 1.6]])
    first, second = facades(crowd, scans, stations)
    assert first.ends[0, 1] == pytest.approx(8, abs=0.2) and first.seen > second.seen


def test_scanners_that_are_not_known_say_nothing():
    found = facades(block(), stations=np.full((1, 3), np.nan))
    assert [facade.seen for facade in found] == [None, None]


def test_a_storey_set_back_belongs_to_its_facade_and_a_house_farther_back_does_not():
    front = upright((0, 0), (10, 0), 0, 3)
    above = upright((0, 1.5), (10, 1.5), 3, 6)
    behind = upright((0, 6), (10, 6), 0, 6)
    found = facades(np.concatenate([front, above, behind, level(-5, -10, 15, 0, 0)]))
    assert sorted(facade.planes for facade in found) == [1, 2]
    joined = max(found, key=lambda facade: facade.planes)
    assert joined.height == pytest.approx(6, abs=0.3)


def test_the_back_of_a_room_seen_through_a_window_is_no_facade():
    front = upright((0, 0), (10, 0), 0, 6, [(3, 6, 1, 4)])
    back = upright((3, 4), (6, 4), 1, 4)
    assert len(facades(np.concatenate([front, back, level(-5, -10, 15, 0, 0)]))) == 1


def test_the_order_of_the_points_does_not_matter():
    xyz = block()
    order = np.random.default_rng(1).permutation(len(xyz))
    first = find_facades(xyz, np.zeros(len(xyz), int), None, DISTANCE)
    second = find_facades(xyz[order], np.zeros(len(xyz), int), None, DISTANCE)
    assert [facade.area for facade in first] == [facade.area for facade in second]
    assert np.allclose([facade.ends for facade in first], [facade.ends for facade in second], atol=1e-6)


def test_hedges_and_the_ground_are_no_facades():
    hedge = np.random.default_rng(0).uniform((0, 0, 0), (12, 1.2, 2.5), (20000, 3))
    assert facades(np.concatenate([hedge, level(-5, -5, 15, 5, 0)])) == ()
