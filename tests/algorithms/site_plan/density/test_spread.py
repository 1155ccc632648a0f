"""The spread of points within a pixel."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.density.settings import SpreadSettings
from ichnograph.algorithms.site_plan.density.spread import count_in_parts, spread_of

PARTS = SpreadSettings().parts


def test_points_above_one_another_are_spread_over_the_part_they_stand_in():
    parts = np.zeros((PARTS, PARTS), np.uint8)
    parts[1] = 20
    assert spread_of(parts).item() == pytest.approx(1 / PARTS, rel=0.05)


@pytest.mark.parametrize("per_part", [1, 10, 200])
def test_strewn_points_are_spread_over_all_of_a_pixel_whatever_their_number(per_part):
    parts = np.random.default_rng(0).poisson(per_part, (50 * PARTS, 50 * PARTS)).astype(np.uint8)
    assert np.nanmedian(spread_of(parts)) > 0.9


def test_of_few_points_it_is_not_known_how_they_spread():
    parts = np.zeros((PARTS, PARTS), np.uint8)
    parts[0, 0] = 7
    assert np.isnan(spread_of(parts)).all()


def test_points_are_counted_in_the_part_that_they_stand_in_between_two_heights():
    counts = np.zeros((2 * PARTS, 2 * PARTS), np.uint8)
    ground = np.array([[0.0, 0.0], [0.0, 1.0]])
    # Lattice steps of a centimetre, pixels of 0.4 m; the last two are too low and too high above the ground.
    xyz = np.array([[5, 5, 50], [5, 8, 50], [45, 75, 150], [45, 75, 120], [45, 75, 400]])
    count_in_parts(counts, ground, xyz, 0, 0, 40, 0.01, 0.3, 2.3, PARTS)
    assert counts[0, 0] == 2
    assert counts[7, 4] == 1
    assert counts.sum() == 3
