"""What a scanner saw in each direction, and what that says of surfaces which another scan shows."""

from dataclasses import dataclass

import numpy as np

from .patches import Surfaces
from .settings import ViewSettings


@dataclass(frozen=True)
class View:
    """The nearest plane cell in each direction from a scanner.

    Attributes
    ----------
    surfaces : Surfaces
        With the position of the scanner.
    rows : ndarray of int, shape (h, w)
        The cell in each pixel, by elevation from -90 degrees and azimuth; -1 without any.
    settings : ViewSettings
    """

    surfaces: Surfaces
    rows: np.ndarray
    settings: ViewSettings

    def gaps(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return how far points lie before the surfaces seen in their directions, and which cells these are.

        Parameters
        ----------
        points : ndarray, shape (n, 3)
            In the scan.

        Returns
        -------
        gaps : ndarray, shape (n,)
            Along the normal of the cell, metres; negative behind it, -inf where nothing was seen.
        rows : ndarray of int, shape (n,)
        """
        own, arms = self.surfaces, points - self.surfaces.station
        rows = self.rows[_pixels(arms, self.rows.shape)]
        normals, centres = own.normals[rows], own.centres[rows] - own.station
        slopes = np.einsum("ij,ij->i", normals, arms)
        parts = np.divide(
            np.einsum("ij,ij->i", normals, centres),
            slopes,
            out=np.full(len(slopes), np.inf),
            where=slopes < 0,
        )
        # Where nothing is met, the product would be undefined.
        off = np.where(np.isfinite(parts), parts, 0.0)[:, None] * arms - centres
        met = np.linalg.norm(off, axis=1) < self.settings.reach * own.edges[rows]
        met &= (rows >= 0) & np.isfinite(parts)
        return np.where(met, np.einsum("ij,ij->i", normals, arms - centres), -np.inf), rows

    def judged(self, points: np.ndarray, normals: np.ndarray) -> np.ndarray:
        """Return of each point with a normal 1 if the scanner saw it, -1 if it saw through it, or else 0.

        Parameters
        ----------
        points, normals : ndarray, shape (n, 3)
            In the scan.
        """
        limits = self.settings
        gaps, rows = self.gaps(points)
        facing = np.einsum("ij,ij->i", normals, self.surfaces.normals[rows])
        parallel = facing > np.cos(np.radians(limits.facing_deg))
        through = gaps > np.where(parallel, limits.parallel_m, limits.through_m)
        return np.where(parallel & (np.abs(gaps) < limits.same_m), 1, np.where(through, -1, 0))


def view_of(surfaces: Surfaces, settings: ViewSettings = ViewSettings()) -> View:
    """Return what the scanner of surfaces saw.

    Parameters
    ----------
    surfaces : Surfaces
        Of at least one cell, with the position of the scanner.
    settings : ViewSettings
    """
    pixel = np.radians(settings.pixel_deg)
    shape = (round(np.pi / pixel), round(2 * np.pi / pixel))
    arms = surfaces.centres - surfaces.station
    ranges = np.linalg.norm(arms, axis=1)
    one, other = _in_plane(surfaces.normals)
    sides = np.ceil(surfaces.edges / (np.maximum(ranges, settings.nearest_m) * pixel)).astype(int)
    pixels, depths, cells = [], [], []
    for side in np.unique(sides):
        rows = np.flatnonzero(sides == side)
        steps = (np.arange(side) + 0.5) / side - 0.5
        u, v = (axis.ravel()[None, :, None] for axis in np.meshgrid(steps, steps))
        edges = surfaces.edges[rows, None, None]
        spots = arms[rows, None, :] + edges * (u * one[rows, None, :] + v * other[rows, None, :])
        spots = spots.reshape(-1, 3)
        pixels.append(np.ravel_multi_index(_pixels(spots, shape), shape))
        depths.append(np.linalg.norm(spots, axis=1))
        cells.append(np.repeat(rows, side * side))
    pixel, depth, cell = (np.concatenate(each) for each in (pixels, depths, cells))
    order = np.lexsort((cell, -depth))
    nearest = np.full(shape[0] * shape[1], -1)
    # Of several values for one pixel, the last is kept: the nearest.
    nearest[pixel[order]] = cell[order]
    return View(surfaces, nearest.reshape(shape), settings)


def _pixels(arms: np.ndarray, shape: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    """Return row and column of directions."""
    height, width = shape
    elevation = np.arctan2(arms[:, 2], np.hypot(arms[:, 0], arms[:, 1])) / np.pi + 0.5
    azimuth = np.arctan2(arms[:, 1], arms[:, 0]) / (2 * np.pi) + 0.5
    return (
        np.minimum((elevation * height).astype(int), height - 1),
        (azimuth * width).astype(int) % width,
    )


def _in_plane(normals: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return two unit vectors at right angles to normals and each other, shape (n, 3) each."""
    axis = np.eye(3)[np.abs(normals).argmin(axis=1)]
    one = np.cross(normals, axis)
    one /= np.linalg.norm(one, axis=1, keepdims=True)
    return one, np.cross(normals, one)
