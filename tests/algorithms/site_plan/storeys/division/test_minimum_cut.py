"""The cheapest division into two kinds."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.storeys.division.minimum_cut import minimum_cut


def test_without_borders_each_cell_takes_its_cheaper_kind():
    found = minimum_cut(np.array([0.0, 2.0]), np.array([1.0, 1.0]), np.zeros((0, 2), int), np.zeros(0))
    assert found.tolist() == [True, False]


@pytest.mark.parametrize("border, together", [(0.2, False), (2.0, True)])
def test_a_dear_border_keeps_neighbours_together(border, together):
    found = minimum_cut(np.array([0.0, 1.0]), np.array([3.0, 0.0]), np.array([[0, 1]]), np.array([border]))
    assert found.tolist() == [True, together]


def test_it_is_as_cheap_as_the_best_of_all_divisions():
    rng = np.random.default_rng(4)
    for _ in range(20):
        first, second = rng.uniform(0, 1, (2, 7))
        pairs = np.array([(i, j) for i in range(7) for j in range(i) if rng.random() < 0.4]).reshape(-1, 2)
        between = rng.uniform(0, 0.5, len(pairs))

        def cost(kinds, first=first, second=second, pairs=pairs, between=between):
            unlike = kinds[pairs[:, 0]] != kinds[pairs[:, 1]]
            return np.where(kinds, first, second).sum() + between[unlike].sum()

        every = [np.array([n >> i & 1 for i in range(7)], bool) for n in range(128)]
        found = minimum_cut(first, second, pairs, between)
        assert cost(found) == pytest.approx(min(cost(kinds) for kinds in every), abs=1e-5)
