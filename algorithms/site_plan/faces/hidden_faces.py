"""Faces that were seen from one side only: which side of the outline is their front, and where their back is.

Both sides of a thin outline find the same ridge then. The front is where the scanner stood: beside it the
density image holds points, behind the back it holds none.
"""

from dataclasses import replace

import numpy as np
from affine import Affine

from .face import Side

SAME = 0.03
"""Ridges up to this far (m) apart are one face, not the two of a wall."""

SHARE = 0.5
"""Least share of a back's ridge points that lie on faces seen from the other side."""

OPPOSITE = -0.9
"""Largest cosine between the directions of the two sides of one face."""

BESIDE = (0.25, 0.35, 0.45)
"""Distances (m) beside a face at which points are looked for."""

LEAST_DEPTH = 0.01
"""Least distance (m) of a back from its front."""


def tell_backs(rings: list, held: np.ndarray, transform: Affine) -> list:
    """Move the backs of faces that were seen from one side behind all that was seen of them.

    Parameters
    ----------
    rings : list of RingSides
        Of one wall.
    held : ndarray of bool, shape (rows, columns)
        Pixels that hold points.
    transform : Affine
        From (column, row) to the coordinates of the rings.
    """
    sides = [(r, k) for r, ring in enumerate(rings) for k in range(len(ring.sides))]
    found = {at: rings[at[0]].sides[at[1]] for at in sides}
    light = {at: _seen_beside(side, held, transform) for at, side in found.items()}
    shared = _shared(found)
    # Most of a back lies on the front; a front may go on beside another face.
    doubtful = {at for at, side in found.items() if _share(side, shared.get(at, {})) >= SHARE}
    pairs = [(-len(rows), at, other) for at, others in shared.items() for other, rows in others.items()]
    backs = {}
    for _, at, other in sorted(pairs):
        candidates = {at, other} & doubtful
        if candidates and at not in backs and other not in backs:
            back = max(candidates, key=lambda one: (-light[one], one))
            backs[back] = _behind(found[back], found[other if back == at else at])
    return [
        replace(ring, sides=tuple(backs.get((r, k), side) for k, side in enumerate(ring.sides)))
        for r, ring in enumerate(rings)
    ]


def _shared(found: dict) -> dict:
    """Return, by sides and other sides, the ridge points of the first that lie on the face of the other."""
    keys = list(found)
    low, high = (np.array([bound(found[at].ridge, axis=0) for at in keys]) for bound in (np.min, np.max))
    shared = {}
    for k, at in enumerate(keys):
        for other in np.flatnonzero(((high >= low[k] - SAME) & (low <= high[k] + SAME)).all(axis=1)):
            rows = _common(found[at], found[keys[other]])
            if other != k and len(rows):
                shared.setdefault(at, {})[keys[other]] = rows
    return shared


def _share(side: Side, others: dict) -> float:
    """Return the share of a side's ridge points that lie on the faces of others."""
    return len(np.unique(np.concatenate(list(others.values())))) / len(side.ridge) if others else 0.0


def _common(side: Side, other: Side) -> np.ndarray:
    """Return the ridge points of a side that lie on the face of another that faces the other way."""
    place = other.curve.station(side.ridge)
    opposite = (side.curve.heading(side.ridge) * other.curve.heading(side.ridge)).sum(axis=1) <= OPPOSITE
    along = (place >= other.start - SAME) & (place <= other.stop + SAME)
    return np.flatnonzero(opposite & along & (np.abs(other.curve.offset(side.ridge)) <= SAME))


def _seen_beside(side: Side, held: np.ndarray, transform: Affine) -> float:
    """Return the share of pixels outside a side that hold points."""
    heading = side.curve.heading(side.ridge)
    outwards = np.column_stack([heading[:, 1], -heading[:, 0]])
    beside = np.concatenate([side.ridge + distance * outwards for distance in BESIDE])
    column, row = ~transform * beside.T
    rows, columns = (np.clip(np.floor(v).astype(int), 0, n - 1) for v, n in zip((row, column), held.shape))
    return float(held[rows, columns].mean())


def _behind(back: Side, front: Side) -> Side:
    """Return the back moved behind its front by twice the scatter of the points."""
    depth = max(2 * max(back.rms, front.rms), LEAST_DEPTH)
    ends = front.curve.offset(back.curve.at(np.array([back.start, back.stop])))
    curve = back.curve.moved(-depth - max(float(np.max(-ends)), 0.0))
    start, stop = curve.station(back.curve.at(np.array([back.start, back.stop])))
    return replace(back, curve=curve, start=float(start), stop=float(stop), back=True)
