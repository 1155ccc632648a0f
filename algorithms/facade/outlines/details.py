"""The borders of the details: of colours on the wall, holes in it, and surfaces in front of it."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Optional

import numpy as np
from scipy.ndimage import binary_dilation, binary_erosion
from shapely.geometry import Polygon

from ..colour.coloured_details import Coloured
from ..colour.mixed_points import divide_at_half
from ..elevation import COLOURED, PROJECTION
from ..openings.content import Opening
from ..openings.states import BEHIND, States
from ..settings import FacadeSettings
from .border import Border, Lost, trace_border
from .jambs import divide_behind, is_plumb
from .surface import Surface, within


@dataclass(frozen=True)
class TracedDetail:
    """A detail whose border is traced, before its outline is made.

    Attributes
    ----------
    kind : str
    border : Border
    depth : float
    rows : ndarray of int64
        Of the points on its surface, among all points.
    opening : Opening or None
        What is known of an opening or a recess.
    """

    kind: str
    border: Border
    depth: float
    rows: np.ndarray
    opening: Optional[Opening] = None


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

    def near(
        self, bounds: tuple[float, float, float, float], margin: float, chosen: np.ndarray
    ) -> np.ndarray:
        """Return the rows of the chosen points within bounds and a margin (m)."""
        left, bottom, right, top = bounds
        u, v = self.uvw[chosen, 0], self.uvw[chosen, 1]
        inside = (u > left - margin) & (u < right + margin) & (v > bottom - margin) & (v < top + margin)
        return chosen[inside]


def coloured_details(
    scene: Scene, surface: Surface, coloured: Coloured, empty: np.ndarray, settings: FacadeSettings
) -> Iterator[TracedDetail]:
    """Yield the details that only their colour distinguishes from the wall."""
    looks, limits = coloured.looks, settings.outlines.border
    if looks is None:
        return
    margin = limits.margin_spacings * surface.spacing
    others = np.flatnonzero((scene.labels >= 0) & (np.abs(scene.uvw[:, 2]) <= settings.distance_m))
    for number in range(1, int(coloured.labels.max(initial=0)) + 1):
        chosen = divide_at_half(
            surface.mesh,
            surface.links,
            looks,
            (coloured.labels == number) & (surface.sizes > 0),
            surface.spacing,
            settings.seed_colour,
            settings.colour,
        )
        rows = surface.rows[chosen]
        if not len(rows):
            continue
        around = scene.near(_bounds(scene.uvw[rows]), margin, others)
        outside = np.concatenate([scene.uvw[np.setdiff1d(around, rows)], empty])
        border = trace_border(
            scene.uvw[rows], outside, np.empty((0, 2)), settings.distance_m, margin, settings=limits
        )
        yield TracedDetail(COLOURED, border, float(np.mean(scene.uvw[rows, 2])), rows)


def opening_details(
    scene: Scene, states: States, openings: list[Opening], settings: FacadeSettings
) -> Iterator[TracedDetail]:
    """Yield the openings and recesses: their borders are those of the wall, whatever is seen in them."""
    ground = np.flatnonzero(scene.labels < 0)
    near_wall = (
        (states.above <= settings.outlines.border.beside_m) & (states.cells >= 0) & (scene.labels >= 0)
    )
    facade = np.flatnonzero(near_wall & (states.above > -settings.outlines.jambs.deepest_m))
    for opening in openings:
        border = _opening_border(scene, states, opening, (facade, ground), settings)
        yield TracedDetail(opening.kind, border, opening.depth, opening.inside, opening)


def _opening_border(
    scene: Scene,
    states: States,
    opening: Opening,
    around: tuple[np.ndarray, np.ndarray],
    settings: FacadeSettings,
) -> Border:
    limits, spacing = settings.outlines.border, _spacing_around(opening, states)
    margin = limits.margin_spacings * spacing
    bounds = opening.polygon.bounds
    core = _core(opening, states)
    near = scene.near(bounds, margin, around[0])
    near = near[~core.ravel()[states.cells[near]]]
    uvw = np.column_stack([scene.uvw[near, :2], states.above[near]])
    before = uvw[:, 2] >= -states.layers[opening.layer].surface.roughness
    wall, behind = uvw[before] * (1, 1, 0), uvw[~before]
    jamb, mixed = divide_behind(behind, wall, spacing, settings.outlines)
    # A gate ends at the ground.
    foot = scene.uvw[scene.near(bounds, margin, around[1])]
    foot = foot[np.abs(foot[:, 2]) <= limits.mixed_depth_m] * (1, 1, 0)
    outside = np.concatenate([wall, foot])
    reach = limits.reach_spacings * max(spacing, states.grid.size / settings.openings.states.pixel_spacings)
    border = trace_border(
        np.empty((0, 3)), outside, states.grid.centres(core), 0.01, margin, Lost(mixed[:, :2], spacing**2),
        limits, reach,
    )  # fmt: skip
    return replace(border, jambs=jamb, bare=~_beside_content(opening, states, border.crossings))


def _beside_content(opening: Opening, states: States, crossings: np.ndarray) -> np.ndarray:
    """Return beside which crossings, shape (k, 2), an opening shows something behind the wall."""
    image = np.zeros(states.grid.shape, bool)
    image[opening.region.box] = opening.region.image
    image &= (states.image == BEHIND) | states.reveals
    # The region ends up to a pixel beside its border.
    cells = states.grid.cells(crossings)
    return np.asarray((cells >= 0) & binary_dilation(image, np.ones((5, 5))).ravel()[np.maximum(cells, 0)])


def _spacing_around(opening: Opening, states: States) -> float:
    """Return the spacing of the points of the wall around an opening (m)."""
    return float(np.median(states.spacings[opening.region.box]))


def _core(opening: Opening, states: States) -> np.ndarray:
    """Return the pixels of an opening that have none of the wall beside them, as an image."""
    image = np.zeros(states.grid.shape, bool)
    image[opening.region.box] = opening.region.image
    core = binary_erosion(image, np.ones((3, 3)))
    return core if core.any() else image


def projecting_details(
    scene: Scene, label: int, surface: Surface, empty: np.ndarray, settings: FacadeSettings
) -> Iterator[TracedDetail]:
    """Yield the pieces of a plane in front of the wall."""
    limits = settings.outlines.border
    others = np.flatnonzero((scene.labels >= 0) & (scene.uvw[:, 2] >= -settings.distance_m))
    own = scene.uvw[surface.rows]
    margin = limits.margin_spacings * surface.spacing
    for piece in surface.outline.geoms:
        if piece.area < settings.smallest_m2:
            continue
        grown = piece.buffer(surface.spacing)
        rows = surface.rows[within(grown, own[:, :2])]
        depth = float(np.median(scene.uvw[rows, 2]))
        near = scene.near(piece.bounds, margin, others)
        near = near[scene.labels[near] != label]
        w = scene.uvw[near, 2]
        around = near[w < 0.5 * depth]
        noise = limits.noise_sigmas * float(np.std(scene.uvw[rows, 2]))
        between = scene.uvw[near[(w >= 0.5 * depth) & (w < depth - noise)]] - (0, 0, depth)
        plumb = is_plumb(between, scene.uvw[rows], settings.outlines)
        lost = Lost(between[~plumb, :2], surface.area_of_point)
        outside = np.concatenate([scene.uvw[around], empty[~within(grown, empty[:, :2])]])
        border = trace_border(
            scene.uvw[rows], outside, np.empty((0, 2)), 0.25 * depth, max(margin, depth), lost, limits
        )
        yield TracedDetail(PROJECTION, border, depth, rows)


def stand_ins(openings: list[Opening], spacing: float) -> np.ndarray:
    """Return u, v, w of positions in the openings that stand in for points infinitely far behind."""
    positions = [_lattice(opening.polygon.buffer(-2 * spacing), spacing) for opening in openings]
    u, v = np.concatenate([np.empty((0, 2)), *positions]).T
    return np.stack([u, v, np.full(len(u), -np.inf)], axis=1)


def _bounds(uvw: np.ndarray) -> tuple[float, float, float, float]:
    (left, bottom), (right, top) = uvw[:, :2].min(axis=0), uvw[:, :2].max(axis=0)
    return left, bottom, right, top


def _lattice(polygon: Polygon, step: float) -> np.ndarray:
    """Return positions `step` apart within a polygon, shape (f, 2)."""
    if polygon.is_empty:
        return np.empty((0, 2))
    left, bottom, right, top = polygon.bounds
    u, v = np.meshgrid(np.arange(left, right, step), np.arange(bottom, top, step))
    positions = np.stack([u.ravel(), v.ravel()], axis=1)
    return positions[within(polygon, positions)]
