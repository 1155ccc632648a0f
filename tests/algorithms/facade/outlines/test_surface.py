"""The points of a plane as a surface: neighbours, noise, outline."""

import numpy as np
import pytest
from ichnograph.algorithms.errors import CancelledError
from ichnograph.algorithms.facade.outlines.surface import make_surface
from ichnograph.algorithms.facade.settings import FacadeSettings
from ichnograph.algorithms.progress import Progress
from ichnograph.tests.algorithms.facade.samples import lattice, without


def test_a_surface_whose_points_come_twice_is_the_surface_of_the_points():
    uvw = np.column_stack([lattice(0, 0, 2, 1, 0.05), np.zeros(800)])
    once = make_surface(uvw, np.arange(len(uvw)), FacadeSettings())
    twice = make_surface(np.repeat(uvw, 2, axis=0), np.arange(2 * len(uvw)), FacadeSettings())

    assert twice.spacing == pytest.approx(once.spacing)
    assert twice.outline.area == pytest.approx(once.outline.area)


def test_edges_across_a_hole_do_not_join_neighbours():
    uvw = np.column_stack([without(lattice(0, 0, 2, 1, 0.05), 0.5, 0.3, 1.0, 0.7), np.zeros(720)])
    surface = make_surface(uvw, np.arange(len(uvw)))

    assert surface.mesh.lengths[surface.linked].max() < 0.2 < surface.mesh.lengths.max()
    assert surface.area_of_point == pytest.approx(0.05**2, rel=0.2)
    assert surface.sizes.sum() == pytest.approx(surface.outline.area)


def test_stray_points_represent_no_area():
    stray = np.random.default_rng(0).uniform((2.5, 0), (4, 1), (12, 2))
    uvw = np.column_stack([np.concatenate([lattice(0, 0, 2, 1, 0.05), stray]), np.zeros(812)])
    surface = make_surface(uvw, np.arange(len(uvw)))

    assert (surface.sizes[surface.rows >= 800] == 0).all()
    assert surface.outline.bounds[2] < 2.0


def test_a_given_alpha_is_used_and_another_follows_the_spacing():
    uvw = np.column_stack([lattice(0, 0, 2, 1, 0.05), np.zeros(800)])

    assert make_surface(uvw, np.arange(800), FacadeSettings(alpha_m=0.3)).alpha == 0.3
    assert make_surface(uvw, np.arange(800)).alpha == pytest.approx(1.8 * 0.05, rel=0.01)


def test_a_cancelled_run_does_not_finish_the_surface():
    uvw = np.random.default_rng(0).random((200, 3))

    with pytest.raises(CancelledError):
        make_surface(uvw, np.arange(200), progress=Progress(is_cancelled=lambda: True))
