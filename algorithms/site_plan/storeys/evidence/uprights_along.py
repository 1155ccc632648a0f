"""How much upright surface stands along a line."""

import numpy as np

from ....kernels import kernel
from .levels import Uprights, count_levels


class UprightsAlong:
    """Looks up the upright surface beside lines.

    Parameters
    ----------
    uprights : Uprights
    beside : float
        Surface within this of a line belongs to it, metres.
    step : float
        Distance between the stations along a line, metres.
    reach : float
        Surface so far from a station along the line is seen from it: in corners normals are askew.
    turn_deg : float
        Largest angle between the surface and the line.
    """

    def __init__(self, uprights: Uprights, beside: float, step: float, reach: float, turn_deg: float) -> None:
        frame = uprights.frame
        self.pixel, self.corner = frame.pixel_m, np.array([frame.left, frame.bottom])
        self.number = np.full(frame.shape, -1, np.int32)
        self.number[uprights.row, uprights.column] = np.arange(len(uprights.xy))
        self.xy = uprights.xy - self.corner
        self.normal = np.column_stack([np.cos(uprights.angle), np.sin(uprights.angle)])
        self.levels = uprights.levels
        self.beside, self.step, self.reach, self.least = beside, step, reach, np.cos(np.radians(turn_deg))

    def stations(self, ends: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the levels at stations along lines.

        Parameters
        ----------
        ends : ndarray of float64, shape (n, 4)
            x, y of both ends.

        Returns
        -------
        bits : ndarray of uint64, shape (stations,)
            Levels with surface.
        line : ndarray of int, shape (stations,)
            The line of each station; each has one at least.
        """
        length = np.hypot(ends[:, 2] - ends[:, 0], ends[:, 3] - ends[:, 1])
        count = np.maximum(np.ceil(length / self.step), 1).astype(np.int64)
        line = np.repeat(np.arange(len(ends)), count)
        share = (np.arange(len(line)) - np.repeat(np.cumsum(count) - count, count) + 0.5) / count[line]
        along = (ends[:, 2:] - ends[:, :2]) / np.maximum(length, 1e-9)[:, None]
        xy = ends[line, :2] + share[:, None] * (ends[line, 2:] - ends[line, :2]) - self.corner
        half = np.maximum(length / count / 2, self.reach)[line]
        pixels = (self.number, self.pixel, self.xy, self.normal, self.levels)
        bits = _look(*pixels, xy, along[line], half, self.beside, self.least)
        return bits, line

    def mean_levels(self, ends: np.ndarray, mask: int = -1) -> np.ndarray:
        """Return the mean number of levels with surface along each line; only those of the mask count."""
        bits, line = self.stations(ends)
        counts = count_levels(bits & np.uint64(mask & 0xFFFFFFFFFFFFFFFF)).astype(float)
        return np.bincount(line, counts, len(ends)) / np.maximum(np.bincount(line, minlength=len(ends)), 1)


@kernel
def _look(
    number: np.ndarray,
    pixel: float,
    xy: np.ndarray,
    normal: np.ndarray,
    levels: np.ndarray,
    stations: np.ndarray,
    along: np.ndarray,
    half: np.ndarray,
    beside: float,
    least: float,
) -> np.ndarray:
    """Gather the levels of the pixels around each station."""
    bits = np.zeros(len(stations), np.uint64)
    rows, columns = number.shape
    for k in range(len(stations)):
        dx, dy = along[k]
        reach = max(half[k], beside)
        low_row, high_row = int((stations[k, 1] - reach) // pixel), int((stations[k, 1] + reach) // pixel)
        low_column, high_column = (
            int((stations[k, 0] - reach) // pixel),
            int((stations[k, 0] + reach) // pixel),
        )
        for row in range(max(low_row, 0), min(high_row + 1, rows)):
            for column in range(max(low_column, 0), min(high_column + 1, columns)):
                i = number[row, column]
                if i < 0:
                    continue
                x, y = xy[i, 0] - stations[k, 0], xy[i, 1] - stations[k, 1]
                if abs(x * dy - y * dx) > beside or abs(x * dx + y * dy) > half[k]:
                    continue
                if abs(normal[i, 0] * dy - normal[i, 1] * dx) >= least:
                    bits[k] |= levels[i]
    return bits
