"""The heads of openings: flat, sloped, segmental, round or pointed."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import least_squares

from ...geometry.circles import fit_circle_on_axis
from .edges import biweight, border_deviation
from .settings import OutlineSettings

FLAT, SLOPED, SEGMENTAL, ROUND, POINTED = "flat", "sloped", "segmental", "round", "pointed"
ARC_POINTS = 49
"""Corners of the polygon that represents an arch."""


@dataclass(frozen=True)
class Head:
    """The upper end of an outline between its jambs.

    Attributes
    ----------
    kind : str
        `FLAT`, `SLOPED`, `SEGMENTAL`, `ROUND` or `POINTED`.
    line : ndarray of float64, shape (k, 2)
        From the right jamb to the left one.
    std : float
        Standard deviation of the height of its highest point (m); of one that sags, of its height anywhere.
    sags : bool
        Whether it is level but for a small slope.
    """

    kind: str
    line: np.ndarray
    std: float
    sags: bool = False

    def off(self, points: np.ndarray) -> np.ndarray:
        """Return the distances of points, shape (n, 2), from the line."""
        start, stop = self.line[:-1], self.line[1:]
        along = stop - start
        lengths = np.maximum((along**2).sum(axis=1), 1e-18)
        offsets = points[:, None] - start
        shares = np.clip((offsets * along).sum(axis=2) / lengths, 0, 1)
        return np.linalg.norm(offsets - shares[..., None] * along, axis=2).min(axis=1)


def fit_head(
    points: np.ndarray,
    gaps: np.ndarray,
    jambs: tuple[float, float],
    settings: OutlineSettings = OutlineSettings(),
    spacing: float = 0.0,
) -> "Head | None":
    """Return the simplest head that agrees with the border; None if none does.

    Parameters
    ----------
    points : ndarray of float64, shape (k, 2)
        The border between the jambs, above the middle of the outline.
    gaps : ndarray of float64, shape (k,)
    jambs : tuple of float
        u of the left and the right jamb.
    settings : OutlineSettings
    spacing : float
        Of the points along the border (m).
    """
    limits = settings.heads
    left, right = jambs
    wide = limits.widest * (right - left)
    if len(points) < limits.fewest or np.ptp(points[:, 0]) < wide:
        return None
    # Of points at random the outermost may lie close to the edge by chance, as the others do not.
    wide_gaps = np.where(gaps > 0, np.maximum(gaps, spacing), 0.0)
    expected = np.hypot(wide_gaps / np.sqrt(12), settings.noise_m)
    found = []
    for kind, line in _candidates(points, jambs, settings):
        head = Head(kind, line, float("nan"))
        off = head.off(points)
        cost = float(np.mean(np.minimum((off / expected) ** 2, limits.outlying**2)))
        found.append((cost, head, off))
    best = min(cost for cost, *_ in found)
    enough = max(limits.consistent, best / limits.gain)
    cost, head, off = next(item for item in found if item[0] <= enough)
    near = off <= limits.outlying * expected
    if near.mean() < limits.agreeing or np.ptp(points[near, 0]) < wide:
        return None
    points, gaps = points[near], gaps[near]
    if head.kind == SLOPED and np.ptp(head.line[:, 1]) < limits.level_m:
        level = np.column_stack([head.line[:, 0], np.full(2, head.line[:, 1].mean())])
        head = Head(FLAT, level, float("nan"), sags=True)
    signed = head.off(points) * np.sign(_side(points, head))
    return replace(head, std=border_deviation(signed, points, gaps, spacing, settings))


def _side(points: np.ndarray, head: Head) -> np.ndarray:
    order = np.argsort(head.line[:, 0], kind="stable")
    return points[:, 1] - np.interp(points[:, 0], head.line[order, 0], head.line[order, 1]) + 1e-12


def _candidates(
    points: np.ndarray, jambs: tuple[float, float], settings: OutlineSettings
) -> Iterator[tuple[str, np.ndarray]]:
    """Yield lines for the head, the simplest first."""
    left, right = jambs
    level = biweight(points[:, 1], _densest_level(points, settings))
    yield FLAT, np.array([(right, level), (left, level)])
    yield from _sloped(points, jambs, settings)
    yield from _arched(points, jambs, settings)
    yield from _pointed(points, jambs, settings.noise_m)


def _densest_level(points: np.ndarray, settings: OutlineSettings) -> float:
    window = 5 * settings.noise_m
    heights = np.sort(points[:, 1])
    counts = np.searchsorted(heights, heights + window, side="right") - np.arange(len(heights))
    best = int(np.argmax(counts))
    return float(np.median(heights[best : best + counts[best]]))


def _sloped(
    points: np.ndarray, jambs: tuple[float, float], settings: OutlineSettings
) -> Iterator[tuple[str, np.ndarray]]:
    middle = 0.5 * (jambs[0] + jambs[1])
    u, v = points[:, 0] - middle, points[:, 1]
    found = least_squares(
        lambda p: p[0] + p[1] * u - v, (np.median(v), 0.0), loss="soft_l1", f_scale=settings.noise_m
    ).x
    if abs(found[1]) <= settings.heads.steepest:
        yield SLOPED, np.array([(edge, found[0] + found[1] * (edge - middle)) for edge in jambs[::-1]])


def _arched(
    points: np.ndarray, jambs: tuple[float, float], settings: OutlineSettings
) -> Iterator[tuple[str, np.ndarray]]:
    left, right = jambs
    half, middle = 0.5 * (right - left), 0.5 * (left + right)
    crown = float(np.percentile(points[:, 1], 98))
    centre, radius = fit_circle_on_axis(points, middle, np.array([crown - half, half]), settings.noise_m)
    if radius > settings.heads.flattest * half:
        return
    if radius <= half * (1 + settings.heads.semicircle):
        # The upright sides end where the semicircle of their own width does.
        centre, radius = centre + radius - half, half
    kind = ROUND if radius == half else SEGMENTAL
    rise = np.arccos(np.clip(half / radius, -1, 1))
    angles = np.linspace(rise, np.pi - rise, ARC_POINTS)
    yield kind, np.stack([middle + radius * np.cos(angles), centre + radius * np.sin(angles)], axis=1)


def _pointed(
    points: np.ndarray, jambs: tuple[float, float], noise: float
) -> Iterator[tuple[str, np.ndarray]]:
    left, right = jambs
    half, middle = 0.5 * (right - left), 0.5 * (left + right)
    own = np.abs(points[:, 0] - middle)

    def residuals(arcs: np.ndarray) -> np.ndarray:
        # Both arcs, folded onto the right half: the centre is beyond the middle.
        return np.hypot(own + arcs[0] - half, points[:, 1] - arcs[1]) - arcs[0]

    start = (2 * half, float(points[:, 1].min()))
    radius, springing = least_squares(residuals, start, loss="soft_l1", f_scale=noise).x
    if not 1.1 * half < radius < 8 * half:
        return
    apex = np.arccos(np.clip((radius - half) / radius, -1, 1))
    angles = np.linspace(0, apex, ARC_POINTS // 2)
    across, up = radius * np.cos(angles) - (radius - half), springing + radius * np.sin(angles)
    right_arc = np.stack([middle + across, up], axis=1)
    left_arc = np.stack([middle - across, up], axis=1)[::-1]
    yield POINTED, np.concatenate([right_arc, left_arc[1:]])
