"""Foliage is separated from walls by how its points spread over the plan."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.site_plan.density.density_image import density_image
from ichnograph.tests.algorithms.site_plan.surfaces import (
    band_at,
    cloud_of,
    foliage,
    gate_of,
    level,
    turned,
    upright,
)

GROUND = level((0, 8), (0, 6), 0.0)
WALL = upright((1, 2), (7, 2), 0.0, 2.2)


def tall_share(points, asked, degrees=0.0):
    """Return the share of the places asked for, at a metre's height, that may be wall."""
    image = density_image(cloud_of(turned(points, degrees)))
    return band_at(image, gate_of(image).tall, turned(asked, degrees)).mean()


def test_a_bush_in_the_open_is_not_a_wall():
    bush = foliage((3, 4.5), (3, 4.5), 1.5)
    assert tall_share(np.concatenate([GROUND, bush]), bush) < 0.05


@pytest.mark.parametrize("degrees", [0.0, 31.0])
def test_a_bush_at_a_wall_is_removed_and_the_wall_is_kept(degrees):
    bush = foliage((3, 4.5), (2.0, 3.0), 1.5)
    points = np.concatenate([GROUND, WALL, bush])
    assert tall_share(points, WALL, degrees) > 0.98
    assert tall_share(points, bush[bush[:, 1] > 2.2], degrees) < 0.1


@settings(max_examples=5, deadline=None)
@given(st.floats(0, 90), st.integers(0, 2**32 - 1))
def test_rubble_masonry_with_centimetres_of_relief_is_kept(degrees, seed):
    random = np.random.default_rng(seed)
    # Stones of 0.2 m that stand out from a face by up to 5 cm.
    stones = random.uniform(-0.05, 0.05, (40, 40))
    faces = []
    for y in (2.0, 2.5):
        face = upright((1, y), (7, y), 0.0, 1.5)
        face[:, 1] += stones[(face[:, 0] / 0.2).astype(int), (face[:, 2] / 0.2 + 20 * (y > 2)).astype(int)]
        faces.append(face)
    wall = np.concatenate(faces)
    image = density_image(cloud_of(turned(np.concatenate([GROUND, wall]), degrees)))
    risen = band_at(image, "occupied", turned(wall, degrees)) >= 0.4
    assert band_at(image, gate_of(image).tall, turned(wall, degrees))[risen].mean() > 0.98


@pytest.mark.parametrize("degrees", [0.0, 20.0, 45.0])
def test_a_wall_that_leans_by_a_degree_is_kept(degrees):
    leaning = WALL + np.tan(np.radians(1)) * WALL[:, 2:] * [0, 1, 0]
    waist = leaning[np.abs(leaning[:, 2] - 1) < 0.2]
    assert tall_share(np.concatenate([GROUND, leaning]), waist, degrees) > 0.98


@pytest.mark.parametrize("radius", [0.15, 0.3, 2.0])
def test_columns_and_round_towers_are_kept(radius):
    turns = np.arange(0, 2 * np.pi, 0.02 / radius)
    rim = np.column_stack([4 + radius * np.cos(turns), 3 + radius * np.sin(turns)])
    round_wall = np.concatenate([np.column_stack([rim, np.full(len(rim), z)]) for z in np.arange(0, 2, 0.03)])
    assert tall_share(np.concatenate([GROUND, round_wall]), round_wall) == 1


def test_a_thin_partition_whose_faces_lie_close_is_kept():
    partition = np.concatenate([upright((1, y), (7, y), 0.0, 2.2) for y in (2.0, 2.1)])
    assert tall_share(np.concatenate([GROUND, partition]), partition, 17.0) == 1


@pytest.mark.parametrize("seed", range(3))
def test_the_order_of_the_points_and_the_cuts_between_files_change_nothing(seed):
    points = np.concatenate([GROUND, WALL, foliage((3, 4.5), (2, 3), 1.5)])
    random = np.random.default_rng(seed)
    cuts = np.sort(random.integers(0, len(points), 3))
    whole = density_image(cloud_of(points))
    parts = density_image(cloud_of(random.permutation(points), cuts))
    np.testing.assert_array_equal(whole.spread, parts.spread)
    np.testing.assert_array_equal(whole.hanging, parts.hanging)
