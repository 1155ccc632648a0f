"""Furniture ends below the ceiling that walls reach."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.density.density_image import density_image
from ichnograph.tests.algorithms.site_plan.surfaces import (
    band_at,
    box,
    cloud_of,
    foliage,
    gate_of,
    level,
    turned,
    upright,
)

CEILING = 3.0


def room(ceiling=CEILING, width=6.0):
    """Return floor, ceiling and the four walls of a room, and its far wall by itself."""
    far = upright((0, 5), (width, 5), 0, ceiling)
    others = [
        upright(a, b, 0, ceiling)
        for a, b in (((0, 0), (width, 0)), ((0, 0), (0, 5)), ((width, 0), (width, 5)))
    ]
    surfaces = [level((0, width), (0, 5), z) for z in (0.0, ceiling)]
    return np.concatenate([*surfaces, *others, far]), far


def without(points, x, y, below):
    """Leave out what is hidden: the points of a box from the floor up."""
    inside = (points[:, 0] >= x[0]) & (points[:, 0] <= x[1]) & (points[:, 1] >= y[0]) & (points[:, 1] <= y[1])
    return points[~(inside & (points[:, 2] < below))]


def tall_at(points, asked, degrees=0.0):
    image = density_image(cloud_of(turned(points, degrees)))
    return band_at(image, gate_of(image).tall, turned(asked, degrees)).mean()


@pytest.mark.parametrize("degrees", [0.0, 28.0])
def test_a_cupboard_before_a_wall_is_removed_and_the_wall_behind_is_seen_above_it(degrees):
    points, far = room()
    cupboard = box((2, 3.2), (4.4, 4.9), 0, 2.1)
    points = np.concatenate([without(points, (2, 3.2), (4.4, 5.1), 2.15), cupboard])
    front = cupboard[cupboard[:, 1] < 4.5]
    behind = far[(far[:, 0] > 2.1) & (far[:, 0] < 3.1) & (far[:, 2] > 2.2)]
    assert tall_at(points, front, degrees) == 0
    assert tall_at(points, behind, degrees) > 0.95


def test_walls_that_reach_the_ceiling_are_kept():
    points, far = room()
    image = density_image(cloud_of(points))
    assert band_at(image, "hanging", far).min() > 2
    assert band_at(image, gate_of(image).tall, far).all()


def test_a_beam_and_the_lintel_of_a_door_are_no_walls():
    points, _far = room()
    door = upright((2, 2.5), (2.9, 2.5), 2.1, CEILING)
    partition = np.concatenate(
        [upright((0, 2.5), (2, 2.5), 0, CEILING), upright((2.9, 2.5), (6, 2.5), 0, CEILING)]
    )
    beam = np.concatenate(
        [upright((4.5, 0), (4.5, 5), 2.6, CEILING), upright((4.7, 0), (4.7, 5), 2.6, CEILING)]
    )
    points = np.concatenate([points, door, partition, beam])
    assert tall_at(points, door[(door[:, 0] > 2.1) & (door[:, 0] < 2.8)]) == 0
    assert tall_at(points, beam[np.abs(beam[:, 1] - 1.2) < 1]) == 0
    assert tall_at(points, partition) == 1


def test_the_wall_below_a_window_is_kept_because_the_lintel_reaches_the_ceiling():
    points, far = room()
    hole = (far[:, 0] > 2) & (far[:, 0] < 3.5) & (far[:, 2] > 0.9) & (far[:, 2] < 2.1)
    points = np.concatenate([points[: -len(far)], far[~hole]])
    below = far[(far[:, 0] > 2.1) & (far[:, 0] < 3.4) & (far[:, 2] < 0.9)]
    assert tall_at(points, below) == 1


def test_a_person_in_a_room_is_no_wall():
    points, _far = room()
    person = box((3, 3.3), (2, 2.5), 0, 1.75)
    assert tall_at(np.concatenate([points, person]), person) == 0


def test_low_walls_below_the_roof_over_an_excavation_are_kept():
    walls = np.concatenate([upright((1, y), (9, y), 0, 1.2) for y in (2.0, 4.0, 6.0)])
    posts = np.concatenate([box((x, x + 0.2), (0.5, 0.7), 0, 4.0) for x in (1, 5, 9)])
    site = np.concatenate([level((0, 10), (0, 8), 0.0), level((0, 10), (0, 8), 4.0), walls, posts])
    assert tall_at(site, walls) == 1


def test_a_low_wall_below_a_crown_is_kept():
    wall = upright((1, 3), (7, 3), 0, 1.2)
    crown = foliage((2, 6), (1, 5), 1.5, 2000) + [0, 0, 2.5]
    ragged = crown[crown[:, 2] > 2.6 + 0.5 * np.sin(3 * crown[:, 0]) * np.cos(4 * crown[:, 1])]
    assert tall_at(np.concatenate([level((0, 8), (0, 6), 0.0), wall, ragged]), wall) == 1


def test_a_yard_wall_without_a_ceiling_may_be_lower_than_the_house():
    points, _far = room()
    low = upright((-6, 0), (0, 0), 0, 1.5)
    points = np.concatenate([points, low, level((-6, 0), (-2, 5), 0.0)])
    assert tall_at(points, low) == 1


def test_a_partition_in_a_room_is_kept_where_its_foot_is_hidden_but_not_its_head():
    points, far = room(width=8.0)
    hidden = without(points, (1, 4), (4.4, 5.1), 1.0)
    assert tall_at(hidden, far) > 0.98
