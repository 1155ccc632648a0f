"""A reference plan drawn by hand: its faces, its rooms, and what can be judged by it.

A drawn plan is a layer whose field `kind` says what each feature stands for:

wall, column
    A line along a face that a plan should have.
glazing
    A line that a plan may have.
opening, low
    A line along which a leaf, a frame or a bench may be drawn or not.
room
    A polygon from face to face. A room whose `note` begins with "optional" may be missing.
judged
    A polygon. Outside of it nothing is judged.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import fiona
import numpy as np
from fiona.errors import FionaError
from shapely.geometry import MultiLineString, Point, Polygon, shape
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union
from shapely.prepared import PreparedGeometry, prep

from ..errors import InputError
from .boundary import Boundary, Pieces, cut_boundary, distances_along
from .outlines import dissolved
from .plan import PlanAgreement
from .settings import DrawnPlanSettings

JUDGED = "judged"

DEMANDED, ALLOWED, NEUTRAL = ("wall", "column"), ("wall", "column", "glazing"), ("opening", "low")


@dataclass(frozen=True)
class DrawnPlan:
    """A reference plan; metres.

    Attributes
    ----------
    demanded, allowed, neutral : MultiLineString
        Faces that a plan should have, faces that it may have, and lines along which nothing is judged.
    judged : Polygon or MultiPolygon
    rooms, optional_rooms : tuple of Polygon
    """

    demanded: MultiLineString
    allowed: MultiLineString
    neutral: MultiLineString
    judged: BaseGeometry
    rooms: tuple[Polygon, ...] = ()
    optional_rooms: tuple[Polygon, ...] = ()


@dataclass(frozen=True)
class RoomAgreement:
    """Agreement of the rooms of a plan with drawn ones.

    Attributes
    ----------
    found, missed, invented : int
    area_errors : tuple of float
        Of the rooms found, as shares of their areas.
    """

    found: int
    missed: int
    invented: int
    area_errors: tuple[float, ...]

    @property
    def median_area_error(self) -> float:
        """Nan if no room was found."""
        return float(np.median(self.area_errors)) if self.area_errors else float("nan")


def read_drawn_plan(path: Path) -> DrawnPlan:
    """Read a drawn plan from a layer.

    Raises
    ------
    InputError
        If the file cannot be read, or has no judged region.
    """
    try:
        with fiona.open(str(path)) as layer:
            features = [(shape(item["geometry"]), dict(item["properties"])) for item in layer]
    except (FionaError, ValueError, TypeError) as error:
        raise InputError(f"{path} cannot be read as a layer of a drawn plan: {error}.") from error
    if not any(properties.get("kind") == JUDGED for _, properties in features):
        raise InputError(f"{path} has no feature of the kind judged; draw the region that is to be judged.")
    return drawn_plan(features)


def drawn_plan(features: Sequence[tuple[BaseGeometry, Mapping[str, Any]]]) -> DrawnPlan:
    """Return the drawn plan of geometries and their properties `kind` and `note`."""

    def of(*kinds: str) -> list[BaseGeometry]:
        return [geometry for geometry, properties in features if properties.get("kind") in kinds]

    rooms: dict[bool, list[Polygon]] = {True: [], False: []}
    for geometry, properties in features:
        if properties.get("kind") == "room":
            rooms[str(properties.get("note") or "").startswith("optional")].append(geometry)
    return DrawnPlan(
        demanded=MultiLineString(of(*DEMANDED)),
        allowed=MultiLineString(of(*ALLOWED)),
        neutral=MultiLineString(of(*NEUTRAL)),
        judged=unary_union(of(JUDGED)),
        rooms=tuple(rooms[False]),
        optional_rooms=tuple(rooms[True]),
    )


def compare_with_drawn(
    walls: Sequence[Polygon],
    drawn: DrawnPlan,
    tolerance: float,
    settings: DrawnPlanSettings = DrawnPlanSettings(),
) -> PlanAgreement:
    """Compare the walls of a plan with a drawn one, inside the judged region.

    A piece of an outline is not judged where it runs along a neutral line, and where it is the back of a
    strip whose front is nearer to a face. A line stands only for faces of its own direction.

    Parameters
    ----------
    walls : sequence of Polygon
        Metres; those that touch are one.
    drawn : DrawnPlan
    tolerance : float
        Metres.
    settings : DrawnPlanSettings
    """
    region = prep(drawn.judged)
    outlines = [cut_boundary(wall, settings.step_m) for wall in dissolved(walls, settings.seam_m).geoms]
    truth, neutral, asked = (
        cut_boundary(lines, settings.step_m) for lines in (drawn.allowed, drawn.neutral, drawn.demanded)
    )
    judged = [_judged(outline, truth, neutral, region, tolerance, settings) for outline in outlines]
    asked = asked.chosen(_inside(asked, region))
    every = _joined(outlines)
    found = distances_along(asked, every, settings.search_m, settings.angle_deg)
    offsets = np.concatenate([np.empty(0), *(offsets for _, offsets in judged)])
    plan = Boundary(_joined([pieces for pieces, _ in judged]), offsets)
    return PlanAgreement(tolerance, float("nan"), plan, Boundary(asked, found))


def compare_rooms(
    rooms: Sequence[Polygon], drawn: DrawnPlan, settings: DrawnPlanSettings = DrawnPlanSettings()
) -> RoomAgreement:
    """Compare the rooms of a plan with drawn ones: which are found, and how far their areas differ."""
    partner: dict[int, int] = {}
    for overlap, row, column in sorted(_overlaps(rooms, drawn.rooms), reverse=True):
        if overlap > settings.room_overlap and row not in partner and column not in partner.values():
            partner[row] = column
    optional = unary_union(drawn.optional_rooms)
    invented = [
        room
        for column, room in enumerate(rooms)
        if column not in partner.values()
        and room.intersection(drawn.judged).area > 0.5 * room.area
        and room.intersection(optional).area < 0.5 * room.area
    ]
    errors = tuple(abs(rooms[column].area / drawn.rooms[row].area - 1) for row, column in partner.items())
    return RoomAgreement(len(partner), len(drawn.rooms) - len(partner), len(invented), errors)


def _overlaps(rooms: Sequence[Polygon], true: Sequence[Polygon]) -> list[tuple[float, int, int]]:
    """Return intersection over union, number of the true room and of the other, of rooms that overlap."""
    return [
        (one.intersection(other).area / one.union(other).area, row, column)
        for row, one in enumerate(true)
        for column, other in enumerate(rooms)
        if one.intersects(other)
    ]


def _judged(
    outline: Pieces,
    truth: Pieces,
    neutral: Pieces,
    region: PreparedGeometry,
    tolerance: float,
    settings: DrawnPlanSettings,
) -> tuple[Pieces, np.ndarray]:
    """Return the pieces of an outline that can be judged, and their distances from faces."""
    offsets = distances_along(outline, truth, settings.search_m, settings.angle_deg)
    away = offsets > tolerance
    beside_opening = np.isfinite(distances_along(outline, neutral, settings.neutral_m, settings.angle_deg))
    left_out = away & (beside_opening | _is_back(outline, offsets, away, settings))
    chosen = _inside(outline, region) & ~left_out
    return outline.chosen(chosen), offsets[chosen]


def _is_back(
    outline: Pieces, offsets: np.ndarray, away: np.ndarray, settings: DrawnPlanSettings
) -> np.ndarray:
    """Return which pieces that are away from faces have the nearer side of their strip before them."""
    middles, angles = outline.middles, outline.directions
    back = np.zeros(len(middles), bool)
    least = np.cos(np.radians(settings.angle_deg))
    for row in np.flatnonzero(away):
        angle = np.radians(angles[row])
        along, across = (np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)]))
        ahead = middles - middles[row]
        gap = np.abs(ahead @ across)
        beside = (
            (gap >= settings.thinnest_m)
            & (gap <= settings.strip_m)
            & (np.abs(ahead @ along) < 2 * settings.step_m)
        )
        beside &= np.abs(np.cos(np.radians(angles) - angle)) >= least
        back[row] = bool(np.any(beside & (offsets < offsets[row] - settings.nearer * gap)))
    return back


def _inside(pieces: Pieces, region: PreparedGeometry) -> np.ndarray:
    """Return which pieces have their middle in a region; bool, shape (n,)."""
    return np.array([region.contains(Point(*middle)) for middle in pieces.middles], dtype=bool)


def _joined(outlines: Sequence[Pieces]) -> Pieces:
    """Return the pieces of outlines as one set, each line with a number of its own."""
    lines, first = [np.empty(0, dtype=int)], 0
    for outline in outlines:
        lines.append(outline.line + first)
        first += int(outline.line.max(initial=-1)) + 1
    none = np.empty((0, 2))
    return Pieces(
        np.concatenate([none, *(outline.starts for outline in outlines)]),
        np.concatenate([none, *(outline.ends for outline in outlines)]),
        np.concatenate(lines),
    )
