"""What is seen in an opening: its depth, and whether it is a window, a door or a passage."""

from dataclasses import dataclass

import numpy as np
from rasterio.features import shapes
from rasterio.transform import Affine
from shapely.geometry import Polygon, shape

from ..elevation import OPENING, RECESS
from .grid import BELOW
from .regions import Region, open_sides, solid_wall
from .settings import ContentSettings
from .states import States

WINDOW, DOOR, PASSAGE = "window", "door", "passage"
SIDES = ("left", "right", "bottom", "top")


@dataclass(frozen=True)
class Opening:
    """A hole of the wall and what is seen in it.

    Attributes
    ----------
    region : Region
    polygon : Polygon
        Its pixels, in u, v.
    kind : str
        `OPENING` or `RECESS`.
    use : str
        `WINDOW`, `DOOR` or `PASSAGE`.
    depth : float
        Median distance of its content from the layer of the wall, negative; nan where nothing was seen.
    layer : int
        Of the wall around it; 0 is the main one.
    open_sides : tuple of str
        Where no wall bounds it.
    inside : ndarray of int64
        The points of its content.
    bent : int
        On how many of its four sides the wall comes as near to its content without a step.
    """

    region: Region
    polygon: Polygon
    kind: str
    use: str
    depth: float
    layer: int
    open_sides: tuple[str, ...]
    inside: np.ndarray
    bent: int = 0


def fill_regions(
    states: States, regions: list[Region], settings: ContentSettings = ContentSettings()
) -> list[Opening]:
    """Return the openings of regions, with what is seen in them."""
    wall = solid_wall(states)
    numbers = np.full(states.grid.shape, -1, np.int32)
    for number, region in enumerate(regions):
        numbers[region.box][region.image] = number
    of_point = np.where(states.cells >= 0, numbers.ravel()[np.maximum(states.cells, 0)], -1)
    behind = np.flatnonzero((of_point >= 0) & ~states.on_wall & (states.above < 0))
    order = behind[np.argsort(of_point[behind], kind="stable")]
    starts = np.searchsorted(of_point[order], np.arange(len(regions) + 1))
    heights = _heights(states)
    return [
        _filled(states, region, wall, heights, order[start:stop], settings)
        for region, start, stop in zip(regions, starts[:-1], starts[1:])
    ]


def _heights(states: States) -> np.ndarray:
    """Return how far the points of the wall in each pixel are in front of its layer; nan where none are."""
    cells, above = states.cells[states.on_wall], states.above[states.on_wall]
    counts = np.bincount(cells, minlength=states.image.size)
    sums = np.bincount(cells, above, minlength=states.image.size)
    means = np.full(states.image.size, np.nan)
    np.divide(sums, counts, out=means, where=counts > 0)
    return means.reshape(states.grid.shape)


def _filled(
    states: States,
    region: Region,
    wall: np.ndarray,
    heights: np.ndarray,
    inside: np.ndarray,
    settings: ContentSettings,
) -> Opening:
    above = states.above[inside]
    near = above > -settings.near_m
    covered = len(np.unique(states.cells[inside[near]])) / max(int(region.image.sum()), 1)
    kind = RECESS if covered >= settings.filled else OPENING
    chosen = above[near] if kind == RECESS else above
    depth = float(np.median(chosen)) if len(chosen) else float("nan")
    sides = open_sides(region, states, wall)
    layer = int(np.bincount(states.nearest[region.box][region.image]).argmax())
    height = region.image.shape[0] * states.grid.size
    use = WINDOW
    grounded = sides[BELOW] or _is_grounded(region, states, wall, settings)
    if grounded and height >= settings.lowest_door_m:
        use = DOOR if kind == RECESS else PASSAGE
    named = tuple(name for name, is_open in zip(SIDES, sides) if is_open)
    polygon = region_polygon(region, states)
    bent = _bent_sides(region, heights, depth, states.grid.size, settings)
    return Opening(region, polygon, kind, use, depth, layer, named, inside, bent)


def _is_grounded(region: Region, states: States, wall: np.ndarray, settings: ContentSettings) -> bool:
    """Whether a region begins at the ground or, where none was seen, at the end of the wall.

    The wall below a window may be hidden, or not a part of the cloud, down to any height.
    """
    rows, columns = region.box
    bottom = states.grid.edges(region.box)[1]
    away = float(np.median(np.abs(bottom - states.ground[columns])))
    if np.isfinite(away):
        return away <= settings.step_m
    below = float(np.median(wall[: rows.start, columns].sum(axis=0)))
    # The lowest pixel of a region is mixed.
    return (below - 1) * states.grid.size <= settings.threshold_m


def _bent_sides(
    region: Region, heights: np.ndarray, depth: float, size: float, settings: ContentSettings
) -> int:
    """Return on how many sides the wall beside a region is nearly as deep as what is seen in it."""
    (bottom, top), (left, right) = ((side.start, side.stop) for side in region.box)
    rows, columns = region.box
    # The pixels at the edge are mixed.
    next_to = 1
    reach = next_to + max(round(settings.beside_m / size), 1)
    strips = (
        heights[rows, max(left - reach, 0) : max(left - next_to, 0)],
        heights[rows, right + next_to : right + reach],
        heights[max(bottom - reach, 0) : max(bottom - next_to, 0), columns],
        heights[top + next_to : top + reach, columns],
    )
    seen = [strip[np.isfinite(strip)] for strip in strips]
    return sum(bool(len(strip) and np.median(strip) < settings.bend * depth) for strip in seen)


def region_polygon(region: Region, states: States) -> Polygon:
    """Return the largest part of a region, in u and v, with half a pixel around it.

    Pixels that hold points of the wall as well as of the opening count as wall.
    """
    size = states.grid.size
    left, bottom, _, _ = states.grid.edges(region.box)
    transform = Affine(size, 0, left, 0, size, bottom)
    image = region.image.astype(np.uint8)
    parts = [shape(part) for part, value in shapes(image, transform=transform) if value]
    largest = max(parts, key=lambda part: part.area)
    return Polygon(largest.exterior).buffer(0.5 * size, join_style=2)
