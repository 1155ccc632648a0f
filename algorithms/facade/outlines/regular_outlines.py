"""Regular outlines: the border of a detail as a rectangle or an arch, where it has that shape."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from shapely.geometry import Polygon

from ...geometry.circles import fit_circle_on_axis
from ...geometry.robust import EFFICIENT_CUT, sigma_about_median, sigma_of_residuals, tukey_weights
from ..elevation import ARCH, FREE, RECTANGLE, Edges
from .border import Border
from .settings import OutlineSettings, ShapeSettings

ARC_POINTS = 49
"""Corners of the polygon that represents an arch."""


@dataclass(frozen=True)
class Outline:
    """The outline of a detail.

    Attributes
    ----------
    shape : str
    polygon : Polygon
    edges : Edges
    rms : float
        Of the crossings of the border against the outline (m).
    """

    shape: str
    polygon: Polygon
    edges: Edges
    rms: float


@dataclass(frozen=True)
class _Arc:
    """The height of the centre of an arch, and its radius."""

    centre: float
    radius: float


@dataclass(frozen=True)
class _Sides:
    """The positions of the four sides; the top is the crown of the arc if there is one."""

    left: float
    bottom: float
    right: float
    top: float
    arc: Optional[_Arc] = None

    @property
    def springing(self) -> float:
        """The height at which the upright sides end."""
        if self.arc is None:
            return self.top
        half = 0.5 * (self.right - self.left)
        return self.arc.centre + float(np.sqrt(max(self.arc.radius**2 - half**2, 0.0)))

    def distances(self, points: np.ndarray) -> np.ndarray:
        """Return the distances of points to the four sides, shape (k, 4), positive outwards."""
        u, v = points.T
        if self.arc is None:
            top = v - self.top
        else:
            top = np.hypot(u - 0.5 * (self.left + self.right), v - self.arc.centre) - self.arc.radius
        return np.stack([self.left - u, self.bottom - v, u - self.right, top], axis=1)

    def polygon(self) -> Polygon:
        """Return the outline."""
        foot = [(self.left, self.bottom), (self.right, self.bottom)]
        if self.arc is None:
            return Polygon([*foot, (self.right, self.top), (self.left, self.top)])
        middle, half = 0.5 * (self.left + self.right), 0.5 * (self.right - self.left)
        rise = np.arctan2(self.springing - self.arc.centre, half)
        angles = np.linspace(rise, np.pi - rise, ARC_POINTS)
        arc = np.stack(
            [middle + self.arc.radius * np.cos(angles), self.arc.centre + self.arc.radius * np.sin(angles)],
            axis=1,
        )
        return Polygon([*foot, *arc])


def make_outline(border: Border, regularise: bool, settings: OutlineSettings = OutlineSettings()) -> Outline:
    """Return the outline of a detail: regular if wanted and if the border allows, else as it was seen.

    Parameters
    ----------
    border : Border
    regularise : bool
    settings : OutlineSettings
    """
    shapes = settings.shapes
    if regularise:
        expected = np.hypot(border.gaps / np.sqrt(12), settings.noise_m)
        found = [
            (shape, sides)
            for shape, sides in _candidates(border, settings)
            if _holds(sides, border, expected, shapes)
        ]
        if found:
            rms = [_rms(sides, border, expected, shapes) for _, sides in found]
            best = 1 if len(found) > 1 and rms[1] < shapes.gain * rms[0] else 0
            shape, sides = found[best]
            return Outline(shape, sides.polygon(), _side_deviations(sides, border, settings), rms[best])
    return _free(border, settings)


def _candidates(border: Border, settings: OutlineSettings) -> list[tuple[str, _Sides]]:
    rectangle = _fit_rectangle(border, settings.shapes)
    arch = _fit_arch(border, rectangle, settings)
    return [(RECTANGLE, rectangle)] + ([(ARCH, arch)] if arch else [])


def _fit_rectangle(border: Border, settings: ShapeSettings) -> _Sides:
    sides = _Sides(*border.ring.bounds)
    for _ in range(settings.rounds):
        sides = _moved(sides, border, settings)
    return sides


def _moved(sides: _Sides, border: Border, settings: ShapeSettings) -> _Sides:
    """Return the sides, each moved to the crossings near it."""
    nearest, _ = _assign(sides, border, settings)
    u, v = border.crossings.T
    old = (sides.left, sides.bottom, sides.right, sides.top)
    left, bottom, right, top = (
        _location(values[nearest == side], position, settings.rounds)
        for side, (values, position) in enumerate(zip((u, v, u, v), old))
    )
    return _Sides(left, bottom, right, top if sides.arc is None else sides.top, sides.arc)


def _assign(sides: _Sides, border: Border, settings: ShapeSettings) -> tuple[np.ndarray, np.ndarray]:
    """Return the number of the side nearest to each crossing, -1 at corners, and the distance to it."""
    distances = sides.distances(border.crossings)
    if sides.arc is not None:
        below = border.crossings[:, 1] < sides.springing
        distances[below, 3] = np.inf
        distances[~below, 0] = distances[~below, 2] = np.inf
    magnitudes = np.abs(distances)
    nearest = np.argmin(magnitudes, axis=1)
    own = np.take_along_axis(distances, nearest[:, None], axis=1)[:, 0]
    second = np.partition(magnitudes, 1, axis=1)[:, 1]
    return np.where(second < settings.corner_gaps * border.gaps, -1, nearest), own


def _location(values: np.ndarray, fallback: float, rounds: int) -> float:
    """Return a robust mean of values, by Tukey's biweight; `fallback` without values."""
    if not len(values):
        return fallback
    middle = float(np.median(values))
    for _ in range(rounds):
        scale = max(sigma_of_residuals(values - middle), 1e-4)
        weights = tukey_weights(values - middle, scale, EFFICIENT_CUT)
        middle = float(np.average(values, weights=weights))
    return middle


def _fit_arch(border: Border, rectangle: _Sides, settings: OutlineSettings) -> Optional[_Sides]:
    """Return upright sides under a semicircle or a flatter arc; None if no arc fits into the border."""
    corner = settings.shapes.corner_gaps * np.median(border.gaps)
    half = 0.5 * (rectangle.right - rectangle.left)
    middle = 0.5 * (rectangle.left + rectangle.right)
    height = rectangle.top - rectangle.bottom
    if half <= 0 or height <= 0:
        return None
    top = border.ring.bounds[3]
    arc = _Arc(top - half, half)
    sides = _Sides(rectangle.left, rectangle.bottom, rectangle.right, top, arc)
    for _ in range(settings.shapes.rounds):
        sides = _moved(sides, border, settings.shapes)
        half, middle = 0.5 * (sides.right - sides.left), 0.5 * (sides.left + sides.right)
        upper = border.crossings[border.crossings[:, 1] > sides.springing + corner]
        if len(upper) < 3:
            return None
        amid = np.abs(upper[:, 0] - middle) < 0.1 * half
        crown = _location(upper[amid, 1], top, settings.shapes.rounds)
        start = np.array([arc.centre, max(arc.radius, half)])
        centre, radius = fit_circle_on_axis(upper, middle, start, settings.noise_m)
        if radius < half:
            # The upright sides end where the semicircle of their own width does.
            centre, radius = crown - half, half
        arc = _Arc(centre, radius)
        sides = _Sides(sides.left, sides.bottom, sides.right, centre + radius, arc)
    return sides if sides.springing > sides.bottom else None


def _holds(sides: _Sides, border: Border, expected: np.ndarray, settings: ShapeSettings) -> bool:
    """Whether the crossings agree with a shape, as far as their expected deviations allow."""
    nearest, own = _assign(sides, border, settings)
    deviations = np.abs(own) / expected
    if not {0, 1, 2, 3} <= set(nearest.tolist()) and len(deviations) < 4:
        return False
    off = deviations > settings.outlying
    within = deviations[~off]
    agrees = len(within) and np.sqrt(np.mean(within**2)) <= settings.tolerance
    return bool(np.mean(off) <= settings.outliers and agrees)


def _rms(sides: _Sides, border: Border, expected: np.ndarray, settings: ShapeSettings) -> float:
    _, own = _assign(sides, border, settings)
    near = np.abs(own) <= settings.outlying * expected
    return float(np.sqrt(np.mean(own[near] ** 2))) if near.any() else float(np.sqrt(np.mean(own**2)))


def _side_deviations(sides: _Sides, border: Border, settings: OutlineSettings) -> Edges:
    nearest, own = _assign(sides, border, settings.shapes)
    left, bottom, right, top = (
        edge_deviation(own[near], border.crossings[near], border.gaps[near], settings)
        for near in (nearest == side for side in range(4))
    )
    return Edges(left, right, bottom, top)


def edge_deviation(
    residuals: np.ndarray,
    crossings: np.ndarray,
    gaps: np.ndarray,
    settings: OutlineSettings = OutlineSettings(),
) -> float:
    """Return the standard deviation of the position of an edge (m); nan if nothing was seen of it.

    The border lies anywhere within the gap. The part of this that appears as scatter along the edge
    averages out. The rest does not, for example where a line of the scan runs along the edge.

    Parameters
    ----------
    residuals, gaps : ndarray of float64, shape (k,)
    crossings : ndarray of float64, shape (k, 2)
    settings : OutlineSettings
    """
    if len(residuals) < 2:
        return float("nan")
    gap = float(np.median(gaps))
    scatter = float(sigma_about_median(residuals)) ** 2
    unseen = max(gap**2 / 12 - settings.shapes.scattered * scatter, 0.0)
    length = float(np.hypot(*np.ptp(crossings, axis=0)))
    independent = max(min(length / max(gap, 1e-6), len(residuals)) / 2, 1.0)
    return float(np.sqrt(unseen + (scatter + settings.noise_m**2) / independent))


def _free(border: Border, settings: OutlineSettings) -> Outline:
    """Return the outline as it was seen, without the scatter of single points."""
    polygon = border.ring.simplify(0.5 * float(np.median(border.gaps)))
    left, bottom, right, top = border.ring.bounds
    u, v = border.crossings.T
    reach = settings.shapes.corner_gaps * float(np.median(border.gaps))
    found = []
    for away in (u - left, v - bottom, right - u, top - v):
        near = away < reach
        found.append(edge_deviation(away[near], border.crossings[near], border.gaps[near], settings))
    return Outline(FREE, polygon, Edges(found[0], found[2], found[1], found[3]), 0.0)
