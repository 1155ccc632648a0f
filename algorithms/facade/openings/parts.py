"""The outlines of the parallel parts of a facade, such as storeys that are set back."""

import numpy as np
from rasterio.features import shapes
from rasterio.transform import Affine
from scipy import ndimage
from shapely.geometry import Polygon, shape

from .layers import SQUARE, Layer
from .spacings import closed_wall
from .states import States


def part_outlines(states: States) -> list[Polygon]:
    """Return the outlines of all parts of a facade but its main wall, in u and v, without their holes."""
    return [outline for layer in states.layers[1:] for outline in _outlines(layer, states)]


def _outlines(layer: Layer, states: States) -> list[Polygon]:
    size = states.grid.size
    left, bottom = states.grid.corner
    closed = closed_wall(ndimage.binary_closing(layer.image, SQUARE), states.spacings, size)
    image = ndimage.binary_opening(closed, SQUARE).astype(np.uint8)
    traced = shapes(image, transform=Affine(size, 0, left, 0, size, bottom))
    # The corners of pixels are not corners of the wall.
    return [Polygon(shape(part).exterior).simplify(size) for part, value in traced if value]
