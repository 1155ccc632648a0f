"""Similarity transformations of points, without loss of digits."""

from dataclasses import dataclass

import numpy as np


def product(vectors: np.ndarray, linear: np.ndarray) -> np.ndarray:
    """Return the matrix `linear`, shape (3, 3), times each of `vectors`, shape (n, 3)."""
    # Column by column: how a product of matrices rounds may depend on how the chunks are cut.
    return vectors[:, :1] * linear[:, 0] + vectors[:, 1:2] * linear[:, 1] + vectors[:, 2:] * linear[:, 2]


@dataclass(frozen=True)
class Motion:
    """A similarity transformation about an origin on either side, so that no digits are lost.

    Attributes
    ----------
    linear, rotation : ndarray, shape (3, 3)
        m R and R.
    origin, offset : ndarray, shape (3,)
        Whole metres near the points, before and after.
    shift : ndarray, shape (3,)
        Where `origin` comes to lie, relative to `offset`.
    """

    linear: np.ndarray
    rotation: np.ndarray
    origin: np.ndarray
    offset: np.ndarray
    shift: np.ndarray

    @classmethod
    def about(cls, matrix: np.ndarray, middle: np.ndarray) -> "Motion":
        """Return the motion of `matrix`, shape (4, 4), for points around `middle`, shape (3,)."""
        linear, origin = matrix[:3, :3], np.floor(middle)
        moved = linear @ origin + matrix[:3, 3]
        offset = np.floor(moved)
        rotation = linear / np.cbrt(np.linalg.det(linear))
        return cls(linear, rotation, origin, offset, moved - offset)

    def positions(self, xyz: np.ndarray) -> np.ndarray:
        """Return the moved points, given relative to `origin`, relative to `offset`; shape (n, 3)."""
        return product(xyz, self.linear) + self.shift

    def directions(self, normals: np.ndarray) -> np.ndarray:
        """Return rotated vectors, shape (n, 3)."""
        return product(normals, self.rotation)
