"""Lines of walls in plan, along which a facade is rolled out into the plane that touches its middle."""

from dataclasses import dataclass, replace
from typing import Union

import numpy as np


def axes_of(azimuth: float) -> np.ndarray:
    """Return the directions to the right and outward of a wall that faces an azimuth, shape (2, 2)."""
    east, north = np.sin(np.radians(azimuth)), np.cos(np.radians(azimuth))
    return np.array([[-north, east], [east, north]])


@dataclass(frozen=True)
class Circle:
    """The wall of a round tower.

    Attributes
    ----------
    centre : ndarray of float64, shape (2,)
        x, y, relative to the origin of the points.
    radius : float
        Of its outer face (m).
    azimuth : float
        Of its middle, where the plane touches it (degrees).
    """

    centre: np.ndarray
    radius: float
    azimuth: float

    @property
    def anchor(self) -> np.ndarray:
        """Where the plane touches the wall, shape (2,)."""
        return np.asarray(self.centre + self.radius * axes_of(self.azimuth)[1])

    def moved(self, shift: np.ndarray) -> "Circle":
        """Return the circle moved by x, y."""
        return replace(self, centre=self.centre + shift)

    def flat(self, xy: np.ndarray) -> np.ndarray:
        """Return points in plan, shape (n, 2), moved to the plane: arcs are as long as they were."""
        right, out = ((xy - self.centre) @ axes_of(self.azimuth).T).T
        along, away = self.radius * np.arctan2(right, out), np.hypot(right, out) - self.radius
        return np.asarray(self.anchor + np.column_stack([along, away]) @ axes_of(self.azimuth))

    def site(self, xy: np.ndarray) -> np.ndarray:
        """Return points in the plane, shape (n, 2), moved back to the tower."""
        along, away = ((xy - self.anchor) @ axes_of(self.azimuth).T).T
        turn, distance = along / self.radius, self.radius + away
        right, out = distance * np.sin(turn), distance * np.cos(turn)
        return np.asarray(self.centre + np.column_stack([right, out]) @ axes_of(self.azimuth))


@dataclass(frozen=True)
class Chain:
    """The sides of a bay or a polygonal tower, from the left to the right as seen from outside.

    Attributes
    ----------
    corners : ndarray of float64, shape (k + 1, 2)
        x, y of the ends of the sides, relative to the origin of the points.
    main : int
        The side that keeps its position.
    """

    corners: np.ndarray
    main: int

    @property
    def azimuth(self) -> float:
        """Of the main side (degrees)."""
        east, north = self._outs[self.main]
        return float(np.degrees(np.arctan2(east, north)) % 360)

    @property
    def anchor(self) -> np.ndarray:
        """The middle of the main side, shape (2,)."""
        return np.asarray(self.corners[self.main : self.main + 2].mean(axis=0))

    @property
    def _lengths(self) -> np.ndarray:
        return np.asarray(np.linalg.norm(np.diff(self.corners, axis=0), axis=1))

    @property
    def _rights(self) -> np.ndarray:
        return np.asarray(np.diff(self.corners, axis=0) / self._lengths[:, None])

    @property
    def _outs(self) -> np.ndarray:
        right = self._rights
        return np.column_stack([right[:, 1], -right[:, 0]])

    @property
    def _starts(self) -> np.ndarray:
        """Return how far each side begins from the anchor along the wall, shape (k,)."""
        ends = np.concatenate([[0.0], np.cumsum(self._lengths)])
        return np.asarray(ends[:-1] - ends[self.main] - 0.5 * self._lengths[self.main])

    def moved(self, shift: np.ndarray) -> "Chain":
        """Return the sides moved by x, y."""
        return replace(self, corners=self.corners + shift)

    def flat(self, xy: np.ndarray) -> np.ndarray:
        """Return points in plan, shape (n, 2), moved to the plane, each with the side nearest to it."""
        sides, along, away = self._beside(xy)
        moved = np.column_stack([self._starts[sides] + along, away])
        return np.asarray(self.anchor + moved @ axes_of(self.azimuth))

    def goes_on(self, xy: np.ndarray, reach: float) -> np.ndarray:
        """Return which points in plan, shape (n, 2), are behind a side but on the line of another one.

        Such is the wall above a bay.

        Parameters
        ----------
        xy : ndarray of float64, shape (n, 2)
        reach : float
            Points this near to the line are on it (m).
        """
        sides, _, away = self._beside(xy)
        on_line = np.zeros(len(xy), bool)
        for corner, out in zip(self.corners, self._outs):
            ends = np.abs((self.corners - corner) @ out)
            # Sides on both sides of a bay are on one line.
            another = np.maximum(ends[:-1], ends[1:]) > 4 * reach
            on_line |= another[sides] & (np.abs((xy - corner) @ out) <= reach)
        # The points of the side itself scatter by less.
        return np.asarray(on_line & (away < -0.3 * reach))

    def _beside(self, xy: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the side nearest to each point, how far along it that is, and how far outward."""
        last = len(self._lengths) - 1
        best, sides = np.full(len(xy), np.inf), np.zeros(len(xy), np.int64)
        along, away = np.zeros(len(xy)), np.zeros(len(xy))
        for side in range(last + 1):
            local = xy - self.corners[side]
            own, out = local @ self._rights[side], local @ self._outs[side]
            low = -np.inf if side == 0 else 0.0
            high = np.inf if side == last else self._lengths[side]
            inside = np.clip(own, low, high)
            distance = np.hypot(own - inside, out)
            nearer = distance < best
            best[nearer], sides[nearer] = distance[nearer], side
            along[nearer], away[nearer] = inside[nearer], out[nearer]
        return sides, along, away

    def site(self, xy: np.ndarray) -> np.ndarray:
        """Return points in the plane, shape (n, 2), moved back to the sides."""
        along, away = ((xy - self.anchor) @ axes_of(self.azimuth).T).T
        sides = np.clip(np.searchsorted(self._starts, along, side="right") - 1, 0, len(self._lengths) - 1)
        return np.asarray(
            self.corners[sides]
            + (along - self._starts[sides])[:, None] * self._rights[sides]
            + away[:, None] * self._outs[sides]
        )


Curve = Union[Circle, Chain]
