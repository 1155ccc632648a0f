"""How well the walls of a plan agree with a reference: the one yardstick of this project."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Optional

import numpy as np
from shapely.geometry import LineString, Point
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union
from shapely.prepared import prep

from .boundary import Boundary, Pieces, cut_boundary, measure_boundary
from .settings import ComparisonSettings

CLASSES = (0.25, 0.5, 1.0)
"""Classes of offsets end at these shares of the tolerance; the style of the layer colours them."""

AGREES, WRONG, MISSING = "agrees", "wrong", "missing"
"""States of a boundary: the two agree; the plan has what the reference lacks; the plan lacks it."""


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
        """Distance that 95 % of the found part of the reference's boundary do not exceed (m), or nan."""
        return self.reference.quantile(0.95, self.tolerance)

    def at(self, tolerance: float) -> "PlanAgreement":
        """Return the same comparison at another tolerance."""
        return replace(self, tolerance=tolerance)

    def stretches(self) -> Iterator[Stretch]:
        """Yield both boundaries in stretches: where the two agree and where they do not."""
        yield from _stretches("plan", WRONG, self.plan, self.tolerance)
        yield from _stretches("reference", MISSING, self.reference, self.tolerance)


def compare_plan(
    walls: BaseGeometry,
    reference: BaseGeometry,
    tolerance: float,
    seen: Optional[BaseGeometry] = None,
    settings: ComparisonSettings = ComparisonSettings(),
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
        The part of the reference's boundary that the scanner saw, and that the plan should have; the
        whole boundary if not given. Where a plan ends inside a wall, before a face that was not seen, it
        is neither right nor wrong.
    settings : ComparisonSettings
    """
    plan, truth = cut_boundary(walls, settings.step_m), cut_boundary(reference, settings.step_m)
    asked, judged = truth, plan
    if seen is not None:
        asked = cut_boundary(seen, settings.step_m)
        judged = plan.chosen(~_before_unseen_faces(plan, reference, seen, settings))
    return PlanAgreement(
        tolerance,
        _intersection_over_union(walls, reference),
        measure_boundary(judged, truth, settings),
        measure_boundary(asked, plan, settings),
    )


def _stretches(side: str, off: str, boundary: Boundary, tolerance: float) -> Iterator[Stretch]:
    """Yield the runs of pieces whose offsets are of one class; `off` is the state of the last class."""
    starts, ends, line = boundary.pieces
    kinds = np.searchsorted(tolerance * np.array(CLASSES), boundary.offsets)
    # Pieces that were not judged leave gaps.
    apart = np.diff(line).astype(bool) | np.any(starts[1:] != ends[:-1], axis=1)
    borders = np.flatnonzero(apart | np.diff(kinds).astype(bool)) + 1
    for run in np.split(np.arange(len(kinds)), borders) if len(kinds) else ():
        drawn = LineString(np.vstack([starts[run], ends[run[-1:]]]))
        offsets = boundary.offsets[run]
        state = AGREES if kinds[run[0]] < len(CLASSES) else off
        # Of the pieces of a straight edge, only the ends are needed.
        yield Stretch(drawn.simplify(1e-6), side, state, float(np.median(offsets)), float(offsets.max()))


def _before_unseen_faces(
    plan: Pieces, reference: BaseGeometry, seen: BaseGeometry, settings: ComparisonSettings
) -> np.ndarray:
    """Return which pieces of a plan lie inside a wall whose next face outwards was not seen."""
    starts, ends, _ = plan
    middles, along = (starts + ends) / 2, ends - starts
    outwards = np.column_stack([along[:, 1], -along[:, 0]]) / np.hypot(*along.T)[:, None]
    wall, boundary = prep(reference), reference.boundary
    unseen = np.zeros(len(middles), dtype=bool)
    for number, (middle, outward) in enumerate(zip(middles, outwards)):
        if wall.contains(Point(middle)):
            ray = LineString([middle, middle + settings.sizes.thickest_m * outward])
            faces = ray.intersection(boundary)
            nearest = min(getattr(faces, "geoms", [faces]), key=Point(middle).distance, default=faces)
            unseen[number] = not nearest.is_empty and seen.distance(nearest) > settings.step_m
    return unseen


def _intersection_over_union(walls: BaseGeometry, reference: BaseGeometry) -> float:
    if not reference.area:
        return float("nan")
    return walls.intersection(reference).area / unary_union([walls, reference]).area
