"""Walls behind faces, and their pieces between junctions."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.storeys.outlines import tidy
from ichnograph.algorithms.site_plan.storeys.wall_bodies import wall_bodies
from ichnograph.algorithms.site_plan.storeys.wall_pieces import cut_at_junctions
from shapely.geometry import LineString, Polygon, box
from shapely.ops import unary_union


def faces_of(rooms):
    """Return the borders of rooms as faces, the solid to the left; shape (n, 4)."""
    found = []
    for room in rooms:
        corners = np.asarray(Polygon(room.exterior).exterior.coords)
        corners = corners if not room.exterior.is_ccw else corners[::-1]
        found.append(np.hstack([corners[:-1], corners[1:]]))
    return np.concatenate(found)


def bodies_between(*rooms):
    solid = box(-2, -2, 12, 12).difference(unary_union(rooms))
    return wall_bodies(faces_of(rooms), solid)


def network(*axes, thickness=0.2):
    return unary_union([LineString(axis).buffer(thickness / 2, cap_style=3, join_style=2) for axis in axes])


def test_a_wall_of_two_faces_fills_what_is_between_them():
    (body,) = bodies_between(box(0, 0, 4, 3), box(4.2, 0, 8, 3))
    assert body.contains(box(4.01, 0.01, 4.19, 2.99))


def test_a_deep_solid_gives_a_strip_along_each_face():
    bodies = bodies_between(box(0, 0, 4, 3), box(6, 0, 8, 3))
    assert len(bodies) == 2
    assert not any(body.intersects(box(4.1, 0, 5.9, 3)) for body in bodies)


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


def test_tiny_edges_and_idle_corners_go():
    drawn = Polygon([(0, 0), (1, 0.0004), (2, 0), (2, 0.5), (2.001, 0.502), (2, 1), (0, 1)])
    assert len(tidy(drawn).exterior.coords) == 5
    assert tidy(drawn).symmetric_difference(box(0, 0, 2, 1)).area < 0.002
