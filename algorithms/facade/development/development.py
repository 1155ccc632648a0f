"""A facade that turns, rolled out into the plane that touches its middle."""

from dataclasses import dataclass, field, replace
from typing import Optional

import numpy as np

from ...errors import NothingFoundError
from ..elevation import Plane, Points
from .circles import find_circle
from .curves import Chain, Circle, Curve, axes_of
from .polygonal_walls import find_sides
from .settings import DevelopmentSettings

FLAT, SIDES, ROUND = range(3)
"""Values of UNROLL: a flat facade, the sides of a bay or a polygonal tower, a round tower."""


@dataclass(frozen=True)
class Development:
    """How a facade is rolled out.

    Attributes
    ----------
    curve : Circle or Chain
        The line of the wall in plan.
    settings : DevelopmentSettings
    """

    curve: Curve
    settings: DevelopmentSettings = field(default_factory=DevelopmentSettings)

    @property
    def radius(self) -> Optional[float]:
        """Of a round tower (m); None of sides."""
        return self.curve.radius if isinstance(self.curve, Circle) else None

    @property
    def plane(self) -> Plane:
        """The plane that touches the wall in its middle."""
        normal = np.append(axes_of(self.curve.azimuth)[1], 0.0)
        return Plane(normal, np.append(self.curve.anchor, 0.0), float("nan"), 0)

    @property
    def said(self) -> str:
        """What is rolled out, for the log."""
        if isinstance(self.curve, Circle):
            return f"A round wall with a radius of {self.curve.radius:.3f} m is rolled out."
        lengths = np.linalg.norm(np.diff(self.curve.corners, axis=0), axis=1)
        return (
            f"{len(lengths)} sides are rolled out: {', '.join(f'{length:.2f}' for length in lengths)} m long."
        )

    def flat(self, points: Points) -> Points:
        """Return the points before the wall and behind it, moved to the plane."""
        xyz = self._moved(points.xyz)
        away = (xyz - self.plane.centre) @ self.plane.normal
        behind = self.settings.behind_m
        if self.radius is not None:
            behind = min(behind, self.settings.inner * self.radius)
        kept = (away < self.settings.before_m) & (away > -behind)
        low, high = self._ends
        along = self._along(xyz[:, :2])
        kept &= (along > low - self.settings.beside_m) & (along < high + self.settings.beside_m)
        if isinstance(self.curve, Chain):
            kept &= ~self.curve.goes_on(points.xyz[:, :2], self.settings.on_line_m)
        kept = np.flatnonzero(kept)
        stations = None if points.stations is None else self._moved(points.stations)
        return replace(points.subset(kept), xyz=xyz[kept], stations=stations)

    def holds(self, xy: np.ndarray) -> bool:
        """Return whether a point in plan, shape (2,), is on the wall that is rolled out."""
        flat = self.curve.flat(xy[None])
        away = float((flat[0] - self.curve.anchor) @ axes_of(self.curve.azimuth)[1])
        low, high = self._ends
        return bool(abs(away) <= self.settings.same_m and low <= self._along(flat)[0] <= high)

    @property
    def _ends(self) -> tuple[float, float]:
        """Return where the wall begins and ends along the plane, from where it touches."""
        if isinstance(self.curve, Circle):
            half = np.pi * self.curve.radius
            return -half, half
        ends = self._along(self.curve.flat(self.curve.corners[[0, -1]]))
        return float(ends[0]), float(ends[1])

    def _along(self, flat: np.ndarray) -> np.ndarray:
        return np.asarray((flat - self.curve.anchor) @ axes_of(self.curve.azimuth)[0])

    def _moved(self, xyz: np.ndarray) -> np.ndarray:
        return np.column_stack([self.curve.flat(xyz[:, :2]), xyz[:, 2]])


def develop(
    points: Points,
    kind: int,
    wanted: Optional[Plane],
    distance: float,
    settings: DevelopmentSettings = DevelopmentSettings(),
) -> Development:
    """Return how the facade of points is rolled out.

    Parameters
    ----------
    points : Points
    kind : int
        UNROLL: `SIDES` or `ROUND`.
    wanted : Plane, optional
        About the main side of a bay or of a polygonal tower, its normal outward.
    distance : float
        ds, the largest distance of a point from its plane (m).
    settings : DevelopmentSettings

    Raises
    ------
    NothingFoundError
        If the wall does not turn like that.
    """
    if kind == ROUND:
        circle = find_circle(points.xyz, settings.circle)
        if circle is None:
            limits = settings.circle
            raise NothingFoundError(
                f"No round wall with a radius of {limits.least_radius_m:g} to {limits.largest_radius_m:g} m "
                f"was found of which {limits.least_deg:g} degrees are seen; cut the cloud to the tower, or "
                "choose another UNROLL."
            )
        return Development(circle, settings)
    chain = find_sides(points.xyz, wanted, distance, settings.sides)
    if chain is None:
        raise NothingFoundError(
            "No sides were found that meet at the facade and turn by "
            f"{settings.sides.least_deg:g} to {settings.sides.most_deg:g} degrees; choose another UNROLL."
        )
    return Development(chain, settings)
