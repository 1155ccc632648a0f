"""Along circles and sides, points are moved into a plane and back; lengths along the wall are kept."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from ichnograph.algorithms.facade.development.curves import Chain, Circle, axes_of

from .towers import BAY

TOWER = Circle(np.array([3.0, 7.0]), 2.5, 200.0)
CHAIN = Chain(np.array(BAY, float), 2)
PLACES = st.tuples(st.floats(-3.5, 3.5), st.floats(-0.5, 0.3))


def at(curve, along, away):
    """Return a point in the plane of a curve."""
    return (curve.anchor + np.array([along, away]) @ axes_of(curve.azimuth))[None]


@given(PLACES)
@pytest.mark.parametrize("curve", [TOWER, CHAIN])
def test_a_point_on_the_wall_comes_back_to_where_it_was(curve, place):
    along, _ = place
    flat = at(curve, along, 0.0)
    np.testing.assert_allclose(curve.flat(curve.site(flat)), flat, atol=1e-9)


@given(PLACES)
def test_around_a_tower_depths_come_back_too(place):
    flat = at(TOWER, *place)
    np.testing.assert_allclose(TOWER.flat(TOWER.site(flat)), flat, atol=1e-9)


def test_the_middle_of_the_wall_stays_where_it_is():
    for curve in (TOWER, CHAIN):
        np.testing.assert_allclose(curve.flat(curve.anchor[None])[0], curve.anchor, atol=1e-9)


def test_an_arc_is_as_long_in_the_plane_as_on_the_tower():
    turns = np.radians(np.array([200.0, 230.0, 170.0]))
    wall = TOWER.centre + TOWER.radius * np.column_stack([np.sin(turns), np.cos(turns)])
    along = (TOWER.flat(wall) - TOWER.anchor) @ axes_of(TOWER.azimuth)[0]
    # Seen from the south, the west is on the left.
    np.testing.assert_allclose(along, TOWER.radius * np.radians([0, -30, 30]), atol=1e-9)


def test_sides_lie_beside_each_other_at_their_lengths():
    flat = CHAIN.flat(np.array(BAY, float))
    lengths = np.linalg.norm(np.diff(np.array(BAY, float), axis=0), axis=1)
    np.testing.assert_allclose(np.linalg.norm(np.diff(flat, axis=0), axis=1), lengths, atol=1e-9)
    np.testing.assert_allclose(flat[:, 1], -0.8, atol=1e-9)


def test_a_curve_moves_with_the_site():
    shift = np.array([412_000.0, 5_812_000.0])
    for curve in (TOWER, CHAIN):
        flat = at(curve, 1.7, -0.1)
        np.testing.assert_allclose(curve.moved(shift).site(flat + shift), curve.site(flat) + shift, atol=1e-6)
