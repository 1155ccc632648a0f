"""Coloured details: panels are found, shadows and gradients are not."""

import numpy as np
from ichnograph.algorithms.facade.colour.appearance import Appearance
from ichnograph.algorithms.facade.colour.coloured_details import find_coloured
from ichnograph.algorithms.facade.settings import FacadeSettings
from ichnograph.tests.algorithms.facade.colour.panel import (
    LINKED,
    MESH,
    PANEL,
    POINTS,
    SHADE,
    SIZES,
    painted,
    reflecting,
)


def found(rgb, relative, **changes):
    looks = Appearance(rgb, relative, 0.06)
    return find_coloured(MESH, LINKED, SIZES, looks, FacadeSettings(**changes))


def test_a_cast_shadow_is_not_a_detail_but_the_panel_in_it_is():
    rgb = painted() * np.where(SHADE, 0.42, 1.0)[:, None].astype(np.float32)
    coloured = found(rgb, reflecting())
    assert coloured.labels.max() == 1
    assert np.mean((coloured.labels == 1) == PANEL) > 0.99


def test_a_gradient_of_brightness_is_not_a_detail_even_without_intensity():
    rgb = painted() * (1 - 0.5 * POINTS[:, :1] / 3).astype(np.float32)
    coloured = found(rgb, None)
    assert coloured.labels.max() == 1
    assert np.mean((coloured.labels == 1) == PANEL) > 0.99


def test_regions_below_the_smallest_area_are_left_out():
    assert found(painted(), reflecting(), min_area_m2=0.6).labels.max() == 0
    assert found(painted(), reflecting(), min_area_m2=0.4).labels.max() == 1
