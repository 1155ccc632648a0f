"""Floors that cross the plane of a wall in an opening, such as the landing between two doors."""

from collections.abc import Iterator

import numpy as np
from scipy import ndimage

from .regions import Region
from .settings import FloorSettings
from .states import States


def divide_at_floors(
    regions: list[Region], states: States, settings: FloorSettings = FloorSettings()
) -> list[Region]:
    """Return the regions, divided where a level surface reaches from behind the wall to the front of it.

    Parameters
    ----------
    regions : list of Region
    states : States
    settings : FloorSettings
    """
    depths = np.linspace(-settings.reach_m, settings.reach_m, 2 * settings.steps + 1)
    steps = [
        states.grid.holds(states.cells[(states.above > low) & (states.above <= high)])
        for low, high in zip(depths[:-1], depths[1:])
    ]
    return [part for region in regions for part in _divided(region, steps, states.grid.size, settings)]


def _divided(
    region: Region, steps: list[np.ndarray], size: float, settings: FloorSettings
) -> Iterator[Region]:
    height = region.image.shape[0]
    least = int(np.ceil(settings.lowest_m / size))
    if height < 2 * least:
        yield region
        return
    window = max(round(settings.thickness_m / size), 1)
    seen = [ndimage.maximum_filter1d(step[region.box], window, axis=0, mode="constant") for step in steps]
    covered = np.min([(part & region.image).sum(axis=1) for part in seen], axis=0)
    covered = covered / np.maximum(region.image.sum(axis=1), 1)
    where = least + int(np.argmax(covered[least : height - least + 1]))
    if covered[where] < settings.covered:
        yield region
        return
    for part in (slice(0, where), slice(where, height)):
        yield from _divided(_rows_of(region, part), steps, size, settings)


def _rows_of(region: Region, part: slice) -> Region:
    """Return some rows of a region, without the empty rows and columns around them."""
    rows, columns = region.box
    image = region.image[part]
    (box,) = ndimage.find_objects(image.astype(np.int8))
    moved = (
        slice(rows.start + part.start + box[0].start, rows.start + part.start + box[0].stop),
        slice(columns.start + box[1].start, columns.start + box[1].stop),
    )
    return Region(moved, image[box], 0.0)
