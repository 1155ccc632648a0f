"""An edge is where most of the border beside it agrees, and says how sure it is."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.outlines.edges import biweight, border_deviation, edge_deviation, fit_edge

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
