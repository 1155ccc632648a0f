"""Where a storey lies under a roof."""

import numpy as np
from affine import Affine
from rasterio.features import shapes
from scipy import ndimage
from shapely.geometry import Polygon, shape
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

from .footprint import Footprint
from .settings import RoofSettings


def roofed(footprint: Footprint, settings: RoofSettings = RoofSettings()) -> BaseGeometry:
    """Return the area over which a ceiling was seen, with the gaps in it closed; Polygon or MultiPolygon."""
    frame = footprint.frame
    block = max(round(settings.cell_m / frame.pixel_m), 1)
    seen = _any_in_blocks(np.isfinite(footprint.ceiling), block)
    rounds = max(round(settings.closed_m / settings.cell_m / 2), 1)
    # On a slope the higher ground lies as high as a ceiling, but over no floor.
    floor = _any_in_blocks(np.isfinite(footprint.floor), block)
    seen &= ndimage.binary_dilation(floor, iterations=rounds)
    padded = np.pad(seen, rounds)
    closed = ndimage.binary_closing(padded, iterations=rounds)[rounds:-rounds, rounds:-rounds]
    edge = block * frame.pixel_m
    grid = Affine(edge, 0.0, frame.left, 0.0, edge, frame.bottom)
    parts = [shape(geometry) for geometry, _ in shapes(closed.astype(np.uint8), mask=closed, transform=grid)]
    return unary_union([part for part in parts if part.area >= settings.smallest_m2] or [Polygon()])


def _any_in_blocks(mask: np.ndarray, block: int) -> np.ndarray:
    """Return whether any pixel is set in square blocks of pixels."""
    rows, columns = (-(-size // block) * block for size in mask.shape)
    padded = np.zeros((rows, columns), bool)
    padded[: mask.shape[0], : mask.shape[1]] = mask
    return padded.reshape(rows // block, block, columns // block, block).any(axis=(1, 3))
