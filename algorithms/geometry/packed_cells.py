"""The cells of a grid in space as one integer each, and sums over the cells."""

import numpy as np

BITS = 21
"""Of the number of a cell along each axis."""

HALF_RANGE = 1 << (BITS - 1)
"""Cells on either side of the origin that an integer can hold: a million, 20 km at 2 cm."""


def packed(numbers: np.ndarray) -> np.ndarray:
    """Return one integer for three whole numbers, shape (n, 3); neighbours in z have neighbouring ones."""
    x, y, z = (numbers.astype(np.int64) + HALF_RANGE).T
    return (x << 2 * BITS) | (y << BITS) | z


def unpacked(keys: np.ndarray) -> np.ndarray:
    """Return the three whole numbers, shape (n, 3), of packed integers."""
    mask = (1 << BITS) - 1
    return np.column_stack([keys >> 2 * BITS, (keys >> BITS) & mask, keys & mask]) - HALF_RANGE


def summed(keys: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return each key once, ascending, with the sum of its values, shape (n, k)."""
    if not len(keys):
        return keys, values
    order = np.argsort(keys, kind="stable")
    keys = keys[order]
    first = np.flatnonzero(np.r_[True, keys[1:] != keys[:-1]])
    return keys[first], np.add.reduceat(values[order], first, axis=0)
