"""The head of an opening is the simplest curve that its border allows."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.outlines.heads import FLAT, POINTED, ROUND, SEGMENTAL, SLOPED, fit_head

GAP = 0.01
JAMBS = (0.0, 1.2)
U = np.linspace(0.03, 1.17, 120)
HALF = 0.6


def flat():
    return np.full(len(U), 2.0)


def sloped():
    return 2.0 + 0.3 * U


def round_head():
    return 1.4 + np.sqrt(HALF**2 - (U - HALF) ** 2)


def segmental():
    return 1.0 + np.sqrt(1.0 - (U - HALF) ** 2)


def pointed():
    own = np.abs(U - HALF)
    return 1.0 + np.sqrt(1.2**2 - (own + HALF) ** 2)


def head_of(v, noise=0.002, spacing=0.0, gap=GAP):
    points = np.column_stack([U, v + np.random.default_rng(0).normal(0, noise, len(U))])
    return fit_head(points, np.full(len(U), gap), JAMBS, spacing=spacing)


@pytest.mark.parametrize(("shape", "kind", "height"), [
    (flat, FLAT, 2.0), (sloped, SLOPED, 2.36), (round_head, ROUND, 2.0), (segmental, SEGMENTAL, 2.0),
    (pointed, POINTED, 1.0 + np.sqrt(1.2**2 - HALF**2)),
])  # fmt: skip
def test_each_head_is_recognised_with_its_height(shape, kind, height):
    head = head_of(shape())

    assert head.kind == kind
    assert head.line[:, 1].max() == pytest.approx(height, abs=0.005)
    assert 0 < head.std < 0.005


def test_an_old_lintel_that_sags_by_less_than_3_cm_is_level():
    assert head_of(2.0 + 0.02 * U).kind == FLAT
    assert head_of(2.0 + 0.04 * U).kind == SLOPED


@pytest.mark.parametrize("gap", [0.002, 0.005, 0.01, 0.02])
@pytest.mark.parametrize("rise", [-0.028, 0.012, 0.028])
def test_a_lintel_that_sags_is_as_uncertain_as_its_height_changes_however_dense_the_points(rise, gap):
    head = head_of(2.0 + rise * (U / 1.2 - 0.5), gap=gap)

    assert head.kind == FLAT
    assert head.line[:, 1] == pytest.approx([2.0, 2.0], abs=0.002)
    assert 0.9 * abs(rise) / np.sqrt(12) < head.std < abs(rise) / np.sqrt(12) + 0.5 * gap


def test_the_outermost_of_points_far_apart_do_not_make_an_arch():
    shallow = 2.0 - 0.15 * (U - HALF) ** 2
    assert head_of(shallow, 0.006).kind == SEGMENTAL
    assert head_of(shallow, 0.006, spacing=0.05).kind == FLAT


def test_a_border_that_is_no_head_has_none():
    assert head_of(np.random.default_rng(1).uniform(1, 2, len(U))) is None


def test_a_head_of_which_too_little_was_seen_is_not_guessed():
    points = np.column_stack([U, flat()])[:40]
    assert fit_head(points, np.full(40, GAP), JAMBS) is None


def test_points_are_as_far_off_as_the_line_is():
    head = head_of(flat())
    assert head.off(np.array([(0.6, 2.1), (0.6, 1.9)])) == pytest.approx([0.1, 0.1], abs=0.002)
