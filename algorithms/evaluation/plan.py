"""How well the walls of a plan agree with a reference."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

STEP = 0.02
"""Distance of the places on a boundary at which it is compared, metres."""


@dataclass(frozen=True)
class PlanAgreement:
    """Agreement of a plan with its reference.

    Attributes
    ----------
    completeness : float
        Share of the reference's boundary that has the plan's boundary within the tolerance.
    correctness : float
        Share of the plan's boundary that has the reference's boundary within the tolerance.
    iou : float
        Intersection over union of the areas.
    median_offset, p95_offset : float
        Distance of the found part of the reference's boundary from the plan's, metres; nan if none is.
    """

    completeness: float
    correctness: float
    iou: float
    median_offset: float
    p95_offset: float


def compare_plan(
    walls: BaseGeometry, reference: BaseGeometry, tolerance: float, seen: BaseGeometry
) -> PlanAgreement:
    """Compare the walls of a plan with a reference.

    Parameters
    ----------
    walls, reference : shapely Polygon or MultiPolygon
        Metres.
    tolerance : float
        Metres.
    seen : shapely LineString or MultiLineString
        The part of the reference's boundary that can be asked of the plan, as the scanner saw it;
        the whole boundary if nothing is known.
    """
    plan = np.empty((0, 2)) if walls.is_empty else places(walls.boundary)
    truth = places(reference.boundary)
    asked = places(seen)
    missing = _distances(asked, plan)
    wrong = _distances(plan, truth)
    found = missing[missing <= tolerance]
    return PlanAgreement(
        completeness=_share(missing, tolerance),
        correctness=_share(wrong, tolerance),
        iou=walls.intersection(reference).area / unary_union([walls, reference]).area,
        median_offset=float(np.median(found)) if len(found) else float("nan"),
        p95_offset=float(np.percentile(found, 95)) if len(found) else float("nan"),
    )


def places(lines: BaseGeometry) -> np.ndarray:
    """Return places along lines, `STEP` apart; float64, shape (n, 2)."""
    parts = getattr(lines, "geoms", [lines])
    spread = [_along(np.asarray(part.coords)[:, :2]) for part in parts if not part.is_empty]
    return np.concatenate(spread) if spread else np.empty((0, 2))


def _along(line: np.ndarray) -> np.ndarray:
    lengths = np.hypot(*np.diff(line, axis=0).T)
    way = np.r_[0.0, np.cumsum(lengths)]
    count = max(round(way[-1] / STEP), 1)
    at = (np.arange(count) + 0.5) * way[-1] / count
    return np.column_stack([np.interp(at, way, line[:, axis]) for axis in (0, 1)])


def _distances(asked: np.ndarray, given: np.ndarray) -> np.ndarray:
    if len(given) == 0:
        return np.full(len(asked), np.inf)
    return cKDTree(given).query(asked)[0]


def _share(distances: np.ndarray, tolerance: float) -> float:
    return float(np.mean(distances <= tolerance)) if len(distances) else 0.0
