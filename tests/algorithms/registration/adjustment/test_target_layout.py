"""What a layout of targets determines."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.adjustment.target_layout import (
    fixes_pose,
    is_of_projection,
    line_width,
    spread,
)
from ichnograph.algorithms.registration.settings import Matching, Model, Settings

LINE = np.array([[0.0, 0, 0], [3, 3, 3], [9, 9, 9]])
POLE = np.array([[2.0, 2, 0], [2, 2, 1.5], [2, 2, 4]])
TRIANGLE = np.array([[0.0, 0, 0], [6, 0, 0], [0, 4, 1]])


def test_spread_is_measured_from_plane_line_and_middle():
    box = np.array([[x, y, z] for x in (-3.0, 3.0) for y in (-2.0, 2.0) for z in (-1.0, 1.0)])

    assert spread(box) == pytest.approx([1.0, np.sqrt(5), np.sqrt(14)])
    assert spread(LINE)[:2] == pytest.approx([0.0, 0.0], abs=1e-12)
    assert spread(LINE[:2]) == pytest.approx([0.0, 0.0, np.sqrt(27) / 2], abs=1e-12)


@pytest.mark.parametrize("model", [Model.RIGID, Model.SIMILARITY, Model.UNKNOWN_SCALE])
def test_a_line_fixes_no_pose(model):
    assert fixes_pose(TRIANGLE, model, 0.01)
    assert not fixes_pose(LINE, model, 0.01)
    assert not fixes_pose(TRIANGLE[:2], model, 0.01)


@pytest.mark.parametrize("model", [Model.LEVELLED, Model.LEVELLED_SCALE])
def test_a_level_pose_is_fixed_by_a_line_that_is_not_vertical(model):
    assert fixes_pose(LINE[:2], model, 0.01)
    assert not fixes_pose(POLE, model, 0.01)
    assert not fixes_pose(LINE[:1], model, 0.01)


def test_a_layout_must_be_wider_than_its_uncertainty():
    bent = LINE + [[0, 0, 0], [0.02, 0, 0], [0, 0, 0]]

    assert fixes_pose(bent, Model.RIGID, 0.001)
    assert not fixes_pose(bent, Model.RIGID, 0.05)


def test_the_width_of_a_line_follows_from_noise_or_where_the_scale_is_unknown_from_the_extent():
    assert line_width(TRIANGLE, Settings(sigma=0.002)) == pytest.approx(3.5 * 0.002)
    assert line_width(TRIANGLE, Settings(model=Model.UNKNOWN_SCALE)) == pytest.approx(0.006)
    named = Settings(matching=Matching.NAMES, model=Model.SIMILARITY)
    assert line_width(100 * TRIANGLE, named) == pytest.approx(0.6)


@pytest.mark.parametrize(
    ("ppm", "extent", "shown"),
    [(-400, 8, False), (-400, 60, True), (30, 1000, False), (800, 60, False), (400, 30, False)],
)
def test_only_a_large_site_shows_the_scale_of_a_projection(ppm, extent, shown):
    assert is_of_projection(ppm, np.array([[0.0, 0, 0], [extent, 0, 0]]), Settings()) == shown
