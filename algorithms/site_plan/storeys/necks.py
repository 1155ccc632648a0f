"""Narrow places of a space, which are doors though no lintel was seen."""

import numpy as np
from shapely.geometry import LineString, Point, Polygon
from shapely.ops import split, unary_union
from shapely.prepared import prep

from .settings import RoomSettings
from .spaces import inner_width

OVER = 1e-4
"""A chord goes on over both its ends by so much, metres, to cut."""


def cut_at_necks(outline: Polygon, settings: RoomSettings = RoomSettings()) -> list:
    """Cut a space at narrow places that are doors without a lintel; return its parts."""
    half = settings.neck_m / 2
    cores = outline.buffer(-half)
    if cores.geom_type != "MultiPolygon":
        return [outline]
    wide = [core.buffer(1.01 * half) for core in cores.geoms]
    throats = outline.difference(unary_union(wide))
    throats = [
        throat
        for throat in getattr(throats, "geoms", [throats])
        if sum(throat.distance(core) < 1e-6 for core in wide) > 1
    ]
    for chord in _narrow_chords(outline, unary_union(throats).buffer(0.3), settings.neck_m):
        parts = [part for part in split(outline, chord).geoms if part.area > 1e-4]
        if len(parts) != 2:
            continue
        width = min(inner_width(part) for part in parts)
        if width >= settings.narrowest_m and chord.length - 2 * OVER < settings.narrowing * width:
            return [one for part in parts for one in cut_at_necks(part, settings)]
    return [outline]


def _narrow_chords(outline: Polygon, near, widest: float) -> list:
    """Return the chords from corners that jut into a space to what is opposite, the shortest first."""
    chords = []
    rings = [np.asarray(ring.coords)[:-1] for ring in (outline.exterior, *outline.interiors)]
    starts = np.concatenate(rings)
    stops = np.concatenate([np.roll(ring, -1, axis=0) for ring in rings])
    before = np.concatenate([np.roll(ring, 1, axis=0) for ring in rings])
    turn = np.cross(starts - before, stops - starts)
    outward = np.concatenate(
        [np.full(len(ring), _winding(ring) * (1 if k == 0 else -1)) for k, ring in enumerate(rings)]
    )
    along = stops - starts
    length = np.maximum((along**2).sum(axis=1), 1e-12)
    within = prep(outline.buffer(2 * OVER))
    near = prep(near)
    for corner in np.flatnonzero(turn * outward < -1e-6):
        place = starts[corner]
        if not near.contains(Point(place)):
            continue
        share = np.clip(((place - starts) * along).sum(axis=1) / length, 0, 1)
        opposite = starts + share[:, None] * along
        distance = np.hypot(*(opposite - place).T)
        for other in np.flatnonzero((distance <= widest) & (distance > 0.05)):
            chord = _over(place, opposite[other])
            if within.contains(chord):
                chords.append(chord)
    return sorted(chords, key=lambda chord: chord.length)


def _winding(ring: np.ndarray) -> float:
    x, y = ring.T
    return float(np.sign(np.dot(x, np.roll(y, -1)) - np.dot(np.roll(x, -1), y)))


def _over(start: np.ndarray, stop: np.ndarray) -> LineString:
    along = (stop - start) / np.hypot(*(stop - start))
    return LineString([start - OVER * along, stop + OVER * along])
