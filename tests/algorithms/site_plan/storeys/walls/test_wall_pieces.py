"""Pieces of walls between junctions."""

import pytest
from ichnograph.algorithms.site_plan.storeys.walls.wall_pieces import cut_at_junctions
from shapely.geometry import LineString, Polygon, box
from shapely.ops import unary_union


def network(*axes, thickness=0.2):
    return unary_union([LineString(axis).buffer(thickness / 2, cap_style=3, join_style=2) for axis in axes])


def test_a_wall_that_meets_another_is_cut_at_its_foot():
    pieces = cut_at_junctions(network([(0, 0), (6, 0)], [(3, 0), (3, 4)]))
    assert sorted(round(piece.area, 3) for piece in pieces) == pytest.approx([0.80, 1.24], abs=0.01)


def test_pieces_fill_the_body_and_share_their_edges():
    body = network([(0, 0), (6, 0), (6, 5), (0, 5), (0, 0)], [(3, 0), (3, 5)])
    pieces = cut_at_junctions(body)
    assert sum(piece.area for piece in pieces) == pytest.approx(body.area, abs=1e-6)
    assert unary_union(pieces).symmetric_difference(body).area < 1e-6
    assert all(not one.crosses(other) for one in pieces for other in pieces)


def test_a_straight_wall_is_one_piece():
    assert len(cut_at_junctions(network([(0, 0), (6, 0)]))) == 1


def test_the_walls_around_a_room_are_cut_at_its_corners():
    ring = box(0, 0, 4, 3).difference(box(0.2, 0.2, 3.8, 2.8))
    pieces = cut_at_junctions(ring)
    assert len(pieces) == 4
    assert sum(piece.area for piece in pieces) == pytest.approx(ring.area, abs=1e-6)


def test_at_a_crossing_one_wall_goes_on_and_the_other_is_parted():
    pieces = cut_at_junctions(network([(0, 3), (6, 3)], [(3, 0), (3, 6)]))
    assert unary_union(pieces).area == pytest.approx(2 * 1.24 - 0.04, abs=1e-3)
    assert sorted(piece.area for piece in pieces) == pytest.approx([0.6, 0.6, 1.24], abs=1e-3)


def test_a_slight_bend_is_no_junction():
    bent = LineString([(0, 0), (3, 0), (6, 0.3)]).buffer(0.1, cap_style=2, join_style=2)
    assert len(cut_at_junctions(bent)) == 1


def test_what_is_wider_than_a_wall_is_not_cut():
    corner = Polygon([(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)])
    assert len(cut_at_junctions(corner)) == 1


def test_a_scrap_is_no_piece():
    nose = unary_union([box(0, 0, 4, 0.2), box(1.5, 0.2, 1.52, 0.22)])
    assert len(cut_at_junctions(nose)) == 1
    assert len(cut_at_junctions(nose.union(box(2.5, 0.2, 2.7, 2)))) == 2
