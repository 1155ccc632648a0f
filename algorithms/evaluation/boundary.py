"""The boundary of walls in short pieces, and their distances from another boundary."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy.spatial import cKDTree
from shapely.geometry.base import BaseGeometry
from shapely.geometry.polygon import orient

from ..errors import InputError
from .settings import ComparisonSettings


class Pieces(NamedTuple):
    """A boundary in pieces.

    Attributes
    ----------
    starts, ends : ndarray, shape (n, 2)
        In order along each line, polygons on their left; metres.
    line : ndarray of int, shape (n,)
        Which line of the boundary a piece belongs to.
    """

    starts: np.ndarray
    ends: np.ndarray
    line: np.ndarray

    @property
    def middles(self) -> np.ndarray:
        """Of the pieces, shape (n, 2), metres."""
        return (self.starts + self.ends) / 2

    @property
    def directions(self) -> np.ndarray:
        """Of the pieces, shape (n,), degrees from the x axis, from 0 to 180."""
        along = self.ends - self.starts
        return np.degrees(np.arctan2(along[:, 1], along[:, 0])) % 180

    def chosen(self, selection: np.ndarray) -> "Pieces":
        """Return the pieces of a selection, ndarray of bool, shape (n,)."""
        return Pieces(self.starts[selection], self.ends[selection], self.line[selection])


@dataclass(frozen=True)
class Boundary:
    """A boundary in pieces, and how far each is from the other boundary.

    Attributes
    ----------
    pieces : Pieces
    offsets : ndarray, shape (n,)
        Distance of the middle of each piece from the other boundary, metres; infinite if that is empty.
    """

    pieces: Pieces
    offsets: np.ndarray

    @property
    def lengths(self) -> np.ndarray:
        """Of the pieces, shape (n,), metres."""
        return np.hypot(*(self.pieces.ends - self.pieces.starts).T)

    def share_within(self, tolerance: float) -> float:
        """Return the share of the length that is within `tolerance` of the other boundary; 0 of nothing."""
        total = self.lengths.sum()
        return float(self.lengths[self.offsets <= tolerance].sum() / total) if total else 0.0

    def quantile(self, share: float, tolerance: float) -> float:
        """Return the offset that `share` of the length within `tolerance` does not exceed; nan of nothing."""
        within = self.offsets <= tolerance
        if not within.any():
            return float("nan")
        order = np.argsort(self.offsets[within])
        way = np.cumsum(self.lengths[within][order])
        return float(self.offsets[within][order][np.searchsorted(way, share * way[-1])])


def cut_boundary(
    shape: BaseGeometry, step_m: float, most_pieces: int = ComparisonSettings.most_pieces
) -> Pieces:
    """Return the boundary of polygons, or lines, in pieces of at most `step_m`.

    Raises
    ------
    InputError
        If there would be more than `most_pieces`.
    """
    if shape.length / step_m > most_pieces:
        raise InputError(
            f"The outlines are {shape.length / 1000:.0f} km long, more than "
            f"{most_pieces * step_m / 1000:.0f} km; choose the walls of one site, and check "
            "that their coordinates are metres."
        )
    corners = [np.asarray(line.coords)[:, :2] for line in _lines(shape) if not line.is_empty]
    if not corners:
        return Pieces(np.empty((0, 2)), np.empty((0, 2)), np.empty(0, dtype=int))
    starts = np.concatenate([line[:-1] for line in corners])
    along = np.concatenate([np.diff(line, axis=0) for line in corners])
    number = np.repeat(np.arange(len(corners)), [len(line) - 1 for line in corners])
    count = np.ceil(np.hypot(*along.T) / step_m).astype(int)
    step = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    starts, along, number, count = (
        np.repeat(array, count, axis=0) for array in (starts, along, number, count)
    )
    first, last = (step / count)[:, None], ((step + 1) / count)[:, None]
    return Pieces(starts + along * first, starts + along * last, number)


def measure_boundary(asked: Pieces, given: Pieces, settings: ComparisonSettings) -> Boundary:
    """Return the asked pieces with their distances from the nearest of the given ones."""
    return Boundary(asked, _distances(asked, given, settings.neighbours))


def distances_along(asked: Pieces, given: Pieces, search_m: float, angle_deg: float) -> np.ndarray:
    """Return the distances of asked pieces from the nearest given ones of about the same direction.

    Parameters
    ----------
    asked, given : Pieces
    search_m : float
        Farther pieces are not found.
    angle_deg : float
        Pieces whose directions differ more do not count.

    Returns
    -------
    ndarray, shape (n,)
        Metres; infinite if there is no such piece.
    """
    distances = np.full(len(asked.starts), np.inf)
    if not len(given.starts):
        return distances
    along = given.ends - given.starts
    longest = float(np.hypot(*along.T).max())
    middles, angles, others = asked.middles, asked.directions, given.directions
    near = cKDTree(given.middles).query_ball_point(middles, search_m + longest / 2)
    for row, candidates in enumerate(near):
        rows = np.array(candidates, dtype=int)
        turned = np.abs(others[rows] - angles[row])
        rows = rows[np.minimum(turned, 180 - turned) <= angle_deg]
        if len(rows):
            away = middles[row] - given.starts[rows]
            share = np.clip((away * along[rows]).sum(axis=1) / (along[rows] ** 2).sum(axis=1), 0, 1)
            distances[row] = np.hypot(*(away - share[:, None] * along[rows]).T).min()
    return np.where(distances <= search_m, distances, np.inf)


def _lines(shape: BaseGeometry) -> Iterator[BaseGeometry]:
    for part in getattr(shape, "geoms", [shape]):
        if part.area:
            polygon = orient(part)
            yield from (polygon.exterior, *polygon.interiors)
        else:
            yield part


def _distances(asked: Pieces, given: Pieces, neighbours: int) -> np.ndarray:
    """Return how far the middles of the asked pieces are from the nearest of the given ones."""
    middles = asked.middles
    starts, ends, _ = given
    if len(starts) == 0 or len(middles) == 0:
        return np.full(len(middles), np.inf)
    neighbours = min(neighbours, len(starts))
    _, near = cKDTree((starts + ends) / 2).query(middles, neighbours)
    near = near.reshape(len(middles), neighbours)
    along = (ends - starts)[near]
    from_start = middles[:, None] - starts[near]
    share = np.clip(np.sum(from_start * along, axis=2) / np.sum(along**2, axis=2), 0, 1)
    return np.linalg.norm(from_start - share[..., None] * along, axis=2).min(axis=1)
