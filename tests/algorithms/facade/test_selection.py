"""The facade that is measured, chosen among those of the cloud."""

import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.facade.development.development import ROUND
from ichnograph.algorithms.facade.measurement import measure_facade
from ichnograph.algorithms.facade.selection import select_facade
from ichnograph.algorithms.facade.settings import FacadeSettings
from ichnograph.tests.algorithms.facade.buildings.sites import block, level, upright
from ichnograph.tests.algorithms.facade.development.towers import ground, round_wall
from ichnograph.tests.algorithms.facade.samples import bare

ORIGIN = (412_000.0, 5_812_000.0, 70.0)


def site():
    xyz = block()
    return bare(xyz + np.random.default_rng(0).normal(0, 0.002, xyz.shape), ORIGIN)


def test_the_first_facade_is_taken_with_what_stands_around_it():
    selection = select_facade(site())
    assert selection.chosen.number == 1 and len(selection.facades) == 2
    assert len(selection.points.xyz) < len(site().xyz)
    assert len(selection.points.scan) == len(selection.points.xyz)


def test_a_point_in_the_coordinates_of_the_site_chooses_the_facade_near_it():
    assert select_facade(site(), near=(412_006.0, 5_812_009.0)).chosen.number == 2


def test_a_point_far_from_every_facade_is_refused():
    with pytest.raises(InputError, match=r"FACADE_NEAR is \d+ m from the nearest facade"):
        select_facade(site(), near=(6.0, 9.0))


def test_a_cloud_of_one_facade_is_measured_as_it_is():
    points = bare(np.concatenate([upright((0, 0), (8, 0), 0, 5), level(-2, -6, 10, 0, 0)]))
    selection = select_facade(points)
    assert selection.points is points
    assert abs(selection.plane.normal[1]) == pytest.approx(1, abs=0.01)
    assert selection.chosen.length == pytest.approx(8, abs=0.3)


def test_a_round_tower_is_rolled_out_and_its_plane_touches_it():
    tower = np.concatenate([round_wall((3, 4), 3.0, 100, 260), ground(-3, -6, 9, 0.9)])
    selection = select_facade(bare(tower, ORIGIN)).unrolled(FacadeSettings(unroll=ROUND))
    away = selection.plane.distances(selection.points.xyz)
    assert selection.development.radius == pytest.approx(3.0, abs=0.01)
    assert np.mean(np.abs(away) < 0.02) > 0.5


def test_a_flat_facade_is_left_as_it_is():
    selection = select_facade(site())
    assert selection.unrolled(FacadeSettings()) is selection


def test_a_cloud_without_facades_refuses_a_number():
    points = bare(level(0, 0, 5, 5, 0))
    assert select_facade(points).chosen is None
    with pytest.raises(InputError, match="leave FACADE 0"):
        select_facade(points, number=2)


def test_the_chosen_facade_is_measured_even_if_a_larger_wall_is_near():
    wide, narrow = upright((0, 0), (12, 0), 0, 7), upright((12, 0.1), (12, 5), 0, 7)
    points = bare(np.concatenate([wide, narrow, level(-6, -10, 22, 0, 0), level(12, 0, 22, 5, 0)]))
    side = next(facade for facade in select_facade(points).facades if facade.length < 6)
    selection = select_facade(points, number=side.number)
    elevation = measure_facade(selection.points, wanted=selection.plane)
    assert abs(np.sin(np.radians(elevation.frame.azimuth - 90))) < 0.02
