"""A wall with what the tests of openings need."""

import numpy as np
from ichnograph.algorithms.facade.openings.states import make_states
from ichnograph.tests.algorithms.facade.samples import at, lattice, without

STEP = 0.03
WINDOW = (1.0, 1.2, 2.0, 2.4)


def wall(*holes, left=0.0, right=6.0, top=4.0):
    """Return a wall without the points in its holes."""
    points = lattice(left, 0, right, top, STEP)
    for hole in holes:
        points = without(points, *hole)
    return at(points)


def pane(hole, depth=-0.15):
    """Return points all over a hole, at a depth."""
    return at(lattice(*hole, STEP), depth)


def reveal(hole, depth=0.2):
    """Return points of the left jamb and the soffit of a hole."""
    left, bottom, right, top = hole
    v, w = np.meshgrid(np.arange(bottom, top, STEP), np.arange(-depth, -0.02, STEP))
    jamb = np.column_stack([np.full(v.size, left + 0.001), v.ravel(), w.ravel()])
    u, w = np.meshgrid(np.arange(left, right, STEP), np.arange(-depth, -0.02, STEP))
    return np.concatenate([jamb, np.column_stack([u.ravel(), np.full(u.size, top - 0.001), w.ravel()])])


def states_of(main, *others, inner=None):
    """Return the states of a wall and what is around it."""
    uvw = np.concatenate([main, *others])
    return make_states(uvw, np.arange(len(uvw)) < len(main), 0.05, inner)
