"""Sheets on common lines, and short ones square to their long neighbours."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..settings import SheetSettings
from .sheets import Sheet


def square_up(sheets: Sequence[Sheet], settings: SheetSettings = SheetSettings()) -> list[Sheet]:
    """Rotate short sheets square to a long one nearby, if their own direction allows it."""
    long = [sheet for sheet in sheets if sheet.length >= settings.long_m]
    if not long:
        return list(sheets)
    return [sheet if sheet.length >= settings.long_m else _squared(sheet, long, settings) for sheet in sheets]


def _squared(sheet: Sheet, long: list[Sheet], settings: SheetSettings) -> Sheet:
    middle = (sheet.start + sheet.stop) / 2
    near = min(long, key=lambda other: _distance(other, middle))
    if _distance(near, middle) > settings.square_within_m:
        return sheet
    along = max(near.direction, near.normal, key=lambda way: abs(way @ sheet.direction))
    turn = np.arccos(min(abs(along @ sheet.direction), 1.0))
    if turn > max(np.radians(settings.square_deg), 2 * settings.band_m / sheet.length):
        return sheet
    half = sheet.length / 2 * np.sign(along @ sheet.direction) * along
    return replace(sheet, start=middle - half, stop=middle + half)


def _distance(sheet: Sheet, xy: np.ndarray) -> float:
    """Return the distance of a position from a sheet, metres."""
    way = np.clip((xy - sheet.start) @ sheet.direction, 0, sheet.length)
    return float(np.hypot(*(xy - sheet.start - way * sheet.direction)))


def share_lines(sheets: Sequence[Sheet], settings: SheetSettings = SheetSettings()) -> list[Sheet]:
    """Move sheets that lie on one line, though apart, onto it."""
    sheets = sorted(sheets, key=lambda sheet: -sheet.length)
    group = list(range(len(sheets)))
    lines = [_Shared([sheet]) for sheet in sheets]
    least = np.cos(np.radians(settings.shared_turn_deg))
    for i, sheet in enumerate(sheets):
        for j in range(i):
            host = lines[group[j]]
            if group[j] != j or host is None or abs(host.direction @ sheet.direction) < least:
                continue
            if host.gap(sheet) <= settings.shared_gap_m and host.accepts(sheet, settings.shared_offset_m):
                lines[j] = _Shared([*host.sheets, sheet])
                group[i] = j
                break
    return [host.project(sheet) for k, host in enumerate(lines) if group[k] == k for sheet in host.sheets]


class _Shared:
    """The common line of some sheets."""

    def __init__(self, sheets: list[Sheet]) -> None:
        self.sheets = sheets
        ends = np.array([end for sheet in sheets for end in (sheet.start, sheet.stop)])
        weight = np.repeat([sheet.length * sheet.levels for sheet in sheets], 2)
        self.middle = weight @ ends / weight.sum()
        away = (ends - self.middle) * np.sqrt(weight)[:, None]
        self.direction = np.linalg.svd(away, full_matrices=False)[2][0]

    def gap(self, sheet: Sheet) -> float:
        """Return the gap between a sheet and the nearest of these along the line."""
        own = sorted((end - self.middle) @ self.direction for end in (sheet.start, sheet.stop))
        gaps = []
        for other in self.sheets:
            low, high = sorted((end - self.middle) @ self.direction for end in (other.start, other.stop))
            gaps.append(max(own[0] - high, low - own[1]))
        return min(gaps)

    def accepts(self, sheet: Sheet, offset: float) -> bool:
        """Return whether all sheets remain on the line if one more is added."""
        together = _Shared([*self.sheets, sheet])
        return all(
            together.distance(end) <= offset for one in together.sheets for end in (one.start, one.stop)
        )

    def distance(self, xy: np.ndarray) -> float:
        """Return the distance of a position from the line, metres."""
        x, y = xy - self.middle
        return abs(x * self.direction[1] - y * self.direction[0])

    def project(self, sheet: Sheet) -> Sheet:
        """Return the sheet on the line."""
        start, stop = (
            self.middle + ((end - self.middle) @ self.direction) * self.direction
            for end in (sheet.start, sheet.stop)
        )
        return replace(sheet, start=start, stop=stop)
