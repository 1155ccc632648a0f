"""Necks of a space, which are doors although no lintel was seen."""

import numpy as np
from shapely.geometry import LinearRing, LineString, Point, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.geometry.polygon import orient
from shapely.ops import split
from shapely.prepared import prep

from ....geometry.polygons import polygons_of
from ..division.outlines import united
from ..settings import RoomSettings
from .spaces import inner_width

OVER = 1e-4
"""A chord extends beyond both its ends by so much, metres, so that it cuts."""

TOUCHING = 1e-6
"""Areas nearer than this touch, metres."""


def cut_at_necks(outline: Polygon, settings: RoomSettings = RoomSettings()) -> list[Polygon]:
    """Cut a space at its necks, which are doors without a lintel; return its parts."""
    half = settings.neck_m / 2
    cores = outline.buffer(-half)
    if cores.geom_type != "MultiPolygon":
        return [outline]
    wide = [core.buffer(1.01 * half) for core in cores.geoms]
    throats = [
        throat
        for throat in polygons_of(outline.difference(united(wide)))
        if sum(throat.distance(core) < TOUCHING for core in wide) > 1
    ]
    for chord in _narrow_chords(outline, united(throats).buffer(settings.throat_m), settings):
        parts = [part for part in split(outline, chord).geoms if part.area > 1e-4]
        if len(parts) != 2:
            continue
        width = min(inner_width(part) for part in parts)
        if width >= settings.narrowest_m and chord.length - 2 * OVER < settings.narrowing * width:
            return [one for part in parts for one in cut_at_necks(part, settings)]
    return [outline]


def _narrow_chords(outline: Polygon, near: BaseGeometry, settings: RoomSettings) -> list[LineString]:
    """Return the chords from corners that jut into a space to what is opposite, the shortest first."""
    sides = np.concatenate([_sides(ring) for ring in (outline.exterior, *outline.interiors)])
    starts, along = sides[:, :2], sides[:, 2:] - sides[:, :2]
    within, is_near = prep(outline.buffer(2 * OVER)), prep(near)
    chords: list[LineString] = []
    for corner in _jutting(outline):
        if not is_near.contains(Point(corner)):
            continue
        share = ((corner - starts) * along).sum(axis=1) / np.maximum((along**2).sum(axis=1), 1e-12)
        opposite = starts + np.clip(share, 0, 1)[:, None] * along
        distance = np.hypot(*(opposite - corner).T)
        chosen = opposite[(distance <= settings.neck_m) & (distance > settings.shortest_chord_m)]
        found = [_over(corner, end) for end in chosen]
        chords += [chord for chord in found if within.contains(chord)]
    return sorted(chords, key=lambda chord: chord.length)


def _sides(ring: LinearRing) -> np.ndarray:
    corners = np.asarray(ring.coords)
    return np.hstack([corners[:-1], corners[1:]])


def _jutting(outline: Polygon) -> np.ndarray:
    """Return the corners that jut into a space, shape (n, 2)."""
    outline = orient(outline)
    found = []
    for ring in (outline.exterior, *outline.interiors):
        corners = np.asarray(ring.coords)[:-1]
        before, after = corners - np.roll(corners, 1, axis=0), np.roll(corners, -1, axis=0) - corners
        found.append(corners[before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0] < 0])
    return np.concatenate(found)


def _over(start: np.ndarray, stop: np.ndarray) -> LineString:
    along = (stop - start) / np.hypot(*(stop - start))
    return LineString([start - OVER * along, stop + OVER * along])
