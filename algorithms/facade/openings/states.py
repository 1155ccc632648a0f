"""What is seen in each pixel of an elevation: the wall, something behind it or in front, or nothing."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from scipy import ndimage

from ..planes.inner_face import Face
from .grid import ABOVE, BELOW, LEFT, RIGHT, Grid, beyond, first_seen, grid_over
from .layers import Layer, find_layers
from .settings import OpeningSettings, StateSettings
from .spacings import local_spacings
from .wall_surface import fit_surface

EMPTY, WALL, BEHIND, FRONT, INNER = range(5)


@dataclass(frozen=True)
class States:
    """A facade in pixels.

    Attributes
    ----------
    grid : Grid
    image : ndarray of uint8, shape (rows, columns)
        `EMPTY`, `WALL`, `BEHIND`, `FRONT` or `INNER`, its inner face.
    layers : tuple of Layer
        The main wall first.
    nearest : ndarray of int16, shape (rows, columns)
        The layer of each pixel, or the nearest one.
    cells : ndarray of int64, shape (n,)
        The pixel of each point; -1 outside.
    above : ndarray of float64, shape (n,)
        How far each point is in front of the layer of its pixel (m).
    on_wall : ndarray of bool, shape (n,)
    reveals : ndarray of bool, shape (rows, columns)
        The pixels with points close behind the wall, as on jambs.
    spacings : ndarray of float64, shape (rows, columns)
        Of the points of the wall around each pixel (m).
    ground : ndarray of float64, shape (columns,)
        Height of the lowest point close before the wall, beyond its sills (m); infinite where none was seen.
    """

    grid: Grid
    image: np.ndarray
    layers: tuple[Layer, ...]
    nearest: np.ndarray
    cells: np.ndarray
    above: np.ndarray
    on_wall: np.ndarray
    reveals: np.ndarray
    spacings: np.ndarray
    ground: np.ndarray


def make_states(
    uvw: np.ndarray,
    wall: np.ndarray,
    distance: float,
    inner: Optional[Face] = None,
    settings: OpeningSettings = OpeningSettings(),
) -> States:
    """Return what is seen in each pixel of a facade.

    Parameters
    ----------
    uvw : ndarray of float64, shape (n, 3)
        Of all points, w towards the viewer.
    wall : ndarray of bool, shape (n,)
        The points of the main plane.
    distance : float
        ds of the paper: no point of the wall is farther from its surface (m).
    inner : Face, optional
        The inner face of the wall, if it was seen.
    settings : OpeningSettings
    """
    limits = settings.states
    size = max(limits.pixel_spacings * _spacing(uvw[wall, :2], settings), limits.finest_m)
    grid = grid_over(_extent(uvw, wall, settings), size, limits.most_pixels)
    cells = grid.cells(uvw[:, :2])
    main = fit_surface(uvw[wall], distance, settings.surface)
    of_main = local_spacings(cells[wall], grid, limits)
    layers = find_layers(uvw, main, grid, cells, of_main, (settings.layers, settings.surface))
    nearest = _nearest(layers, settings)
    of_point = np.where(cells >= 0, nearest.ravel()[np.maximum(cells, 0)], 0)
    above, tolerance = np.empty(len(uvw)), np.empty(len(uvw))
    for number, layer in enumerate(layers):
        own = of_point == number
        above[own], tolerance[own] = layer.surface.above(uvw[own]), layer.surface.tolerance
    inside = cells >= 0
    on_wall = inside & (np.abs(above) <= tolerance)
    behind = inside & (above < -tolerance) & (above > -limits.farthest_m)
    front = inside & (above > tolerance) & (above < limits.before_m)
    image = np.zeros(grid.shape, np.uint8)
    for state, points in ((FRONT, front), (BEHIND, behind), (WALL, on_wall)):
        image[grid.holds(cells[points])] = state
    attached = inside & (above > tolerance) & (above <= limits.sill_m)
    image[_sills(grid.holds(cells[attached]), image, grid.size, limits) & (image == BEHIND)] = FRONT
    if inner is not None:
        own = inside & (np.abs(-uvw[:, 2] - inner.offset) <= distance)
        image[grid.holds(cells[own]) & (image != WALL)] = INNER
    deepest = limits.jamb_m if inner is None else min(limits.jamb_m, inner.offset - distance)
    reveals = grid.holds(cells[behind & (above > -deepest)])
    spacings = local_spacings(cells[on_wall], grid, limits)
    ground = _ground(uvw, grid, limits)
    return States(grid, image, tuple(layers), nearest, cells, above, on_wall, reveals, spacings, ground)


def _extent(uvw: np.ndarray, wall: np.ndarray, settings: OpeningSettings) -> np.ndarray:
    """Return the lower left and the upper right corner of a facade, shape (2, 2).

    Its main wall says where it begins and ends; storeys that are set back may rise above it.
    """
    low, high = uvw[wall, :2].min(axis=0), uvw[wall, :2].max(axis=0)
    u, v, w = uvw.T
    above = (u > low[0]) & (u < high[0]) & (v > high[1])
    above &= (w < settings.layers.before_m) & (w > -settings.layers.behind_m)
    if above.any():
        high[1] = max(high[1], float(np.percentile(v[above], settings.states.highest_percent)))
    return np.stack([low, high])


def _spacing(uv: np.ndarray, settings: OpeningSettings) -> float:
    """Return the usual spacing of the points of a wall (m)."""
    side = settings.states.square_m
    squares = np.floor(uv / side).astype(np.int64)
    columns, rows = (squares - squares.min(axis=0)).T
    counts = np.unique(rows * (columns.max() + 1) + columns, return_counts=True)[1]
    # Squares at the border of the wall are not full.
    full = counts[counts >= settings.states.fullest * np.median(counts)]
    return float(side / np.sqrt(np.median(full)))


def _ground(uvw: np.ndarray, grid: Grid, limits: StateSettings) -> np.ndarray:
    """Return the height of the lowest point close before the wall in each column; infinite where none is."""
    near, far = limits.ground_m
    close = uvw[(uvw[:, 2] > near) & (uvw[:, 2] <= far)]
    columns = np.floor((close[:, 0] - grid.corner[0]) / grid.size).astype(np.int64)
    inside = (columns >= 0) & (columns < grid.shape[1])
    lowest = np.full(grid.shape[1], np.inf)
    np.minimum.at(lowest, columns[inside], close[inside, 1])
    return lowest


def _sills(attached: np.ndarray, image: np.ndarray, size: float, limits: StateSettings) -> np.ndarray:
    """Return the pixels of sills: solid strips on the wall below a hole, which reach beyond both its jambs.

    What is behind them was seen from inside the building. Shutters and boxes of flowers in front of a hole
    hide it, and do not bound it; nor do the bars of a railing.
    """
    bar, highest, gap = (
        max(round(length / size), 2) for length in (limits.bar_m, limits.sill_height_m, limits.sill_gap_m)
    )
    solid = ndimage.binary_opening(attached, np.ones((bar, bar)))
    # At its ends a sill may be as low as a pixel.
    solid |= attached & ndimage.binary_dilation(solid, np.ones((1, 3)))
    solid = ndimage.binary_closing(solid, np.ones((bar + 1, gap + 1)))
    strips = solid & ~ndimage.binary_opening(solid, np.ones((highest + 1, 1)))
    behind = image == BEHIND
    # The pixels in the corners between sill and jamb are mixed.
    behind &= ~(ndimage.binary_dilation(image == WALL) & ndimage.binary_dilation(strips, np.ones((5, 1))))
    wall = first_seen(~strips & ((image == WALL) | behind), image == WALL)
    beyond_jambs = strips & wall[ABOVE] & wall[BELOW] & (wall[LEFT] | wall[RIGHT])
    held = first_seen(~strips | beyond_jambs, beyond_jambs)
    return strips & wall[BELOW] & held[LEFT] & held[RIGHT]


def _nearest(layers: list[Layer], settings: OpeningSettings) -> np.ndarray:
    if len(layers) == 1:
        return np.zeros(layers[0].image.shape, np.int16)
    numbers = np.zeros(layers[0].image.shape, np.int16)
    for number, layer in enumerate(layers, start=1):
        numbers[layer.image & (numbers == 0)] = number
    for number, layer in enumerate(layers, start=1):
        if layer.depth >= settings.layers.bay_m:
            # What is seen in the windows of a bay may be as deep as the main wall.
            inside = beyond(ndimage.binary_closing(layer.image, np.ones((3, 3)))).all(axis=0)
            numbers[inside & (numbers == 1)] = number
    nearest = ndimage.distance_transform_edt(numbers == 0, return_distances=False, return_indices=True)
    return numbers[tuple(nearest)] - 1
