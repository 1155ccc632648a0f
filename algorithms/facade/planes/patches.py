"""Planes of limited extent: where on an infinite plane there are points of it."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from scipy import ndimage

from .ransac import best_plane, refit
from .settings import PlaneSettings
from .voxels import Voxels


@dataclass(frozen=True)
class Patch:
    """A plane and the squares of it that have points.

    Attributes
    ----------
    normal, anchor : ndarray of float64, shape (3,)
        Of the plane, relative to the origin of the points.
    corner : ndarray of float64, shape (2,)
        Of the squares, along `axes`.
    squares : ndarray of bool, shape (rows, columns)
    side : float
        Of a square (m).
    area : float
        Of its voxels (m2).
    """

    normal: np.ndarray
    anchor: np.ndarray
    corner: np.ndarray
    squares: np.ndarray
    side: float
    area: float

    @property
    def axes(self) -> np.ndarray:
        """Two directions in the plane, as rows, shape (2, 3); the same for either sign of the normal."""
        level = np.cross([0.0, 0.0, 1.0], self.normal)
        if np.linalg.norm(level) < 1e-3:
            level = np.array([1.0, 0.0, 0.0])
        level = level - (level @ self.normal) * self.normal
        level /= np.linalg.norm(level)
        return np.array([level, np.cross(self.normal, level)])

    def heights(self, xyz: np.ndarray) -> np.ndarray:
        """Return the signed distances of points, shape (n, 3)."""
        return (xyz - self.anchor) @ self.normal

    def covers(self, xyz: np.ndarray) -> np.ndarray:
        """Return which points, shape (n, 3), project into a square with points, or into one beside it."""
        cells = np.floor(((xyz - self.anchor) @ self.axes.T - self.corner) / self.side).astype(np.int64)
        rows, columns = cells[:, 1], cells[:, 0]
        height, width = self.squares.shape
        inside = (rows >= 0) & (rows < height) & (columns >= 0) & (columns < width)
        inside[inside] = self._and_beside[rows[inside], columns[inside]]
        return inside

    @cached_property
    def _and_beside(self) -> np.ndarray:
        # Normals are mixed at the end of a plane, so its last square may have none of its voxels.
        return ndimage.binary_dilation(self.squares, np.ones((3, 3)))

    def flipped(self) -> "Patch":
        """Return the same patch, seen from the other side."""
        return make_patch(-self.normal, self.anchor, self.centres_of_squares(), self.side, self.area)

    def centres_of_squares(self) -> np.ndarray:
        """Return the middles of the squares that have points, shape (k, 3)."""
        rows, columns = np.nonzero(self.squares)
        middles = self.corner + (np.stack([columns, rows], axis=1) + 0.5) * self.side
        return self.anchor + middles @ self.axes


def make_patch(normal: np.ndarray, anchor: np.ndarray, xyz: np.ndarray, side: float, area: float) -> Patch:
    """Return the patch of a plane where points, shape (n, 3), are; squares have a `side` (m)."""
    patch = Patch(normal, anchor, np.zeros(2), np.zeros((0, 0), bool), side, area)
    places = (xyz - anchor) @ patch.axes.T
    corner = places.min(axis=0) - 1.5 * side
    cells = np.floor((places - corner) / side).astype(np.int64)
    squares = np.zeros(tuple(cells.max(axis=0)[::-1] + 2), bool)
    squares[cells[:, 1], cells[:, 0]] = True
    return replace(patch, corner=corner, squares=squares)


def extract(voxels: Voxels, distance: float, settings: PlaneSettings = PlaneSettings()) -> list[Patch]:
    """Return the largest connected planes, each from the voxels that the ones before left.

    Parameters
    ----------
    voxels : Voxels
    distance : float
        ds (m).
    settings : PlaneSettings
    """
    left = np.arange(len(voxels.centres))
    smallest, fit = settings.smallest_m2, settings.fit
    patches: list[Patch] = []
    while len(patches) < settings.most_planes and len(left) * voxels.size**2 >= smallest:
        centres, normals = voxels.centres[left], voxels.normals[left]
        plane = best_plane(centres, normals, distance, len(patches), fit)
        if plane is None:
            break
        # Remote voxels have a long lever: the first fit uses the connected part only.
        compact = _members(*plane, centres, normals, distance, 0, settings)
        plane = refit(centres[compact], *plane, fit.vote * distance, normals[compact], fit)
        near = np.abs((centres - plane[1]) @ plane[0]) <= distance
        own = _members(*plane, centres, normals, distance, settings.gap_squares, settings)
        area = float(own.sum() * voxels.size**2)
        if area < smallest:
            break
        patches.append(make_patch(*plane, centres[own], settings.cell_m, area))
        # Corners of the same surface, where normals are mixed, would come back as slivers.
        left = left[~(own | (near & patches[-1].covers(centres)))]
    return patches


def _members(
    normal: np.ndarray,
    anchor: np.ndarray,
    centres: np.ndarray,
    normals: np.ndarray,
    distance: float,
    gap: int,
    settings: PlaneSettings,
) -> np.ndarray:
    """Return which voxels are on a plane, in its largest part; gaps of so many empty squares are bridged."""
    facing = np.abs(normals @ normal) >= settings.fit.least_cosine
    own = (np.abs((centres - anchor) @ normal) <= distance) & facing
    own[own] = _largest_part(normal, anchor, centres[own], settings.cell_m, gap)
    return own


def _largest_part(
    normal: np.ndarray, anchor: np.ndarray, centres: np.ndarray, side: float, gap: int
) -> np.ndarray:
    """Return which points, shape (n, 3), are in the largest connected part of them."""
    if not len(centres):
        return np.zeros(0, bool)
    patch = make_patch(normal, anchor, centres, side, 0.0)
    # A part reaches half a gap further on either side.
    reach = gap // 2
    closed = np.pad(patch.squares, reach)
    if reach:
        closed = ndimage.binary_dilation(closed, iterations=reach)
    parts, _ = ndimage.label(closed, np.ones((3, 3)))
    parts = parts[reach : parts.shape[0] - reach, reach : parts.shape[1] - reach]
    cells = np.floor(((centres - anchor) @ patch.axes.T - patch.corner) / side).astype(np.int64)
    own = parts[cells[:, 1], cells[:, 0]]
    return own == np.argmax(np.bincount(own))
