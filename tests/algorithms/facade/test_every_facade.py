"""Every facade of a building is measured; those that cannot be are said."""

from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.errors import CancelledError, InputError
from ichnograph.algorithms.facade.development.development import ROUND, SIDES
from ichnograph.algorithms.facade.every_facade import measure_every, measure_selection
from ichnograph.algorithms.facade.planes.front import EAST
from ichnograph.algorithms.facade.selection import select_facade
from ichnograph.algorithms.facade.settings import FacadeSettings
from ichnograph.algorithms.progress import Progress
from ichnograph.tests.algorithms.facade.buildings.sites import block, level
from ichnograph.tests.algorithms.facade.development.towers import BAY, ground, round_wall, sides
from ichnograph.tests.algorithms.facade.samples import bare
from shapely.geometry import LineString, box

SETTINGS = FacadeSettings()
ORIGIN = (412_000.0, 5_812_000.0, 70.0)


@pytest.fixture(scope="module")
def points():
    xyz = block()
    return bare(xyz + np.random.default_rng(0).normal(0, 0.002, xyz.shape), ORIGIN)


@pytest.fixture(scope="module")
def first(points):
    return measure_selection(select_facade(points, SETTINGS), SETTINGS)


def test_each_facade_has_its_own_elevation(first):
    every = measure_every(first, SETTINGS)
    assert [item.number for item in every.drawn] == [1, 2]
    assert every.drawn[0] is first
    turned = every.drawn[1].elevation.frame.azimuth - first.elevation.frame.azimuth
    assert np.cos(np.radians(turned)) == pytest.approx(-1, abs=1e-3)
    assert every.drawn[1].elevation.wall.area == pytest.approx(12 * 5, rel=0.05)


def test_side_applies_to_the_chosen_facade_only():
    turned = block()[:, [1, 0, 2]] * (-1, 1, 1)
    settings = replace(SETTINGS, side=EAST)
    selection = select_facade(bare(turned, ORIGIN), settings)
    chosen = next(facade for facade in selection.facades if facade.azimuth < 180)
    selection = selection.of(chosen, settings)
    every = measure_every(measure_selection(selection, settings), settings)
    assert sorted(item.elevation.frame.azimuth for item in every.drawn) == pytest.approx([90, 270], abs=0.1)


def test_facades_are_those_along_the_lines_where_lines_are_given(points):
    north = LineString([(412_000, 5_812_008.5), (412_012, 5_812_008.5)])
    selection = select_facade(points, SETTINGS, shapes=[north])
    assert [
        item.number for item in measure_every(measure_selection(selection, SETTINGS), SETTINGS).drawn
    ] == [2]


def test_a_chosen_facade_that_no_line_runs_along_is_not_one_of_them(points):
    north = LineString([(412_000, 5_812_008.5), (412_012, 5_812_008.5)])
    chosen = measure_selection(select_facade(points, SETTINGS, number=1, shapes=[north]), SETTINGS)
    assert chosen.number == 1
    assert [item.number for item in measure_every(chosen, SETTINGS).drawn] == [2]


def test_a_polygon_of_a_building_has_all_its_facades(points):
    building = box(412_000, 5_812_000, 412_012, 5_812_008)
    assert [facade.number for facade in select_facade(points, SETTINGS, shapes=[building]).wanted] == [1, 2]


def test_lines_in_other_coordinates_are_refused(points):
    with pytest.raises(InputError, match=r"FACADE_ALONG has a line .* without a facade within 2 m"):
        select_facade(points, SETTINGS, shapes=[LineString([(0, 8), (12, 8)])])


def test_a_facade_that_cannot_be_measured_is_said_and_the_others_are_drawn(first):
    second = first.selection.wanted[1]
    lost = replace(second, anchor=second.anchor + (0, 4, 0))
    selection = replace(first.selection, wanted=(first.selection.wanted[0], lost))
    every = measure_every(replace(first, selection=selection), SETTINGS)
    assert [item.number for item in every.drawn] == [1]
    assert len(every.warnings) == 1 and every.warnings[0].startswith("Facade 2 is not drawn: ")


def test_a_cloud_without_several_facades_is_drawn_once():
    wall = np.concatenate([block()[block()[:, 1] < 0.1], level(-6, -10, 18, 0, 0.0)])
    alone = measure_selection(select_facade(bare(wall), SETTINGS), SETTINGS)
    assert measure_every(alone, SETTINGS).drawn == (alone,)


def test_a_cancel_ends_it_between_facades(first):
    with pytest.raises(CancelledError):
        measure_every(first, SETTINGS, Progress(is_cancelled=lambda: True))


def test_a_bay_is_drawn_once_with_its_sides_and_flat_facades_as_they_are():
    front = sides([*BAY, (9.6, 6)])
    back = sides([(12, 20), (4, 20)])
    cloud = np.concatenate([front, back, ground(-3, -8, 13, -1), ground(-3, 20.5, 13, 28)])
    points = bare(cloud, ORIGIN)
    settings = FacadeSettings(unroll=SIDES)
    selection = select_facade(points, settings, near=(412_004.8, 5_811_999.0))
    every = measure_every(measure_selection(selection, settings), settings)
    turned = [item for item in every.drawn if item.elevation.curve is not None]
    assert len(turned) == 1 and len(every.drawn) > 1
    assert turned[0].elevation.wall.area == pytest.approx((3 + 3 + 2 + 2 * 0.8 * np.sqrt(2)) * 5, rel=0.03)


def test_what_is_drawn_rolled_out_lies_on_the_wall_in_the_site():
    tower = np.concatenate([round_wall((3, 4), 3.0, 100, 260), ground(-3, -6, 9, 0.9)])
    settings = FacadeSettings(unroll=ROUND)
    drawn = measure_selection(select_facade(bare(tower, ORIGIN), settings), settings)
    left, _, right, _ = drawn.elevation.wall.bounds
    assert drawn.elevation.radius == pytest.approx(3.0, abs=0.01)
    assert right - left == pytest.approx(3.0 * np.radians(160), rel=0.01)
    site = drawn.elevation.world(np.array([[u, 1.0, 0.0] for u in np.linspace(left, right, 9)])) - ORIGIN
    np.testing.assert_allclose(np.hypot(*(site[:, :2] - (3, 4)).T), 3.0, atol=0.01)
