"""Outlines along faces, which meet at corners or end where their points end."""

from collections.abc import Sequence
from typing import Optional

import numpy as np

from ...geometry.curves import crossing
from ...kernels import kernel
from .face import Face
from .ring_faces import RingFaces
from .settings import FaceOutlineSettings


def redraw(
    ring: RingFaces, pixel_size: float, settings: FaceOutlineSettings = FaceOutlineSettings()
) -> tuple[np.ndarray, list[Face]]:
    """Return the corners of a ring, shape (n, 2), the first not repeated, and the faces it runs along."""
    if ring.closed:
        face = ring.faces[0]
        around = np.pi * face.curve.radius
        return face.curve.run(-around, around, settings.curves.chord_m)[:-1], [face]
    faces, crossed = list(ring.faces), None
    while faces:
        ends, joints = _ends(faces, ring, settings)
        wrong = {k for k, (start, stop) in enumerate(ends) if stop <= start}
        if not wrong:
            corners, owner = _corners(faces, ends, joints, ring, pixel_size, settings)
            wrong = set(owner[_crossed(corners)].tolist())
            if not wrong:
                return corners, faces
            crossed = crossed or (corners, list(faces))
            if _length(faces) < settings.least_left * _length(ring.faces):
                return crossed
        # The shortest face is the least sure: of those that cross, or that end before they begin.
        faces.pop(min(wrong, key=lambda k: (faces[k].length, k)))
    return _pixel_path(ring, 0, len(ring.stations.xy) - 1, settings.bias_px * pixel_size), []


def _length(faces: Sequence[Face]) -> float:
    return sum(face.length for face in faces)


def _ends(
    faces: list[Face], ring: RingFaces, settings: FaceOutlineSettings
) -> tuple[list[tuple[float, float]], list[bool]]:
    """Return start and stop of each side along its curve, and whether it meets the next at a corner."""
    starts, stops = [face.start for face in faces], [face.stop for face in faces]
    joints = []
    for k, face in enumerate(faces):
        following = (k + 1) % len(faces)
        gap = _between(face, faces[following], ring) * ring.step
        corner = _corner(face, faces[following], gap, settings)
        joints.append(corner is not None)
        if corner is not None:
            stops[k] = float(face.curve.station(corner))
            starts[following] = float(faces[following].curve.station(corner))
        elif _continues(face, faces[following]):
            # Neither reaches beside the other.
            middle = (face.ridge[-1] + faces[following].ridge[0]) / 2
            stops[k] = min(stops[k], float(face.curve.station(middle)))
            starts[following] = max(starts[following], float(faces[following].curve.station(middle)))
    return list(zip(starts, stops)), joints


def _continues(face: Face, following: Face) -> bool:
    """Return whether a face runs on about as the one before."""
    return bool(face.curve.heading(face.ridge[-1]) @ following.curve.heading(following.ridge[0]) > 0)


def _between(face: Face, following: Face, ring: RingFaces) -> int:
    """Return the number of stations from a face to the following one."""
    return int(following.members[0] - face.members[-1]) % len(ring.stations.xy)


def _corner(face: Face, following: Face, gap: float, settings: FaceOutlineSettings) -> Optional[np.ndarray]:
    """Return the corner of two neighbouring faces, if they cross well and near their points."""
    if gap > settings.corner_gap_m:
        return None
    end, begin = face.curve.at(face.stop), following.curve.at(following.start)
    corner = crossing(face.curve, following.curve, (end + begin) / 2)
    if corner is None:
        return None
    if max(np.hypot(*(corner - end)), np.hypot(*(corner - begin))) > settings.corner_reach_m:
        return None
    one, other = face.curve.heading(corner), following.curve.heading(corner)
    return corner if abs(one[0] * other[1] - one[1] * other[0]) >= settings.least_sine else None


def _corners(
    faces: list[Face],
    ends: list[tuple[float, float]],
    joints: list[bool],
    ring: RingFaces,
    pixel_size: float,
    settings: FaceOutlineSettings,
) -> tuple[np.ndarray, np.ndarray]:
    """Return the corners of the ring, and the number of the face that begins or continues at each."""
    parts: list[np.ndarray] = []
    owner: list[int] = []
    for k, face in enumerate(faces):
        run = face.curve.run(*ends[k], settings.curves.chord_m)
        parts.append(run[:-1] if joints[k] else run)
        between, last = _between(face, faces[(k + 1) % len(faces)], ring), int(face.members[-1])
        if not joints[k] and between > 1 and between * ring.step > settings.chord_gap_m:
            parts.append(_pixel_path(ring, last + 1, last + between - 1, settings.bias_px * pixel_size))
        owner += [k] * (sum(map(len, parts)) - len(owner))
    return np.concatenate(parts), np.array(owner)


def _crossed(corners: np.ndarray) -> np.ndarray:
    """Return the edges of a ring that cross others."""
    order = np.argsort(np.minimum(corners[:, 0], np.roll(corners[:, 0], -1)), kind="stable")
    return _sweep(corners, order)


@kernel
def _sweep(corners: np.ndarray, order: np.ndarray) -> np.ndarray:
    """Return the edges that cross others; `order` is that of their western ends."""
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


def _pixel_path(ring: RingFaces, first: int, last: int, bias: float) -> np.ndarray:
    """Return the corners of an outline of pixels, freed of its bias (m)."""
    rows = np.arange(first, last + 1) % len(ring.stations.xy)
    tangent = ring.stations.tangent[rows]
    bend = np.abs(np.diff(tangent, axis=0)).max(axis=1, initial=0.0) > 1e-6
    kept = np.r_[True, bend] | np.r_[bend, True]
    rows, tangent = rows[kept], tangent[kept]
    inwards = np.column_stack([-tangent[:, 1], tangent[:, 0]])
    return ring.stations.xy[rows] + bias * inwards
