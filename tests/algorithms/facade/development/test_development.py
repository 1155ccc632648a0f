"""A facade that turns is rolled out, with its radius; a flat one is refused."""

import numpy as np
import pytest
from ichnograph.algorithms.errors import NothingFoundError
from ichnograph.algorithms.facade.development.development import ROUND, SIDES, develop
from ichnograph.tests.algorithms.facade.samples import bare

from .towers import BAY, round_wall, sides

ORIGIN = (412_000.0, 5_812_000.0, 70.0)


def test_a_round_tower_becomes_a_wall_as_long_as_its_arc():
    points = bare(round_wall((3.0, 4.0), 3.0, 120, 240), ORIGIN)
    development = develop(points, ROUND, None, 0.05)
    flat = development.flat(points)
    assert development.radius == pytest.approx(3.0, abs=0.01)
    assert "3.0" in development.said
    along = (flat.xyz - development.plane.centre) @ np.cross([0, 0, 1.0], development.plane.normal)
    assert np.ptp(along) == pytest.approx(3.0 * np.radians(120), rel=0.01)
    assert np.abs((flat.xyz - development.plane.centre) @ development.plane.normal).max() < 0.03


def test_the_sides_of_a_bay_become_one_wall():
    points = bare(sides(BAY), ORIGIN)
    development = develop(points, SIDES, None, 0.05)
    flat = development.flat(points)
    assert development.radius is None and development.said.startswith("5 sides are rolled out")
    assert np.abs((flat.xyz - development.plane.centre) @ development.plane.normal).max() < 0.03
    assert np.ptp(flat.xyz[:, 0]) == pytest.approx(3 + 3 + 2 + 2 * 0.8 * np.sqrt(2), abs=0.1)


def test_what_lies_far_before_and_behind_is_left_out_and_stations_move_with_the_points():
    far = np.array([[3.0, 60.0, 1.0], [3.0, -60.0, 1.0]])
    points = bare(np.concatenate([sides(BAY), far]), ORIGIN)
    assert len(develop(points, SIDES, None, 0.05).flat(points).xyz) == len(points.xyz) - 2


def test_the_wall_above_a_bay_is_not_seen_behind_it_but_its_room_is():
    chain = develop(bare(sides(BAY), ORIGIN), SIDES, None, 0.05).curve
    above, room, wall = sides([(3.2, 0), (6.4, 0)]), sides([(3.5, 1.5), (6.0, 1.5)]), sides(BAY)
    assert chain.goes_on(above[:, :2], 0.05).all()
    assert not chain.goes_on(np.concatenate([room, wall])[:, :2], 0.05).any()


def test_points_on_the_wall_are_held_and_others_are_not():
    development = develop(bare(sides(BAY), ORIGIN), SIDES, None, 0.05)
    assert development.holds(np.array([3.4, -0.4])) and not development.holds(np.array([4.8, 5.0]))


@pytest.mark.parametrize(("kind", "said"), [(ROUND, "No round wall"), (SIDES, "No sides were found")])
def test_a_flat_wall_is_refused_in_one_sentence(kind, said):
    with pytest.raises(NothingFoundError, match=said):
        develop(bare(sides([(0, 0), (8, 0)]), ORIGIN), kind, None, 0.05)
