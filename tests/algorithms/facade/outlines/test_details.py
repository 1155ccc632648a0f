"""The borders of details are traced between their own points and those around them."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.colour.appearance import Appearance
from ichnograph.algorithms.facade.colour.coloured_details import Coloured
from ichnograph.algorithms.facade.elevation import COLOURED, PROJECTION, RECESS
from ichnograph.algorithms.facade.openings.content import fill_regions
from ichnograph.algorithms.facade.openings.regions import find_regions
from ichnograph.algorithms.facade.openings.states import make_states
from ichnograph.algorithms.facade.outlines.details import (
    Scene,
    coloured_details,
    opening_details,
    projecting_details,
    stand_ins,
)
from ichnograph.algorithms.facade.outlines.surface import make_surface
from ichnograph.algorithms.facade.settings import FacadeSettings
from ichnograph.tests.algorithms.facade.samples import at, lattice, without

STEP = 0.02
HOLE = (1.0, 0.8, 1.8, 1.6)
SETTINGS = FacadeSettings()
NOTHING = np.empty((0, 3))


def scene_of(wall, *others):
    """Return the wall as plane 1, and others with their labels."""
    uvw = np.concatenate([at(wall), *(points for points, _ in others)])
    labels = np.concatenate([np.ones(len(wall)), *(np.full(len(points), label) for points, label in others)])
    scene = Scene(uvw, labels.astype(np.int16))
    return scene, make_surface(uvw, np.flatnonzero(scene.labels == 1), SETTINGS)


def holed():
    return without(lattice(0, 0, 3, 2.4, STEP), *HOLE)


def openings_of(scene):
    """Return the states of a scene and its openings."""
    states = make_states(scene.uvw, scene.labels == 1, 0.05)
    return states, fill_regions(states, find_regions(states))


def test_the_border_of_a_recess_is_that_of_the_wall_whatever_fills_it():
    left, bottom, right, top = HOLE
    pane = at(lattice(left + 0.1, bottom + 0.1, right, top, STEP), -0.15)
    scene, _ = scene_of(holed(), (pane, 0))
    states, openings = openings_of(scene)
    (found,) = opening_details(scene, states, openings, SETTINGS)

    assert found.kind == RECESS and found.depth == pytest.approx(-0.15)
    assert found.border.ring.bounds == pytest.approx(HOLE, abs=0.3 * STEP)
    assert (scene.uvw[found.rows, 2] == -0.15).all()


def test_points_of_a_jamb_are_kept_for_the_edge_that_they_show():
    left, bottom, _, top = HOLE
    v, w = np.meshgrid(np.arange(bottom, top, STEP), np.arange(-0.14, -0.02, STEP))
    jamb = np.column_stack([np.full(v.size, left), v.ravel(), w.ravel()])
    scene, _ = scene_of(holed(), (jamb, 0), (at(lattice(*HOLE, STEP), -0.15), 0))
    states, openings = openings_of(scene)
    (found,) = opening_details(scene, states, openings, SETTINGS)

    assert len(found.border.jambs) > 50
    assert np.abs(found.border.jambs[:, 0] - left).max() < 1e-9


def test_a_projection_is_as_deep_as_its_median():
    panel = at(lattice(*HOLE, STEP), 0.12)
    scene, _ = scene_of(holed(), (panel, 2))
    surface = make_surface(scene.uvw, np.flatnonzero(scene.labels == 2), SETTINGS)
    (found,) = projecting_details(scene, 2, surface, NOTHING, SETTINGS)

    assert found.kind == PROJECTION and found.depth == pytest.approx(0.12)
    assert found.border.ring.bounds == pytest.approx(HOLE, abs=0.6 * STEP)


def test_a_projection_below_the_smallest_area_is_left_out():
    panel = at(lattice(1, 1, 1.12, 1.12, STEP), 0.12)
    scene, _ = scene_of(lattice(0, 0, 3, 2.4, STEP), (panel, 2))
    surface = make_surface(scene.uvw, np.flatnonzero(scene.labels == 2), SETTINGS)

    assert list(projecting_details(scene, 2, surface, NOTHING, SETTINGS)) == []


def test_a_coloured_detail_ends_where_the_colour_changes():
    scene, surface = scene_of(lattice(0, 0, 3, 2.4, STEP))
    left, bottom, right, top = HOLE
    u, v = surface.mesh.points.T
    panel = (u > left) & (u < right) & (v > bottom) & (v < top)
    rgb = np.where(panel[:, None], (70.0, 105, 85), (210.0, 200, 180)).astype(np.float32)
    coloured = Coloured(panel.astype(np.int32), Appearance(rgb), 2, 2, 200.0)
    (found,) = coloured_details(scene, surface, coloured, NOTHING, SETTINGS)

    assert found.kind == COLOURED and found.depth == 0
    assert found.border.ring.bounds == pytest.approx(HOLE, abs=1e-6)
    np.testing.assert_array_equal(np.sort(found.rows), np.sort(surface.rows[panel]))


def test_without_colour_there_are_no_coloured_details():
    scene, surface = scene_of(lattice(0, 0, 1, 1, STEP))
    coloured = Coloured(np.zeros(len(surface.rows), np.int32), None, 1, 1, np.nan)

    assert list(coloured_details(scene, surface, coloured, NOTHING, SETTINGS)) == []


def test_points_infinitely_far_stand_in_for_what_is_behind_a_hole():
    scene, _ = scene_of(holed(), (at(lattice(*HOLE, STEP), -0.15), 0))
    uvw = stand_ins(openings_of(scene)[1], STEP)

    assert np.isneginf(uvw[:, 2]).all()
    low, high = uvw[:, :2].min(axis=0), uvw[:, :2].max(axis=0)
    assert (low > HOLE[:2]).all() and (high < HOLE[2:]).all()
    assert len(uvw) == pytest.approx(0.72**2 / STEP**2, rel=0.15)
    assert len(stand_ins([], STEP)) == 0
