"""Control points and search spaces for the tests of matching."""

import numpy as np
from ichnograph.algorithms.registration.adjustment.control_network import ControlNetwork
from ichnograph.algorithms.registration.matching.control_points import ControlPoints
from ichnograph.algorithms.registration.matching.search_space import search_space
from ichnograph.algorithms.registration.settings import Settings


def network(xyz, control_sigma=0.0):
    return ControlNetwork.of_surveyed(
        tuple(f"P{row}" for row in range(1, len(xyz) + 1)), np.asarray(xyz, float), control_sigma
    )


def control_points(xyz, settings=Settings(), scale_error=0.0):
    return ControlPoints.of_network(network(xyz, settings.control_sigma), settings, scale_error)


def space(xyz, targets, settings=Settings(), allowed=None, scale_error=0.0):
    allowed = np.ones((len(targets), len(xyz)), bool) if allowed is None else allowed
    control = control_points(xyz, settings, scale_error)
    return search_space(control, np.asarray(targets, float), settings.model, allowed, settings)
