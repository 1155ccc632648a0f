"""Triangles fill the walls and the space around them."""

import numpy as np
import pytest
from ichnograph.algorithms.geometry.outline_triangles import triangulate_outlines
from ichnograph.algorithms.geometry.settings import OutlineMeshSettings
from shapely.affinity import translate
from shapely.geometry import Polygon, box

HOUSE = box(0, 0, 6, 4).difference(box(0.3, 0.3, 5.7, 3.7))


def test_the_triangles_of_walls_have_the_area_of_the_walls():
    mesh = triangulate_outlines([HOUSE])
    assert mesh.areas()[mesh.wall].sum() == pytest.approx(HOUSE.area)
    assert mesh.areas().sum() == pytest.approx(8 * 6)


def test_walls_that_overlap_count_once():
    mesh = triangulate_outlines([box(0, 0, 5, 0.3), box(0, 0, 0.3, 5)])
    assert mesh.areas()[mesh.wall].sum() == pytest.approx(3 - 0.09)


def test_every_piece_of_an_outline_is_the_side_of_a_triangle_even_at_a_sliver():
    sliver = Polygon([(0, 0), (5, 0), (5, 0.002), (0, 0.002)])
    mesh = triangulate_outlines([sliver])
    lengths = mesh.lengths(mesh.outline_pieces())
    assert lengths.sum() == pytest.approx(sliver.length, abs=1e-3)


def test_grid_coordinates_lose_no_digits():
    mesh = triangulate_outlines([translate(HOUSE, 412_300, 5_812_700)])
    assert mesh.origin == pytest.approx([412_300, 5_812_700])
    assert mesh.areas()[mesh.wall].sum() == pytest.approx(HOUSE.area)


def test_shared_sides_lie_between_triangles_of_one_kind_and_on_no_outline():
    mesh = triangulate_outlines([HOUSE])
    sides = mesh.sides(mesh.wall)
    assert mesh.wall[sides.first].all() and mesh.wall[sides.second].all()
    pieces = {tuple(sorted(piece)) for piece in mesh.outline_pieces().tolist()}
    assert not pieces & {tuple(sorted(ends)) for ends in sides.ends.tolist()}
    np.testing.assert_allclose(sides.lengths, mesh.lengths(sides.ends))


def test_widths_are_the_diameters_of_clear_circles():
    mesh = triangulate_outlines([box(0, 0, 5, 0.4)])
    assert mesh.widths()[mesh.wall].max() == pytest.approx(0.4, abs=0.02)


def test_the_space_around_reaches_the_margin():
    wide = triangulate_outlines([HOUSE], margin=3.0)
    assert np.ptp(wide.points, axis=0) == pytest.approx([12, 10])
    near = triangulate_outlines([HOUSE], OutlineMeshSettings(margin_m=0.5))
    assert np.ptp(near.points, axis=0) == pytest.approx([7, 5])


def test_faces_that_cross_by_less_than_a_millimetre_end_the_halving():
    # Rounding of large coordinates leaves such outlines; each round of halving would double their points.
    slit = Polygon([(0, 0), (8, 0), (8, 3), (4.00005, 3), (4, 0.5), (3.99995, 3), (0, 3)])
    mesh = triangulate_outlines([slit, box(4, 2.9999, 12, 6)])
    assert len(mesh.points) < 20_000
