"""The border between two sides is unbiased, whether both can be seen or one hides the other."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.facade.outlines.border import Lost, trace_border
from ichnograph.algorithms.facade.outlines.regular_outlines import make_outline
from ichnograph.tests.algorithms.facade.samples import at, lattice

STEP, BAND = 0.02, 0.3
NOTHING = np.empty((0, 2))


def sides(left, bottom, right, top, seed=0):
    """Random points within a rectangle, and around it."""
    points = np.random.default_rng(seed).uniform((-0.5, -0.5), (1.5, 1.5), (10000, 2))
    inside = ((points > (left, bottom)) & (points < (right, top))).all(axis=1)
    return points[inside], points[~inside]


@settings(max_examples=15, deadline=None)
@given(seed=st.integers(0, 1000), right=st.floats(0.6, 1.0))
def test_the_mean_of_the_two_sides_is_where_the_edge_is(seed, right):
    inside, outside = sides(0.1, 0.2, right, 0.9, seed)
    outline = make_outline(trace_border(at(inside), at(outside), NOTHING, 0.05, BAND), True)

    assert outline.polygon.bounds == pytest.approx((0.1, 0.2, right, 0.9), abs=0.006)


def test_each_side_alone_would_be_off_by_about_half_the_spacing():
    inside, outside = sides(0.1, 0.2, 0.8, 0.9)
    ring = trace_border(at(inside), at(outside), NOTHING, 0.05, BAND).ring
    reached = inside.max(axis=0) - inside.min(axis=0)

    assert (reached < (0.7, 0.7)).all()
    assert ring.area == pytest.approx(0.49, rel=0.01)


@pytest.mark.parametrize("strip", [0.03, 0.1, 0.2])
def test_a_strip_that_the_front_hides_does_not_move_the_edge(strip):
    found = []
    for seed in range(20):
        inside, outside = sides(0.1, 0.2, 0.8, 0.9, seed)
        seen = inside[inside[:, 1] > 0.2 + strip]
        filler = lattice(0.2, 0.3, 0.7, 0.8, STEP)
        outline = make_outline(trace_border(at(seen, -0.2), at(outside), filler, 0.05, BAND), True)
        found.append(outline.polygon.bounds[1])

    assert np.mean(found) == pytest.approx(0.2, abs=0.002)
    assert np.std(found) < 0.004


def test_an_opening_into_nothing_ends_half_a_spacing_beyond_the_wall():
    places = lattice(-0.5, -0.5, 1.5, 1.5, STEP)
    inside = ((places > (0.1, 0.2)) & (places < (0.8, 0.9))).all(axis=1)
    filler = lattice(0.16, 0.26, 0.74, 0.84, STEP)
    outline = make_outline(trace_border(at(NOTHING), at(places[~inside]), filler, 0.05, BAND), True)

    assert outline.polygon.bounds == pytest.approx((0.1, 0.2, 0.8, 0.9), abs=0.001)


def test_points_that_the_front_lost_to_mixed_spots_count_for_it():
    places = lattice(-0.5, -0.5, 1.5, 1.5, 0.01)
    hole = ((places > (0.1, 0.2)) & (places < (0.8, 0.9))).all(axis=1)
    mixed = ~hole & (places[:, 1] > 0.19) & (places[:, 1] < 0.2) & (places[:, 0] > 0.1) & (places[:, 0] < 0.8)
    filler = lattice(0.16, 0.26, 0.74, 0.84, 0.01)
    outside = at(places[~hole & ~mixed])
    naive = trace_border(at(NOTHING), outside, filler, 0.05, BAND)
    aware = trace_border(at(NOTHING), outside, filler, 0.05, BAND, Lost(places[mixed], 1e-4))

    assert make_outline(naive, True).polygon.bounds[1] == pytest.approx(0.19, abs=0.001)
    assert make_outline(aware, True).polygon.bounds[1] == pytest.approx(0.2, abs=0.002)


def test_a_detail_without_points_has_no_border():
    assert trace_border(at(NOTHING), at(lattice(0, 0, 1, 1, STEP)), NOTHING, 0.05, BAND).ring.is_empty
