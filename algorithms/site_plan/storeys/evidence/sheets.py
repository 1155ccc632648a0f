"""Sheets: straight upright surfaces, found in the points wherever they stand."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from shapely.geometry import LineString

from ....kernels import kernel
from ..settings import SheetSettings
from .levels import Uprights, count_levels


@dataclass(frozen=True)
class Sheet:
    """A straight upright surface, seen from above.

    Attributes
    ----------
    start, stop : ndarray of float64, shape (2,)
        Its ends, metres.
    levels : float
        Mean number of levels that it fills along its length.
    scatter_m : float
        Standard deviation across the sheet.
    """

    start: np.ndarray
    stop: np.ndarray
    levels: float
    scatter_m: float

    @property
    def length(self) -> float:
        """Metres."""
        return float(np.hypot(*(self.stop - self.start)))

    @property
    def line(self) -> LineString:
        """From start to stop."""
        return LineString([self.start, self.stop])

    @property
    def direction(self) -> np.ndarray:
        """Unit vector from start to stop."""
        return (self.stop - self.start) / self.length

    @property
    def normal(self) -> np.ndarray:
        """Unit vector to the left."""
        x, y = self.direction
        return np.array([-y, x])


def find_sheets(
    uprights: Uprights, noise: float, spacing: float, settings: SheetSettings = SheetSettings()
) -> list[Sheet]:
    """Find the straight sheets, the fullest first.

    Parameters
    ----------
    uprights : Uprights
    noise, spacing : float
        Of the points, metres.
    settings : SheetSettings

    Returns
    -------
    list of Sheet
    """
    band = max(settings.band_m + settings.band_noises * noise, settings.band_spacings * spacing)
    band = min(band, settings.widest_band_m)
    gap = max(settings.gap_m, settings.gap_spacings * spacing)
    growth = _Growth(uprights, band, gap, settings)
    step = max(2 * uprights.frame.pixel_m, spacing)
    found = []
    for seed in np.argsort(-growth.weight, kind="stable"):
        if not growth.free[seed]:
            continue
        member, line = growth.grow(seed)
        growth.free[seed] = False
        if len(member) < settings.fewest_pixels:
            continue
        along = (uprights.xy[member] - line[:2]) @ line[2:]
        start, stop = along.min(), along.max()
        if stop - start < settings.shortest_m:
            continue
        growth.strike(line, start, stop)
        levels = _filled(along - start, stop - start, uprights.levels[member], step)
        if levels >= settings.fewest_levels:
            scatter = np.sqrt(
                np.average(_across(uprights.xy[member], line) ** 2, weights=growth.weight[member])
            )
            first, last = (line[:2] + end * line[2:] for end in (start, stop))
            found.append(Sheet(first, last, levels, float(scatter)))
    return found


def _across(xy: np.ndarray, line: np.ndarray) -> np.ndarray:
    return (xy[:, 1] - line[1]) * line[2] - (xy[:, 0] - line[0]) * line[3]


class _Growth:
    """Pixels that sheets grow over, and those that are still free.

    A line is x, y of a point on it and its direction; ndarray, shape (4,).
    """

    def __init__(self, uprights: Uprights, band: float, gap: float, settings: SheetSettings) -> None:
        frame = uprights.frame
        self.xy = uprights.xy - (frame.left, frame.bottom)
        self.corner = np.array([frame.left, frame.bottom, 0.0, 0.0])
        self.normal = np.column_stack([np.cos(uprights.angle), np.sin(uprights.angle)])
        self.weight = count_levels(uprights.levels).astype(float)
        self.pixel, self.band, self.gap, self.settings = frame.pixel_m, band, gap, settings
        self.least = np.cos(np.radians(settings.turn_deg))
        self.number = np.full(frame.shape, -1, np.int32)
        self.number[uprights.row, uprights.column] = np.arange(len(self.xy))
        self.free = np.ones(len(self.xy), bool)
        self.visited = np.zeros(len(self.xy), np.int64)
        self.walks = 0

    def grow(self, seed: int) -> tuple[np.ndarray, np.ndarray]:
        """Grow a sheet from a pixel; return its pixels and its line."""
        settings = self.settings
        line = self._turned(seed, 0.0)
        member = self._walk(line, self.gap, settings.begin_m, settings.begin_bands * self.band)
        if len(member) < settings.fewest_pixels:
            return member, line
        line = self._begun(seed)
        count = -1
        for _ in range(settings.rounds):
            member = self._walk(line, self.gap, np.inf)
            if len(member) < settings.fewest_pixels or len(member) == count:
                break
            count = len(member)
            line = self._fitted(member, line)
        return member, line + self.corner

    def strike(self, line: np.ndarray, start: float, stop: float) -> None:
        """Take the pixels of a sheet, and what lies close to them, out of those that are free.

        In the wider band, a walk may pass gaps at which the sheet ends: beyond, another sheet begins.
        """
        line = line - self.corner
        band, least = self.settings.struck_bands * self.band, self.settings.struck_turn * self.least
        member = self._walk(line, self.gap, np.inf, band, least)
        along = (self.xy[member] - line[:2]) @ line[2:]
        self.free[member[(along >= start - band) & (along <= stop + band)]] = False

    def _begun(self, seed: int) -> np.ndarray:
        """Return the line through a pixel that the most levels lie on; a normal near a corner is askew."""
        lines = np.array([self._turned(seed, turn) for turn in np.radians(self.settings.begin_turns_deg)])
        members = [self._walk(line, self.gap, self.settings.begin_m) for line in lines]
        best = int(np.argmax([self.weight[member].sum() for member in members]))
        return self._fitted(members[best], lines[best])

    def _fitted(self, member: np.ndarray, line: np.ndarray) -> np.ndarray:
        farthest = self.settings.robust_bands * self.band
        return _fitted(self.xy[member], self.weight[member], line, farthest)

    def _turned(self, seed: int, turn: float) -> np.ndarray:
        (x, y), c, s = self.normal[seed], np.cos(turn), np.sin(turn)
        return np.array([*self.xy[seed], -(x * s + y * c), x * c - y * s])

    def _walk(
        self,
        line: np.ndarray,
        gap: float,
        reach: float,
        band: Optional[float] = None,
        least: Optional[float] = None,
    ) -> np.ndarray:
        self.walks += 1
        return _walk(
            self.number, self.pixel, self.xy, self.normal, self.free, self.visited, self.walks, line,
            band or self.band, gap, reach, least or self.least,
        )  # fmt: skip


@kernel
def _walk(
    number: np.ndarray,
    pixel: float,
    xy: np.ndarray,
    normal: np.ndarray,
    free: np.ndarray,
    visited: np.ndarray,
    walk: int,
    line: np.ndarray,
    band: float,
    gap: float,
    reach: float,
    least: float,
) -> np.ndarray:
    """Return the free pixels along a line, both ways until a gap, whose normals are across it."""
    chosen = []
    rows, columns = number.shape
    half = int(np.ceil(band / pixel)) + 1
    for way in (1.0, -1.0):
        dx, dy = way * line[2], way * line[3]
        s = last = 0.0
        while s - last <= gap and s <= reach:
            for k in range(-2 * half, 2 * half + 1):
                column = int((line[0] + s * dx - 0.5 * k * pixel * dy) // pixel)
                row = int((line[1] + s * dy + 0.5 * k * pixel * dx) // pixel)
                if row < 0 or column < 0 or row >= rows or column >= columns:
                    continue
                i = number[row, column]
                if i < 0 or visited[i] == walk or not free[i]:
                    continue
                x, y = xy[i, 0] - line[0], xy[i, 1] - line[1]
                if abs(x * dy - y * dx) <= band and abs(normal[i, 0] * dy - normal[i, 1] * dx) >= least:
                    visited[i] = walk
                    chosen.append(i)
                    last = max(last, x * dx + y * dy)
            s += 0.5 * pixel
    return np.array(chosen, dtype=np.int64)


@kernel
def _fitted(xy: np.ndarray, weight: np.ndarray, line: np.ndarray, farthest: float) -> np.ndarray:
    """Fit a line by least squares with Tukey weights, 0 from the farthest; its origin stays near the seed."""
    robust = weight.copy()
    x0, y0, dx, dy = line[0], line[1], line[2], line[3]
    for _ in range(4):
        total = robust.sum()
        if total <= 0.0:
            break
        mx, my = (robust * xy[:, 0]).sum() / total, (robust * xy[:, 1]).sum() / total
        x, y = xy[:, 0] - mx, xy[:, 1] - my
        turn = 0.5 * np.arctan2(2.0 * (robust * x * y).sum(), (robust * (x * x - y * y)).sum())
        dx, dy = np.cos(turn), np.sin(turn)
        along = (x0 - mx) * dx + (y0 - my) * dy
        x0, y0 = mx + along * dx, my + along * dy
        for i in range(len(xy)):
            share = min(abs(x[i] * dy - y[i] * dx) / farthest, 1.0)
            robust[i] = weight[i] * (1.0 - share * share) ** 2
    return np.array([x0, y0, dx, dy])


def _filled(along: np.ndarray, length: float, bits: np.ndarray, step: float) -> float:
    """Return the mean number of levels that the stations along a sheet fill."""
    count = max(round(length / step), 1)
    station = np.minimum((along / length * count).astype(int), count - 1)
    filled = np.zeros(count, np.uint64)
    np.bitwise_or.at(filled, station, bits)
    return float(count_levels(filled).mean())
