"""A simulated room, and how to write it."""

from pathlib import Path
from typing import Optional

import laspy
import numpy as np
from laspy.vlrs.known import WktCoordinateSystemVlr
from rasterio.crs import CRS

CORNER = np.array([412300.0, 5812300.0, 70.0])
"""South-west of the room by 1 m each, on its floor; UTM."""


def room_points() -> np.ndarray:
    """Return points 3 to 5 cm apart on four walls, 6 and 4 m long and 2.5 m high, and the floor."""
    along, up = np.meshgrid(np.arange(0, 1, 1 / 140), np.arange(0, 2.5, 0.04))
    along, up, zero = along.ravel(), up.ravel(), np.zeros(along.size)
    x, y = (grid.ravel() for grid in np.meshgrid(np.arange(0, 6, 0.05), np.arange(0, 4, 0.05)))
    walls = [(6 * along, zero), (6 * along, zero + 4), (zero, 4 * along), (zero + 6, 4 * along)]
    parts = [np.column_stack([*wall, up]) for wall in walls]
    parts.append(np.column_stack([x, y, np.zeros(x.size)]))
    return np.concatenate(parts) + (1.0, 1.0, 0.0) + CORNER


def covered_points(open_from: float = 0.0) -> np.ndarray:
    """Return the points of the room with a ceiling, and a board that stands free in it.

    Its eastern wall has no points above that height, unless it is 0.
    """
    inside = room_points() - CORNER - (1.0, 1.0, 0.0)
    floor = inside[-(120 * 80) :]
    ceiling = floor + (0.0, 0.0, 2.5)
    along, up = (grid.ravel() for grid in np.meshgrid(np.arange(0, 0.8, 0.03), np.arange(0, 1.6, 0.03)))
    board = np.column_stack([2.0 + along, np.full(along.size, 2.0), up])
    if open_from:
        inside = inside[(inside[:, 0] < 5.99) | (inside[:, 2] < open_from)]
    return np.concatenate([inside, ceiling, board]) + (1.0, 1.0, 0.0) + CORNER


def write_las(path: Path, points: np.ndarray, crs: Optional[CRS] = None) -> None:
    """Write `points` with intensities that differ."""
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales, header.offsets = np.full(3, 0.001), np.floor(points.min(axis=0))
    if crs:
        header.vlrs.append(WktCoordinateSystemVlr(crs.to_wkt()))
        header.global_encoding.wkt = True
    cloud = laspy.LasData(header)
    cloud.x, cloud.y, cloud.z = points.T
    cloud.intensity = np.arange(len(points)) % 65536
    cloud.write(str(path))
