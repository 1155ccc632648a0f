"""The hidden backs of faces that were seen from one side only.

Both sides of a thin outline find the same ridge then. The front is where the scanner stood: beside it the
density image holds points, beside the hidden back it holds none.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from affine import Affine

from .face import Face
from .ring_faces import RingFaces
from .settings import HiddenFaceSettings

Key = tuple[int, int]
"""Ring, and face of the ring."""


def move_hidden_faces(
    rings: Sequence[RingFaces],
    held: np.ndarray,
    transform: Affine,
    settings: HiddenFaceSettings = HiddenFaceSettings(),
) -> list[RingFaces]:
    """Move the hidden backs of faces behind all that was seen of their fronts.

    Parameters
    ----------
    rings : sequence of RingFaces
        Of one wall.
    held : ndarray of bool, shape (rows, columns)
        Pixels that hold points.
    transform : Affine
        From (column, row) to the coordinates of the rings.
    settings : HiddenFaceSettings
    """
    found = {(r, k): face for r, ring in enumerate(rings) for k, face in enumerate(ring.faces)}
    light = {key: _seen_beside(face, held, transform, settings) for key, face in found.items()}
    shared = _shared(found, settings)
    # Most of a back lies on the front; a front may run on beside another face.
    doubtful = {key for key, face in found.items() if _share(face, shared.get(key, {})) >= settings.share}
    pairs = [(-len(rows), key, other) for key, others in shared.items() for other, rows in others.items()]
    backs: dict[Key, Face] = {}
    # A front that another back lies behind was seen, so that it is not itself a back.
    fronts: set[Key] = set()
    for _, key, other in sorted(pairs):
        candidates = {key, other} & doubtful - fronts
        if candidates and key not in backs and other not in backs:
            back = max(candidates, key=lambda one: (-light[one], one))
            front = other if back == key else key
            backs[back] = _behind(found[back], found[front], settings)
            fronts.add(front)
    return [
        replace(ring, faces=tuple(backs.get((r, k), face) for k, face in enumerate(ring.faces)))
        for r, ring in enumerate(rings)
    ]


def _shared(found: dict[Key, Face], settings: HiddenFaceSettings) -> dict[Key, dict[Key, np.ndarray]]:
    """Return, by faces and other faces, the ridge points of the first that lie on the other."""
    keys, same = list(found), settings.same_m
    low, high = (np.array([bound(found[key].ridge, axis=0) for key in keys]) for bound in (np.min, np.max))
    shared: dict[Key, dict[Key, np.ndarray]] = {}
    for k, key in enumerate(keys):
        for other in np.flatnonzero(((high >= low[k] - same) & (low <= high[k] + same)).all(axis=1)):
            rows = _common(found[key], found[keys[other]], settings)
            if other != k and len(rows):
                shared.setdefault(key, {})[keys[other]] = rows
    return shared


def _share(face: Face, others: dict[Key, np.ndarray]) -> float:
    """Return the share of a face's ridge points that lie on the faces of others."""
    return len(np.unique(np.concatenate(list(others.values())))) / len(face.ridge) if others else 0.0


def _common(face: Face, other: Face, settings: HiddenFaceSettings) -> np.ndarray:
    """Return the ridge points of a face that lie on another that runs the opposite way."""
    station = other.curve.station(face.ridge)
    cosine = (face.curve.heading(face.ridge) * other.curve.heading(face.ridge)).sum(axis=1)
    along = (station >= other.start - settings.same_m) & (station <= other.stop + settings.same_m)
    on_other = along & (np.abs(other.curve.offset(face.ridge)) <= settings.same_m)
    return np.flatnonzero(on_other & (cosine <= settings.largest_cosine))


def _seen_beside(face: Face, held: np.ndarray, transform: Affine, settings: HiddenFaceSettings) -> float:
    """Return the share of pixels outside a face that hold points."""
    heading = face.curve.heading(face.ridge)
    outwards = np.column_stack([heading[:, 1], -heading[:, 0]])
    beside = np.concatenate([face.ridge + distance * outwards for distance in settings.beside_m])
    column, row = ~transform * beside.T
    rows, columns = (np.clip(np.floor(v).astype(int), 0, n - 1) for v, n in zip((row, column), held.shape))
    return float(held[rows, columns].mean())


def _behind(back: Face, front: Face, settings: HiddenFaceSettings) -> Face:
    """Return the back moved behind its front by twice the scatter of the points."""
    depth = max(2 * max(back.rms, front.rms), settings.least_depth_m)
    ends = front.curve.offset(back.curve.at(np.array([back.start, back.stop])))
    curve = back.curve.moved(-depth - max(float(np.max(-ends)), 0.0))
    start, stop = curve.station(back.curve.at(np.array([back.start, back.stop])))
    return replace(back, curve=curve, start=float(start), stop=float(stop), hidden=True)
