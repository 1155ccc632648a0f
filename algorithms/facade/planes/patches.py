"""Planes of limited extent: where on an infinite plane there are points of it."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from scipy import ndimage

from .ransac import NORMAL, SHARP, best_plane, refit
from .voxels import Voxels

CELL = 0.25
"""Side of the squares in which a plane has points or not (m)."""

BRIDGED = 4
"""Empty squares between parts of one plane."""


@dataclass(frozen=True)
class Patch:
    """A plane and the squares of it that have points.

    Attributes
    ----------
    normal, place : ndarray of float64, shape (3,)
        Of the plane, relative to the origin of the points.
    corner : ndarray of float64, shape (2,)
        Of the squares, along `axes`.
    squares : ndarray of bool, shape (rows, columns)
    area : float
        Of its voxels (m2).
    """

    normal: np.ndarray
    place: np.ndarray
    corner: np.ndarray
    squares: np.ndarray
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
        return (xyz - self.place) @ self.normal

    def covers(self, xyz: np.ndarray) -> np.ndarray:
        """Tell before or behind which points, shape (n, 3), the plane has points, or beside them."""
        cells = np.floor(((xyz - self.place) @ self.axes.T - self.corner) / CELL).astype(np.int64)
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
        return make_patch(-self.normal, self.place, self.centres_of_squares(), self.area)

    def centres_of_squares(self) -> np.ndarray:
        """Return the middles of the squares that have points, shape (k, 3)."""
        rows, columns = np.nonzero(self.squares)
        places = self.corner + (np.stack([columns, rows], axis=1) + 0.5) * CELL
        return self.place + places @ self.axes


def make_patch(normal: np.ndarray, place: np.ndarray, xyz: np.ndarray, area: float) -> Patch:
    """Return the patch of a plane where points, shape (n, 3), are."""
    patch = Patch(normal, place, np.zeros(2), np.zeros((0, 0), bool), area)
    places = (xyz - place) @ patch.axes.T
    corner = places.min(axis=0) - 1.5 * CELL
    cells = np.floor((places - corner) / CELL).astype(np.int64)
    squares = np.zeros(tuple(cells.max(axis=0)[::-1] + 2), bool)
    squares[cells[:, 1], cells[:, 0]] = True
    return replace(patch, corner=corner, squares=squares)


def extract(voxels: Voxels, distance: float, most: int, smallest: float) -> list[Patch]:
    """Return the largest connected planes, each taken from what the ones before left.

    Parameters
    ----------
    voxels : Voxels
    distance : float
        ds (m).
    most : int
        Planes.
    smallest : float
        Of them (m2).
    """
    left = np.arange(len(voxels.centres))
    patches = []
    while len(patches) < most and len(left) * voxels.size**2 >= smallest:
        centres, normals = voxels.centres[left], voxels.normals[left]
        plane = best_plane(centres, normals, distance, seed=len(patches))
        if plane is None:
            break
        # A plane leans on what is far from its main part more than on that.
        compact = _own(*plane, centres, normals, distance, 0)
        plane = refit(centres[compact], *plane, SHARP * distance, normals[compact])
        near = np.abs((centres - plane[1]) @ plane[0]) <= distance
        own = _own(*plane, centres, normals, distance, BRIDGED)
        area = float(own.sum() * voxels.size**2)
        if area < smallest:
            break
        patches.append(make_patch(*plane, centres[own], area))
        # Corners of the same surface, where normals are mixed, would come back as slivers.
        left = left[~(own | (near & patches[-1].covers(centres)))]
    return patches


def _own(
    normal: np.ndarray,
    place: np.ndarray,
    centres: np.ndarray,
    normals: np.ndarray,
    distance: float,
    bridged: int,
) -> np.ndarray:
    """Tell which cubes are on a plane, in the largest part of it over gaps of so many empty squares."""
    own = (np.abs((centres - place) @ normal) <= distance) & (np.abs(normals @ normal) >= NORMAL)
    own[own] = _largest_part(normal, place, centres[own], bridged)
    return own


def _largest_part(normal: np.ndarray, place: np.ndarray, centres: np.ndarray, bridged: int) -> np.ndarray:
    """Tell which points, shape (n, 3), are in the largest connected part of them."""
    if not len(centres):
        return np.zeros(0, bool)
    squares = make_patch(normal, place, centres, 0.0)
    # A part reaches half a gap further on either side.
    reach = bridged // 2
    closed = np.pad(squares.squares, reach)
    if reach:
        closed = ndimage.binary_dilation(closed, iterations=reach)
    parts, _ = ndimage.label(closed, np.ones((3, 3)))
    parts = parts[reach : parts.shape[0] - reach, reach : parts.shape[1] - reach]
    cells = np.floor(((centres - place) @ squares.axes.T - squares.corner) / CELL).astype(np.int64)
    own = parts[cells[:, 1], cells[:, 0]]
    return own == np.argmax(np.bincount(own))
