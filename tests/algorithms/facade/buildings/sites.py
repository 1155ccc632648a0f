"""Points on buildings made of a few planes."""

import numpy as np

SPACING = 0.1


def upright(start, stop, bottom, top, holes=()):
    """Return points on a wall between two places of the plan; holes as (from, to, low, high) along it."""
    start, stop = np.asarray(start, float), np.asarray(stop, float)
    length = np.linalg.norm(stop - start)
    along, up = np.meshgrid(np.arange(0, length, SPACING), np.arange(bottom, top, SPACING))
    along, up = along.ravel(), up.ravel()
    for low, high, sill, head in holes:
        kept = (along < low) | (along > high) | (up < sill) | (up > head)
        along, up = along[kept], up[kept]
    return np.column_stack([start + np.outer(along / length, stop - start), up])


def level(left, bottom, right, top, z):
    """Return points on a floor, a ceiling or the ground."""
    x, y = np.meshgrid(np.arange(left, right, SPACING), np.arange(bottom, top, SPACING))
    return np.column_stack([x.ravel(), y.ravel(), np.full(x.size, z)])


def house():
    """Return a house of 10 x 8 m and two storeys, seen from inside, and from the street in the south."""
    rooms = [level(0.3, 0.3, 9.7, 7.7, z) for z in (0.1, 2.7, 3.0, 5.6)]
    inner = [
        upright((0.3, 0.3), (9.7, 0.3), 0, 5.6, [(2, 4, 1, 2)]),
        upright((0.3, 7.7), (9.7, 7.7), 0, 5.6),
        upright((0.3, 0.3), (0.3, 7.7), 0, 5.6),
        upright((9.7, 0.3), (9.7, 7.7), 0, 5.6),
    ]
    outside = [upright((0, 0), (10, 0), 0, 6, [(2, 4, 1, 2), (6, 8, 1, 2)]), level(-5, -12, 15, 0, 0.0)]
    return np.concatenate([*rooms, *inner, *outside])


def block():
    """Return a block of 12 x 8 m with two facades that were seen from a street and from a yard."""
    return np.concatenate(
        [
            upright((0, 0), (12, 0), 0, 7),
            upright((12, 8), (0, 8), 0, 5),
            level(-6, -10, 18, 0, 0.0),
            level(-6, 8, 18, 18, 0.0),
        ]
    )
