"""An edge that was not seen is where the other windows of its row have theirs, or is unchanged."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.completion import complete_edges
from ichnograph.algorithms.facade.elevation import ARCH, FREE, RECESS, RECTANGLE, Edges
from ichnograph.algorithms.facade.openings.content import WINDOW, Opening
from ichnograph.algorithms.facade.openings.regions import Region
from ichnograph.algorithms.facade.outlines.border import Border
from ichnograph.algorithms.facade.outlines.details import TracedDetail
from ichnograph.algorithms.facade.outlines.regular_outlines import Outline
from shapely.geometry import Polygon, box

REGION = Region((slice(0, 1), slice(0, 1)), np.ones((1, 1), bool), 0.0)
NOWHERE = Border(Polygon(), np.empty((0, 2)), np.empty(0), np.empty(0, bool))


def pair(left, bottom, right, top, unseen=(), shape=RECTANGLE, open_sides=(), layer=0, polygon=None):
    stds = {name: float("nan") if name in unseen else 0.002 for name in ("left", "right", "bottom", "top")}
    polygon = polygon or box(left, bottom, right, top)
    opening = Opening(REGION, polygon, RECESS, WINDOW, -0.2, layer, open_sides, np.empty(0, int))
    outline = Outline(shape, None, polygon, Edges(**stds), 0.002)
    return TracedDetail(RECESS, NOWHERE, -0.2, np.empty(0, int), opening), outline


def row(*first):
    """Return an opening and two windows of 1 x 1.5 m beside it."""
    return [*first, pair(2.0, 1.0, 3.0, 2.5), pair(4.0, 1.01, 5.01, 2.51)]


def completed(*pairs):
    return complete_edges(pairs)[0][1]


@pytest.mark.parametrize(("seen", "edge", "position"), [
    ((0.0, 1.12, 1.0, 2.5), "bottom", 1.005),
    ((0.0, 1.0, 1.0, 2.4), "top", 2.505),
    ((0.15, 1.0, 1.0, 2.5), "left", -0.005),
    ((0.0, 1.0, 0.9, 2.5), "right", 1.005),
])  # fmt: skip
def test_a_hidden_edge_is_where_the_row_has_it_and_has_no_deviation(seen, edge, position):
    found = completed(*row(pair(*seen, unseen=(edge,))))
    bounds = dict(zip(("left", "bottom", "right", "top"), found.polygon.bounds))

    assert found.completed == (edge,)
    assert bounds[edge] == pytest.approx(position)
    assert np.isnan(getattr(found.edges, edge))


def test_measured_openings_are_left_as_they_are():
    pairs = row(pair(0.0, 1.0, 1.0, 2.5))
    assert complete_edges(pairs) == pairs


@pytest.mark.parametrize("first", [
    pair(0.0, 1.12, 1.0, 2.3, unseen=("bottom",)),
    pair(0.0, 1.12, 1.3, 2.5, unseen=("bottom",)),
    pair(0.0, 1.9, 1.0, 2.5, unseen=("bottom",)),
    pair(0.0, 1.12, 1.0, 2.5, unseen=("bottom",), open_sides=("bottom",)),
    pair(0.0, 1.12, 1.0, 2.5, unseen=("bottom",), layer=1),
    pair(0.0, 1.12, 1.0, 2.5, unseen=("bottom",), shape=FREE),
], ids=["another head", "another width", "too far", "on the ground", "another wall", "free"])  # fmt: skip
def test_openings_of_another_kind_are_not_completed(first):
    assert completed(*row(first)).completed == ()


def test_one_neighbour_alone_or_two_that_disagree_complete_nothing():
    first = pair(0.0, 1.12, 1.0, 2.5, unseen=("bottom",))
    assert completed(first, pair(2.0, 1.0, 3.0, 2.5)).completed == ()
    assert completed(first, pair(2.0, 1.0, 3.0, 2.5), pair(4.0, 0.9, 5.0, 2.5)).completed == ()


def test_in_a_row_that_runs_on_over_a_neighbour_the_nearest_windows_complete_an_edge():
    first = pair(0.0, 1.12, 1.0, 2.5, unseen=("bottom",))
    own = [pair(left, 1.0, left + 1, 2.5) for left in (2.0, 4.0, 6.0)]
    assert completed(first, *own, pair(8.0, 0.95, 9.0, 2.5)).polygon.bounds[1] == pytest.approx(1.0)


def test_an_arch_keeps_its_head():
    def arch(left, bottom, **changes):
        angles = np.linspace(0, np.pi, 25)
        head = np.column_stack([left + 0.5 + 0.5 * np.cos(angles), 2.0 + 0.5 * np.sin(angles)])
        polygon = Polygon([(left, bottom), (left + 1, bottom), *head])
        return pair(0, 0, 0, 0, shape=ARCH, polygon=polygon, **changes)

    found = completed(arch(0, 1.1, unseen=("bottom",)), arch(2, 1.0), arch(4, 1.0))
    assert found.completed == ("bottom",)
    assert found.polygon.area == pytest.approx(arch(0, 1.0)[1].polygon.area, abs=1e-9)
