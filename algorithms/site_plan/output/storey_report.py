"""The part of the report about the storey: its heights, where the scan ends, and what was left out."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from shapely.geometry import LineString

from ...reporting.maps import Map
from ...reporting.numbers import number
from ..results import SitePlan
from ..storeys.storey_plan import StoreyPlan
from ..storeys.walls.left_out import LeftOut

FACE, ROOM, LIMIT, LEFT_OUT = "#a8321a", "#2a8a96", "#3b78a8", "#e0a030"


@dataclass(frozen=True)
class ShownStorey:
    """What the page shows of a storey.

    Attributes
    ----------
    map : str
        SVG.
    rows : list of tuple of str
        Heights, points and lengths.
    left_out : list of tuple of str
        Reason, number of surfaces, their length and their area.
    """

    map: str
    rows: list[tuple[str, str]]
    left_out: list[tuple[str, ...]]


def shown(storey: StoreyPlan) -> ShownStorey:
    """Return what the page shows of a storey."""
    return ShownStorey(_map(storey), _rows(storey), _left_out_rows(storey.left_out))


def decided_by(plan: SitePlan) -> str:
    """Return in a sentence whether the plan is that of a storey, and why not."""
    if plan.storey:
        return (
            "Under the ceiling, walls and rooms come from the faces and the floor of the storey; elsewhere "
            "from the density image."
        )
    if not plan.settings.refine:
        return "REFINE is no: all walls come from the density image, with the outlines of pixels."
    if not plan.settings.storey:
        return "STOREY is no: all walls come from the density image."
    return "No room under a ceiling was seen: all walls come from the density image."


def _map(storey: StoreyPlan) -> str:
    """Draw the rooms and walls of a storey, where the scan ends, and what was left out."""
    with Map.around(np.reshape(storey.region.bounds, (2, 2))) as sheet:
        sheet.areas([room.outline for room in storey.rooms], ROOM, 0.15)
        sheet.areas([wall.outline for wall in storey.walls], FACE, 0.6)
        _draw(sheet, [item.line for item in storey.left_out], LEFT_OUT)
        _draw(sheet, storey.limits, LIMIT)
        return sheet.svg()


def _draw(sheet: Map, lines: Sequence[LineString], colour: str) -> None:
    corners = [np.asarray(line.coords) for line in lines]
    if corners:
        starts, ends = (np.concatenate([xy[part] for xy in corners]) for part in (np.s_[:-1], np.s_[1:]))
        sheet.lines(starts, ends, colour, 1.6)


def _rows(storey: StoreyPlan) -> list[tuple[str, str]]:
    heights = storey.storey
    rows = [
        ("floor", f"{heights.floor:.2f} m" if heights else ""),
        ("ceiling", f"{heights.ceiling:.2f} m" if heights and heights.ceiling is not None else "not seen"),
        ("distance of points", f"{100 * storey.spacing_m:.1f} cm"),
        ("noise of upright surfaces", f"{1000 * storey.noise_m:.0f} mm"),
        ("outlines of rooms", f"{sum(room.outline.length for room in storey.rooms):.1f} m"),
        ("of them limits, without a wall", f"{sum(line.length for line in storey.limits):.1f} m"),
    ]
    kinds = Counter(wall.kind for wall in storey.walls)
    return rows + [(f"pieces of the kind {kind}", str(count)) for kind, count in sorted(kinds.items())]


def _left_out_rows(left_out: Sequence[LeftOut]) -> list[tuple[str, ...]]:
    """Return a row for each reason: how many surfaces, how long and how large they are; the largest first."""
    groups: dict[str, list[LeftOut]] = {}
    for item in left_out:
        groups.setdefault(item.reason, []).append(item)
    rows = [
        (reason, len(group), sum(item.line.length for item in group), sum(item.area for item in group))
        for reason, group in groups.items()
    ]
    return [
        (reason, str(count), number(length, 1), number(area, 1))
        for reason, count, length, area in sorted(rows, key=lambda row: -row[3])
    ]
