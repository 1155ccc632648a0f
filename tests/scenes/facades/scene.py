"""A facade with known details, and its scans. Everything is simulated in u, v, w of the facade."""

from dataclasses import dataclass, field, replace

import numpy as np
from ichnograph.algorithms.facade.elevation import Frame
from scipy.ndimage import map_coordinates
from shapely.geometry import Polygon

from .caster import LEAF, NOTHING, Leaves, Panel, cast, flatten

BEAM, DIVERGENCE = 0.003, 0.0003
"""Diameter of the laser spot at the scanner (m), and its growth per metre."""

SUBRAYS = 7
SEPARATE = 0.3
"""Surfaces within one spot that are further apart along the ray return two points (m)."""

LEAF_COLOUR, LEAF_REFLECTANCE = (70.0, 95.0, 45.0), 0.4
MARGIN = 2.0
SHADE = np.array([0.42, 0.45, 0.52])
"""Shares of red, green and blue that remain in a cast shadow."""


@dataclass(frozen=True)
class TrueDetail:
    """A detail as it was built.

    Attributes
    ----------
    kind : str
    outline : Polygon
        In u, v.
    depth : float
        w of its surface (m).
    """

    kind: str
    outline: Polygon
    depth: float

    @property
    def width(self) -> float:
        return self.outline.bounds[2] - self.outline.bounds[0]

    @property
    def height(self) -> float:
        return self.outline.bounds[3] - self.outline.bounds[1]

    @property
    def sill(self) -> float:
        return self.outline.bounds[1]

    @property
    def area(self) -> float:
        return self.outline.area


@dataclass(frozen=True)
class Light:
    """Sunlight on a facade.

    Attributes
    ----------
    shadow : Polygon
        The cast shadow in u, v.
    penumbra : float
        Width of its soft edge (m).
    gradient : float
        Share of the brightness lost from left to right.
    """

    shadow: Polygon = field(default_factory=Polygon)
    penumbra: float = 0.025
    gradient: float = 0.0


@dataclass(frozen=True)
class FacadeScan:
    """The points that the scanner returned.

    Attributes
    ----------
    points : ndarray of float64, shape (n, 3)
        World coordinates (m).
    rgb : ndarray of uint8, shape (n, 3)
    intensity : ndarray of uint16, shape (n,)
    station : ndarray of int, shape (n,)
    stations : ndarray, shape (k, 3)
        World positions.
    """

    points: np.ndarray
    rgb: np.ndarray
    intensity: np.ndarray
    station: np.ndarray
    stations: np.ndarray


@dataclass(frozen=True)
class FacadeScene:
    """A facade, its surroundings, and the stations from which it is scanned.

    Parameters
    ----------
    name : str
    wall : Polygon
        In u, v; openings and recesses are holes.
    details : tuple of TrueDetail
    panels : tuple of Panel
    leaves : tuple of Leaves
    light : Light
    stations : ndarray, shape (k, 3)
        In u, v, w.
    gains : tuple of float
        Of the intensity of each station's scanner.
    frame : Frame
    bulge : tuple of 2 float
        How far the wall stands out in its middle, and how far its top leans out (m); all that is scanned
        moves with it.
    """

    name: str
    wall: Polygon
    details: tuple[TrueDetail, ...]
    panels: tuple[Panel, ...]
    leaves: tuple[Leaves, ...]
    light: Light
    stations: np.ndarray
    gains: tuple[float, ...]
    frame: Frame = field(default_factory=lambda: Frame(np.zeros(3), 180.0, 0.0))
    bulge: tuple[float, float] = (0.0, 0.0)

    def moved(self, angle_degrees: float, shift_xyz: tuple[float, float, float]) -> "FacadeScene":
        """Return the scene rotated anticlockwise about the world's z axis, then shifted (m)."""
        turn = np.radians(angle_degrees)
        x, y, z = self.frame.origin
        turned = np.array([x * np.cos(turn) - y * np.sin(turn), x * np.sin(turn) + y * np.cos(turn), z])
        frame = Frame(turned + shift_xyz, (self.frame.azimuth - angle_degrees) % 360, self.frame.tilt)
        return replace(self, frame=frame)

    def scan(self, spacing: float = 0.005, range_noise: float = 0.002, seed: int = 0) -> FacadeScan:
        """Scan the facade from all its stations.

        Parameters
        ----------
        spacing : float
            Of the points of the first station in the middle of the wall (m). The other stations have the
            same angular step, so the density varies over the wall.
        range_noise : float
            Standard deviation along the ray (m).
        seed : int
            Of noise, leaves and texture.
        """
        generator = np.random.default_rng(seed)
        texture = _texture(generator)
        middle = np.array([*np.array(self.wall.bounds).reshape(2, 2).mean(axis=0), 0.0])
        step = spacing / np.linalg.norm(self.stations[0] - middle)
        parts = [
            self._scan_from(station, gain, step, range_noise, texture, generator)
            for station, gain in zip(self.stations, self.gains)
        ]
        uvw, rgb, intensity = (np.concatenate(values) for values in zip(*parts))
        return FacadeScan(
            self.frame.world(uvw),
            rgb,
            intensity,
            np.repeat(np.arange(len(parts)), [len(part[0]) for part in parts]),
            self.frame.world(self.stations),
        )

    def _scan_from(self, station, gain, step, range_noise, texture, generator):
        directions, columns = self._directions(station, step, generator)
        things = flatten(self.panels, self.leaves)
        reach, met = cast(station, directions, things, int(generator.integers(2**31)))
        rgb, intensity = self._seen(station, directions, reach, met, texture)
        split = np.flatnonzero(_at_edges(met.reshape(-1, columns)).ravel())
        self._mix(station, directions, split, things, texture, generator, (reach, rgb, intensity))
        back = np.flatnonzero(np.isfinite(reach) & (intensity > 0))
        reach, rgb, intensity = reach[back], rgb[back], intensity[back]
        reach = reach + range_noise * generator.normal(size=len(reach))
        rgb = rgb + generator.normal(0, 5.0, rgb.shape)
        intensity = gain * intensity * (1 + 0.04 * generator.normal(size=len(reach)))
        return (
            self._bent(station + reach[:, None] * directions[back]),
            np.clip(np.rint(rgb), 0, 255).astype(np.uint8),
            np.clip(np.rint(65535 * intensity), 1, 65535).astype(np.uint16),
        )

    def _bent(self, uvw: np.ndarray) -> np.ndarray:
        """Return points moved with the wall's bulge and lean."""
        out, lean = self.bulge
        if not out and not lean:
            return uvw
        left, bottom, right, top = self.wall.bounds
        across = np.clip((uvw[:, 0] - left) / (right - left), 0, 1)
        up = np.clip((uvw[:, 1] - bottom) / (top - bottom), 0, 1)
        return uvw + np.outer(16 * out * across * (1 - across) * up * (1 - up) + lean * up, [0.0, 0.0, 1.0])

    def _directions(self, station, step, generator):
        """Return a grid of rays that covers the facade with a margin, column by column."""
        left, bottom, right, top = self.wall.buffer(MARGIN).bounds
        corners = np.array([(u, v, 0.0) for u in (left, right) for v in (bottom, top)]) - station
        azimuths = np.arctan2(corners[:, 0], -corners[:, 2])
        level = np.hypot(corners[:, 0], corners[:, 2])
        steepest = np.arctan2(corners[:, 1], np.minimum(level, -corners[:, 2]))
        azimuths = np.arange(azimuths.min(), azimuths.max(), step) + generator.uniform(0, step)
        elevations = np.arange(steepest.min(), steepest.max(), step) + generator.uniform(0, step)
        turn, rise = np.meshgrid(azimuths, elevations, indexing="ij")
        directions = np.stack(
            [np.sin(turn) * np.cos(rise), np.sin(rise), -np.cos(turn) * np.cos(rise)], axis=-1
        )
        return directions.reshape(-1, 3), len(elevations)

    def _seen(self, station, directions, reach, met, texture):
        """Return colour and intensity of the surfaces that rays meet."""
        colours = np.array([panel.colour for panel in self.panels] + [LEAF_COLOUR, (0, 0, 0)])
        shares = np.array([panel.reflectance for panel in self.panels] + [LEAF_REFLECTANCE, 0])
        normals = np.array([panel.normal for panel in self.panels] + [(0, 0, 1), (0, 0, 1)])
        rows = np.where(met == LEAF, len(self.panels), np.where(met == NOTHING, len(self.panels) + 1, met))
        cosines = np.abs(np.sum(normals[rows] * directions, axis=1))
        far = np.where(np.isfinite(reach), reach, 1.0)
        places = station + far[:, None] * directions
        light = self._lit(places)
        rgb = colours[rows] * light + texture_at(texture, places)[:, None]
        return rgb, shares[rows] * cosines * np.exp(-far / 40.0)

    def _lit(self, places: np.ndarray) -> np.ndarray:
        left, _, right, _ = self.wall.bounds
        gradient = 1 - self.light.gradient * np.clip((places[:, 0] - left) / (right - left), 0, 1)
        if self.light.shadow.is_empty:
            return gradient[:, None] * np.ones(3)
        depth = _depth_within(self.light.shadow, places[:, :2])
        share = np.clip(depth / self.light.penumbra + 0.5, 0, 1)[:, None]
        return gradient[:, None] * (share * SHADE + (1 - share))

    def _mix(self, station, directions, split, things, texture, generator, results):
        """Replace the returns of rays at edges by those of the parts of their spots, in place."""
        reach, rgb, intensity = results
        if not len(split):
            return
        centre = directions[split]
        right = np.cross(centre, [0.0, 1.0, 0.0])
        right /= np.linalg.norm(right, axis=1)[:, None]
        up = np.cross(right, centre)
        typical = np.where(np.isfinite(reach[split]), reach[split], np.linalg.norm(station))
        radius = 0.5 * (BEAM + DIVERGENCE * typical) / typical
        parts = []
        for number in range(SUBRAYS):
            # The middle of the spot, and a ring that divides its area into halves.
            away = 0.0 if number == 0 else np.sqrt(0.5)
            turn = 2 * np.pi * number / (SUBRAYS - 1)
            ray = centre + (away * radius)[:, None] * (np.cos(turn) * right + np.sin(turn) * up)
            ray /= np.linalg.norm(ray, axis=1)[:, None]
            part_reach, met = cast(station, ray, things, int(generator.integers(2**31)))
            parts.append((part_reach, *self._seen(station, ray, part_reach, met, texture)))
        reaches, colours, strengths = (np.stack(values) for values in zip(*parts))
        # Of surfaces far from each other one returns, more often that with the larger part of the spot.
        chosen = reaches[generator.integers(SUBRAYS, size=len(split)), np.arange(len(split))]
        with np.errstate(invalid="ignore"):
            alike = np.where(np.isfinite(chosen), np.abs(reaches - chosen) < SEPARATE, ~np.isfinite(reaches))
        counts = alike.sum(axis=0)
        reach[split] = np.where(alike, reaches, 0).sum(axis=0) / counts
        rgb[split] = np.where(alike[..., None], colours, 0).sum(axis=0) / counts[:, None]
        intensity[split] = np.where(alike, strengths, 0).sum(axis=0) / counts


def _at_edges(met: np.ndarray) -> np.ndarray:
    """Return which rays of a grid have a neighbour that meets another panel."""
    edge = np.zeros(met.shape, bool)
    across, along = met[1:] != met[:-1], met[:, 1:] != met[:, :-1]
    for part in (edge[1:], edge[:-1]):
        part |= across
    for part in (edge[:, 1:], edge[:, :-1]):
        part |= along
    return edge


def _texture(generator: np.random.Generator) -> np.ndarray:
    """Return a mottling with waves of about 0.3 m, repeated every 64 cells."""
    return generator.normal(0, 6.0, (64, 64))


def texture_at(texture: np.ndarray, places: np.ndarray) -> np.ndarray:
    """Return the mottling at points, in grey values."""
    cells = np.stack([(places[:, 0] + places[:, 2]) / 0.15, places[:, 1] / 0.15])
    return map_coordinates(texture, cells, order=1, mode="grid-wrap")


def _depth_within(polygon: Polygon, points: np.ndarray) -> np.ndarray:
    """Return the depth of points within a convex polygon; negative outside."""
    corners = np.array(polygon.exterior.coords)
    if not polygon.exterior.is_ccw:
        corners = corners[::-1]
    depth = np.full(len(points), np.inf)
    for start, stop in zip(corners[:-1], corners[1:]):
        along = (stop - start) / np.linalg.norm(stop - start)
        offset = points - start
        depth = np.minimum(depth, along[0] * offset[:, 1] - along[1] * offset[:, 0])
    return depth
