"""A scene and its scans. Everything is simulated in the frame of the scene and moved at the end."""

from collections.abc import Container
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Optional, Union

import numpy as np
from shapely.affinity import affine_transform
from shapely.geometry import LineString, MultiLineString, MultiPolygon, Polygon

from .scanner import Optics, flatten, panorama, surround
from .things import Ground, Mirror, Plant, Prism
from .truth import dissolved, is_cut, is_footing, is_wall, seen_boundary

LOWEST_RAY = -60.0
HIGHEST_RAY = 90.0


@dataclass(frozen=True)
class Pose:
    """A rotation about z (degrees, anticlockwise), then a shift."""

    angle: float = 0.0
    shift: tuple[float, float, float] = (0.0, 0.0, 0.0)

    @property
    def rotation(self) -> np.ndarray:
        """The rotation matrix, shape (3, 3)."""
        cosine, sine = np.cos(np.radians(self.angle)), np.sin(np.radians(self.angle))
        return np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])

    def points(self, points: np.ndarray) -> np.ndarray:
        """Return `points`, shape (n, 3), moved."""
        return points @ self.rotation.T + self.shift

    def geometry(self, geometry):
        """Return a shapely `geometry` moved."""
        return affine_transform(geometry, [*self.rotation[:2, :2].ravel(), *self.shift[:2]])

    def then(self, other: "Pose") -> "Pose":
        """Return the pose that moves by this one first, then by `other`."""
        shift = other.points(np.array([self.shift]))[0]
        return Pose(self.angle + other.angle, tuple(shift))


@dataclass(frozen=True)
class Scan:
    """The points that the scanner returned from all stations of a scene.

    Attributes
    ----------
    points : ndarray of float64, shape (n, 3)
        World coordinates (m).
    station : ndarray of int, shape (n,)
        Row of `Scene.stations`.
    intensity : ndarray of uint16, shape (n,)
    seen_boundary : MultiLineString
        The part of the boundary of `Scene.truth` that rays have met.
    """

    points: np.ndarray
    station: np.ndarray
    intensity: np.ndarray
    seen_boundary: MultiLineString


@dataclass(frozen=True)
class Scene:
    """Objects, the ground on which they stand, and the stations from which they are scanned.

    Parameters
    ----------
    name : str
    prisms : tuple of Prism
    scanners : ndarray, shape (n, 3)
        Stations in the frame of the prisms.
    ground : Ground
    plants : tuple of Plant
    max_range : float
        Beyond it nothing returns (m).
    ghosts : float
        Share of returns from prisms that appear, after a reflection, as points far behind.
    range_noise : float
        Standard deviation along the ray that the scanner of this scene has (m).
    pose : Pose
        From the frame of the prisms to the world.
    thinned : float
        Edge of the cubes of which one point each remains, as in clouds that were thinned (m); 0 keeps all.
    mirrors : tuple of Mirror
        Each in front of a prism of the material "mirror".
    drifts : ndarray, shape (n, 3)
        How far the points of each station are off, as in two passes of a moving scanner; none if not given.
    local_rooms : tuple of Polygon
        True rooms, from face to face, in the frame of the prisms.
    local_doubtful_rooms : tuple of Polygon
        Spaces that plans end differently, as under a stair: neither asked for nor wrong.
    local_openings : tuple of LineString
        Where doors and windows interrupt the faces of walls: leaves, frames and panes there are neither
        right nor wrong.
    """

    name: str
    prisms: tuple[Prism, ...]
    scanners: np.ndarray
    ground: Ground = field(default_factory=Ground)
    plants: tuple[Plant, ...] = ()
    max_range: float = 80.0
    ghosts: float = 0.0
    range_noise: float = 0.003
    thinned: float = 0.0
    pose: Pose = field(default_factory=Pose)
    mirrors: tuple[Mirror, ...] = ()
    drifts: Optional[np.ndarray] = None
    local_rooms: tuple[Polygon, ...] = ()
    local_doubtful_rooms: tuple[Polygon, ...] = ()
    local_openings: tuple[LineString, ...] = ()

    @property
    def rooms(self) -> list[Polygon]:
        """True rooms, from face to face."""
        return [self.pose.geometry(room) for room in self.local_rooms]

    @property
    def doubtful_rooms(self) -> list[Polygon]:
        """Spaces that are neither asked for nor wrong."""
        return [self.pose.geometry(room) for room in self.local_doubtful_rooms]

    @property
    def openings(self) -> list[LineString]:
        """Where doors and windows interrupt the faces of walls."""
        return [self.pose.geometry(opening) for opening in self.local_openings]

    @cached_property
    def truth(self) -> MultiPolygon:
        """Footprints of the walls that rise at least 0.8 m above the ground."""
        return self.pose.geometry(self._local_truth)

    @property
    def faces(self) -> MultiLineString:
        """All that may be drawn: outlines of the truth and of the walls as they are cut, and panes.

        At a window over a parapet both the reveals and the face of the parapet are right.
        """
        panes = [prism.footprint for prism in self.prisms if prism.material == "glass"]
        cut = [prism.footprint for prism in self.prisms if is_cut(prism, self.ground)]
        drawn = [*self._local_truth.geoms, *dissolved(cut).geoms, *panes]
        rings = [ring for part in drawn for ring in (part.exterior, *part.interiors)]
        return self.pose.geometry(MultiLineString([ring.coords for ring in rings]))

    @property
    def fitted(self) -> list[LineString]:
        """Outlines of furniture that reaches the ceiling, of which no point shows that it is not wall."""
        return [
            self.pose.geometry(LineString(prism.footprint.exterior.coords))
            for prism in self.prisms
            if prism.material == "fitted"
        ]

    @cached_property
    def footings(self) -> MultiPolygon:
        """Footprints of the walls too low to be found."""
        low = [prism.footprint for prism in self.prisms if is_footing(prism, self.ground)]
        return self.pose.geometry(dissolved(low))

    @property
    def stations(self) -> np.ndarray:
        """Positions of the scanner in the world, shape (n, 3)."""
        return self.pose.points(self._lifted(self.scanners))

    def moved(self, angle_degrees: float, shift_xyz: tuple[float, float, float]) -> "Scene":
        """Return the scene rotated anticlockwise about the world's z axis, then shifted (m)."""
        return replace(self, pose=self.pose.then(Pose(angle_degrees, tuple(shift_xyz))))

    def scan(
        self,
        angular_step: float = 0.1,
        range_noise: Optional[float] = None,
        seed: int = 0,
        without: Container[int] = (),
    ) -> Scan:
        """Scan the scene from its stations.

        Parameters
        ----------
        angular_step : float
            Between neighbouring rays, in azimuth and elevation (degrees).
        range_noise : float, optional
            Standard deviation along the ray (m); that of the scene if not given.
        seed : int
            Of noise, foliage and the first azimuth of each station.
        without : container of int
            Rows of `stations` to leave out; the points of the others do not change.
        """
        step = np.radians(angular_step)
        azimuths = step * np.arange(round(360 / angular_step))
        rows = round((HIGHEST_RAY - LOWEST_RAY) / angular_step)
        elevations = np.radians(LOWEST_RAY) + step * (np.arange(rows) + 0.5)
        bodies, surroundings = flatten(self.prisms), surround(self.ground, self.plants)
        optics = Optics(
            float(self.max_range),
            float(self.range_noise if range_noise is None else range_noise),
            float(self.ghosts),
        )
        random = np.random.default_rng(seed)
        starts = random.uniform(0, step, len(self.scanners))
        seeds = random.integers(2**32, size=len(self.scanners))
        kept = [row for row in range(len(self.scanners)) if row not in without]

        def scan_from(scanner, start, ray_seed):
            returned, intensity, hits = panorama(
                scanner, azimuths + start, elevations, bodies, surroundings, optics, ray_seed
            )
            images = [mirror.images(scanner, returned) for mirror in self.mirrors]
            returned = np.concatenate([returned, *images])
            intensity = np.resize(intensity, len(returned))
            return returned, intensity, hits

        with ThreadPoolExecutor() as pool:
            blocks = list(pool.map(scan_from, self.scanners[kept], starts[kept], seeds[kept]))
        points, intensity, hits = zip(*blocks)
        if self.drifts is not None:
            points = [block + drift for block, drift in zip(points, self.drifts[kept])]
        points = [self.pose.points(self._lifted(block)) for block in points]
        points, stations = np.concatenate(points), np.repeat(kept, [len(block) for block in points])
        first = _first_in_cubes(points, self.thinned)
        walls = np.array([is_wall(prism, self.ground) for prism in self.prisms])
        return Scan(
            points[first],
            stations[first],
            np.concatenate(intensity)[first],
            self.pose.geometry(seen_boundary(self._local_truth, walls, bodies, sum(hits))),
        )

    @cached_property
    def _local_truth(self) -> MultiPolygon:
        return dissolved([prism.footprint for prism in self.prisms if is_wall(prism, self.ground)])

    def _lifted(self, points: np.ndarray) -> np.ndarray:
        if self.ground.is_plane:
            return points
        lift = self.ground.lift(points[:, 0], points[:, 1])
        return points + np.column_stack([np.zeros((len(points), 2)), lift])


def _first_in_cubes(points: np.ndarray, edge: float) -> Union[slice, np.ndarray]:
    """Return the rows of the first points in each cube of an edge (m); all if that is 0."""
    if not edge:
        return slice(None)
    cubes = np.floor((points - points.min(axis=0)) / edge).astype(np.int64)
    width, depth, _ = cubes.max(axis=0) + 1
    keys = cubes @ np.array([1, width, width * depth])
    return np.sort(np.unique(keys, return_index=True)[1])
