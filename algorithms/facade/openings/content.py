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
    """

    region: Region
    polygon: Polygon
    kind: str
    use: str
    depth: float
    layer: int
    open_sides: tuple[str, ...]
    inside: np.ndarray


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
    return [
        _filled(states, region, wall, order[start:stop], settings)
        for region, start, stop in zip(regions, starts[:-1], starts[1:])
    ]


def _filled(
    states: States, region: Region, wall: np.ndarray, inside: np.ndarray, settings: ContentSettings
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
    if sides[BELOW] and height >= settings.lowest_door_m:
        use = DOOR if kind == RECESS else PASSAGE
    named = tuple(name for name, is_open in zip(SIDES, sides) if is_open)
    polygon = region_polygon(region, states)
    return Opening(region, polygon, kind, use, depth, layer, named, inside)


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
