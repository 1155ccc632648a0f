"""Noise is removed: points among large triangles (delta and eta of the paper)."""

import numpy as np
from ichnograph.algorithms.facade.outlines.denoising import remove_noise
from ichnograph.algorithms.geometry.triangulation import triangulate
from ichnograph.tests.algorithms.facade.samples import lattice, scattered

PAPER = {"factor": 3.0, "count": 5, "rounds": 10}


def test_points_that_stray_far_from_the_surface_are_noise():
    generator = np.random.default_rng(0)
    surface = scattered(lattice(0, 0, 1, 1, 0.02))
    stray = np.column_stack([generator.uniform(1.2, 2.0, 12), generator.uniform(0, 1, 12)])
    kept = remove_noise(triangulate(np.concatenate([surface, stray])), **PAPER)
    assert kept[: len(surface)].mean() > 0.98
    assert kept[len(surface) :].mean() < 0.5


def test_more_large_triangles_are_allowed_with_a_larger_count_and_none_go_without_rounds():
    generator = np.random.default_rng(0)
    points = np.concatenate([lattice(0, 0, 1, 1, 0.02), generator.uniform(1.2, 2, (30, 2))])
    mesh = triangulate(points)
    removed = [np.sum(~remove_noise(mesh, **{**PAPER, **change})) for change in (
        {"count": 3}, {"count": 5}, {"count": 100}, {"rounds": 0})]  # fmt: skip
    assert removed[0] >= removed[1] > removed[2] == removed[3] == 0


def test_larger_triangles_are_allowed_with_a_larger_factor():
    points = np.concatenate([lattice(0, 0, 1, 1, 0.02), np.random.default_rng(0).uniform(1.2, 2, (30, 2))])
    mesh = triangulate(points)
    assert remove_noise(mesh, 1e6, 5, 10).all()
    assert not remove_noise(mesh, 3, 5, 10).all()
