"""The space of a search: how wide seeds must be, lines of targets, and the order of the search."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.settings import Model, Settings
from ichnograph.tests.algorithms.registration.hall import HALL, scanned
from ichnograph.tests.algorithms.registration.matching.matching_cases import space

LINE = np.array([[0.0, 0, 0], [2.1, 0, 0], [5.3, 0, 0], [11.0, 0, 0], [4.0, 6.0, 1.0]])
POLE = np.array([[1.0, 1, 0], [1, 1, 1.3], [1, 1, 3.1], [6, 2, 1]])


def test_seeds_are_wide_beside_noise_but_no_wider_than_the_targets_allow():
    assert space(HALL, HALL, Settings(sigma=0.003)).width == pytest.approx(25 * 3.5 * 0.003)
    narrow = HALL * [1, 0.01, 0.01]
    assert space(HALL, narrow, Settings(sigma=0.003)).width < 0.3 * 0.2


def test_where_the_scale_is_unknown_the_width_is_a_share_of_the_extent():
    unknown = Settings(model=Model.UNKNOWN_SCALE)

    assert space(HALL, 10 * HALL, unknown).width == pytest.approx(10 * space(HALL, HALL, unknown).width)


@pytest.mark.parametrize(
    ("targets", "model", "longest"),
    [(LINE, Model.RIGID, 4), (HALL, Model.RIGID, 2), (POLE, Model.LEVELLED, 3), (LINE, Model.LEVELLED, 1)],
)
def test_the_longest_line_counts_its_targets(targets, model, longest):
    assert space(HALL, targets, Settings(model=model, sigma=0.001)).longest_line() == longest


def test_targets_with_few_edges_come_first_and_the_order_is_kept():
    # The last target is far from everything, so that none of its distances occurs.
    targets = np.concatenate([scanned(HALL)[0], [[90.0, 10.0, 3.0]]])[::-1]
    before = space(HALL, targets)
    after = before.reordered(before.matrix(3))

    assert after.order[0] == 0
    assert np.array_equal(after.targets, targets[after.order])
    assert sorted(after.order) == list(range(9))
    assert after.width == before.width


@pytest.mark.parametrize(
    ("model", "seed_model", "size"),
    [
        (Model.RIGID, Model.RIGID, 3),
        (Model.SIMILARITY, Model.RIGID, 3),
        (Model.LEVELLED_SCALE, Model.LEVELLED, 2),
        (Model.UNKNOWN_SCALE, Model.UNKNOWN_SCALE, 3),
    ],
)
def test_seeds_have_a_scale_only_if_it_is_unknown(model, seed_model, size):
    found = space(HALL, HALL, Settings(model=model))

    assert (found.seed_model, found.size) == (seed_model, size)
