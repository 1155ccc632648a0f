"""Rooms: what is seen as room, cut at doors, windows and passages."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from affine import Affine
from rasterio.features import rasterize
from shapely.geometry import LineString, Point, Polygon
from shapely.ops import split, unary_union
from shapely.prepared import prep

from .division import Division
from .evidence import UprightsAlong
from .footprint import Footprint
from .levels import Storey
from .linking import label_linked
from .settings import LevelSettings, RoomSettings


@dataclass(frozen=True)
class Parts:
    """The parts that rooms fall into when they are cut at openings.

    Attributes
    ----------
    outlines : list of Polygon
    over_sill : list of bool
        Whether a part is cut off by the face of a parapet.
    """

    outlines: list
    over_sill: list


@dataclass(frozen=True)
class Room:
    """A room.

    Attributes
    ----------
    outline : Polygon
        Metres; along the faces of the walls and straight across openings. Free columns are holes.
    z_floor, z_ceiling : float or None
        Usual heights, metres; None where not seen.
    seen : float
        Share of the area over which floor or ceiling was seen.
    """

    outline: Polygon
    z_floor: Optional[float]
    z_ceiling: Optional[float]
    seen: float


def find_rooms(
    division: Division,
    footprint: Footprint,
    storey: Storey,
    uprights: UprightsAlong,
    settings: RoomSettings = RoomSettings(),
    levels: LevelSettings = LevelSettings(),
) -> tuple:
    """Find the rooms, and the parapets in the niches of windows.

    Returns
    -------
    rooms : list of Room
        The largest first.
    parapets : list of Polygon
    """
    parts = cut_at_openings(division, uprights, settings, levels)
    rooms, parapets = [], []
    for part, over_sill in zip(parts.outlines, parts.over_sill):
        for outline in getattr(part, "geoms", [part]):
            if are_rooms([outline], settings)[0]:
                rooms += [
                    piece for piece in cut_at_necks(outline, settings) if are_rooms([piece], settings)[0]
                ]
            elif over_sill and _is_parapet(outline, footprint, storey, settings):
                parapets.append(outline)
    rooms = [_described(room, footprint) for room in sorted(rooms, key=lambda room: -room.area)]
    return rooms, parapets


def _pixels(outline: Polygon, footprint: Footprint) -> tuple:
    """Return the numbers of the pixels inside an outline."""
    frame = footprint.frame
    low, high = np.reshape(outline.bounds, (2, 2))
    (row0, row1), (column0, column1) = frame.places(np.array([low, high]))
    grid = Affine(
        frame.pixel_m,
        0,
        frame.left + column0 * frame.pixel_m,
        0,
        frame.pixel_m,
        frame.bottom + row0 * frame.pixel_m,
    )
    shape = (row1 - row0 + 1, column1 - column0 + 1)
    inside = rasterize([outline], shape, transform=grid, dtype="uint8")
    row, column = np.nonzero(inside)
    return row + row0, column + column0


def _described(outline: Polygon, footprint: Footprint) -> Room:
    place = _pixels(outline, footprint)
    weight = footprint.weight[place]
    known = weight[np.isfinite(weight)]
    seen = float((known > 0).mean()) if len(known) else 0.0
    return Room(outline, _median(footprint.floor[place]), _median(footprint.ceiling[place]), seen)


def _median(values: np.ndarray) -> Optional[float]:
    values = values[np.isfinite(values)]
    return float(np.median(values)) if len(values) else None


def _is_parapet(niche: Polygon, footprint: Footprint, storey: Storey, settings: RoomSettings) -> bool:
    """Tell whether the floor of a niche is a sill."""
    if niche.area < 0.01 or not niche.buffer(-settings.deepest_parapet_m / 2).is_empty:
        return False
    floor = footprint.floor[_pixels(niche, footprint)]
    floor = floor[np.isfinite(floor)]
    if not len(floor) or np.median(floor) < storey.floor + settings.sill_m:
        return False
    return bool((np.abs(floor - np.median(floor)) < settings.sill_m_off).mean() >= settings.sill_share)


def cut_at_openings(
    division: Division,
    uprights: UprightsAlong,
    settings: RoomSettings = RoomSettings(),
    levels: LevelSettings = LevelSettings(),
) -> Parts:
    """Cut what is room along the lines of sheets under lintels and over sills."""
    sides, is_room = division.arrangement.sides, division.is_room
    inside = is_room[sides].all(axis=1)
    chords, over_sill, shut = _chords(division, inside, uprights, settings, levels)
    linked = _cut_at_shut_doors(division, inside & ~chords, shut, settings)
    part = label_linked(*sides[linked].T, len(is_room))
    beside_sill = np.unique(part[sides[over_sill]])
    numbers = np.unique(part[is_room])
    outlines = [division.area(np.flatnonzero((part == number) & is_room)) for number in numbers]
    return Parts(outlines, np.isin(numbers, beside_sill).tolist())


def _chords(
    division: Division,
    inside: np.ndarray,
    uprights: UprightsAlong,
    settings: RoomSettings,
    levels: LevelSettings,
) -> tuple:
    """Tell the borders within rooms that lie in openings, those of them that lie over a parapet, and shut ones.

    Returns
    -------
    chords, over_sill : ndarray of bool, shape (borders,)
    shut : list of ndarray of int
        The borders of each opening that something fills, a leaf or a curtain or a piece of furniture.
    """
    ends, tracks = division.arrangement.ends, division.tracks
    candidate = np.flatnonzero(inside & (tracks.sheet >= 0))
    chords, over_sill = np.zeros(len(ends), bool), np.zeros(len(ends), bool)
    if not len(candidate):
        return chords, over_sill, []
    head, low, high = (round(z / levels.level_m) for z in (settings.head_m, *settings.eye_m))
    above = uprights.mean_levels(ends[candidate], -1 << head)
    eye = uprights.mean_levels(ends[candidate], (1 << high) - (1 << low))
    below = uprights.mean_levels(ends[candidate], (1 << low) - 2)
    length = division.arrangement.lengths[candidate]
    rim, shut = _nodes(ends[division.are_borders()]), []
    for run in _runs(ends[candidate], rim):
        first, last = _tips(ends[candidate[run]])
        if first not in rim or last not in rim:
            continue
        wide = length[run].sum()
        lintel, face, parapet = (np.average(kind[run], weights=length[run]) for kind in (above, eye, below))
        if face > settings.open_share * (high - low):
            if lintel >= settings.lintel_levels and wide <= settings.widest_leaf_m:
                shut.append(candidate[run])
            continue
        parapet = wide <= settings.widest_window_m and min(parapet / settings.parapet_levels, lintel) >= 1
        lintel = wide <= settings.widest_opening_m and lintel >= settings.lintel_levels
        chords[candidate[run]] = lintel or parapet
        over_sill[candidate[run]] = parapet
    return chords, over_sill, shut


def _cut_at_shut_doors(
    division: Division, linked: np.ndarray, shut: list, settings: RoomSettings
) -> np.ndarray:
    """Return which borders link cells, less the shut openings between two rooms: the others are furniture."""
    sides, is_room = division.arrangement.sides, division.is_room
    for own in sorted(shut, key=len):
        linked = linked.copy()
        before = linked[own].copy()
        if not before.any():
            continue
        linked[own] = False
        part = label_linked(*sides[linked].T, len(is_room))
        one, other = (part[side] for side in sides[own[before]][0])
        outlines = [division.area(np.flatnonzero((part == number) & is_room)) for number in (one, other)]
        if one == other or not are_rooms(outlines, settings).all():
            linked[own] = before
    return linked


def _nodes(ends: np.ndarray) -> set:
    return set(map(tuple, ends.reshape(-1, 2).tolist()))


def _runs(ends: np.ndarray, rim: set) -> list:
    """Return the numbers of borders that hang together on one line between places on the rim."""
    places = {}
    first, second = [], []
    for number, (x0, y0, x1, y1) in enumerate(ends.tolist()):
        for place in ((x0, y0), (x1, y1)):
            if place in rim:
                continue
            for other in places.setdefault(place, []):
                if _are_in_line(ends[number], ends[other]):
                    first.append(number)
                    second.append(other)
            places[place].append(number)
    label = label_linked(np.array(first, int), np.array(second, int), len(ends))
    return [np.flatnonzero(label == number) for number in np.unique(label)]


def _are_in_line(one: np.ndarray, other: np.ndarray) -> bool:
    a, b = one[2:] - one[:2], other[2:] - other[:2]
    return abs(a[0] * b[1] - a[1] * b[0]) <= 0.01 * np.hypot(*a) * np.hypot(*b)


def _tips(ends: np.ndarray) -> tuple:
    """Return the two ends of borders in one line."""
    places = ends.reshape(-1, 2)
    along = places @ (ends[0, 2:] - ends[0, :2])
    return tuple(places[np.argmin(along)].tolist()), tuple(places[np.argmax(along)].tolist())


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
        width = min(2 * _inner_radius(part) for part in parts)
        if width >= settings.narrowest_m and chord.length - 2 * OVER < settings.narrowing * width:
            return [one for part in parts for one in cut_at_necks(part, settings)]
    return [outline]


OVER = 1e-4
"""A chord goes on over both its ends by so much, metres, to cut."""


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


def _inner_radius(outline: Polygon) -> float:
    """Return about the radius of the largest circle inside an outline, metres; 1 m where it is larger."""
    low, high = 0.0, 1.0
    if not outline.buffer(-high).is_empty:
        return high
    while high - low > 0.02:
        middle = (low + high) / 2
        if outline.buffer(-middle).is_empty:
            high = middle
        else:
            low = middle
    return low


def are_rooms(outlines: list, settings: RoomSettings = RoomSettings()) -> np.ndarray:
    """Tell the parts that are rooms from niches and openings."""
    return np.array(
        [
            outline.area >= settings.smallest_m2 and not outline.buffer(-settings.narrowest_m / 2).is_empty
            for outline in outlines
        ],
        bool,
    )
