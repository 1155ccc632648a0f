"""All facades of a cloud: upright planes, grouped, with the side of the open air."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Optional

import numpy as np

from ...progress import Progress
from ..planes.patches import Patch, extract
from ..planes.voxels import Voxels, make_voxels
from .openness import even_points, sides_of
from .settings import BuildingSettings
from .upright import upright_rows


@dataclass(frozen=True)
class Facade:
    """A facade of a cloud. Coordinates are relative to the origin of the points.

    Attributes
    ----------
    number : int
        From 1: the facades that most points see first, then the largest.
    azimuth : float
        Of the direction that it faces, clockwise from grid north (degrees).
    normal : ndarray of float64, shape (3,)
        Of its main plane, of length 1, outward.
    anchor : ndarray of float64, shape (3,)
        A point of its main plane.
    ends : ndarray of float64, shape (2, 2)
        x, y of its left and right end, seen from outside.
    bottom, top : float
        Heights (m).
    area : float
        Of its planes, without openings (m2).
    points : int
        On its planes.
    seen : int or None
        Of those, the points whose scanner stood before the facade; None if no position is known.
    planes : int
        Parallel planes that it consists of.
    """

    number: int
    azimuth: float
    normal: np.ndarray
    anchor: np.ndarray
    ends: np.ndarray
    bottom: float
    top: float
    area: float
    points: int
    seen: Optional[int]
    planes: int

    @property
    def length(self) -> float:
        """From end to end (m)."""
        return float(np.linalg.norm(self.ends[1] - self.ends[0]))

    @property
    def height(self) -> float:
        """From the lowest to the highest point of its planes (m)."""
        return self.top - self.bottom

    @property
    def axes(self) -> np.ndarray:
        """Level directions to the right and outward, as rows, shape (2, 2)."""
        east, north = np.sin(np.radians(self.azimuth)), np.cos(np.radians(self.azimuth))
        return np.array([[-north, east], [east, north]])


def find_facades(
    xyz: np.ndarray,
    scan: np.ndarray,
    stations: Optional[np.ndarray],
    distance: float,
    settings: BuildingSettings = BuildingSettings(),
    progress: Progress = Progress(),
) -> tuple[Facade, ...]:
    """Return the facades of a cloud, by number.

    Walls inside a building, those of which only the rooms behind them were seen, and small ones that are seen
    through the openings of a facade are left out.

    Parameters
    ----------
    xyz : ndarray of float64, shape (n, 3)
    scan : ndarray of int, shape (n,)
        The scan of each point.
    stations : ndarray of float64, shape (k, 3), or None
        Position of the scanner of each scan; nan where it is not known.
    distance : float
        ds, the largest distance of a point from its plane (m).
    settings : BuildingSettings
    progress : Progress
    """
    rows = upright_rows(xyz, settings.upright)
    if len(rows) < settings.planes.fewest_points:
        return ()
    near = xyz[rows]
    voxels = make_voxels(near, settings.cube_m, settings.planes.voxels)
    progress.update(0.4)
    steep = np.abs(voxels.normals[:, 2]) < np.sin(np.radians(settings.planes.upright_deg))
    cubes = Voxels(voxels.size, voxels.centres[steep], voxels.normals[steep], np.empty(0, np.int64))
    reach = max(distance, 0.5 * voxels.size)
    patches = [
        patch for patch in extract(cubes, reach, settings.planes) if _is_wall(patch, near, voxels, settings)
    ]
    progress.update(0.8)
    cloud = _Cloud(near, scan[rows], stations, even_points(xyz, settings.openness.cube_m))
    found = [_facade(group, cloud, settings) for group in _groups(patches, settings)]
    known = [facade for facade in found if facade is not None]
    facades = [facade for facade in known if not any(_is_within(facade, other, settings) for other in known)]
    facades.sort(key=lambda facade: (-(facade.seen or 0), -facade.points))
    return tuple(replace(facade, number=number) for number, facade in enumerate(facades, start=1))


@dataclass(frozen=True)
class _Cloud:
    """What facades are measured by: upright points, their scans, and all points, spread evenly."""

    xyz: np.ndarray
    scan: np.ndarray
    stations: Optional[np.ndarray]
    even: np.ndarray


def _is_wall(patch: Patch, xyz: np.ndarray, voxels: Voxels, settings: BuildingSettings) -> bool:
    """Whether a plane is upright, and a surface of its own and not a slice of a tree."""
    if abs(patch.normal[2]) > np.sin(np.radians(settings.lean_deg)):
        return False
    beside = np.abs(patch.heights(voxels.centres)) <= 2 * voxels.size
    beside[beside] = patch.covers(voxels.centres[beside])
    heights = np.abs(patch.heights(xyz[beside[voxels.of_point]]))
    near, on = (np.count_nonzero(heights <= reach * voxels.size) for reach in (1.0, settings.thin))
    return on >= settings.flat * near


def _groups(patches: Sequence[Patch], settings: BuildingSettings) -> list[list[Patch]]:
    """Return the planes of each facade, the largest first; they adjoin and are nearly parallel to it."""
    left = sorted(patches, key=lambda patch: -patch.area)
    groups = []
    while left:
        group, left = [left[0]], left[1:]
        while True:
            joined = [patch for patch in left if _adjoins(patch, group, settings)]
            if not joined:
                break
            group += joined
            left = [patch for patch in left if all(patch is not other for other in joined)]
        groups.append(group)
    return groups


def _adjoins(patch: Patch, group: list[Patch], settings: BuildingSettings) -> bool:
    main = group[0]
    if abs(patch.normal @ main.normal) < np.cos(np.radians(settings.parallel_deg)):
        return False
    if abs(np.median(main.heights(patch.centres_of_squares()))) > settings.apart_m:
        return False
    own = _extent(patch, main)
    return any(_gap(own, _extent(other, main)) <= settings.gap_m for other in group)


def _extent(patch: Patch, main: Patch) -> np.ndarray:
    """Return least and greatest u and v, shape (2, 2), of a plane along another one."""
    places = (patch.centres_of_squares() - main.anchor) @ main.axes.T
    return np.stack([places.min(axis=0), places.max(axis=0)]) + 0.5 * patch.side * np.array([[-1], [1]])


def _gap(first: np.ndarray, second: np.ndarray) -> float:
    """Return the larger of the gaps in u and v; not positive where they overlap."""
    return float(np.max(np.maximum(first[0], second[0]) - np.minimum(first[1], second[1])))


def _facade(group: list[Patch], cloud: _Cloud, settings: BuildingSettings) -> Optional[Facade]:
    level = group[0].normal[:2] / np.linalg.norm(group[0].normal[:2])
    covered, held = sides_of(
        cloud.even, level, float(group[0].anchor[:2] @ level), _limits(group[:1], level), settings.openness
    )
    before = _points_before(group[:1], cloud, settings)
    sign = _outward(covered, held, before, settings)
    if _is_inside(covered[::sign], held[::sign], settings):
        return None
    patches = _outermost(group, sign * group[0].normal, settings)
    start, stop, bottom, top = _limits(patches, level)
    area = sum(patch.area for patch in patches)
    if (
        stop - start < settings.least_length_m
        or top - bottom < settings.least_height_m
        or area < settings.least_m2
    ):
        return None
    main = patches[0]
    outside = 0 if main.normal @ group[0].normal * sign > 0 else 1
    after = None if before is None else _points_before(patches, cloud, settings)
    normal = main.normal * np.sign(main.normal @ group[0].normal) * sign
    along, foot = np.array([-level[1], level[0]]), (main.anchor[:2] @ level) * level
    return Facade(
        number=0,
        azimuth=float(np.degrees(np.arctan2(*(sign * level))) % 360),
        normal=normal,
        anchor=main.anchor,
        ends=foot + np.array([start, stop][::sign])[:, None] * along,
        bottom=bottom,
        top=top,
        area=area,
        points=int(np.count_nonzero(_on(patches, cloud.xyz, settings))),
        seen=None if after is None else int(after[outside]),
        planes=len(patches),
    )


def _limits(patches: Sequence[Patch], level: np.ndarray) -> tuple[float, float, float, float]:
    """Return start and stop along (-level_y, level_x), foot and top of planes."""
    squares = np.concatenate([patch.centres_of_squares() for patch in patches])
    along, margin = squares[:, :2] @ np.array([-level[1], level[0]]), 0.5 * patches[0].side
    up = squares[:, 2]
    return (
        float(along.min() - margin), float(along.max() + margin),
        float(up.min() - margin), float(up.max() + margin),
    )  # fmt: skip


def _on(patches: Sequence[Patch], xyz: np.ndarray, settings: BuildingSettings) -> np.ndarray:
    """Return which points lie on one of the planes."""
    on = np.zeros(len(xyz), bool)
    for patch in patches:
        rows = np.flatnonzero(~on & (np.abs(patch.heights(xyz)) <= settings.on_wall_m))
        on[rows] = patch.covers(xyz[rows])
    return on


def _points_before(group: list[Patch], cloud: _Cloud, settings: BuildingSettings) -> Optional[np.ndarray]:
    """Return the number of points that scanners before and behind planes measured; None if not known."""
    if cloud.stations is None:
        return None
    heights = group[0].heights(cloud.stations[cloud.scan[_on(group, cloud.xyz, settings)]])
    before = np.array([np.sum(heights > 0), np.sum(heights < 0)])
    return before if before.any() else None


def _outward(
    covered: np.ndarray, held: np.ndarray, before: Optional[np.ndarray], settings: BuildingSettings
) -> int:
    """Return 1 if the facade faces along the normal of its plane, -1 if it faces the other way.

    Ceilings show the inside; where there are none, the scanners stood outside, or more was seen outside.
    """
    if abs(covered[0] - covered[1]) > settings.openness.clearer:
        return 1 if covered[0] < covered[1] else -1
    counts = held if before is None else before
    return 1 if counts[0] >= counts[1] else -1


def _is_inside(covered: np.ndarray, held: np.ndarray, settings: BuildingSettings) -> bool:
    """Whether there is a room on both sides of a wall, or nothing was seen outside it, as of party walls."""
    limits = settings.openness
    rooms = covered > limits.covered
    return bool(rooms.all() or (rooms[1] and held[0] < limits.outside * held[1]))


def _is_within(facade: Facade, front: Facade, settings: BuildingSettings) -> bool:
    """Whether a wall is a part of the rooms or passages that are seen through a larger facade."""
    if facade.area > settings.small * front.area or facade.top > front.top:
        return False
    beside, away = ((facade.ends - front.ends[0]) @ front.axes.T).T
    behind = (away < settings.before_it_m) & (away > -settings.behind_m)
    return bool(np.all(behind & (beside > 0) & (beside < front.length)))


def _outermost(group: list[Patch], outward: np.ndarray, settings: BuildingSettings) -> list[Patch]:
    """Return the planes that are not behind the others, the largest first."""
    squares = [patch.centres_of_squares() for patch in group]
    seen = []
    for patch, own in zip(group, squares):
        hidden = np.zeros(len(own), bool)
        for other, there in zip(group, squares):
            before = float(np.median(there @ outward) - np.median(own @ outward))
            if other is not patch and before > settings.before_it_m:
                hidden |= other.covers(own)
        if hidden.mean() < settings.hidden:
            seen.append(patch)
    return seen
