"""Wall pixels as polygons (section 2.2, last paragraph)."""

import numpy as np
from affine import Affine
from rasterio.features import shapes
from scipy import ndimage
from shapely.geometry import Polygon, shape
from shapely.prepared import prep

from .settings import OutlineSettings


def label_walls(walls: np.ndarray) -> np.ndarray:
    """Give the walls the numbers 1, 2, ...; pixels connect over edges; int32, shape (rows, columns)."""
    return ndimage.label(walls)[0].astype(np.int32)


def trace_outlines(
    labels: np.ndarray, transform: Affine, settings: OutlineSettings = OutlineSettings()
) -> dict[int, Polygon]:
    """Trace the pixel edges of each wall and straighten their steps.

    A step is straightened as long as the polygons stay valid and do not overlap.

    Parameters
    ----------
    labels : ndarray of int32, shape (rows, columns)
        0 outside walls.
    transform : Affine
        From (column, row) to world coordinates.
    settings : OutlineSettings

    Returns
    -------
    dict of int to shapely Polygon
    """
    # Traced about the raster's corner: large coordinates would cost the straightening its digits.
    size = transform.a
    local = Affine(size, 0, 0, 0, -size, 0)
    traced = shapes(labels, mask=labels > 0, connectivity=4, transform=local)
    raw = {int(value): shape(outline) for outline, value in traced}
    corner = transform.c, transform.f
    outlines = {}
    for i, polygon in raw.items():
        plain = _straightened(polygon, size, settings)
        # The rounding of large coordinates may spoil a narrow outline.
        outlines[i] = plain if _sound(plain) and _moved(plain, *corner).is_valid else polygon
    outlines = _without_overlaps(outlines, raw)
    return {i: _moved(outlines[i], *corner) for i in sorted(outlines)}


def _straightened(polygon: Polygon, size: float, settings: OutlineSettings) -> Polygon:
    shortest = (settings.corner_px - 0.5) * size
    outer, *holes = (
        _middles(np.asarray(ring.coords)[:-1], shortest) for ring in (polygon.exterior, *polygon.interiors)
    )
    return Polygon(outer, holes).simplify(settings.tolerance_px * size)


def _middles(corners: np.ndarray, shortest: float) -> np.ndarray:
    """Replace the steps of a ring by the middles of their sides, but keep corners between longer sides.

    The outer corners of the steps would lie outside the wall by up to 0.7 pixels, the inner ones
    inside; the middles are unbiased.
    """
    sides = np.roll(corners, -1, axis=0) - corners
    long = np.abs(sides).sum(axis=1) >= shortest
    real = long & np.roll(long, 1)
    points = np.empty((2 * len(corners), 2))
    points[::2], points[1::2] = corners, corners + sides / 2
    wanted = np.empty(len(points), bool)
    wanted[::2], wanted[1::2] = real, ~(real & np.roll(real, -1))
    return points[wanted]


def _without_overlaps(plain: dict[int, Polygon], raw: dict[int, Polygon]) -> dict[int, Polygon]:
    """Take the raw outline wherever the straightened ones would overlap."""
    chosen = dict(plain)
    while True:
        clashing = {i for pair in overlaps(chosen) for i in pair if chosen[i] is not raw[i]}
        if not clashing:
            return chosen
        chosen.update({i: raw[i] for i in clashing})


def _sound(polygon: Polygon) -> bool:
    return polygon.is_valid and polygon.geom_type == "Polygon" and polygon.area > 0


def overlaps(polygons: dict[int, Polygon]) -> list[tuple[int, int]]:
    """Return the pairs of numbers of polygons whose interiors meet."""
    numbers, geometries = list(polygons), list(polygons.values())
    # Boxes come first: shapely 1.8 and 2 answer the query of a tree differently.
    boxes = np.array([geometry.bounds for geometry in geometries]).reshape(-1, 4)
    order = np.argsort(boxes[:, 0])
    pairs = []
    for rank, i in enumerate(order):
        prepared = prep(geometries[i])
        for j in order[rank + 1 :]:
            if boxes[j, 0] > boxes[i, 2]:
                break
            apart = boxes[j, 1] > boxes[i, 3] or boxes[i, 1] > boxes[j, 3]
            if apart or not prepared.intersects(geometries[j]):
                continue
            if geometries[i].intersection(geometries[j]).area > 0:
                pairs.append((numbers[i], numbers[j]))
    return pairs


def _moved(polygon: Polygon, x: float, y: float) -> Polygon:
    rings = [np.add(ring.coords, (x, y)) for ring in (polygon.exterior, *polygon.interiors)]
    return Polygon(rings[0], rings[1:])
