"""The whole wall: completed where something hides it, with openings and recesses as holes."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.elevation import COLOURED, OPENING, PROJECTION
from ichnograph.algorithms.facade.outlines.surface import make_surface
from ichnograph.algorithms.facade.outlines.wall_extent import complete, parts_of
from ichnograph.tests.algorithms.facade.samples import at, lattice, without
from shapely.geometry import MultiPolygon, box

STEP, SMALLEST = 0.02, 0.04
HOLE = (1.0, 0.8, 1.8, 1.6)


def wall_of(*holes):
    points = lattice(0, 0, 3, 2, STEP)
    for hole in holes:
        points = without(points, *hole)
    return make_surface(at(points), np.arange(len(points)))


def test_a_wall_ends_half_a_spacing_beyond_its_outermost_points():
    whole = complete(wall_of(), {}, 0.0, SMALLEST)

    assert whole.face.bounds == pytest.approx((0, 0, 3, 2), abs=0.001)
    assert whole.face.area == pytest.approx(6, abs=0.01)
    assert whole.unseen == ()


def test_an_opening_is_a_hole_of_the_wall_and_a_coloured_detail_is_not():
    opening, panel = box(*HOLE), box(2.2, 0.8, 2.6, 1.6)
    whole = complete(wall_of(HOLE), {OPENING: [opening], COLOURED: [panel]}, 0.0, SMALLEST)

    assert whole.face.intersection(opening).area == pytest.approx(0)
    assert whole.face.area == pytest.approx(6 - opening.area, abs=0.01)


def test_a_scan_shadow_is_unseen_and_part_of_the_wall():
    whole = complete(wall_of(HOLE), {}, 0.0, SMALLEST)

    (unseen,) = whole.unseen
    assert unseen.symmetric_difference(box(*HOLE)).area < 0.04
    assert whole.face.area == pytest.approx(6, abs=0.01)


def test_a_strip_beside_a_projection_that_hides_it_is_unseen():
    strip, cornice = box(0, 1.3, 3, 1.55), box(0, 1.55, 3, 1.8)
    wall = wall_of((-1, 1.3, 4, 1.8))
    whole = complete(wall, {PROJECTION: [cornice]}, 0.3, SMALLEST)

    assert whole.face.area == pytest.approx(6, abs=0.02)
    (unseen,) = whole.unseen
    assert unseen.symmetric_difference(strip).area < 0.1


def test_a_storey_that_is_set_back_belongs_to_the_wall():
    storey, window = box(0, 2, 3, 3), box(1, 2.2, 2, 2.8)
    whole = complete(wall_of(HOLE), {OPENING: [box(*HOLE), window]}, 0.0, SMALLEST, parts=[storey])

    assert whole.unseen == ()
    assert whole.face.area == pytest.approx(9 - box(*HOLE).area - window.area, abs=0.06)


def test_parts_without_an_area_are_left_out():
    assert parts_of(MultiPolygon([box(0, 0, 1, 1), box(2, 0, 3, 1)])) == [box(0, 0, 1, 1), box(2, 0, 3, 1)]
    assert parts_of(box(0, 0, 1, 1).intersection(box(1, 0, 2, 1))) == []
