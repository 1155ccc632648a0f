"""Pictures of targets as the scanner saw them."""

import numpy as np

from .range_image.range_image import RangeImage
from .results import Kind, Target, View
from .settings import TargetSettings


def view_of(image: RangeImage, target: Target, settings: TargetSettings) -> View:
    """Return the picture of a target with its surroundings: intensities of a pattern, depths of a sphere.

    Columns are made as wide as rows are high, as the scanner saw them, whatever its azimuth steps are.
    """
    distance = float(np.linalg.norm(target.xyz))
    row, column = image.pixel(target.xyz)
    half = settings.view * target.size / 2 / distance
    level = max(np.hypot(target.xyz[0], target.xyz[1]) / distance, 0.05)
    count = int(np.clip(2 * half / image.step, 12, settings.view_pixels))
    # From the upper left corner; azimuths grow to the left.
    offsets = (np.arange(count) + 0.5) / count * 2 - 1
    rows = np.rint(row - offsets * half / image.step).astype(np.int64)
    columns = np.rint(column - offsets * half / (image.step_of_azimuth * level)).astype(np.int64)
    columns %= image.period
    inside = ((rows >= 0) & (rows < image.ranges.shape[0]))[:, None] & (columns < image.ranges.shape[1])
    values = image.brightness if target.kind is Kind.CHECKERBOARD else image.ranges
    cells = np.ix_(np.clip(rows, 0, len(values) - 1), np.clip(columns, 0, values.shape[1] - 1))
    seen = inside & (image.ranges[cells] > 0)
    picture = np.where(seen, values[cells], np.nan)
    if target.kind is Kind.SPHERE:
        # Near is bright.
        picture = np.clip(distance + target.size - picture, 0, 2 * target.size)
    shades = _shades(picture)
    return View(shades, (count / 2 - 0.5, count / 2 - 0.5), 2 * half * distance)


def _shades(values: np.ndarray) -> np.ndarray:
    """Return values as shades from black to white between their extremes; unknown ones are black."""
    known = values[np.isfinite(values)]
    if not len(known):
        return np.zeros(values.shape, np.uint8)
    low, high = np.percentile(known, (1, 99))
    shade = (values - low) / max(high - low, 1e-9) * 255
    return np.nan_to_num(np.clip(shade, 0, 255)).astype(np.uint8)
