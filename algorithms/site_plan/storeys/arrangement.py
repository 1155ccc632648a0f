"""The cells that the lines of the sheets and the outline of the footprint divide a storey into."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from rasterio.features import rasterize, shapes
from scipy import ndimage
from shapely.geometry import LineString, box, shape
from shapely.affinity import affine_transform
from shapely.ops import linemerge, polygonize, unary_union

from .footprint import Footprint
from .levels import Frame
from .settings import CutSettings

OUTSIDE = -1
"""Number of the cell beyond the frame."""


@dataclass(frozen=True)
class Arrangement:
    """Cells and the borders between them.

    Attributes
    ----------
    cells : list of Polygon
    ends : ndarray of float64, shape (n, 4)
        Borders: x, y of both ends, metres.
    sides : ndarray of int, shape (n, 2)
        The cells to the left and to the right of each border; `OUTSIDE` beyond the frame.
    """

    cells: list
    ends: np.ndarray
    sides: np.ndarray

    @property
    def lengths(self) -> np.ndarray:
        """Lengths of the borders, metres."""
        return np.hypot(self.ends[:, 2] - self.ends[:, 0], self.ends[:, 3] - self.ends[:, 1])


def arrange(lines: Iterable, frame: Frame) -> Arrangement:
    """Divide a frame by lines.

    Parameters
    ----------
    lines : iterable of LineString
    frame : Frame
    """
    height, width = (count * frame.pixel_m for count in frame.shape)
    rim = box(frame.left, frame.bottom, frame.left + width, frame.bottom + height)
    cells = list(polygonize(unary_union([rim.exterior, *(line.intersection(rim) for line in lines)])))
    starts, stops, owner = [], [], []
    for number, cell in enumerate(cells):
        for ring in (cell.exterior, *cell.interiors):
            corners = np.asarray(ring.coords)
            # Exterior rings run one way and interior rings the other in one polygon.
            if _is_clockwise(corners) == (ring is cell.exterior):
                corners = corners[::-1]
            starts.append(corners[:-1])
            stops.append(corners[1:])
            owner.append(np.full(len(corners) - 1, number))
    return _paired(cells, np.hstack([np.concatenate(starts), np.concatenate(stops)]), np.concatenate(owner))


def _is_clockwise(corners: np.ndarray) -> bool:
    x, y = corners.T
    return float(np.dot(x[:-1], y[1:]) - np.dot(x[1:], y[:-1])) < 0.0


def _paired(cells: list, edges: np.ndarray, owner: np.ndarray) -> Arrangement:
    """Join the two edges of two cells that run the same way in opposite directions."""
    forward = (edges[:, 0] < edges[:, 2]) | ((edges[:, 0] == edges[:, 2]) & (edges[:, 1] < edges[:, 3]))
    ends = np.where(forward[:, None], edges, edges[:, [2, 3, 0, 1]])
    ends, number = np.unique(ends, axis=0, return_inverse=True)
    sides = np.full((len(ends), 2), OUTSIDE)
    sides[number.ravel(), np.where(forward, 0, 1)] = owner
    return Arrangement(cells, ends, sides)


def sheet_lines(sheets: Iterable, extension: float) -> list:
    """Return the sheets as lines that go on beyond their ends, metres."""
    return [
        LineString([sheet.start - extension * sheet.direction, sheet.stop + extension * sheet.direction])
        for sheet in sheets
    ]


def footprint_lines(footprint: Footprint, sheets: list, settings: CutSettings) -> list:
    """Return the outline of what was seen, straightened, where no sheet runs beside it."""
    frame = footprint.frame
    unknown = np.isnan(footprint.weight)
    nearest = ndimage.distance_transform_edt(unknown, return_distances=False, return_indices=True)
    seen = footprint.weight[tuple(nearest)] >= 0.5
    seen = ndimage.binary_opening(seen)
    near = unary_union(sheet_lines(sheets, settings.beside_outline_m)).buffer(settings.beside_outline_m)
    lines = []
    for geometry, _ in shapes(seen.astype(np.uint8), mask=seen, connectivity=4):
        outline = affine_transform(shape(geometry), [frame.pixel_m, 0, 0, frame.pixel_m, frame.left, frame.bottom])
        if outline.area < settings.smallest_outline_m2:
            continue
        for ring in (outline.exterior, *outline.interiors):
            rest = ring.simplify(settings.outline_m).difference(near)
            rest = linemerge(rest) if rest.geom_type == "MultiLineString" else rest
            lines += [_extended(part, 2 * settings.beside_outline_m) for part in getattr(rest, "geoms", [rest])]
    return [line for line in lines if line.length > 0]


def _extended(line: LineString, extension: float) -> LineString:
    """Return an open line that goes on straight at both ends."""
    if line.is_empty or line.is_ring:
        return LineString(line.coords) if not line.is_empty else line
    corners = np.asarray(line.coords)
    first, last = corners[0] - corners[1], corners[-1] - corners[-2]
    start = corners[0] + extension * first / np.hypot(*first)
    stop = corners[-1] + extension * last / np.hypot(*last)
    return LineString([start, *corners, stop])


def seen_and_unseen(arrangement: Arrangement, footprint: Footprint) -> tuple:
    """Return how much of each cell was seen and was not seen as room, m2; shape (cells,) each."""
    frame, fine = footprint.frame, 2
    shape_ = tuple(fine * count for count in frame.shape)
    pixel = frame.pixel_m / fine
    transform = (pixel, 0.0, frame.left, 0.0, pixel, frame.bottom)
    label = rasterize(
        ((cell, number) for number, cell in enumerate(arrangement.cells, start=1)),
        shape_,
        transform=_affine(transform),
        dtype="int32",
    )
    weight = footprint.weight.repeat(fine, axis=0).repeat(fine, axis=1)
    count = len(arrangement.cells) + 1
    total = np.bincount(label.ravel(), minlength=count)[1:]
    known = np.isfinite(weight)
    certain = np.bincount(label[known], minlength=count)[1:]
    seen = np.bincount(label[known], weight[known], count)[1:]
    area = np.array([cell.area for cell in arrangement.cells]) / np.maximum(total, 1)
    return seen * area, (certain - seen) * area


def _affine(coefficients: tuple):
    from affine import Affine

    return Affine(*coefficients)
