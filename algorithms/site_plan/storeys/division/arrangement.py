"""The cells that the lines of the sheets and the outline of the footprint divide a storey into."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from affine import Affine
from rasterio.features import rasterize, shapes
from scipy import ndimage
from shapely.affinity import affine_transform
from shapely.geometry import LineString, Polygon, box, shape
from shapely.geometry.polygon import orient
from shapely.ops import polygonize, unary_union

from ..evidence.footprint import Footprint
from ..evidence.levels import Frame
from ..evidence.sheets import Sheet
from ..settings import CutSettings

OUTSIDE = -1
"""Number of the cell beyond the frame."""

ON_LINE = 1e-4
"""A border lies on a line if both its ends are so near to it, metres."""


@dataclass(frozen=True)
class Arrangement:
    """Cells and the borders between them.

    Attributes
    ----------
    cells : tuple of Polygon
    ends : ndarray of float64, shape (n, 4)
        Borders: x, y of both ends, metres.
    sides : ndarray of int, shape (n, 2)
        The cells to the left and to the right of each border; `OUTSIDE` beyond the frame.
    """

    cells: tuple[Polygon, ...]
    ends: np.ndarray
    sides: np.ndarray

    @property
    def lengths(self) -> np.ndarray:
        """Lengths of the borders, metres."""
        return np.hypot(self.ends[:, 2] - self.ends[:, 0], self.ends[:, 3] - self.ends[:, 1])


def arrange(lines: Iterable[LineString], frame: Frame) -> Arrangement:
    """Divide a frame by lines.

    Parameters
    ----------
    lines : iterable of LineString
    frame : Frame
    """
    height, width = (count * frame.pixel_m for count in frame.shape)
    rim = box(frame.left, frame.bottom, frame.left + width, frame.bottom + height)
    cells = tuple(polygonize(unary_union([rim.exterior, *(line.intersection(rim) for line in lines)])))
    starts, stops, owner = [], [], []
    for number, cell in enumerate(cells):
        # The cell lies to the left of all its rings.
        cell = orient(cell)
        for ring in (cell.exterior, *cell.interiors):
            corners = np.asarray(ring.coords)
            starts.append(corners[:-1])
            stops.append(corners[1:])
            owner.append(np.full(len(corners) - 1, number))
    return _paired(cells, np.hstack([np.concatenate(starts), np.concatenate(stops)]), np.concatenate(owner))


def _paired(cells: tuple[Polygon, ...], edges: np.ndarray, owner: np.ndarray) -> Arrangement:
    """Join the two edges of two cells that run the same way in opposite directions."""
    forward = (edges[:, 0] < edges[:, 2]) | ((edges[:, 0] == edges[:, 2]) & (edges[:, 1] < edges[:, 3]))
    ends = np.where(forward[:, None], edges, edges[:, [2, 3, 0, 1]])
    ends, number = np.unique(ends, axis=0, return_inverse=True)
    sides = np.full((len(ends), 2), OUTSIDE)
    sides[number.ravel(), np.where(forward, 0, 1)] = owner
    return Arrangement(cells, ends, sides)


def sheet_lines(sheets: Iterable[Sheet], settings: CutSettings) -> list[LineString]:
    """Return the sheets as lines that extend beyond their ends, short ones less far."""
    lines = []
    for sheet in sheets:
        beyond = min(settings.extension_m, settings.extension_lengths * sheet.length) * sheet.direction
        lines.append(LineString([sheet.start - beyond, sheet.stop + beyond]))
    return lines


def footprint_lines(footprint: Footprint, settings: CutSettings) -> list[LineString]:
    """Return the outline of what was seen, straightened."""
    frame = footprint.frame
    unknown = np.isnan(footprint.weight)
    nearest = ndimage.distance_transform_edt(unknown, return_distances=False, return_indices=True)
    seen = footprint.weight[tuple(nearest)] >= settings.outline_weight
    seen = ndimage.binary_opening(seen)
    lines: list[LineString] = []
    for geometry, _ in shapes(seen.astype(np.uint8), mask=seen, connectivity=4):
        outline = affine_transform(
            shape(geometry), [frame.pixel_m, 0, 0, frame.pixel_m, frame.left, frame.bottom]
        )
        if outline.area >= settings.smallest_outline_m2:
            lines += [ring.simplify(settings.outline_m) for ring in (outline.exterior, *outline.interiors)]
    return lines


@dataclass(frozen=True)
class Tracks:
    """How borders lie to sheets; arrays of shape (borders,).

    Attributes
    ----------
    sheet : ndarray of int
        The sheet on whose line a border lies, the fullest first; -1 if it lies on none.
    within : ndarray of bool
        Whether it lies between the ends of that sheet, or of another on the same line.
    beside : ndarray of bool
        Whether it lies on no sheet's line, though one runs nearby.
    """

    sheet: np.ndarray
    within: np.ndarray
    beside: np.ndarray


def find_tracks(ends: np.ndarray, sheets: Sequence[Sheet], reach: float) -> Tracks:
    """Find the sheets that borders, shape (n, 4), lie on or within the reach of, metres."""
    count = len(ends)
    sheet, within, beside = np.full(count, -1), np.zeros(count, bool), np.zeros(count, bool)
    middle = (ends[:, :2] + ends[:, 2:]) / 2
    for number, one in sorted(enumerate(sheets), key=lambda pair: -pair[1].levels * pair[1].length):
        first, last, centre = (_away(xy, one) for xy in (ends[:, :2], ends[:, 2:], middle))
        on_line = (np.abs(first[1]) < ON_LINE) & (np.abs(last[1]) < ON_LINE)
        inside = on_line & (centre[0] > 0) & (centre[0] < one.length)
        near = (np.abs(centre[1]) < reach) & (centre[0] > -reach) & (centre[0] < one.length + reach)
        sheet[on_line & ((sheet < 0) | (inside & ~within))] = number
        within |= inside
        beside |= near
    return Tracks(sheet, within, beside & (sheet < 0))


def _away(xy: np.ndarray, sheet: Sheet) -> tuple[np.ndarray, np.ndarray]:
    """Return how far positions lie along and across a sheet from its start, metres."""
    away = xy - sheet.start
    return away @ sheet.direction, away @ sheet.normal


def seen_and_unseen(
    arrangement: Arrangement, footprint: Footprint, settings: CutSettings = CutSettings()
) -> tuple[np.ndarray, np.ndarray]:
    """Return how much of each cell was seen and was not seen as room, m2; shape (cells,) each."""
    frame, fine = footprint.frame, 2
    shape_ = tuple(fine * count for count in frame.shape)
    pixel = frame.pixel_m / fine
    transform = Affine(pixel, 0.0, frame.left, 0.0, pixel, frame.bottom)
    label = rasterize(
        ((cell, number) for number, cell in enumerate(arrangement.cells, start=1)),
        shape_,
        transform=transform,
        dtype="int32",
    )
    weight = footprint.weight.repeat(fine, axis=0).repeat(fine, axis=1)
    count = len(arrangement.cells) + 1
    total = np.bincount(label.ravel(), minlength=count)[1:]
    known = np.isfinite(weight)
    certain = np.bincount(label[known], minlength=count)[1:]
    seen = np.bincount(label[known], weight[known], count)[1:]
    area = np.array([cell.area for cell in arrangement.cells]) / np.maximum(total, 1)
    # The faces of a partition hide most of its core: all of it is as what is known.
    core = (seen < settings.core_seen_share * certain) & (certain > settings.core_known_share * total)
    area[core] *= (total / np.maximum(certain, 1))[core]
    return seen * area, (certain - seen) * area
