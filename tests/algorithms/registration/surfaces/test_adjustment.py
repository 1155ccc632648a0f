"""Targets first, then surfaces: which scans come into the block."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.adjustment.control_network import ControlNetwork
from ichnograph.algorithms.registration.sequential_registration import in_frame_of_first
from ichnograph.algorithms.registration.settings import Model, Settings
from ichnograph.algorithms.registration.surfaces.adjustment import adjust_with_surfaces
from ichnograph.tests.algorithms.registration.hall import listed
from ichnograph.tests.scenes.scanned_rooms import FURNISHED, OTHER, surfaces_from

LISTS = {name: listed(name, np.zeros((0, 3))) for name in ("a", "b")}
NETWORK = ControlNetwork.of_surveyed((), np.zeros((0, 3)), 0.0)
SETTINGS = Settings(model=Model.LEVELLED)


@pytest.fixture(scope="module")
def first():
    return surfaces_from(FURNISHED, (2, 2, 1.6))


def test_the_first_scan_is_held_where_it_is(first):
    surfaces = {"a": first, "b": surfaces_from(FURNISHED, (6, 3.2, 1.6), 1)}
    refined = adjust_with_surfaces(in_frame_of_first(LISTS, NETWORK), LISTS, surfaces, SETTINGS)
    held, moved = refined.adjusted.block.poses

    assert held.matrix() == pytest.approx(np.eye(4))
    assert np.linalg.norm(moved.position) > 1
    assert not refined.adjusted.block.pose_cofactors[0].any()
    assert (np.diag(refined.adjusted.block.pose_cofactors[1]) > 0).all()


def test_the_first_scan_is_refused_too_if_nothing_stands_beside_it(first):
    surfaces = {"a": first, "b": surfaces_from(OTHER, (2, 2, 1.6), 1)}
    refined = adjust_with_surfaces(in_frame_of_first(LISTS, NETWORK), LISTS, surfaces, SETTINGS)

    assert refined.sequence.placed == ()
    assert set(refined.sequence.refused) == {"a", "b"}
