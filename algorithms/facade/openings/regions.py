"""The regions of an elevation that are openings: where the wall has a hole, whatever is seen in it."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from .grid import ABOVE, BELOW, LEFT, RIGHT, beyond, first_seen
from .settings import OpeningSettings, RegionSettings
from .shadows import without_shadows
from .spacings import closed_wall
from .states import BEHIND, EMPTY, FRONT, WALL, States

Box = tuple[slice, slice]
SQUARE = np.ones((3, 3), bool)


@dataclass(frozen=True)
class Region:
    """A hole of the wall, in pixels.

    Attributes
    ----------
    box : tuple of slice
        Rows and columns.
    image : ndarray of bool
        Its pixels, within the box.
    front : float
        The part of it that something in front hides.
    """

    box: Box
    image: np.ndarray
    front: float

    @property
    def fill(self) -> float:
        """The part of the box that the region fills."""
        return float(self.image.mean())


def find_regions(states: States, settings: OpeningSettings = OpeningSettings()) -> list[Region]:
    """Return the regions in which the facade has openings, from below and the left.

    Parameters
    ----------
    states : States
    settings : OpeningSettings
    """
    limits, size = settings.regions, states.grid.size
    wall = solid_wall(states)
    holes = without_shadows(_holes(states, wall, limits), states, wall, limits)
    labels, _ = ndimage.label(holes)
    found = [_region(labels, number, box) for number, box in enumerate(ndimage.find_objects(labels), start=1)]
    found = [part for region in found for part in _split(region, limits, size)]
    found = _joined(found, states, limits)
    found = [_with_front(region, states) for region in found]
    return [
        region for region in found if _is_opening(region, limits, size) and _has_depth(region, states, limits)
    ]


def solid_wall(states: States) -> np.ndarray:
    """Return the pixels of the wall, without single gaps between its points."""
    wall = states.image == WALL
    closed = closed_wall(wall, states.spacings, states.grid.size)
    wall |= closed & (states.image == EMPTY)
    # A pixel amid the wall that shows what is behind is a gap as well.
    crowded = ndimage.convolve(wall.astype(np.uint8), SQUARE.astype(np.uint8), mode="constant") >= 6
    return wall | crowded


def _holes(states: States, wall: np.ndarray, limits: RegionSettings) -> np.ndarray:
    """Return the pixels that show something behind the wall, and empty ones that belong to them."""
    enclosed = beyond(wall).sum(axis=0) >= 3
    behind = (states.image == BEHIND) & ~wall & enclosed
    front = states.image == FRONT
    open_pixels = ~wall & ~front & ~behind & enclosed
    # What is empty amid things behind the wall is glass.
    glass = open_pixels & (first_seen(wall | behind | front, behind).sum(axis=0) >= 3)
    holes = behind | glass | _glazed(open_pixels & ~glass, behind | glass | states.reveals, front, limits)
    square = np.ones((limits.speck_pixels,) * 2, bool)
    holes = ndimage.binary_opening(holes, square)
    return _framed(holes, wall, limits) & ~front


def _glazed(empty: np.ndarray, behind: np.ndarray, front: np.ndarray, limits: RegionSettings) -> np.ndarray:
    """Return the empty pieces of whose rim enough shows something behind the wall, and little in front."""
    pieces, count = ndimage.label(empty)
    if not count:
        return empty
    kept = np.zeros(count + 1, bool)
    for number, box in enumerate(ndimage.find_objects(pieces), start=1):
        grown = tuple(slice(max(side.start - 1, 0), side.stop + 1) for side in box)
        own = pieces[grown] == number
        rim = ndimage.binary_dilation(own, SQUARE) & ~own
        kept[number] = (behind[grown] & rim).sum() >= limits.jambs * rim.sum()
        kept[number] &= (front[grown] & rim).sum() <= limits.hidden * rim.sum()
    return kept[pieces]


def _framed(holes: np.ndarray, wall: np.ndarray, limits: RegionSettings) -> np.ndarray:
    """Return the holes with what stands flush with the wall in them, such as frames and bars."""
    pieces, _ = ndimage.label(wall & ~holes, SQUARE)
    sizes = np.bincount(pieces.ravel())
    sizes[0] = 0
    # Pieces that hang together with a large part of the wall are piers.
    loose = (pieces > 0) & (sizes[pieces] < limits.pier * sizes.max())
    around = first_seen((wall & ~loose) | holes, holes).sum(axis=0) >= 3
    filled = holes | (loose & around)
    return ndimage.binary_closing(np.pad(filled, 1), SQUARE)[1:-1, 1:-1] & (~wall | filled)


def _region(labels: np.ndarray, number: int, box: Box) -> Region:
    return Region(box, labels[box] == number, 0.0)


def _split(region: Region, limits: RegionSettings, size: float) -> Iterator[Region]:
    """Yield the parts of a region, divided at its necks."""
    shape = region.image.shape
    if min(shape) * size < limits.narrowest_m:
        return
    narrow, cut, axis = min(
        ((*_neck(region.image, axis, limits), axis) for axis in (0, 1)), key=lambda neck: neck[0]
    )
    full = region.fill >= limits.filled
    length = cut.stop - cut.start or shape[axis]
    clear = narrow <= limits.clear_neck and length * size >= limits.post_m
    if max(shape) < 4 or (full and not clear) or narrow > limits.neck:
        yield region
        return
    for part in (slice(0, cut.start), slice(cut.stop, shape[axis])):
        piece = region.image[part] if axis == 0 else region.image[:, part]
        start = region.box[axis].start
        moved = slice(start + part.start, start + part.stop)
        box = (moved, region.box[1]) if axis == 0 else (region.box[0], moved)
        yield from _pieces(Region(box, piece, 0.0), limits, size)


def _pieces(region: Region, limits: RegionSettings, size: float) -> Iterator[Region]:
    """Yield the connected pieces of a part, each divided further."""
    labels, _ = ndimage.label(region.image)
    rows, columns = region.box
    for number, box in enumerate(ndimage.find_objects(labels), start=1):
        inside = (
            slice(rows.start + box[0].start, rows.start + box[0].stop),
            slice(columns.start + box[1].start, columns.start + box[1].stop),
        )
        yield from _split(Region(inside, labels[box] == number, 0.0), limits, size)


def _neck(image: np.ndarray, axis: int, limits: RegionSettings) -> tuple[float, slice]:
    """Return how narrow the narrowest row or column is beside what it joins, and the rows of the neck.

    All rows that are about as narrow are the neck and belong to neither part, whichever way the axes point.
    A step has no rows of its own.
    """
    widths = image.sum(axis=1 - axis).astype(float)
    before = np.maximum.accumulate(widths)[:-1]
    after = np.maximum.accumulate(widths[::-1])[::-1][1:]
    both = np.minimum(before, after)
    inner = np.arange(1, len(widths) - 1)
    if not len(inner):
        return np.inf, slice(0, 0)
    ratios = widths[inner] / np.maximum(np.minimum(both[inner - 1], both[inner]), 1.0)
    if ratios.min() >= limits.neck:
        # A step from narrow to wide is a neck too: the narrower side is cut off where it begins.
        steps = np.minimum(widths[:-1], widths[1:]) / np.maximum(np.maximum(widths[:-1], widths[1:]), 1.0)
        step = int(np.argmin(steps)) + 1
        return float(steps.min()), slice(step, step)
    where = int(inner[np.argmin(ratios)])
    wide = np.flatnonzero(limits.neck * widths > widths[where])
    return float(ratios.min()), slice(int(wide[wide < where][-1]) + 1, int(wide[wide > where][0]))


def _joined(regions: list[Region], states: States, limits: RegionSettings) -> list[Region]:
    """Return the regions, with the lights of one window as one."""
    regions = list(regions)
    merged = True
    while merged:
        merged = False
        for first in range(len(regions)):
            for second in range(first + 1, len(regions)):
                if _are_lights(regions[first], regions[second], limits, states.grid.size):
                    one = _union(regions[first], regions[second])
                    regions = [r for number, r in enumerate(regions) if number not in (first, second)] + [one]
                    merged = True
                    break
            if merged:
                break
    return sorted(regions, key=lambda region: (region.box[0].start, region.box[1].start))


def _are_lights(first: Region, second: Region, limits: RegionSettings, size: float) -> bool:
    """Whether a post or a transom is all that separates two regions."""
    one, other = _main_box(first), _main_box(second)
    for across, along in ((1, 0), (0, 1)):
        gap = max(one[across].start, other[across].start) - min(one[across].stop, other[across].stop)
        overlap = min(one[along].stop, other[along].stop) - max(one[along].start, other[along].start)
        longest = max(_length(one[along]), _length(other[along]))
        if gap * size <= limits.post_m and overlap >= limits.alike * longest:
            return True
    return False


def _main_box(region: Region) -> Box:
    """Return the box of a region without what hangs on to it, such as the shadow of a car."""
    sides = []
    for axis, side in enumerate(region.box):
        widths = region.image.sum(axis=1 - axis)
        (wide,) = np.nonzero(2 * widths >= widths.max())
        sides.append(slice(side.start + int(wide[0]), side.start + int(wide[-1]) + 1))
    return sides[0], sides[1]


def _length(side: slice) -> int:
    return int(side.stop - side.start)


def _union(first: Region, second: Region) -> Region:
    box = tuple(slice(min(a.start, b.start), max(a.stop, b.stop)) for a, b in zip(first.box, second.box))
    image = np.zeros(tuple(_length(side) for side in box), bool)
    for region in (first, second):
        within = tuple(
            slice(own.start - side.start, own.stop - side.start) for own, side in zip(region.box, box)
        )
        image[within] |= region.image
    # The post between them is content of the window.
    for axis in (0, 1):
        both = [np.logical_or.accumulate(part, axis=axis) for part in (image, np.flip(image, axis))]
        image |= both[0] & np.flip(both[1], axis)
    return Region((box[0], box[1]), image, 0.0)


def _with_front(region: Region, states: States) -> Region:
    front = (states.image[region.box] == FRONT).mean()
    return Region(region.box, region.image, float(front))


def _is_opening(region: Region, limits: RegionSettings, size: float) -> bool:
    height, width = region.image.shape
    return min(height, width) * size >= limits.narrowest_m and region.front <= limits.most_front


def _has_depth(region: Region, states: States, limits: RegionSettings) -> bool:
    """Whether jambs, a frame or a pane are seen close behind the rim of a region.

    Otherwise something in front, such as a canopy, hides the wall, and what is seen is a room, scanned from
    inside.
    """
    reach = limits.rim_pixels
    rows, columns = (slice(max(side.start - reach, 0), side.stop + reach) for side in region.box)
    image = np.zeros(states.grid.shape, bool)
    image[region.box] = region.image
    own = image[rows, columns]
    rim = ndimage.binary_dilation(own) & ~own
    close = ndimage.binary_dilation(states.reveals[rows, columns], iterations=reach)
    return bool((close & rim).sum() >= limits.jambs * rim.sum())


def open_sides(region: Region, states: States, wall: np.ndarray) -> tuple[bool, bool, bool, bool]:
    """Return on which sides, in the order of `grid.LEFT` and so on, no wall bounds a region."""
    rows, columns = region.box
    ahead = {
        LEFT: wall[rows, : columns.start],
        RIGHT: wall[rows, columns.stop :],
        BELOW: wall[: rows.start, columns],
        ABOVE: wall[rows.stop :, columns],
    }
    axis = {LEFT: 1, RIGHT: 1, BELOW: 0, ABOVE: 0}
    bounded = {
        side: image.any(axis=axis[side]).mean() if image.size else 0.0 for side, image in ahead.items()
    }
    return tuple(bool(bounded[side] < 0.5) for side in (LEFT, RIGHT, BELOW, ABOVE))  # type: ignore[return-value]
