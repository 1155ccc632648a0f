"""The details of a facade: coloured ones, holes in the wall, and surfaces before it."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from shapely.geometry import Polygon

from ..colour.coloured_details import Coloured, divide_at_half
from ..elevation import COLOURED, PROJECTION
from ..settings import Settings
from .border import Border, Lost, trace_border
from .holes import Hole, within
from .jambs import is_plumb
from .surface import Surface

MARGIN = 12.0
"""Points around a detail that tell its border, in spacings."""

DEEPEST_MIXED = 0.3
"""A laser spot on two surfaces gives a point between them up to this distance (m); beyond, two points."""

NOISE = 4.0
"""Points further behind the wall, in standard deviations of its own, are of a jamb or mixed."""

INSET = 3.0
"""Places that stand in for points within a hole keep this many spacings from its border."""


@dataclass(frozen=True)
class Found:
    """A detail before its outline is made.

    Attributes
    ----------
    kind : str
    border : Border
    depth : float
    rows : ndarray of int64
        The points on its surface, among all points.
    """

    kind: str
    border: Border
    depth: float
    rows: np.ndarray


@dataclass(frozen=True)
class Scene:
    """All points of a facade in its frame.

    Attributes
    ----------
    uvw : ndarray of float64, shape (n, 3)
    labels : ndarray of int16, shape (n,)
        Planes; see `Segmentation`.
    """

    uvw: np.ndarray
    labels: np.ndarray

    def near(self, polygon_bounds: tuple, margin: float, chosen: np.ndarray) -> np.ndarray:
        """Return the rows of the chosen points within bounds and a margin (m)."""
        left, bottom, right, top = polygon_bounds
        u, v = self.uvw[chosen, 0], self.uvw[chosen, 1]
        inside = (u > left - margin) & (u < right + margin) & (v > bottom - margin) & (v < top + margin)
        return chosen[inside]


def coloured_details(
    scene: Scene, surface: Surface, coloured: Coloured, empty: np.ndarray, settings: Settings
) -> Iterator[Found]:
    """Yield the details of a plane that their colour tells from the wall."""
    margin = MARGIN * surface.spacing
    others = np.flatnonzero((scene.labels >= 0) & (np.abs(scene.uvw[:, 2]) <= settings.distance))
    for number in range(1, int(coloured.labels.max(initial=0)) + 1):
        chosen = coloured.labels == number
        chosen &= surface.sizes > 0
        chosen = divide_at_half(
            surface.mesh,
            surface.linked,
            coloured.looks,
            chosen,
            surface.spacing,
            settings.seed_colour,
        )
        rows = surface.rows[chosen]
        if not len(rows):
            continue
        around = scene.near(_bounds(scene.uvw[rows]), margin, others)
        outside = np.concatenate([scene.uvw[np.setdiff1d(around, rows)], empty])
        border = trace_border(scene.uvw[rows], outside, np.empty((0, 2)), settings.distance, margin)
        yield Found(COLOURED, border, float(np.mean(scene.uvw[rows, 2])), rows)


def hole_details(scene: Scene, surface: Surface, holes: list[Hole], settings: Settings) -> Iterator[Found]:
    """Yield openings and recesses, which lie between the wall and what is behind it."""
    facade, ground = np.flatnonzero(scene.labels >= 0), np.flatnonzero(scene.labels < 0)
    noise = NOISE * float(np.std(scene.uvw[surface.rows, 2]))
    for hole in holes:
        if hole.kind is None:
            continue
        half = -0.5 * min(abs(hole.depth), DEEPEST_MIXED)
        margin = MARGIN * surface.spacing
        near = scene.near(hole.polygon.bounds, margin, facade)
        w = scene.uvw[near, 2]
        grown = hole.polygon.buffer(surface.spacing)
        inside = near[w <= half]
        inside = inside[within(grown, scene.uvw[inside, :2])]
        outside = near[(w >= -noise) & (w <= settings.distance)]
        between = near[(w > half) & (w < -noise)]
        plumb = is_plumb(scene.uvw[between], scene.uvw[outside])
        lost = Lost(scene.uvw[between[~plumb], :2], surface.area_of_point)
        outside = np.concatenate([outside, between[plumb]])
        # A gate ends at the ground.
        foot = scene.near(hole.polygon.bounds, margin, ground)
        foot = foot[np.abs(scene.uvw[foot, 2]) <= DEEPEST_MIXED]
        outside = np.concatenate([outside, foot])
        filler = _lattice(hole.polygon.buffer(-INSET * surface.spacing), surface.spacing)
        border = trace_border(scene.uvw[inside], scene.uvw[outside], filler, 0.5 * abs(half), margin, lost)
        yield Found(hole.kind, border, hole.depth, inside)


def projecting_details(
    scene: Scene, label: int, surface: Surface, empty: np.ndarray, settings: Settings
) -> Iterator[Found]:
    """Yield the pieces of a plane before the wall."""
    others = np.flatnonzero((scene.labels >= 0) & (scene.uvw[:, 2] >= -settings.distance))
    own = scene.uvw[surface.rows]
    margin = MARGIN * surface.spacing
    for piece in surface.outline.geoms:
        if piece.area < settings.smallest_area:
            continue
        rows = surface.rows[within(piece.buffer(surface.spacing), own[:, :2])]
        depth = float(np.median(scene.uvw[rows, 2]))
        near = scene.near(piece.bounds, margin, others)
        near = near[scene.labels[near] != label]
        w = scene.uvw[near, 2]
        around = near[w < 0.5 * depth]
        noise = NOISE * float(np.std(scene.uvw[rows, 2]))
        between = scene.uvw[near[(w >= 0.5 * depth) & (w < depth - noise)]] - (0, 0, depth)
        plumb = is_plumb(between, scene.uvw[rows])
        lost = Lost(between[~plumb, :2], surface.area_of_point)
        outside = np.concatenate(
            [scene.uvw[around], empty[~within(piece.buffer(surface.spacing), empty[:, :2])]]
        )
        border = trace_border(
            scene.uvw[rows], outside, np.empty((0, 2)), 0.25 * depth, max(margin, depth), lost
        )
        yield Found(PROJECTION, border, depth, rows)


def empty_places(holes: list[Hole], spacing: float) -> np.ndarray:
    """Return u, v, w of places that stand in for what lies behind the holes of a wall, infinitely far."""
    places = [_lattice(hole.polygon.buffer(-spacing), spacing) for hole in holes]
    u, v = np.concatenate([np.empty((0, 2)), *places]).T
    return np.stack([u, v, np.full(len(u), -np.inf)], axis=1)


def _bounds(uvw: np.ndarray) -> tuple:
    return (*uvw[:, :2].min(axis=0), *uvw[:, :2].max(axis=0))


def _lattice(polygon: Polygon, step: float) -> np.ndarray:
    """Return places `step` apart within a polygon, shape (f, 2)."""
    if polygon.is_empty:
        return np.empty((0, 2))
    left, bottom, right, top = polygon.bounds
    u, v = np.meshgrid(np.arange(left, right, step), np.arange(bottom, top, step))
    places = np.stack([u.ravel(), v.ravel()], axis=1)
    return places[within(polygon, places)]
