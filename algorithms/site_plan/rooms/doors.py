"""Where exactly a room ends at a door: on the faces of the wall, not in the middle of the passage."""

from typing import Optional

import numpy as np
from shapely.geometry import LineString, Point, Polygon
from shapely.ops import substring
from shapely.prepared import prep

from .settings import DoorSettings

FLAT = 1e-5
"""How far corners that are left out may lie off the line between others, in metres."""


def trim(room: Polygon, gaps: np.ndarray, settings: DoorSettings = DoorSettings()) -> Polygon:
    """Let a room end on the faces of the walls at its doors.

    Where the jambs of a passage run apart, as in a splay, the room ends where they begin to.

    Parameters
    ----------
    room : Polygon
        Reaches into each door, up to where it is narrowest.
    gaps : ndarray, shape (n, 2, 2)
        Both ends of the narrowest gaps; they are sides of the room.
    settings : DoorSettings
    """
    rings = [
        _without_flat_corners(np.asarray(ring.coords)[:-1], gaps) for ring in (room.exterior, *room.interiors)
    ]
    room = Polygon(rings[0], rings[1:])
    for gap in gaps:
        for i, ring in enumerate(list(rings)):
            start = _find(ring, gap)
            if start is None:
                continue
            trimmed = _moved(np.roll(ring, -start, axis=0), room, settings)
            changed = [*rings[:i], trimmed, *rings[i + 1 :]]
            candidate = Polygon(changed[0], changed[1:])
            if candidate.is_valid:
                rings, room = changed, candidate
    return room.simplify(FLAT)


def _without_flat_corners(ring: np.ndarray, gaps: np.ndarray) -> np.ndarray:
    """Leave out the samples between corners, but for the ends of gaps."""
    ends = np.flatnonzero((ring[:, None] == gaps.reshape(-1, 2)).all(axis=2).any(axis=1))
    first = ends[0] if len(ends) else 0
    closed = np.concatenate([ring[first:], ring[: first + 1]])
    cuts = [*(ends - first if len(ends) else [0]), len(ring)]
    parts = [LineString(closed[a : b + 1]).simplify(FLAT) for a, b in zip(cuts, cuts[1:])]
    return np.concatenate([np.asarray(part.coords)[:-1] for part in parts])


def _find(ring: np.ndarray, gap: np.ndarray) -> Optional[int]:
    """Return the number of the corner at the end of a gap, or None if no side of the ring spans it."""
    after = np.roll(ring, -1, axis=0)
    one = (ring == gap[0]).all(axis=1) & (after == gap[1]).all(axis=1)
    other = (ring == gap[1]).all(axis=1) & (after == gap[0]).all(axis=1)
    found = np.flatnonzero(one | other)
    return int(found[0] + 1) % len(ring) if len(found) else None


def _moved(ring: np.ndarray, room: Polygon, settings: DoorSettings) -> np.ndarray:
    """Move the side between the last and the first corner to where the passage opens into the room."""
    ahead, behind = _Jamb(ring, settings.deepest_m), _Jamb(ring[::-1], settings.deepest_m)
    corners = np.stack(np.meshgrid(ahead.stations, behind.stations), axis=-1).reshape(-1, 2)
    opposite = np.column_stack([ahead.stations, behind.nearest(ahead.at(ahead.stations))])
    other = np.column_stack([ahead.nearest(behind.at(behind.stations)), behind.stations])
    pairs = np.concatenate([corners, opposite, other])
    ends = np.stack([ahead.at(pairs[:, 0]), behind.at(pairs[:, 1])], axis=1)
    widths = np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1)
    narrowest = np.linalg.norm(ring[0] - ring[-1])
    gain = pairs.mean(axis=1) - settings.loss * np.maximum(widths - narrowest, 0)
    gain[widths > settings.wider * narrowest] = 0
    clear = prep(room.buffer(FLAT, join_style=2))
    for best in np.argsort(-gain, kind="stable"):
        if gain[best] <= FLAT:
            break
        kept = ring[ahead.passed(pairs[best, 0]) : len(ring) - behind.passed(pairs[best, 1])]
        if len(kept) and clear.contains(LineString(ends[best])):
            return np.concatenate([ends[best, :1], kept, ends[best, 1:]])
    return ring


class _Jamb:
    """One side of a passage: the beginning of a ring.

    Attributes
    ----------
    stations : ndarray
        How far along the corners lie, in metres; not more than half around.
    """

    def __init__(self, ring: np.ndarray, deepest: float) -> None:
        steps = np.linalg.norm(np.diff(ring, axis=0), axis=1)
        self.ring, self.along = ring, np.concatenate([[0.0], np.cumsum(steps)])
        reach = min(deepest, self.along[-1] / 2)
        self.line = substring(LineString(ring), 0.0, reach)
        self.stations = self.along[self.along <= reach]

    def at(self, stations: np.ndarray) -> np.ndarray:
        """Return the points at stations, shape (n, 2)."""
        return np.column_stack([np.interp(stations, self.along, axis) for axis in self.ring.T])

    def nearest(self, points: np.ndarray) -> np.ndarray:
        """Return the stations nearest to points, shape (n, 2)."""
        return np.array([self.line.project(Point(point)) for point in points])

    def passed(self, station: float) -> int:
        """Return how many corners lie up to a station."""
        return int(np.searchsorted(self.along, station + FLAT, side="right"))
