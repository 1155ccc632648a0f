"""Control lists for the tests of the simulation."""

import numpy as np
from ichnograph.algorithms.registration.lists.point_list import PointList

FEW = 12


def points(xyz, **more):
    return PointList("hall", tuple(f"P{row}" for row in range(len(xyz))), np.array(xyz, float), **more)


def box_at(corner):
    """Return the corners of a box, which can be laid on itself in four ways."""
    corners = [(x, y, z) for x in (0, 4) for y in (0, 6) for z in (0, 3)]
    return np.array(corners) + corner
