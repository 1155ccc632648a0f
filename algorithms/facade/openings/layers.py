"""The layers of a facade: its main wall, and parallel parts of it in front and behind."""

from dataclasses import dataclass

import numpy as np
from scipy import ndimage
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from ..planes.voxels import make_voxels
from .grid import Grid, beyond
from .settings import LayerSettings, SurfaceSettings
from .spacings import closed_wall
from .wall_surface import WallSurface, fit_surface

SQUARE = np.ones((3, 3), bool)


@dataclass(frozen=True)
class Layer:
    """A part of a facade.

    Attributes
    ----------
    surface : WallSurface
    depth : float
        Median distance in front of the main wall; negative behind it, 0 for itself (m).
    image : ndarray of bool, shape (rows, columns)
        The pixels with points of it.
    """

    surface: WallSurface
    depth: float
    image: np.ndarray


def find_layers(
    uvw: np.ndarray,
    main: WallSurface,
    grid: Grid,
    cells: np.ndarray,
    spacings: np.ndarray,
    limits: tuple[LayerSettings, SurfaceSettings] = (LayerSettings(), SurfaceSettings()),
) -> list[Layer]:
    """Return the layers of a facade, the main wall first, then by falling area.

    Parts count where the main wall is not seen, unless a part before them, such as the main wall, is on both
    sides of them and above or below, as it encloses what is seen in an opening.

    Parameters
    ----------
    uvw : ndarray of float64, shape (n, 3)
        Of all points.
    main : WallSurface
    grid : Grid
    cells : ndarray of int64, shape (n,)
        The pixel of each point.
    spacings : ndarray of float64, shape (rows, columns)
        Of the points of the main wall around each pixel (m).
    limits : tuple of LayerSettings and SurfaceSettings
    """
    settings, _ = limits
    above = main.above(uvw)
    wall = grid.holds(cells[np.abs(above) <= main.tolerance])
    layers = [Layer(main, 0.0, wall)]
    solids = [_solid(wall, spacings, grid, settings)]
    near = (cells >= 0) & (above < settings.before_m) & (above > -settings.behind_m)
    rows = np.flatnonzero(near & (np.abs(above) > main.tolerance))
    for part in _flat_parts(np.column_stack([uvw[rows, :2], above[rows]]), settings):
        layer = _layer(uvw, rows[part], main, grid, cells, limits)
        if layer is None or _is_covered(layer, wall, settings):
            continue
        # What is seen through the openings of a bay or a neighbour has that part of the wall around it.
        before = [solid for other, solid in zip(layers, solids) if other.depth > layer.depth]
        if not _is_enclosed(layer, before, settings):
            layers.append(layer)
            solids.append(_solid(layer.image, spacings, grid, settings))
    return layers


def _flat_parts(uvw: np.ndarray, settings: LayerSettings) -> list[np.ndarray]:
    """Return the points of each connected surface that faces as the wall does, the largest first."""
    if len(uvw) < settings.smallest_m2 / settings.cube_m**2:
        return []
    voxels = make_voxels(uvw, settings.cube_m)
    flat = np.flatnonzero(np.abs(voxels.normals[:, 2]) >= settings.cosine)
    if not len(flat):
        return []
    stretch = np.array([1.0, 1.0, settings.reach_cubes / settings.step]) / voxels.size
    pairs = cKDTree(voxels.centres[flat] * stretch).query_pairs(settings.reach_cubes, output_type="ndarray")
    links = coo_matrix((np.ones(len(pairs)), tuple(pairs.T)), shape=(len(flat), len(flat)))
    _, parts = connected_components(links, directed=False)
    areas = np.bincount(parts) * voxels.size**2
    of_cube = np.full(len(voxels.centres), -1)
    of_cube[flat] = parts
    of_point = of_cube[voxels.of_point]
    large = np.flatnonzero(areas >= settings.smallest_m2)
    return [np.flatnonzero(of_point == part) for part in large[np.argsort(-areas[large], kind="stable")]]


def _layer(
    uvw: np.ndarray,
    rows: np.ndarray,
    main: WallSurface,
    grid: Grid,
    cells: np.ndarray,
    limits: tuple[LayerSettings, SurfaceSettings],
) -> "Layer | None":
    settings, surfaces = limits
    offset = float(np.median(main.above(uvw[rows])))
    surface = fit_surface(uvw[rows], 2 * main.tolerance, surfaces)
    slopes = surface.coefficients[1:3] - main.coefficients[1:3]
    if np.hypot(*slopes) > settings.steepest:
        return None
    own = rows[np.abs(surface.above(uvw[rows])) <= surface.tolerance]
    image = grid.holds(cells[own])
    if image.sum() * grid.size**2 < 0.5 * settings.smallest_m2:
        return None
    return Layer(surface, offset, image)


def _solid(wall: np.ndarray, spacings: np.ndarray, grid: Grid, settings: LayerSettings) -> np.ndarray:
    """Return the large parts of a wall without gaps, because strips and specks of it enclose nothing."""
    closed = closed_wall(ndimage.binary_closing(wall, SQUARE), spacings, grid.size)
    pieces, _ = ndimage.label(ndimage.binary_opening(closed, SQUARE))
    sizes = np.bincount(pieces.ravel())
    sizes[0] = 0
    return np.asarray((sizes >= settings.piece * sizes.max())[pieces] & (pieces > 0))


def _is_covered(layer: Layer, wall: np.ndarray, settings: LayerSettings) -> bool:
    """Whether the main wall is seen where a surface is, so that the surface is not a part of the facade."""
    closed = ndimage.binary_closing(wall, SQUARE)
    return bool((layer.image & closed).sum() > settings.covered * layer.image.sum())


def _is_enclosed(layer: Layer, before: list[np.ndarray], settings: LayerSettings) -> bool:
    """Whether a surface was seen through an opening of the parts before it."""
    if not before:
        return False
    left, right, below, above = beyond(np.logical_or.reduce(before))
    around = left & right & (below | above)
    return bool((layer.image & around).sum() > settings.enclosed * layer.image.sum())
