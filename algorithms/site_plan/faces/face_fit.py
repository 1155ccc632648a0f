"""Faces of walls: straight or round, fitted to voxels so that a few strangers do no harm."""

from dataclasses import dataclass, replace
from typing import Optional, Union

import numpy as np

WIDE = 0.05
"""Voxels farther than this (m) from a face belong to another; thin walls are twice as thick."""

LEAST_SCATTER = 0.002
"""Smallest standard deviation (m) that voxels about a face are taken to have."""

TUKEY = 3.0
"""Voxels farther than this many standard deviations have no weight (Beaton and Tukey 1974); their 4.7 is for
few observations, and lets more strangers in."""

ROUNDS = 12

CHORD = 0.002
"""Largest distance (m) of a polygon from the arc that it stands for."""


@dataclass(frozen=True)
class Line:
    """A straight face.

    Attributes
    ----------
    point : ndarray, shape (2,)
    direction : ndarray, shape (2,)
        Unit vector, along the outline; the wall is to the left.
    """

    point: np.ndarray
    direction: np.ndarray

    def place(self, xy: np.ndarray) -> np.ndarray:
        """Return how far along the face places (n, 2) are, metres."""
        return (xy - self.point) @ self.direction

    def offset(self, xy: np.ndarray) -> np.ndarray:
        """Return how far to the left of the face, towards the wall's core, places (n, 2) are, metres."""
        return (xy - self.point) @ _left(self.direction)

    def ends(self, row: np.ndarray) -> np.ndarray:
        """Return the places of the first and the last of a row of points."""
        return self.place(row[[0, -1]])

    def at(self, place: np.ndarray) -> np.ndarray:
        """Return the points at places along the face."""
        return self.point + np.multiply.outer(place, self.direction)

    def run(self, start: float, stop: float) -> np.ndarray:
        """Return a line of corners from one place along the face to another."""
        return self.at(np.array([start, stop]))

    def heading(self, xy: np.ndarray) -> np.ndarray:
        """Return the direction of the face beside places (n, 2)."""
        return np.broadcast_to(self.direction, np.shape(xy))

    def moved(self, distance: float) -> "Line":
        """Return the face moved to its left."""
        return replace(self, point=self.point + distance * _left(self.direction))

    def reversed(self) -> "Line":
        """Return the face as seen from its other side."""
        return replace(self, direction=-self.direction)

    def fitted(self, xy: np.ndarray, weight: np.ndarray) -> "Line":
        """Return the line of least weighted squared distances."""
        middle = weight @ xy / weight.sum()
        spread = (xy - middle).T @ ((xy - middle) * weight[:, None])
        direction = np.linalg.eigh(spread)[1][:, -1]
        return Line(middle, direction if direction @ self.direction >= 0 else -direction)


@dataclass(frozen=True)
class Arc:
    """A round face.

    Attributes
    ----------
    centre : ndarray, shape (2,)
    radius : float
    turn : int
        1 if the outline runs anticlockwise, the wall inside; -1 if clockwise, the wall around.
    zero : float
        Angle at which places along the arc are counted from, radians.
    """

    centre: np.ndarray
    radius: float
    turn: int
    zero: float

    def place(self, xy: np.ndarray) -> np.ndarray:
        """Return how far along the face places (n, 2) are, metres; within half a turn of the zero."""
        x, y = np.moveaxis(xy - self.centre, -1, 0)
        angle = (np.arctan2(y, x) - self.zero + np.pi) % (2 * np.pi) - np.pi
        return self.turn * self.radius * angle

    def offset(self, xy: np.ndarray) -> np.ndarray:
        """Return how far to the left of the face, towards the wall's core, places (n, 2) are, metres."""
        return self.turn * (self.radius - np.hypot(*np.moveaxis(xy - self.centre, -1, 0)))

    def ends(self, row: np.ndarray) -> np.ndarray:
        """Return the places of the first and the last of a row of points; at most half a turn each way."""
        x, y = (row - self.centre).T
        angle = self.turn * np.unwrap(np.arctan2(y, x))
        middle = len(row) // 2
        ends = self.place(row[middle]) + self.radius * (angle[[0, -1]] - angle[middle])
        return np.clip(ends, -np.pi * self.radius, np.pi * self.radius)

    def at(self, place: np.ndarray) -> np.ndarray:
        """Return the points at places along the face."""
        angle = self.zero + self.turn * np.asarray(place) / self.radius
        return self.centre + self.radius * np.stack([np.cos(angle), np.sin(angle)], axis=-1)

    def run(self, start: float, stop: float) -> np.ndarray:
        """Return a line of corners from one place along the face to another, near the arc by `CHORD`."""
        step = 2 * np.sqrt(2 * CHORD * self.radius)
        return self.at(np.linspace(start, stop, max(int(np.ceil(abs(stop - start) / step)), 1) + 1))

    def heading(self, xy: np.ndarray) -> np.ndarray:
        """Return the direction of the face beside places (n, 2)."""
        ray = xy - self.centre
        return self.turn * _left(ray / np.linalg.norm(ray, axis=-1, keepdims=True))

    def moved(self, distance: float) -> "Arc":
        """Return the face moved to its left."""
        return replace(self, radius=self.radius - self.turn * distance)

    def reversed(self) -> "Arc":
        """Return the face as seen from its other side."""
        return replace(self, turn=-self.turn)

    def fitted(self, xy: np.ndarray, weight: np.ndarray) -> "Arc":
        """Return the circle one step of Gauss and Newton nearer to least weighted squared distances."""
        ray = xy - self.centre
        distance = np.linalg.norm(ray, axis=1)
        model = np.column_stack([ray / distance[:, None], np.ones(len(xy))])
        root = np.sqrt(weight)
        step = np.linalg.lstsq(model * root[:, None], (distance - self.radius) * root, rcond=None)[0]
        return replace(self, centre=self.centre + step[:2], radius=self.radius + step[2])


Curve = Union[Line, Arc]


@dataclass(frozen=True)
class Fit:
    """A face as fitted.

    Attributes
    ----------
    curve : Line or Arc
    rms : float
        Of the voxels about it, metres.
    reach : float
        Voxels up to this far from it belong to it, metres.
    """

    curve: Curve
    rms: float
    reach: float


def first_line(xy: np.ndarray) -> Line:
    """Return the line through a row of points, shape (n, 2), in their order."""
    return Line(xy.mean(axis=0), xy[-1] - xy[0]).fitted(xy, np.ones(len(xy)))


def first_arc(xy: np.ndarray) -> Arc:
    """Return the circle through a row of points, shape (n, 2), in their order (Kasa 1976)."""
    middle = xy.mean(axis=0)
    local = xy - middle
    square = (local**2).sum(axis=1)
    a, b, c = np.linalg.lstsq(np.column_stack([local, np.ones(len(xy))]), square, rcond=None)[0]
    centre = np.array([a, b]) / 2
    sides = np.diff(local - centre, axis=0)
    rays = (local[:-1] + local[1:]) / 2 - centre
    turn = 1 if (rays[:, 0] * sides[:, 1] - rays[:, 1] * sides[:, 0]).sum() > 0 else -1
    # Counted from the middle of the row, so that a row of less than a turn does not pass the cut.
    halfway = local[len(local) // 2] - centre
    radius = float(np.sqrt(c + centre @ centre))
    return Arc(centre + middle, radius, turn, float(np.arctan2(halfway[1], halfway[0])))


def fit_face(curve: Curve, xy: np.ndarray, area: np.ndarray) -> Optional[Fit]:
    """Fit a face to voxels about a first guess; iterated, with Tukey's weights.

    Parameters
    ----------
    curve : Line or Arc
        First guess, within `WIDE` of the face.
    xy : ndarray of float64, shape (n, 2)
        Means of voxels.
    area : ndarray of float64, shape (n,)
        How much of the face a voxel stands for.

    Returns
    -------
    Fit or None
        None if hardly any voxel is near.
    """
    for _ in range(ROUNDS):
        offset = curve.offset(xy)
        near = np.abs(offset) < WIDE
        if near.sum() < 3 or area[near].sum() <= 0:
            return None
        scatter = max(1.4826 * _median(np.abs(offset[near]), area[near]), LEAST_SCATTER)
        weight = np.where(near, np.maximum(1 - (offset / (TUKEY * scatter)) ** 2, 0.0) ** 2, 0.0) * area
        if np.count_nonzero(weight) < 3:
            return None
        curve = curve.fitted(xy, weight)
    offset = curve.offset(xy)
    reach = min(3 * scatter + LEAST_SCATTER, WIDE)
    used = np.abs(offset) <= reach
    return Fit(curve, float(np.sqrt(np.average(offset[used] ** 2, weights=area[used]))), reach)


def crossing(one: Curve, other: Curve, near: np.ndarray) -> Optional[np.ndarray]:
    """Return the point that two faces share nearest to a place; None if they do not meet there.

    Newton's method: two steps suffice for lines, and a few for arcs.
    """
    point = np.array(near, float)
    for _ in range(8):
        across = np.stack([_left(one.heading(point)), _left(other.heading(point))])
        if abs(np.linalg.det(across)) < 1e-3:
            return None
        point = point - np.linalg.solve(across, [one.offset(point), other.offset(point)])
    return point if max(abs(one.offset(point)), abs(other.offset(point))) < 1e-6 else None


def _left(direction: np.ndarray) -> np.ndarray:
    return np.stack([-direction[..., 1], direction[..., 0]], axis=-1)


def _median(values: np.ndarray, weight: np.ndarray) -> float:
    order = np.argsort(values)
    total = np.cumsum(weight[order])
    return float(values[order][np.searchsorted(total, total[-1] / 2)])
