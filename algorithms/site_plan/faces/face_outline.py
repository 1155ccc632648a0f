"""Drawing a ring anew along its sides, which meet at corners or end where their points end."""

from collections.abc import Sequence
from typing import Optional

import numpy as np
from numba import njit

from .face import Side
from .face_fit import crossing
from .ring_faces import RingSides

CORNER_GAP = 0.6
"""Neighbouring sides meet at a corner if the outline between them is shorter than this, metres."""

CORNER_REACH = 0.3
"""A corner is at most this far (m) beyond the points of its sides."""

LEAST_ANGLE = 0.26
"""Sine of the least angle at which two sides cross well enough for a corner: 15 degrees."""

CHORD_GAP = 1.2
"""Ends of sides are joined directly if the outline between them is shorter than this, metres."""

LEAST_LEFT = 0.75
"""Sides are dropped for crossing others as long as this share of their length is left; then the crossing
stays, and is cut off the polygon."""

INSIDE = 0.5
"""An outline of pixels lies this many pixels outside the face."""


def redraw(ring: RingSides, pixel_size: float) -> tuple[np.ndarray, list]:
    """Return the corners of a ring, shape (n, 2), the first not repeated, and the sides it runs along."""
    if ring.closed:
        side = ring.sides[0]
        around = np.pi * side.curve.radius
        return side.curve.run(-around, around)[:-1], [side]
    sides, crossing = list(ring.sides), None
    while sides:
        ends, joints = _ends(sides, ring)
        wrong = {k for k, (start, stop) in enumerate(ends) if stop <= start}
        if not wrong:
            corners, owner = _corners(sides, ends, joints, ring, pixel_size)
            wrong = set(owner[_crossed(corners)].tolist())
            if not wrong:
                return corners, sides
            crossing = crossing or (corners, list(sides))
            if _length(sides) < LEAST_LEFT * _length(ring.sides):
                return crossing
        # Of sides that cross, or of which their corners leave nothing, the shortest is the least sure.
        sides.pop(min(wrong, key=lambda k: (sides[k].length, k)))
    return _pixel_path(ring, 0, len(ring.places.xy) - 1, pixel_size), []


def _length(sides: Sequence) -> float:
    return sum(side.length for side in sides)


def _ends(sides: list, ring: RingSides) -> tuple:
    """Return start and stop of each side along its curve, and whether it meets the next at a corner."""
    starts, stops = [side.start for side in sides], [side.stop for side in sides]
    joints = []
    for k, side in enumerate(sides):
        following = (k + 1) % len(sides)
        corner = _corner(side, sides[following], _between(side, sides[following], ring), ring.step)
        joints.append(corner is not None)
        if corner is not None:
            stops[k] = float(side.curve.station(corner))
            starts[following] = float(sides[following].curve.station(corner))
        elif _goes_on(side, sides[following]):
            # Neither reaches beside the other.
            middle = (side.ridge[-1] + sides[following].ridge[0]) / 2
            stops[k] = min(stops[k], float(side.curve.station(middle)))
            starts[following] = max(starts[following], float(sides[following].curve.station(middle)))
    return list(zip(starts, stops)), joints


def _goes_on(side: Side, following: Side) -> bool:
    """Tell whether a side runs on about as the one before."""
    return bool(side.curve.heading(side.ridge[-1]) @ following.curve.heading(following.ridge[0]) > 0)


def _between(side: Side, following: Side, ring: RingSides) -> int:
    """Return the number of places from a side to the following one."""
    return int(following.members[0] - side.members[-1]) % len(ring.places.xy)


def _corner(side: Side, following: Side, between: int, step: float) -> Optional[np.ndarray]:
    """Return the corner of two neighbouring sides, if they cross well and near their points."""
    if between * step > CORNER_GAP:
        return None
    end, begin = side.curve.at(side.stop), following.curve.at(following.start)
    corner = crossing(side.curve, following.curve, (end + begin) / 2)
    if corner is None or max(np.hypot(*(corner - end)), np.hypot(*(corner - begin))) > CORNER_REACH:
        return None
    one, other = side.curve.heading(corner), following.curve.heading(corner)
    return corner if abs(one[0] * other[1] - one[1] * other[0]) >= LEAST_ANGLE else None


def _corners(sides: list, ends: list, joints: list, ring: RingSides, pixel_size: float) -> tuple:
    """Return the corners of the ring, and the number of the side that goes on from each."""
    parts, owner = [], []
    for k, side in enumerate(sides):
        run = side.curve.run(*ends[k])
        parts.append(run[:-1] if joints[k] else run)
        between, last = _between(side, sides[(k + 1) % len(sides)], ring), int(side.members[-1])
        if not joints[k] and between > 1 and between * ring.step > CHORD_GAP:
            parts.append(_pixel_path(ring, last + 1, last + between - 1, pixel_size))
        owner += [k] * (sum(map(len, parts)) - len(owner))
    return np.concatenate(parts), np.array(owner)


def _crossed(corners: np.ndarray) -> np.ndarray:
    """Tell the edges of a ring that cross others."""
    order = np.argsort(np.minimum(corners[:, 0], np.roll(corners[:, 0], -1)), kind="stable")
    return _sweep(corners, order)


@njit(nogil=True, cache=True)
def _sweep(corners, order):
    """Tell the edges that cross others; `order` is that of their western ends."""
    n = len(corners)
    crossed = np.zeros(n, np.bool_)
    for rank in range(n):
        i = order[rank]
        ax, ay = corners[i]
        bx, by = corners[(i + 1) % n]
        for j in order[rank + 1 :]:
            cx, cy = corners[j]
            dx, dy = corners[(j + 1) % n]
            if min(cx, dx) > max(ax, bx):
                break
            beside = (i + 1) % n == j or (j + 1) % n == i
            if beside or min(ay, by) > max(cy, dy) or max(ay, by) < min(cy, dy):
                continue
            c = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
            d = (bx - ax) * (dy - ay) - (by - ay) * (dx - ax)
            a = (dx - cx) * (ay - cy) - (dy - cy) * (ax - cx)
            b = (dx - cx) * (by - cy) - (dy - cy) * (bx - cx)
            if c * d < 0 and a * b < 0:
                crossed[i] = crossed[j] = True
    return crossed


def _pixel_path(ring: RingSides, first: int, last: int, pixel_size: float) -> np.ndarray:
    """Return the places of an outline of pixels, freed of the bias that it has."""
    rows = np.arange(first, last + 1) % len(ring.places.xy)
    tangent = ring.places.tangent[rows]
    bend = np.abs(np.diff(tangent, axis=0)).max(axis=1, initial=0.0) > 1e-6
    kept = np.r_[True, bend] | np.r_[bend, True]
    rows, tangent = rows[kept], tangent[kept]
    inwards = np.column_stack([-tangent[:, 1], tangent[:, 0]])
    return ring.places.xy[rows] + INSIDE * pixel_size * inwards
