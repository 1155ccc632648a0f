"""How well the walls of a plan agree with a reference: the one yardstick of this project."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Optional

import numpy as np
from scipy.spatial import cKDTree
from shapely.geometry import LineString, Point
from shapely.geometry.base import BaseGeometry
from shapely.geometry.polygon import orient
from shapely.ops import unary_union
from shapely.prepared import prep

from ..geometry.settings import WallSizeSettings

STEP = 0.02
"""Longest piece of a boundary that is measured as one, metres."""

NEIGHBOURS = 8
"""Pieces whose middles are nearest, among which the nearest piece is looked for."""

CLASSES = (0.25, 0.5, 1.0)
"""Classes of offsets end at these shares of the tolerance."""

THICKEST = WallSizeSettings().thickest_m
"""No wall is thicker, metres."""

AGREES, WRONG, MISSING = "agrees", "wrong", "missing"
"""States of a boundary: the two agree; the plan has what the reference lacks; the plan lacks it."""


@dataclass(frozen=True)
class Boundary:
    """A boundary in pieces, and how far each is from the other boundary.

    Attributes
    ----------
    starts, ends : ndarray, shape (n, 2)
        Of the pieces, in order along each line, polygons on their left; metres.
    line : ndarray of int, shape (n,)
        Which line of the boundary a piece belongs to.
    offsets : ndarray, shape (n,)
        Distance of the middle of each piece from the other boundary, metres; infinite if that is empty.
    """

    starts: np.ndarray
    ends: np.ndarray
    line: np.ndarray
    offsets: np.ndarray

    @property
    def lengths(self) -> np.ndarray:
        """Of the pieces, shape (n,), metres."""
        return np.hypot(*(self.ends - self.starts).T)

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


@dataclass(frozen=True)
class Stretch:
    """A run of a boundary whose offsets are of one class.

    Attributes
    ----------
    line : LineString
    side : str
        'plan' or 'reference': whose boundary it is.
    state : str
        `AGREES`, `WRONG` or `MISSING`.
    offset, max_offset : float
        Median and largest distance from the other boundary, metres; infinite if that is empty.
    """

    line: LineString
    side: str
    state: str
    offset: float
    max_offset: float


@dataclass(frozen=True)
class PlanAgreement:
    """Agreement of a plan with its reference.

    Attributes
    ----------
    tolerance : float
        Metres.
    iou : float
        Intersection over union of the areas; nan if the reference has no area.
    plan, reference : Boundary
        Of the reference, the part that was asked for; of the plan, what can be judged by it.
    """

    tolerance: float
    iou: float
    plan: Boundary
    reference: Boundary

    @property
    def completeness(self) -> float:
        """Share of the reference's boundary that has the plan's boundary within the tolerance."""
        return self.reference.share_within(self.tolerance)

    @property
    def correctness(self) -> float:
        """Share of the plan's boundary that has the reference's boundary within the tolerance."""
        return self.plan.share_within(self.tolerance)

    @property
    def median_offset(self) -> float:
        """Median distance of the found part of the reference's boundary from the plan's (m), or nan."""
        return self.reference.quantile(0.5, self.tolerance)

    @property
    def p95_offset(self) -> float:
        """Distance that 95 % of the found part of the reference's boundary keep to (m), or nan."""
        return self.reference.quantile(0.95, self.tolerance)

    def at(self, tolerance: float) -> "PlanAgreement":
        """Return the same comparison at another tolerance."""
        return replace(self, tolerance=tolerance)

    def stretches(self) -> Iterator[Stretch]:
        """Yield both boundaries in stretches: where the two agree and where they do not."""
        for side, boundary, off in (("plan", self.plan, WRONG), ("reference", self.reference, MISSING)):
            limits = self.tolerance * np.array(CLASSES)
            kinds = np.searchsorted(limits, boundary.offsets)
            turns = np.flatnonzero(np.diff(boundary.line).astype(bool) | np.diff(kinds).astype(bool)) + 1
            for run in np.split(np.arange(len(kinds)), turns) if len(kinds) else ():
                line = LineString(np.vstack([boundary.starts[run], boundary.ends[run[-1:]]]))
                offsets = boundary.offsets[run]
                state = AGREES if kinds[run[0]] < len(CLASSES) else off
                # Of the pieces of a straight edge, the ends say all.
                yield Stretch(
                    line.simplify(1e-6), side, state, float(np.median(offsets)), float(offsets.max())
                )


def compare_plan(
    walls: BaseGeometry, reference: BaseGeometry, tolerance: float, seen: Optional[BaseGeometry] = None
) -> PlanAgreement:
    """Compare the walls of a plan with a reference.

    Parameters
    ----------
    walls : shapely Polygon or MultiPolygon
        Metres; without borders between polygons that touch.
    reference : shapely Polygon, MultiPolygon, LineString or MultiLineString
        Metres; the walls, or their faces as lines.
    tolerance : float
        Metres.
    seen : shapely LineString or MultiLineString, optional
        The part of the reference's boundary that can be asked of the plan, as the scanner saw it; the
        whole boundary if not given. Where a plan leaves off inside a wall, before a face that was not
        seen, it is neither right nor wrong.
    """
    plan, truth = _pieces(walls), _pieces(reference)
    asked, judged = truth, plan
    if seen is not None:
        asked = _pieces(seen)
        fronts = ~_backs(plan, reference, seen)
        judged = tuple(array[fronts] for array in plan)
    return PlanAgreement(
        tolerance,
        _intersection_over_union(walls, reference),
        Boundary(*judged, _distances(judged, truth)),
        Boundary(*asked, _distances(asked, plan)),
    )


def _pieces(shape: BaseGeometry) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Cut the boundary of polygons, or lines, into pieces of `STEP` at most: starts, ends, line numbers."""
    corners = [np.asarray(line.coords)[:, :2] for line in _lines(shape) if not line.is_empty]
    if not corners:
        return np.empty((0, 2)), np.empty((0, 2)), np.empty(0, dtype=int)
    starts = np.concatenate([line[:-1] for line in corners])
    along = np.concatenate([np.diff(line, axis=0) for line in corners])
    number = np.repeat(np.arange(len(corners)), [len(line) - 1 for line in corners])
    count = np.ceil(np.hypot(*along.T) / STEP).astype(int)
    place = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    starts, along, number, count = (
        np.repeat(array, count, axis=0) for array in (starts, along, number, count)
    )
    return starts + along * (place / count)[:, None], starts + along * ((place + 1) / count)[:, None], number


def _lines(shape: BaseGeometry) -> Iterator[BaseGeometry]:
    for part in getattr(shape, "geoms", [shape]):
        if part.area:
            polygon = orient(part)
            yield from (polygon.exterior, *polygon.interiors)
        else:
            yield part


def _backs(plan: tuple, reference: BaseGeometry, seen: BaseGeometry) -> np.ndarray:
    """Tell which pieces of a plan lie in a wall, with only a face before them that was not seen."""
    starts, ends, _ = plan
    middles, along = (starts + ends) / 2, ends - starts
    outwards = np.column_stack([along[:, 1], -along[:, 0]]) / np.hypot(*along.T)[:, None]
    wall, boundary = prep(reference), reference.boundary
    backs = np.zeros(len(middles), dtype=bool)
    for number, (middle, outward) in enumerate(zip(middles, outwards)):
        if wall.contains(Point(middle)):
            before = LineString([middle, middle + THICKEST * outward]).intersection(boundary)
            nearest = min(getattr(before, "geoms", [before]), key=Point(middle).distance, default=before)
            backs[number] = not nearest.is_empty and seen.distance(nearest) > STEP
    return backs


def _distances(asked: tuple, given: tuple) -> np.ndarray:
    """Return how far the middles of the asked pieces are from the nearest of the given ones."""
    middles = (asked[0] + asked[1]) / 2
    starts, ends, _ = given
    if len(starts) == 0 or len(middles) == 0:
        return np.full(len(middles), np.inf)
    neighbours = min(NEIGHBOURS, len(starts))
    _, near = cKDTree((starts + ends) / 2).query(middles, neighbours)
    near = near.reshape(len(middles), neighbours)
    along = (ends - starts)[near]
    from_start = middles[:, None] - starts[near]
    share = np.clip(np.sum(from_start * along, axis=2) / np.sum(along**2, axis=2), 0, 1)
    return np.linalg.norm(from_start - share[..., None] * along, axis=2).min(axis=1)


def _intersection_over_union(walls: BaseGeometry, reference: BaseGeometry) -> float:
    if not reference.area:
        return float("nan")
    return walls.intersection(reference).area / unary_union([walls, reference]).area
