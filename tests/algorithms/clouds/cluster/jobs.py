"""Functions that tests send to workers, which find them here by name."""

import time

import numpy as np


def slow(seconds):
    """Take some time."""
    time.sleep(seconds)
    return seconds


def fail(error):
    """Raise an error."""
    raise error


def higher(tile, limit):
    """Return the rows of the points from a height on, and the highest."""
    return np.flatnonzero(tile.xyz[:, 2] >= limit), tile.xyz[:, 2].max()


def highest(tile, more):
    """Return the height of the highest point, and more."""
    return int(tile.xyz[:, 2].max()) + more


def points_in(tiles, progress, keys, letter):
    """Return how many points some tiles hold."""
    return letter, sorted(keys), sum(len(tile.xyz) for _, tile in tiles.tiles(keys, progress, "Reading"))
