"""Sheets on common lines, and short ones square to their long neighbours."""

from dataclasses import replace

import numpy as np

from .settings import SheetSettings
from .sheets import Sheet


def square_up(sheets: list, settings: SheetSettings = SheetSettings()) -> list:
    """Turn short sheets square to the nearest long one, where their own direction is no surer than that."""
    long = [sheet for sheet in sheets if sheet.length >= settings.long_m]
    if not long:
        return sheets
    return [sheet if sheet.length >= settings.long_m else _squared(sheet, long, settings) for sheet in sheets]


def _squared(sheet: Sheet, long: list, settings: SheetSettings) -> Sheet:
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


def _distance(sheet: Sheet, place: np.ndarray) -> float:
    """Return the distance of a place from a sheet, metres."""
    way = np.clip((place - sheet.start) @ sheet.direction, 0, sheet.length)
    return float(np.hypot(*(place - sheet.start - way * sheet.direction)))
