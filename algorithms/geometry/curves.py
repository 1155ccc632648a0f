"""Lines and arcs that run from a start to an end: faces and centrelines of walls."""

from dataclasses import dataclass, replace
from typing import Optional, Union

import numpy as np


def left_of(direction: np.ndarray) -> np.ndarray:
    """Return the directions to the left of directions, shape (..., 2)."""
    return np.stack([-direction[..., 1], direction[..., 0]], axis=-1)


@dataclass(frozen=True)
class Line:
    """A straight line.

    Attributes
    ----------
    point : ndarray, shape (2,)
        Stations are counted from here.
    direction : ndarray, shape (2,)
        Unit vector. The wall of which it is a face is to the left.
    """

    point: np.ndarray
    direction: np.ndarray

    radius = None

    def station(self, xy: np.ndarray) -> np.ndarray:
        """Return how far along the line points (n, 2) are, metres."""
        return (xy - self.point) @ self.direction

    def offset(self, xy: np.ndarray) -> np.ndarray:
        """Return how far to the left of the line points (n, 2) are, metres."""
        return (xy - self.point) @ left_of(self.direction)

    def distances(self, xy: np.ndarray) -> np.ndarray:
        """Return how far from the line points (n, 2) are, metres."""
        return np.abs(self.offset(xy))

    def ends(self, row: np.ndarray) -> np.ndarray:
        """Return the stations of the first and the last of a row of points."""
        return self.station(row[[0, -1]])

    def at(self, station: np.ndarray) -> np.ndarray:
        """Return the points at stations."""
        return self.point + np.multiply.outer(station, self.direction)

    def foot(self, point: np.ndarray) -> np.ndarray:
        """Return the nearest point on the line."""
        return self.at(self.station(point))

    def run(self, start: float, stop: float, chord_m: float) -> np.ndarray:
        """Return the corners of the line from one station to another; `chord_m` is for arcs."""
        return self.at(np.array([start, stop]))

    def between(self, row: np.ndarray, chord_m: float) -> np.ndarray:
        """Return the corners of the line from the first to the last of a row of points."""
        return np.array([self.foot(row[0]), self.foot(row[-1])])

    def heading(self, xy: np.ndarray) -> np.ndarray:
        """Return the direction of the line beside points (n, 2)."""
        return np.broadcast_to(self.direction, np.shape(xy))

    def normal(self, xy: np.ndarray) -> np.ndarray:
        """Return the direction to the left of the line beside points (n, 2)."""
        return left_of(self.heading(xy))

    def tangent(self, point: np.ndarray) -> "Line":
        """Return the line that touches this one beside a point: itself."""
        return self

    def moved(self, distance: float) -> "Line":
        """Return the line moved to its left."""
        return replace(self, point=self.point + distance * left_of(self.direction))

    def reversed(self) -> "Line":
        """Return the line as it runs the other way."""
        return replace(self, direction=-self.direction)

    def fitted(self, xy: np.ndarray, weight: np.ndarray) -> "Line":
        """Return the line of least weighted squared distances."""
        middle = weight @ xy / weight.sum()
        spread = (xy - middle).T @ ((xy - middle) * weight[:, None])
        direction = np.linalg.eigh(spread)[1][:, -1]
        return Line(middle, direction if direction @ self.direction >= 0 else -direction)


@dataclass(frozen=True)
class Arc:
    """An arc, or a circle.

    Attributes
    ----------
    centre : ndarray, shape (2,)
    radius : float
    sense : int
        1 if it runs anticlockwise, -1 if clockwise. The wall of which it is a face is to the left.
    zero : float
        Angle from which stations are counted, radians.
    """

    centre: np.ndarray
    radius: float
    sense: int
    zero: float

    def station(self, xy: np.ndarray) -> np.ndarray:
        """Return how far along the arc points (n, 2) are, metres; within half a circle of the zero."""
        x, y = np.moveaxis(xy - self.centre, -1, 0)
        angle = (np.arctan2(y, x) - self.zero + np.pi) % (2 * np.pi) - np.pi
        return self.sense * self.radius * angle

    def offset(self, xy: np.ndarray) -> np.ndarray:
        """Return how far to the left of the arc points (n, 2) are, metres."""
        return self.sense * (self.radius - np.hypot(*np.moveaxis(xy - self.centre, -1, 0)))

    def distances(self, xy: np.ndarray) -> np.ndarray:
        """Return how far from the circle points (n, 2) are, metres."""
        return np.abs(self.offset(xy))

    def ends(self, row: np.ndarray) -> np.ndarray:
        """Return the stations of the first and the last of a row of points, up to half a circle each way."""
        return np.clip(self._ends(row), -np.pi * self.radius, np.pi * self.radius)

    def _ends(self, row: np.ndarray) -> np.ndarray:
        x, y = (row - self.centre).T
        angle = self.sense * np.unwrap(np.arctan2(y, x))
        middle = len(row) // 2
        return self.station(row[middle]) + self.radius * (angle[[0, -1]] - angle[middle])

    def at(self, station: np.ndarray) -> np.ndarray:
        """Return the points at stations."""
        angle = self.zero + self.sense * np.asarray(station) / self.radius
        return self.centre + self.radius * np.stack([np.cos(angle), np.sin(angle)], axis=-1)

    def foot(self, point: np.ndarray) -> np.ndarray:
        """Return the nearest point on the circle."""
        return self.centre + self.radius * self._ray(point)

    def run(self, start: float, stop: float, chord_m: float) -> np.ndarray:
        """Return the corners of the arc from one station to another, its chords within `chord_m` of it."""
        step = 2 * np.sqrt(2 * chord_m * self.radius)
        return self.at(np.linspace(start, stop, max(int(np.ceil(abs(stop - start) / step)), 1) + 1))

    def between(self, row: np.ndarray, chord_m: float) -> np.ndarray:
        """Return the corners of the arc from the first to the last of a row of points."""
        start, stop = self._ends(row)
        return self.run(start, stop, chord_m)

    def heading(self, xy: np.ndarray) -> np.ndarray:
        """Return the direction of the arc beside points (n, 2)."""
        return self.sense * left_of(self._ray(xy))

    def normal(self, xy: np.ndarray) -> np.ndarray:
        """Return the direction to the left of the arc beside points (n, 2)."""
        return left_of(self.heading(xy))

    def tangent(self, point: np.ndarray) -> Line:
        """Return the line that touches the arc beside a point."""
        return Line(self.foot(point), self.heading(point))

    def moved(self, distance: float) -> "Arc":
        """Return the arc moved to its left."""
        return replace(self, radius=self.radius - self.sense * distance)

    def reversed(self) -> "Arc":
        """Return the arc as it runs the other way."""
        return replace(self, sense=-self.sense)

    def fitted(self, xy: np.ndarray, weight: np.ndarray) -> "Arc":
        """Return the arc one step of Gauss and Newton nearer to least weighted squared distances."""
        ray = xy - self.centre
        distance = np.linalg.norm(ray, axis=1)
        model = np.column_stack([ray / distance[:, None], np.ones(len(xy))])
        root = np.sqrt(weight)
        step = np.linalg.lstsq(model * root[:, None], (distance - self.radius) * root, rcond=None)[0]
        return replace(self, centre=self.centre + step[:2], radius=self.radius + step[2])

    def _ray(self, xy: np.ndarray) -> np.ndarray:
        """Return the unit vectors from the centre to points (n, 2)."""
        ray = xy - self.centre
        return ray / np.linalg.norm(ray, axis=-1, keepdims=True)


Curve = Union[Line, Arc]


def line_through(xy: np.ndarray) -> Line:
    """Return the line of least squared distances from a row of points, shape (n, 2), in their order."""
    return Line(xy.mean(axis=0), xy[-1] - xy[0]).fitted(xy, np.ones(len(xy)))


def crossing(one: Curve, other: Curve, near: np.ndarray) -> Optional[np.ndarray]:
    """Return the point that two curves share nearest to a point; None if they do not meet there.

    Newton's method: two steps suffice for lines, and a few for arcs.
    """
    point = np.array(near, float)
    for _ in range(8):
        across = np.stack([left_of(one.heading(point)), left_of(other.heading(point))])
        if abs(np.linalg.det(across)) < 1e-3:
            return None
        point = point - np.linalg.solve(across, [one.offset(point), other.offset(point)])
    return point if max(abs(one.offset(point)), abs(other.offset(point))) < 1e-6 else None
