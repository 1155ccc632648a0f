"""The skeleton of a wall: chains of chords that meet at junctions."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.axes.settings import AxisSettings, SkeletonSettings
from ichnograph.algorithms.site_plan.axes.skeleton import skeleton_of
from shapely.geometry import Point, box
from shapely.ops import unary_union

BAR = box(0, 0, 6, 0.3)
TEE = unary_union([BAR, box(2.9, 0, 3.1, 3)])
BUTTRESS = unary_union([BAR, box(3, 0, 3.4, 0.5)])


def test_a_straight_wall_is_one_chain_along_its_middle():
    skeleton = skeleton_of(BAR)
    (chain,) = skeleton.chains
    assert (chain.start, chain.end) == (None, None)
    inner = np.abs(chain.middles[:, 0] - 3) < 2.5
    assert chain.middles[inner, 1] == pytest.approx(0.15, abs=1e-6)
    assert chain.width == pytest.approx(0.3, abs=0.02)
    assert chain.length == pytest.approx(6, abs=0.5)
    assert skeleton.width == pytest.approx(0.3, abs=0.02)


def test_three_chains_meet_at_the_junction_of_a_tee():
    skeleton = skeleton_of(TEE)
    assert len(skeleton.chains) == 3
    ((node, where),) = skeleton.junctions.items()
    assert where == pytest.approx([3, 0.15], abs=0.15)
    assert all([chain.start, chain.end].count(node) == 1 for chain in skeleton.chains)


def test_a_stub_is_pruned_unless_the_settings_keep_it():
    assert skeleton_of(BUTTRESS).junctions == {}
    keen = AxisSettings(skeleton=SkeletonSettings(least_protrusion=0.3))
    junctions = skeleton_of(BUTTRESS, keen).junctions.values()
    assert min(np.linalg.norm(where - (3.2, 0.2)) for where in junctions) < 0.2


def test_a_ring_is_one_chain_that_ends_where_it_begins():
    (chain,) = skeleton_of(Point(0, 0).buffer(2.2).difference(Point(0, 0).buffer(1.8))).chains
    assert chain.start == chain.end is not None
    assert chain.length == pytest.approx(4 * np.pi, rel=0.03)
