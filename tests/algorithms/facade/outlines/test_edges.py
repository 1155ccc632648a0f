"""An edge is where most of the border beside it agrees, and says how sure it is."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.outlines.edges import (
    Edge,
    biweight,
    border_deviation,
    edge_at_wall,
    edge_deviation,
    fit_edge,
)

GAP = 0.01


def border(count=150, scatter=0.003, seed=0):
    along = np.linspace(0, 1.5, count)
    return np.random.default_rng(seed).normal(0.5, scatter, count), along


def edge_of(across, along, fallback=0.4):
    return fit_edge(across, along, np.full(len(across), GAP), (0.0, 1.5), fallback)


def test_an_edge_is_the_mean_of_its_border():
    edge = edge_of(*border())

    assert edge.measured
    assert edge.position == pytest.approx(0.5, abs=0.001)
    assert (edge.first, edge.last) == pytest.approx((0, 1.5), abs=0.1)


def test_a_frame_along_a_third_of_it_does_not_move_an_edge():
    across, along = border()
    across[along > 1.0] += 0.06

    assert edge_of(across, along).position == pytest.approx(0.5, abs=0.001)


def test_where_the_border_agrees_on_nothing_the_edge_is_the_fallback_and_not_measured():
    _, along = border()
    edge = edge_of(np.random.default_rng(1).uniform(0, 1, len(along)), along)

    assert not edge.measured and np.isnan(edge.std)
    assert edge.position == 0.4


def test_too_short_a_piece_does_not_measure_an_edge():
    across, along = border()
    assert not edge_of(across[along < 0.3], along[along < 0.3]).measured


def test_deviations_agree_with_the_errors_of_random_borders():
    found = [edge_of(*border(seed=seed)) for seed in range(60)]
    errors = [edge.position - 0.5 for edge in found]

    # The border of a scan in step with the edge does not scatter, so the gap counts as well.
    assert np.std(errors) < np.mean([edge.std for edge in found]) < 0.5 * GAP


def test_an_edge_along_a_line_of_the_scan_may_lie_anywhere_in_the_gap():
    crossings = np.column_stack([np.zeros(100), np.linspace(0, 1, 100)])
    assert edge_deviation(np.zeros(100), crossings, np.full(100, GAP)) == pytest.approx(
        GAP / np.sqrt(12), rel=0.1
    )


def test_an_edge_that_leans_is_uncertain_by_its_lean():
    across, along = border(scatter=0.001)
    upright, leaning = (edge_of(across + rise * (along / 1.5 - 0.5), along) for rise in (0, 0.024))
    assert leaning.position == pytest.approx(upright.position, abs=0.002)
    assert upright.std < 0.004
    assert leaning.std == pytest.approx(0.024 / np.sqrt(12), rel=0.15)


def test_an_edge_that_was_not_seen_has_no_deviation():
    assert np.isnan(edge_deviation(np.empty(0), np.empty((0, 2)), np.empty(0)))


def test_a_few_gross_errors_do_not_move_a_robust_mean():
    values = np.concatenate([np.linspace(-0.01, 0.01, 21), [1.0, 2.0]])
    assert biweight(values, 0.0) == pytest.approx(0, abs=1e-6)


def test_the_ends_of_a_surface_are_less_sure_than_a_jamb_however_many_agree():
    along = np.linspace(0, 1.5, 1000)
    scatter = np.random.default_rng(0).normal(0, 0.006, 1000)
    crossings = np.stack([scatter, along], axis=1)
    ends = border_deviation(scatter, crossings, np.full(1000, 0.02), 0.02)
    jamb = border_deviation(scatter, crossings, np.zeros(1000), 0.02)

    assert jamb < 0.0015
    assert 0.15 * 0.02 < ends < 0.25 * 0.02


def jamb(slope, noise=0.001):
    """Positions and depths of points on a jamb that meets the wall at 1 m."""
    generator = np.random.default_rng(0)
    depths = generator.uniform(0.01, 0.25, 500)
    return 1.0 + slope * depths + generator.normal(0, noise, 500), depths


@pytest.mark.parametrize("slope", [-0.15, 0.15])
def test_the_edge_of_an_oblique_jamb_is_where_it_meets_the_wall(slope):
    across, depths = jamb(slope)
    start = float(np.median(across[np.abs(across - 1.0) < 0.01]))
    edge = edge_at_wall(Edge(start, 0.001), across, depths, 0.01)
    assert edge.position == pytest.approx(1.0, abs=0.0005)
    assert edge.std >= 0.001


def test_the_edge_of_a_square_jamb_stays_where_its_points_are():
    across, depths = jamb(0.01)
    edge = Edge(float(np.median(across)), 0.001)
    assert edge_at_wall(edge, across, depths, 0.01) is edge


def test_a_few_points_that_lie_off_a_square_jamb_do_not_turn_it():
    across, depths = jamb(0.0)
    off = 1.0 + 0.1 * depths[:60]
    edge = Edge(1.0, 0.001)
    found = edge_at_wall(edge, np.concatenate([across, off]), np.concatenate([depths, depths[:60]]), 0.01)
    assert found is edge


def test_points_at_one_depth_do_not_show_whether_a_jamb_is_oblique():
    edge = Edge(1.0, 0.001)
    assert edge_at_wall(edge, 1.0 + 0.001 * np.arange(9), 0.1 + 0.001 * np.arange(9), 0.01) is edge
