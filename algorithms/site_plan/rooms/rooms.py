"""Rooms: the closed spaces between walls, from face to face.

Where two spaces meet at a narrow place, it is a door, and each space ends there.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Optional

import numpy as np
from affine import Affine
from rasterio.features import rasterize
from scipy import ndimage
from shapely.affinity import translate
from shapely.geometry import LineString, Polygon
from shapely.ops import polygonize

from ...geometry.linked_parts import label_linked
from ...geometry.outline_triangles import OutlineMesh, triangulate_outlines
from .doors import FLAT, trim

DOOR_WIDTH = 1.3
"""Widest gap in metres that counts as a door: leaves are up to 1.25 m wide, corridors seldom narrower."""

NARROWING = 0.8
"""A door is narrower than this share of the spaces on both sides; a corridor beside its doors is not."""

POCKET = 0.25
"""A smaller space (m2) behind a narrow place is part of the space before it."""

MIN_AREA, MIN_WIDTH = 1.0, 0.8
"""Least area (m2) and width (m) of a room: what is less is the core of a wall, or a shaft."""

SLENDER = 6.0
"""A space longer than so many times its mean width has that width, whatever is wider where it turns."""


@dataclass(frozen=True)
class Room:
    """A closed space.

    Attributes
    ----------
    room_id : int
        From 1, the largest first.
    outline : Polygon
        World coordinates; along the faces of the walls and straight across doors. Free columns are holes.
    openings : int
        Number of gaps to other rooms or the outside that were bridged: doors, and where a wall is broken.
    z_floor : float or None
        Usual height of the ground inside, metres; None if it is not known.
    """

    room_id: int
    outline: Polygon
    openings: int
    z_floor: Optional[float] = None

    @property
    def area(self) -> float:
        """Square metres, without free columns."""
        return float(self.outline.area)

    @property
    def perimeter(self) -> float:
        """Metres; across doors, and around free columns."""
        return float(self.outline.length)


def find_rooms(outlines: Iterable, door_width: float = DOOR_WIDTH) -> tuple:
    """Find the closed spaces between walls.

    Parameters
    ----------
    outlines : iterable of Polygon
        Walls, in world coordinates.
    door_width : float
        Gaps up to this width, in metres, are bridged.

    Returns
    -------
    tuple of Room
        The largest first; empty if no space is closed.
    """
    outlines = list(outlines)
    if not outlines:
        return ()
    mesh = triangulate_outlines(outlines, margin=max(2 * door_width, 1.0))
    spaces = _spaces(mesh, door_width)
    mesh = _at_narrowest(mesh, spaces.gap_ends)
    found = [(_outline(mesh, spaces, number), number) for number in np.flatnonzero(spaces.is_room)]
    found = sorted((pair for pair in found if _is_wide(pair[0])), key=lambda pair: -pair[0].area)
    return tuple(
        Room(room_id, translate(outline, *mesh.origin), _count_openings(spaces, number))
        for room_id, (outline, number) in enumerate(found, start=1)
    )


def with_floors(rooms: tuple, ground: np.ndarray, transform: Affine) -> tuple:
    """Return rooms with the heights of their floors.

    Parameters
    ----------
    rooms : tuple of Room
    ground : ndarray of float, shape (rows, columns)
        Height of the local ground, metres; nan where it is not known.
    transform : Affine
        From (column, row) to world coordinates.
    """
    if not rooms:
        return ()
    labels = rasterize(
        [(room.outline, room.room_id) for room in rooms], ground.shape, transform=transform, dtype="int32"
    )
    known = np.where(np.isfinite(ground), labels, 0)
    floors = ndimage.median(ground, known, [room.room_id for room in rooms])
    seen = np.isin([room.room_id for room in rooms], known)
    return tuple(
        replace(room, z_floor=float(z)) if held else room for room, z, held in zip(rooms, floors, seen)
    )


def _is_wide(outline: Polygon) -> bool:
    length, width = outline.length / 2, 2 * outline.area / outline.length
    return outline.area >= MIN_AREA and (length < SLENDER * width or width >= MIN_WIDTH)


@dataclass(frozen=True)
class _Spaces:
    """The spaces that are left when narrow places are closed.

    Attributes
    ----------
    label : ndarray of int, shape (triangles,)
        -1 inside walls.
    area : ndarray, shape (spaces,)
        Square metres.
    is_room, is_outside : ndarray of bool, shape (spaces,)
    gaps, gap_ends : ndarray of int, shape (n, 2)
        The spaces on both sides of each narrow place, and the corners of the mesh at its ends.
    """

    label: np.ndarray
    area: np.ndarray
    is_room: np.ndarray
    is_outside: np.ndarray
    gaps: np.ndarray
    gap_ends: np.ndarray


def _spaces(mesh: OutlineMesh, door_width: float) -> _Spaces:
    """Join all that hangs together over wide places, and then over narrow ones that are no doors."""
    sides = mesh.sides(~mesh.wall)
    wide = sides.lengths > door_width
    part = label_linked(sides.first[wide], sides.second[wide], len(mesh.wall))
    count = part.max() + 1
    width = np.zeros(count)
    np.maximum.at(width, part, mesh.widths())
    width[part[(mesh.neighbours < 0).any(axis=1)]] = np.inf
    merged = _Merging(np.bincount(part, mesh.areas(), count), width)
    narrow = np.flatnonzero(~wide)
    narrow = narrow[np.argsort(-sides.lengths[narrow], kind="stable")]
    pairs = part[np.column_stack([sides.first, sides.second])[narrow]]
    lengths = sides.lengths[narrow].tolist()
    apart = [not merged.join(*pair, length) for pair, length in zip(pairs.tolist(), lengths)]
    root = np.array([merged.root(i) for i in range(count)])
    label = np.where(mesh.wall, -1, root[part])
    is_outside = np.isinf(merged.width)
    is_room = (merged.area >= MIN_AREA) & (merged.width >= MIN_WIDTH) & ~is_outside
    is_room[np.setdiff1d(np.arange(count), label)] = False
    gaps, ends = root[pairs[apart]], sides.ends[narrow[apart]]
    between = gaps[:, 0] != gaps[:, 1]
    return _Spaces(label, merged.area, is_room, is_outside, gaps[between], ends[between])


def _at_narrowest(mesh: OutlineMesh, gap_ends: np.ndarray) -> OutlineMesh:
    """Slide the ends of gaps along straight faces to where the gap is narrowest: samples lie anywhere."""
    points, pieces = mesh.points.copy(), mesh.outline_pieces()
    for gap in gap_ends:
        for fixed, loose in (gap, gap[::-1]):
            beside = np.setdiff1d(pieces[(pieces == loose).any(axis=1)], [loose])
            if len(beside) != 2:
                continue
            along = points[beside[1]] - points[beside[0]]
            x, y = points[loose] - points[beside[0]]
            if abs(along[0] * y - along[1] * x) <= FLAT * np.linalg.norm(along):
                share = (points[fixed] - points[beside[0]]) @ along / (along @ along)
                points[loose] = points[beside[0]] + np.clip(share, 0.01, 0.99) * along
    return replace(mesh, points=points)


class _Merging:
    """Spaces that are joined over ever narrower places, unless the place is a door.

    Parameters
    ----------
    area, width : ndarray, shape (n,)
        Of the spaces at the beginning; m2, m. The width is that of the largest circle that fits in.
    """

    def __init__(self, area: np.ndarray, width: np.ndarray) -> None:
        self.parent = list(range(len(area)))
        self.area, self.width = area, width

    def root(self, i: int) -> int:
        while self.parent[i] != i:
            self.parent[i] = self.parent[self.parent[i]]
            i = self.parent[i]
        return i

    def join(self, a: int, b: int, length: float) -> bool:
        """Join two spaces over a place of a width; return False if they stay apart."""
        a, b = self.root(a), self.root(b)
        if a == b:
            return True
        pocket = min(self.area[a], self.area[b]) < POCKET
        if not pocket and length < NARROWING * min(self.width[a], self.width[b]):
            return False
        self.parent[b] = a
        self.area[a] += self.area[b]
        self.width[a] = max(self.width[a], self.width[b])
        return True


def _count_openings(spaces: _Spaces, number: int) -> int:
    real = spaces.is_room | spaces.is_outside
    return sum(number in pair and bool(real[pair].all()) for pair in spaces.gaps)


def _outline(mesh: OutlineMesh, spaces: _Spaces, number: int) -> Polygon:
    """Return the outline of a space, from face to face."""
    inside = np.flatnonzero(spaces.label == number)
    neighbours = mesh.neighbours[inside]
    row, corner = np.nonzero(np.where(neighbours >= 0, spaces.label[neighbours], -1) != number)
    ends = np.column_stack([mesh.triangles[inside[row], (corner + k) % 3] for k in (1, 2)])
    is_gap = ~mesh.outline[inside[row], corner]
    faces = list(polygonize(LineString(pair) for pair in mesh.points[ends]))
    # The rings of columns inside the space are faces as well.
    whole = min(faces, key=lambda face: abs(face.area - spaces.area[number]))
    return trim(whole, mesh.points[ends[is_gap]])
