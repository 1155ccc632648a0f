"""Where a storey lies under a roof."""

from dataclasses import replace

import numpy as np
from affine import Affine
from rasterio.features import shapes
from scipy import ndimage
from shapely.geometry import Polygon, shape
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

from ..settings import LevelSettings, RoofSettings
from .footprint import Footprint
from .levels import Storey
from .voxels import Voxels


def roofed(footprint: Footprint, settings: RoofSettings = RoofSettings()) -> BaseGeometry:
    """Return the area over which a ceiling was seen, with the gaps in it closed; Polygon or MultiPolygon."""
    frame = footprint.frame
    block = max(round(settings.cell_m / frame.pixel_m), 1)
    seen = _any_in_blocks(np.isfinite(footprint.ceiling), block)
    # On a slope the higher ground lies as high as a ceiling, but over no floor.
    floor = _any_in_blocks(np.isfinite(footprint.floor), block)
    rounds = max(round(settings.closed_m / settings.cell_m / 2), 1)
    closed = _closed(seen & ndimage.binary_dilation(floor, iterations=rounds), settings)
    edge = block * frame.pixel_m
    grid = Affine(edge, 0.0, frame.left, 0.0, edge, frame.bottom)
    parts = [shape(geometry) for geometry, _ in shapes(closed.astype(np.uint8), mask=closed, transform=grid)]
    return unary_union([part for part in parts if part.area >= settings.smallest_m2] or [Polygon()])


def near_roof(
    voxels: Voxels,
    storey: Storey,
    levels: LevelSettings = LevelSettings(),
    settings: RoofSettings = RoofSettings(),
) -> Voxels:
    """Return the voxels under the ceiling of a storey and a little around it, without the street outside."""
    high = voxels.xyz[:, 2] > storey.floor + levels.lowest_storey_m
    high &= np.abs(voxels.normal[:, 2]) > levels.flat
    cell = np.floor(voxels.xyz[:, :2] / settings.cell_m).astype(np.int64)
    rounds = round(settings.around_m / settings.cell_m)
    cell -= cell.min(axis=0) - rounds
    seen = np.zeros(cell.max(axis=0) + 1 + rounds, bool)
    seen[tuple(cell[high].T)] = True
    closed = _closed(seen, settings)
    parts, _ = ndimage.label(closed)
    area = np.bincount(parts.ravel()) * settings.cell_m**2
    large = closed & (area >= settings.smallest_m2)[parts]
    near = ndimage.binary_dilation(large, iterations=rounds)[tuple(cell.T)]
    return replace(voxels, xyz=voxels.xyz[near], normal=voxels.normal[near])


def _closed(seen: np.ndarray, settings: RoofSettings) -> np.ndarray:
    """Return cells with the gaps between them closed."""
    rounds = max(round(settings.closed_m / settings.cell_m / 2), 1)
    padded = np.pad(seen, rounds)
    return ndimage.binary_closing(padded, iterations=rounds)[rounds:-rounds, rounds:-rounds]


def _any_in_blocks(mask: np.ndarray, block: int) -> np.ndarray:
    """Return whether any pixel is set in square blocks of pixels."""
    rows, columns = (-(-size // block) * block for size in mask.shape)
    padded = np.zeros((rows, columns), bool)
    padded[: mask.shape[0], : mask.shape[1]] = mask
    return padded.reshape(rows // block, block, columns // block, block).any(axis=(1, 3))
