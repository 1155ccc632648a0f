"""On which side of a wall the open air is: rooms have ceilings, streets have not."""

import numpy as np
import pandas as pd

from .settings import OpennessSettings


def even_points(xyz: np.ndarray, size: float) -> np.ndarray:
    """Return the middles of the cubes of `size` (m) that hold points, shape (k, 3)."""
    corner = xyz.min(axis=0)
    cubes = np.floor((xyz - corner) / size).astype(np.int64)
    most = cubes.max(axis=0) + 1
    keys = np.sort(pd.unique((cubes[:, 0] * most[1] + cubes[:, 1]) * most[2] + cubes[:, 2]))
    held = np.stack([keys // (most[1] * most[2]), keys // most[2] % most[1], keys % most[2]], axis=1)
    return corner + (held + 0.5) * size


def sides_of(
    even: np.ndarray,
    level: np.ndarray,
    offset: float,
    limits: tuple[float, float, float, float],
    settings: OpennessSettings = OpennessSettings(),
) -> tuple[np.ndarray, np.ndarray]:
    """Return what lies before a wall and behind it.

    Parameters
    ----------
    even : ndarray of float64, shape (n, 3)
        Points as `even_points` spreads them.
    level : ndarray of float64, shape (2,)
        Direction of the normal of the wall in plan, of length 1.
    offset : float
        Of the wall along `level` (m).
    limits : tuple of 4 float
        Start and stop of the wall along (-level_y, level_x), its foot and its top (m).
    settings : OpennessSettings

    Returns
    -------
    covered : ndarray of float64, shape (2,)
        Part of the length of the wall that has a ceiling, before it and behind it.
    held : ndarray of float64, shape (2,)
        Area in plan where anything was seen, before it and behind it (m2): ground, floors.
    """
    start, stop, bottom, top = limits
    away = even[:, :2] @ level - offset
    along = even[:, :2] @ np.array([-level[1], level[0]])
    near = (np.abs(away) > settings.nearest_m) & (np.abs(away) < settings.farthest_m)
    near &= (along > start) & (along < stop)
    held = np.array(
        [_plan_area(along[side], away[side], settings) for side in (near & (away > 0), near & (away < 0))]
    )
    near &= (np.abs(away) < settings.room_m) & (even[:, 2] > bottom + settings.head_m) & (even[:, 2] < top)
    pieces = max(int((stop - start) / settings.cell_m), 1)
    piece = np.minimum(((along[near] - start) / settings.cell_m).astype(np.int64), pieces - 1)
    floor = np.floor((even[near, 2] - bottom) / settings.cell_m).astype(np.int64)
    depth = np.floor((np.abs(away[near]) - settings.nearest_m) / settings.cell_m).astype(np.int64)
    covered = [
        _ceilings(piece[side], depth[side], floor[side], pieces, settings)
        for side in (away[near] > 0, away[near] < 0)
    ]
    return np.array(covered), held


def _plan_area(along: np.ndarray, away: np.ndarray, settings: OpennessSettings) -> float:
    cells = np.floor(np.stack([along, away], axis=1) / settings.cell_m).astype(np.int64)
    return len(np.unique(cells, axis=0)) * settings.cell_m**2


def _ceilings(
    piece: np.ndarray, depth: np.ndarray, floor: np.ndarray, pieces: int, settings: OpennessSettings
) -> float:
    """Return the part of the pieces of a wall with points at one height over most of the depth of a room.

    Below a ceiling is air, and above its floor too; below and above leaves are more leaves.
    """
    if not len(piece):
        return 0.0
    deep = int((settings.room_m - settings.nearest_m) / settings.cell_m)
    air = 1 + int(settings.air_m / settings.cell_m)
    held = np.zeros((pieces, deep, floor.max() + 2 * air + 1), bool)
    inside = depth < deep
    held[piece[inside], depth[inside], air + floor[inside]] = True
    # A ceiling can lie across the limit of two levels.
    held[..., :-1] |= held[..., 1:]
    level = held.mean(axis=1)
    empty = level < 1 - settings.flat
    ceilings = (level[:, air:-air] >= settings.flat) & empty[:, : -2 * air] & empty[:, 2 * air :]
    return float(ceilings.any(axis=1).mean())
