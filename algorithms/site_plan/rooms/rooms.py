"""Rooms: the closed spaces between walls, from face to face.

Where two spaces meet at a narrow gap, it is a door, and each space ends there.
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
from ...progress import Progress
from .doors import FLAT, trim
from .settings import RoomSettings, SpaceSettings


@dataclass(frozen=True)
class Room:
    """A closed space.

    Attributes
    ----------
    room_id : int
        From 1, the largest first.
    outline : Polygon
        World coordinates; along the faces of the walls and straight across doors. Free columns are holes.
    openings : int or None
        Number of gaps to other rooms or the outside that were bridged: doors, and where a wall is broken;
        None where the room is cut from a storey.
    z_floor, z_ceiling : float or None
        Usual heights of floor and ceiling inside, metres; None if they are not known.
    seen : float or None
        Share of the area over which floor or ceiling was seen; None outside of storeys.
    """

    room_id: int
    outline: Polygon
    openings: Optional[int]
    z_floor: Optional[float] = None
    z_ceiling: Optional[float] = None
    seen: Optional[float] = None

    @property
    def area(self) -> float:
        """Square metres, without free columns."""
        return float(self.outline.area)

    @property
    def perimeter(self) -> float:
        """Metres; across doors, and around free columns."""
        return float(self.outline.length)


def find_rooms(
    outlines: Iterable[Polygon],
    settings: RoomSettings = RoomSettings(),
    progress: Progress = Progress(),
) -> tuple[Room, ...]:
    """Find the closed spaces between walls.

    Parameters
    ----------
    outlines : iterable of Polygon
        Walls, in world coordinates.
    settings : RoomSettings
    progress : Progress
        Reports and cancels.

    Returns
    -------
    tuple of Room
        The largest first; empty if no space is closed.
    """
    outlines = list(outlines)
    if not outlines:
        return ()
    progress.update(0.0, "Triangulating the space between walls")
    mesh = triangulate_outlines(outlines, settings.mesh, margin=2 * settings.door_width_m, progress=progress)
    spaces = _spaces(mesh, settings.door_width_m, settings.spaces)
    mesh = _at_narrowest(mesh, spaces.gap_ends)
    numbers, found = np.flatnonzero(spaces.is_room), []
    for done, number in enumerate(numbers):
        progress.update(0.5 + 0.5 * done / len(numbers), "Outlining rooms")
        found.append((trim(*_outline(mesh, spaces, number), settings.doors), number))
    found = [pair for pair in found if _is_wide(pair[0], settings.spaces)]
    found.sort(key=lambda pair: -pair[0].area)
    return tuple(
        Room(room_id, translate(outline, *mesh.origin), _count_openings(spaces, number))
        for room_id, (outline, number) in enumerate(found, start=1)
    )


def with_floors(rooms: tuple[Room, ...], ground: np.ndarray, transform: Affine) -> tuple[Room, ...]:
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


def _is_wide(outline: Polygon, settings: SpaceSettings) -> bool:
    length, width = outline.length / 2, 2 * outline.area / outline.length
    is_slender = length >= settings.slender * width
    return outline.area >= settings.least_area_m2 and not (is_slender and width < settings.least_width_m)


@dataclass(frozen=True)
class _Spaces:
    """The spaces that are left when narrow gaps are closed.

    Attributes
    ----------
    label : ndarray of int, shape (triangles,)
        -1 inside walls.
    area : ndarray, shape (spaces,)
        Square metres.
    is_room, is_outside : ndarray of bool, shape (spaces,)
    gaps, gap_ends : ndarray of int, shape (n, 2)
        The spaces on both sides of each narrow gap, and the corners of the mesh at its ends.
    """

    label: np.ndarray
    area: np.ndarray
    is_room: np.ndarray
    is_outside: np.ndarray
    gaps: np.ndarray
    gap_ends: np.ndarray


def _spaces(mesh: OutlineMesh, door_width: float, settings: SpaceSettings) -> _Spaces:
    """Join all that is linked over wide gaps, and then over narrow ones that are not doors."""
    sides = mesh.sides(~mesh.wall)
    wide = sides.lengths > door_width
    part = label_linked(sides.first[wide], sides.second[wide], len(mesh.wall))
    count = part.max() + 1
    width = np.zeros(count)
    np.maximum.at(width, part, mesh.widths())
    width[part[(mesh.neighbours < 0).any(axis=1)]] = np.inf
    merged = _Merging(np.bincount(part, mesh.areas(), count), width, settings)
    narrow = np.flatnonzero(~wide)
    narrow = narrow[np.argsort(-sides.lengths[narrow], kind="stable")]
    pairs = part[np.column_stack([sides.first, sides.second])[narrow]]
    lengths = sides.lengths[narrow].tolist()
    apart = [not merged.join(a, b, length) for (a, b), length in zip(pairs.tolist(), lengths)]
    root = np.array([merged.root(i) for i in range(count)])
    label = np.where(mesh.wall, -1, root[part])
    is_outside = np.isinf(merged.width)
    is_room = (merged.area >= settings.least_area_m2) & (merged.width >= settings.least_width_m)
    is_room &= ~is_outside
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
    """Spaces that are joined over ever narrower gaps, unless the gap is a door.

    Parameters
    ----------
    area, width : ndarray, shape (n,)
        Of the spaces at the beginning; m2, m. The width is that of the largest circle that fits in.
    settings : SpaceSettings
    """

    def __init__(self, area: np.ndarray, width: np.ndarray, settings: SpaceSettings) -> None:
        self.parent, self.settings = list(range(len(area))), settings
        self.area, self.width = area, width

    def root(self, i: int) -> int:
        while self.parent[i] != i:
            self.parent[i] = self.parent[self.parent[i]]
            i = self.parent[i]
        return i

    def join(self, a: int, b: int, length: float) -> bool:
        """Join two spaces over a gap of a width; return False if they remain apart."""
        a, b = self.root(a), self.root(b)
        if a == b:
            return True
        pocket = min(self.area[a], self.area[b]) < self.settings.pocket_m2
        narrow = length < self.settings.narrowing * min(self.width[a], self.width[b])
        if narrow and not pocket:
            return False
        self.parent[b] = a
        self.area[a] += self.area[b]
        self.width[a] = max(self.width[a], self.width[b])
        return True


def _count_openings(spaces: _Spaces, number: int) -> int:
    real = spaces.is_room | spaces.is_outside
    return sum(number in pair and bool(real[pair].all()) for pair in spaces.gaps)


def _outline(mesh: OutlineMesh, spaces: _Spaces, number: int) -> tuple[Polygon, np.ndarray]:
    """Return the outline of a space, and both ends of its gaps, shape (n, 2, 2)."""
    inside = np.flatnonzero(spaces.label == number)
    neighbours = mesh.neighbours[inside]
    row, corner = np.nonzero(np.where(neighbours >= 0, spaces.label[neighbours], -1) != number)
    ends = np.column_stack([mesh.triangles[inside[row], (corner + k) % 3] for k in (1, 2)])
    is_gap = ~mesh.outline[inside[row], corner]
    faces = list(polygonize(LineString(pair) for pair in mesh.points[ends]))
    # The rings of columns inside the space are faces as well.
    whole = min(faces, key=lambda face: abs(face.area - spaces.area[number]))
    return whole, mesh.points[ends[is_gap]]
