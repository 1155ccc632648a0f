"""A made detail has a clear step of colour all around; stains, lamplight, joints and shadows have not."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.colour.appearance import Appearance
from ichnograph.algorithms.facade.colour.steps import (
    NARROW,
    SOFT,
    UNCONFIRMED,
    WEATHERED,
    reason_against_colour,
)
from ichnograph.tests.algorithms.facade.colour.panel import (
    POINTS,
    SHADE,
    STEP,
    WHITE,
    painted,
    reflecting,
)
from shapely.geometry import box

OUTLINE = box(1.0, 0.5, 1.6, 1.3)
TR = 30.0


def reason(rgb, relative=None, outline=OUTLINE):
    looks = Appearance(rgb.astype(np.float32), relative, 0.06)
    return reason_against_colour(POINTS, looks, outline, STEP, TR)


def test_a_painted_panel_is_a_detail_with_and_without_intensity():
    assert reason(painted()) is None
    assert reason(painted(), reflecting()) is None


def test_a_gradient_of_lamplight_is_none():
    away = np.hypot(*(POINTS - (1.3, 0.9)).T)
    lit = 1 - 0.6 * np.exp(-((away / 0.45) ** 2))
    assert reason(WHITE * lit[:, None]) == SOFT


def test_a_stain_that_is_sharp_on_one_side_only_is_none():
    share = np.clip((1.6 - POINTS[:, 0]) / 0.6, 0, 1) * ((POINTS > (1.0, 0.5)) & (POINTS < (1.6, 1.3))).all(
        axis=1
    )
    assert reason(WHITE * (1 - 0.6 * share)[:, None]) == SOFT


def test_a_stone_among_stones_of_all_colours_is_none():
    stones = np.floor(POINTS / (0.3, 0.2)).astype(int)
    values = np.random.default_rng(4).uniform(0.5, 1.0, (12, 12))[stones[:, 0], stones[:, 1]]
    relative = values.astype(np.float32)
    assert reason(WHITE * values[:, None], outline=box(1.2, 0.6, 1.5, 0.8)) == WEATHERED
    assert reason(WHITE * values[:, None], relative, box(1.2, 0.6, 1.5, 0.8)) == WEATHERED


def test_a_panel_in_a_cast_shadow_is_a_detail_where_the_intensity_shows_it():
    shaded = painted() * np.where(SHADE, 0.4, 1.0)[:, None]
    assert reason(shaded, reflecting()) is None


def test_a_shadow_has_no_edge_in_the_intensity():
    shaded = painted(panel=0.4 * WHITE)
    assert reason(shaded) is None
    assert reason(shaded, reflecting(panel=1.0)) == UNCONFIRMED


@pytest.mark.parametrize("width", [0.03, 0.06])
def test_what_is_as_narrow_as_a_joint_is_none(width):
    line = box(1.0, 0.5, 1.0 + width, 1.7)
    inside = (POINTS[:, 0] > 1.0) & (POINTS[:, 0] < 1.0 + width)
    rgb = np.where(inside[:, None], 0.4 * WHITE, WHITE)
    assert reason(rgb, outline=line) == NARROW
