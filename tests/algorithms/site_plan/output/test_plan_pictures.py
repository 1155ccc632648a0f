"""The pictures of the report: what became of each pixel, in a colour of its own."""

from dataclasses import replace

import numpy as np
import pytest
from affine import Affine
from ichnograph.algorithms.site_plan.output.plan_pictures import (
    COLOURS,
    Fate,
    View,
    coloured,
    fates,
    fates_at,
    fitted,
)
from ichnograph.algorithms.site_plan.walls.extraction import Verdict

PLACES = {
    Fate.UNSEEN: (148, 5),
    Fate.WALL: (20, 50),
    Fate.CLOSED: (22, 50),
    Fate.SURFACE: (60, 60),
    Fate.SMALL: (120, 31),
    Fate.MISSHAPEN: (45, 145),
    Fate.FAINT: (130, 120),
    Fate.LOW: (110, 120),
    Fate.FOLIAGE: (77, 157),
    Fate.FURNITURE: (43, 45),
}
"""A row and column of the site for each fate."""


def whole(shape):
    return View(slice(0, shape[0]), slice(0, shape[1]), np.zeros((2, 2)))


def test_a_view_shows_what_is_set_with_a_tenth_around_it():
    pixels = np.zeros((100, 200), bool)
    pixels[40:60, 50:90] = True
    view = View.around(pixels, Affine(0.5, 0, 1000, 0, -0.5, 2000))

    # The larger side has 40 pixels, so that the margin is 4.
    assert (view.rows, view.columns) == (slice(36, 64), slice(46, 94))
    np.testing.assert_array_equal(view.corners, [(1023, 1982), (1047, 1968)])
    assert view.part(pixels).shape == (28, 48)


def test_a_view_ends_at_the_edge_of_the_raster():
    pixels = np.zeros((100, 200), bool)
    pixels[0, 0] = pixels[-1, -1] = True

    view = View.around(pixels, Affine.identity())
    assert (view.rows, view.columns) == (slice(0, 100), slice(0, 200))


@pytest.mark.parametrize("fate", PLACES)
def test_a_pixel_has_the_fate_that_a_criterion_gave_it(plan, fate):
    assert Fate(fates(plan, whole(plan.image.walls.shape))[PLACES[fate]]) is fate


def test_fates_are_those_of_the_part_that_is_shown(plan):
    view = View.around(plan.image.gated > 0, plan.transform)

    np.testing.assert_array_equal(
        fates(plan, view), fates(plan, whole(plan.image.walls.shape))[view.rows, view.columns]
    )


def test_without_a_height_criterion_nothing_is_foliage_or_furniture(plan):
    gate = replace(plan.image.gate, foliage=None, furniture=None)
    blind = replace(plan, image=replace(plan.image, gate=gate))
    found = fates(blind, whole(plan.image.walls.shape))

    assert not np.isin(found, (Fate.FOLIAGE, Fate.FURNITURE)).any()
    assert found[PLACES[Fate.WALL]] == Fate.WALL


def test_at_one_threshold_a_pixel_has_the_fate_of_its_verdict():
    verdicts = np.array([[Verdict.FAINT, Verdict.SMALL], [Verdict.MISSHAPEN, Verdict.KEPT]], np.uint8)

    np.testing.assert_array_equal(
        fates_at(verdicts, whole((2, 2))), [[Fate.UNSEEN, Fate.SMALL], [Fate.MISSHAPEN, Fate.WALL]]
    )


def test_every_fate_has_a_colour_of_its_own():
    colours = coloured(np.array([list(Fate)], np.uint8))

    assert [tuple(colour) for colour in colours[0]] == [COLOURS[fate] for fate in Fate]
    assert len(set(COLOURS.values())) == len(Fate)


def test_a_picture_that_is_too_large_shows_the_largest_fate_of_each_block():
    fate = np.full((3, 5), Fate.SURFACE, np.uint8)
    fate[0, 1] = Fate.WALL

    np.testing.assert_array_equal(
        fitted(fate, largest=3), [[Fate.WALL, Fate.SURFACE, Fate.SURFACE], [Fate.SURFACE] * 3]
    )
    np.testing.assert_array_equal(fitted(fate, largest=5), fate)
    assert coloured(fate, largest=3).shape == (2, 3, 3)
