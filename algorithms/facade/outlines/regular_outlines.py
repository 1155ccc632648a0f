"""Turn the border of a detail into a rectangle or an arch, where it is one."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from shapely.geometry import Polygon

from ...geometry.circles import fit_circle_on_axis
from ...geometry.robust import sigma_about_median, sigma_of_residuals, tukey_weights
from ..elevation import ARCH, FREE, RECTANGLE, Edges
from .border import Border

ROUNDS = 8
CUT = 4.685
"""Of Tukey's biweight, in standard deviations."""

CORNER = 2.0
"""Places nearer to a corner than this many gaps belong to no side; there the border is rounded."""

TOLERANCE = 1.8
"""A shape holds if the rms of the places against it is at most this many times what is expected."""

FLOOR = 0.002
"""What is never measured better, whatever the gap: the noise of the points (m)."""

OUTLIERS = 0.15
"""Largest share of places that may lie off a shape, where something hides its border."""

FAR = 4.0
"""Expected deviations beyond which a place lies off."""

ARC_POINTS = 49
"""Corners of the polygon that stands for an arch."""

SCATTERED = 1.5
"""Scatter along an edge is estimated from few places; so much of it counts, lest chance look like a rest."""

GAIN = 0.8
"""An arch is taken for a rectangle unless it lowers the rms to this share."""


@dataclass(frozen=True)
class Outline:
    """The outline of a detail.

    Attributes
    ----------
    shape : str
    polygon : Polygon
    edges : Edges
    rms : float
        Of the places of the border against the outline (m).
    """

    shape: str
    polygon: Polygon
    edges: Edges
    rms: float


@dataclass(frozen=True)
class _Sides:
    """Left, bottom, right, top, and the height of the springing and the radius of an arch."""

    left: float
    bottom: float
    right: float
    top: float
    centre: Optional[float] = None
    radius: Optional[float] = None

    @property
    def springing(self) -> float:
        """Where the upright sides end."""
        if self.radius is None:
            return self.top
        half = 0.5 * (self.right - self.left)
        return self.centre + np.sqrt(max(self.radius**2 - half**2, 0.0))

    def distances(self, places: np.ndarray) -> np.ndarray:
        """Return the distances of places to the four sides, shape (k, 4), positive outwards."""
        u, v = places.T
        if self.radius is None:
            top = v - self.top
        else:
            top = np.hypot(u - 0.5 * (self.left + self.right), v - self.centre) - self.radius
        return np.stack([self.left - u, self.bottom - v, u - self.right, top], axis=1)

    def polygon(self) -> Polygon:
        """Return the outline."""
        foot = [(self.left, self.bottom), (self.right, self.bottom)]
        if self.radius is None:
            return Polygon([*foot, (self.right, self.top), (self.left, self.top)])
        middle, half = 0.5 * (self.left + self.right), 0.5 * (self.right - self.left)
        rise = np.arctan2(self.springing - self.centre, half)
        turns = np.linspace(rise, np.pi - rise, ARC_POINTS)
        arc = np.stack(
            [middle + self.radius * np.cos(turns), self.centre + self.radius * np.sin(turns)], axis=1
        )
        return Polygon([*foot, *arc])


def make_outline(border: Border, regularise: bool) -> Outline:
    """Return the outline of a detail: regular if asked for and if the border allows, else as it was seen.

    Parameters
    ----------
    border : Border
    regularise : bool
    """
    if regularise:
        expected = np.hypot(border.gaps / np.sqrt(12), FLOOR)
        found = [(shape, sides) for shape, sides in _candidates(border) if _holds(sides, border, expected)]
        if found:
            rms = [_rms(sides, border, expected) for _, sides in found]
            best = 1 if len(found) > 1 and rms[1] < GAIN * rms[0] else 0
            shape, sides = found[best]
            return Outline(shape, sides.polygon(), _side_deviations(sides, border), rms[best])
    return _free(border)


def _candidates(border: Border) -> list[tuple[str, _Sides]]:
    rectangle = _fit_rectangle(border)
    arch = _fit_arch(border, rectangle)
    return [(RECTANGLE, rectangle)] + ([(ARCH, arch)] if arch else [])


def _fit_rectangle(border: Border) -> _Sides:
    sides = _Sides(*border.ring.bounds)
    for _ in range(ROUNDS):
        sides = _moved(sides, border)
    return sides


def _moved(sides: _Sides, border: Border) -> _Sides:
    """Return the sides, each where the places near it are."""
    nearest, _ = _assign(sides, border)
    u, v = border.places.T
    old = (sides.left, sides.bottom, sides.right, sides.top)
    new = [
        _location(values[nearest == side], position)
        for side, (values, position) in enumerate(zip((u, v, u, v), old))
    ]
    if sides.radius is None:
        return _Sides(*new)
    return _Sides(*new[:3], sides.top, sides.centre, sides.radius)


def _assign(sides: _Sides, border: Border) -> tuple[np.ndarray, np.ndarray]:
    """Return the number of the nearest side of each place, -1 at corners, and its distance to it."""
    distances = sides.distances(border.places)
    if sides.radius is not None:
        below = border.places[:, 1] < sides.springing
        distances[below, 3] = np.inf
        distances[~below, 0] = distances[~below, 2] = np.inf
    magnitudes = np.abs(distances)
    nearest = np.argmin(magnitudes, axis=1)
    own = np.take_along_axis(distances, nearest[:, None], axis=1)[:, 0]
    second = np.partition(magnitudes, 1, axis=1)[:, 1]
    return np.where(second < CORNER * border.gaps, -1, nearest), own


def _location(values: np.ndarray, fallback: float) -> float:
    """Return a robust mean of values, by Tukey's biweight; `fallback` if there are none."""
    if not len(values):
        return fallback
    middle = float(np.median(values))
    for _ in range(ROUNDS):
        scale = max(sigma_of_residuals(values - middle), 1e-4)
        weights = tukey_weights(values - middle, scale, CUT)
        middle = float(np.average(values, weights=weights))
    return middle


def _fit_arch(border: Border, rectangle: _Sides) -> Optional[_Sides]:
    """Return upright sides under a semicircle or a flatter arc; None if no arc fits into the border."""
    half = 0.5 * (rectangle.right - rectangle.left)
    middle = 0.5 * (rectangle.left + rectangle.right)
    height = rectangle.top - rectangle.bottom
    if half <= 0 or height <= 0:
        return None
    top = border.ring.bounds[3]
    sides = _Sides(rectangle.left, rectangle.bottom, rectangle.right, top, top - half, half)
    for _ in range(ROUNDS):
        sides = _moved(sides, border)
        half, middle = 0.5 * (sides.right - sides.left), 0.5 * (sides.left + sides.right)
        upper = border.places[border.places[:, 1] > sides.springing + CORNER * np.median(border.gaps)]
        if len(upper) < 3:
            return None
        crown = _location(upper[np.abs(upper[:, 0] - middle) < 0.1 * half, 1], top)
        start = np.array([sides.centre, max(sides.radius, half)])
        centre, radius = fit_circle_on_axis(upper, middle, start, FLOOR)
        if radius < half:
            # The upright sides end where the semicircle of their own width does.
            centre, radius = crown - half, half
        sides = _Sides(sides.left, sides.bottom, sides.right, centre + radius, centre, radius)
    return sides if sides.springing > sides.bottom else None


def _holds(sides: _Sides, border: Border, expected: np.ndarray) -> bool:
    nearest, own = _assign(sides, border)
    deviations = np.abs(own) / expected
    if not {0, 1, 2, 3} <= set(nearest.tolist()) and len(deviations) < 4:
        return False
    off = deviations > FAR
    within = deviations[~off]
    return bool(np.mean(off) <= OUTLIERS and len(within) and np.sqrt(np.mean(within**2)) <= TOLERANCE)


def _rms(sides: _Sides, border: Border, expected: np.ndarray) -> float:
    _, own = _assign(sides, border)
    near = np.abs(own) <= FAR * expected
    return float(np.sqrt(np.mean(own[near] ** 2))) if near.any() else float(np.sqrt(np.mean(own**2)))


def _side_deviations(sides: _Sides, border: Border) -> Edges:
    nearest, own = _assign(sides, border)
    left, bottom, right, top = (
        edge_deviation(own[nearest == side], border.places[nearest == side], border.gaps[nearest == side])
        for side in range(4)
    )
    return Edges(left, right, bottom, top)


def edge_deviation(residuals: np.ndarray, places: np.ndarray, gaps: np.ndarray) -> float:
    """Return the standard deviation of where an edge lies (m); nan if nothing was seen of it.

    The border lies anywhere within the gap. What of that shows as scatter along the edge averages out; the
    rest, as where a line of the scan runs along the edge, does not.

    Parameters
    ----------
    residuals, gaps : ndarray of float64, shape (k,)
    places : ndarray of float64, shape (k, 2)
    """
    if len(residuals) < 2:
        return float("nan")
    gap = float(np.median(gaps))
    scatter = float(sigma_about_median(residuals)) ** 2
    unseen = max(gap**2 / 12 - SCATTERED * scatter, 0.0)
    length = float(np.hypot(*np.ptp(places, axis=0)))
    independent = max(min(length / max(gap, 1e-6), len(residuals)) / 2, 1.0)
    return float(np.sqrt(unseen + (scatter + FLOOR**2) / independent))


def _free(border: Border) -> Outline:
    """Return the outline as it was seen, without the scatter of single points."""
    polygon = border.ring.simplify(0.5 * float(np.median(border.gaps)))
    left, bottom, right, top = border.ring.bounds
    u, v = border.places.T
    reach = CORNER * float(np.median(border.gaps))
    sides = (
        (u - left, border.places),
        (v - bottom, border.places),
        (right - u, border.places),
        (top - v, border.places),
    )
    found = [
        edge_deviation(away[away < reach], places[away < reach], border.gaps[away < reach])
        for away, places in sides
    ]
    return Outline(FREE, polygon, Edges(found[0], found[2], found[1], found[3]), 0.0)
