"""Lines and arcs through points of a centreline."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

SAGITTA = 0.001
"""How far an arc may lie off the chords it is drawn with, in metres."""


@dataclass(frozen=True)
class Line:
    """A straight line through `point`, along the unit vector `direction`; arrays of shape (2,)."""

    point: np.ndarray
    direction: np.ndarray

    radius = None

    def distances(self, points: np.ndarray) -> np.ndarray:
        """Return how far points, shape (n, 2), lie off."""
        return np.abs((points - self.point) @ self.normal(self.point))

    def normal(self, point: np.ndarray) -> np.ndarray:
        """Return the unit vector across the curve beside a point."""
        return np.array([-self.direction[1], self.direction[0]])

    def tangent(self, point: np.ndarray) -> "Line":
        """Return the line that goes on where the curve passes a point."""
        return self

    def foot(self, point: np.ndarray) -> np.ndarray:
        """Return the nearest point on the curve."""
        return self.point + (point - self.point) @ self.direction * self.direction

    def between(self, points: np.ndarray) -> np.ndarray:
        """Return the corners of the curve, shape (m, 2), from the first to the last of ordered points."""
        return np.array([self.foot(points[0]), self.foot(points[-1])])


@dataclass(frozen=True)
class Arc:
    """A circle with its centre, shape (2,), and its radius, metres."""

    centre: np.ndarray
    radius: float

    def distances(self, points: np.ndarray) -> np.ndarray:
        """Return how far points, shape (n, 2), lie off."""
        return np.abs(np.linalg.norm(points - self.centre, axis=1) - self.radius)

    def normal(self, point: np.ndarray) -> np.ndarray:
        """Return the unit vector across the curve beside a point."""
        return (point - self.centre) / np.linalg.norm(point - self.centre)

    def tangent(self, point: np.ndarray) -> Line:
        """Return the line that goes on where the curve passes a point."""
        x, y = self.normal(point)
        return Line(self.foot(point), np.array([-y, x]))

    def foot(self, point: np.ndarray) -> np.ndarray:
        """Return the nearest point on the curve."""
        return self.centre + self.radius * self.normal(point)

    def between(self, points: np.ndarray) -> np.ndarray:
        """Return the corners of the curve, shape (m, 2), from the first to the last of ordered points."""
        turns = np.unwrap(np.arctan2(*(points - self.centre).T[::-1]))
        step = 2 * np.arccos(1 - min(SAGITTA / self.radius, 0.5))
        turns = np.linspace(turns[0], turns[-1], max(int(np.ceil(abs(turns[-1] - turns[0]) / step)), 1) + 1)
        return self.centre + self.radius * np.column_stack([np.cos(turns), np.sin(turns)])


def fit_line(points: np.ndarray) -> Line:
    """Return the line of least squared distances from points, shape (n, 2), n >= 2."""
    middle = points.mean(axis=0)
    axes = np.linalg.svd(points - middle, full_matrices=False)[2]
    forward = axes[0] if (points[-1] - points[0]) @ axes[0] >= 0 else -axes[0]
    return Line(middle, forward)


def fit_arc(points: np.ndarray) -> Optional[Arc]:
    """Return the circle through points, shape (n, 2), by Kasa's fit; None if they lie on a line."""
    middle = points.mean(axis=0)
    local = points - middle
    unknowns, _, rank, _ = np.linalg.lstsq(
        np.column_stack([2 * local, np.ones(len(local))]), (local**2).sum(axis=1), rcond=1e-9
    )
    if rank < 3:
        return None
    return Arc(middle + unknowns[:2], float(np.sqrt(unknowns[2] + unknowns[:2] @ unknowns[:2])))
