"""The faces of a wall along one ring of its outline."""

from dataclasses import dataclass
from typing import Callable, Optional

import numpy as np

from ...geometry.curves import Arc
from ...parallel import in_order
from .face import Face, fit_face
from .face_points import FacePoints
from .ridge_segments import cut_into_segments, scatter_of
from .ridges import Ridges, Stations, find_ridges, stations_along
from .settings import FaceSettings, RingSettings

Fit = Callable[[np.ndarray, bool], Optional[Face]]


@dataclass(frozen=True)
class RingFaces:
    """A ring of an outline, and its faces in the ring's order.

    Attributes
    ----------
    stations : Stations
    step : float
        Distance of the stations, metres.
    faces : tuple of Face
    closed : bool
        Whether a single face runs all the way round.
    """

    stations: Stations
    step: float
    faces: tuple[Face, ...]
    closed: bool = False


def find_faces(
    ring: np.ndarray, points: FacePoints, pixel_size: float, settings: FaceSettings = FaceSettings()
) -> RingFaces:
    """Find the faces of a ring, shape (n + 1, 2), the wall to its left."""
    stations = stations_along(ring, pixel_size, settings.ridges)
    ridges = find_ridges(stations, points, pixel_size, settings.ridges)
    count = len(stations.xy)
    step = float(np.hypot(*np.diff(ring, axis=0).T).sum() / count)
    found = np.flatnonzero(ridges.found)
    segments = _segments(found, ridges, step, settings)
    if segments:
        # Cut again from where a segment begins, so that the row's own beginning makes no corner.
        begin = np.searchsorted(found, segments[len(segments) // 2][0][0])
        found = np.r_[found[begin:], found[:begin] + count]
        segments = _segments(found, ridges, step, settings)

    def fit(members: np.ndarray, curved: bool) -> Optional[Face]:
        return fit_face(members, curved, ridges, points, settings)

    fitted = [face for face in in_order(lambda segment: fit(*segment), segments) if face is not None]
    faces = tuple(_joined(fitted, fit, round(settings.rings.gap_m / step), settings.rings))
    return RingFaces(stations, step, faces, _is_closed(faces, count, step, settings.rings))


def _segments(
    found: np.ndarray, ridges: Ridges, step: float, settings: FaceSettings
) -> list[tuple[np.ndarray, bool]]:
    """Return the stations of each segment, and whether it is curved."""
    sigma = scatter_of(ridges.xy[found % len(ridges.xy)], settings=settings.segments)
    segments = []
    for row in np.split(found, np.flatnonzero(np.diff(found) * step > settings.rings.gap_m) + 1):
        rows = row % len(ridges.xy)
        cut = cut_into_segments(ridges.xy[rows], ridges.direction[rows], sigma, settings.segments)
        segments += [(row[segment.first : segment.last + 1], segment.curved) for segment in cut]
    return segments


def _joined(faces: list[Face], fit: Fit, gap: int, settings: RingSettings) -> list[Face]:
    """Join neighbours that belong to one face."""
    k = 0
    while k + 1 < len(faces):
        joined = _join(faces[k], faces[k + 1], fit, gap, settings)
        if joined is None:
            k += 1
        else:
            faces[k : k + 2] = [joined]
            k = max(k - 1, 0)
    return faces


def _join(one: Face, other: Face, fit: Fit, gap: int, settings: RingSettings) -> Optional[Face]:
    """Return the face that two neighbours are parts of, or None."""
    curved = isinstance(one.curve, Arc)
    if curved != isinstance(other.curve, Arc) or other.members[0] - one.members[-1] > gap:
        return None
    cosine = one.curve.heading(one.ridge[-1]) @ other.curve.heading(other.ridge[0])
    if cosine < settings.least_cosine:
        return None
    joined = fit(np.r_[one.members, other.members], curved)
    if joined is None:
        return None
    weights = len(one.members), len(other.members)
    apart = np.sqrt(np.average([one.rms**2, other.rms**2], weights=weights))
    shift = max(abs(np.median(joined.curve.offset(face.ridge))) for face in (one, other))
    return joined if max(joined.rms, shift) <= settings.worse * apart else None


def _is_closed(faces: tuple[Face, ...], count: int, step: float, settings: RingSettings) -> bool:
    """Return whether a single round face runs all the way round a ring of so many stations."""
    if len(faces) != 1:
        return False
    free = count - (faces[0].members[-1] - faces[0].members[0])
    return isinstance(faces[0].curve, Arc) and bool(free * step < settings.gap_m)
