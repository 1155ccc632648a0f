"""The pixels of an elevation."""

from dataclasses import dataclass

import numpy as np

LEFT, RIGHT, BELOW, ABOVE = range(4)
"""The directions in which a pixel looks over the elevation."""


@dataclass(frozen=True)
class Grid:
    """Square pixels in u and v.

    Attributes
    ----------
    corner : ndarray of float64, shape (2,)
        u and v of the lower left corner.
    size : float
        Side of a pixel (m).
    shape : tuple of int
        Rows, from below, and columns.
    """

    corner: np.ndarray
    size: float
    shape: tuple[int, int]

    def cells(self, uv: np.ndarray) -> np.ndarray:
        """Return the pixel of each point, shape (n,), in the order of a flat array; -1 outside."""
        columns, rows = np.floor((uv - self.corner) / self.size).astype(np.int64).T
        inside = (rows >= 0) & (rows < self.shape[0]) & (columns >= 0) & (columns < self.shape[1])
        return np.where(inside, rows * self.shape[1] + columns, -1)

    def holds(self, cells: np.ndarray) -> np.ndarray:
        """Return which pixels hold points, as an image."""
        image = np.zeros(self.shape, bool)
        image.ravel()[cells[cells >= 0]] = True
        return image

    def centres(self, image: np.ndarray) -> np.ndarray:
        """Return the middles of the marked pixels, shape (k, 2)."""
        rows, columns = np.nonzero(image)
        return self.corner + (np.stack([columns, rows], axis=1) + 0.5) * self.size

    def edges(self, box: tuple[slice, slice]) -> np.ndarray:
        """Return left, bottom, right and top of a box of pixels (m)."""
        rows, columns = box
        low = self.corner + self.size * np.array([columns.start, rows.start])
        high = self.corner + self.size * np.array([columns.stop, rows.stop])
        return np.concatenate([low, high])


def grid_over(uv: np.ndarray, size: float, most: int) -> Grid:
    """Return pixels over all points, shape (n, 2), with one more around; larger if more than `most`."""
    low, high = uv.min(axis=0), uv.max(axis=0)
    size = max(size, float(np.sqrt(np.prod(high - low) / most)))
    columns, rows = np.floor((high - low) / size).astype(int) + 3
    return Grid(low - size, size, (int(rows), int(columns)))


def beyond(marked: np.ndarray) -> np.ndarray:
    """Return whether a marked pixel lies in each of the four directions, shape (4, rows, columns)."""
    return np.stack([_from(np.logical_or.accumulate, marked, direction) for direction in range(4)])


def first_seen(barrier: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """Return whether the first barrier in each of the four directions is wanted.

    Parameters
    ----------
    barrier, wanted : ndarray of bool, shape (rows, columns)

    Returns
    -------
    ndarray of bool, shape (4, rows, columns)
    """
    # Barriers are numbered in the direction of the look, so that the last one passed is the largest.
    seen = []
    for direction in range(4):
        passed = _from(np.add.accumulate, barrier.astype(np.int32), direction)
        order = _ordered(barrier, direction)
        values = np.concatenate([[False], _ordered(wanted, direction)[order]])
        counts = _ordered(passed, direction)
        starts = np.cumsum(order.sum(axis=1)) - order.sum(axis=1)
        result = np.where(counts > 0, values[counts + starts[:, None]], False)
        seen.append(_restored(result, direction))
    return np.stack(seen)


def _from(accumulate: np.ufunc, image: np.ndarray, direction: int) -> np.ndarray:
    return _restored(accumulate(_ordered(image, direction), axis=1), direction)


def _ordered(image: np.ndarray, direction: int) -> np.ndarray:
    """Return the image with what a pixel looks at before it in its row."""
    image = image.T if direction in (BELOW, ABOVE) else image
    return image[:, ::-1] if direction in (RIGHT, ABOVE) else image


def _restored(image: np.ndarray, direction: int) -> np.ndarray:
    image = image[:, ::-1] if direction in (RIGHT, ABOVE) else image
    return image.T if direction in (BELOW, ABOVE) else image
