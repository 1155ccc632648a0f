"""The report of a facade: the key plan of all facades of the cloud, and what was measured on one of them."""

from dataclasses import replace
from pathlib import Path
from typing import Optional

import numpy as np

from ...reporting.figures import COLOURS, RED
from ...reporting.maps import Map
from ...reporting.numbers import number
from ...reporting.page import write_page
from ..buildings.facades import Facade
from ..elevation import Detail, Elevation
from ..left_out import summary
from ..selection import Selection

TEMPLATE = Path(__file__).parent / "templates" / "facade.html"

ARROW = 1.0
"""Length of the arrow that shows where a facade faces (m)."""

MARGIN = 2.0
"""What the key plan shows around the facades (m)."""

PIXELS, WHITE, SHADE = 600, 255, 185
"""Of the picture of all points on it: the longer side, and grey values."""


def write_report(path: Path, selection: Selection, elevation: Elevation) -> None:
    """Write the report as HTML.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    details = elevation.details
    selection = _as_measured(selection, elevation)
    write_page(
        path,
        TEMPLATE,
        chosen=None if selection.chosen is None else selection.chosen.number,
        azimuth=elevation.frame.azimuth,
        side=elevation.side,
        spacing_mm=1000 * elevation.spacing,
        wall_m2=elevation.wall.area,
        unseen_m2=sum(area.area for area in elevation.unseen),
        plan=_key_plan(selection) if selection.facades else "",
        facades=[_facade_row(facade) for facade in selection.facades],
        marked=[] if selection.chosen is None else [selection.chosen.number - 1],
        parts=[(number(part.depth, 2), number(part.area, 1)) for part in elevation.parts],
        details=[_detail_row(detail) for detail in details],
        left_out=[
            (kind, reason, str(count), number(area, 2))
            for kind, reason, count, area in summary(elevation.left_out)
        ],
        rolled_out=_rolled_out(elevation),
        warnings=elevation.warnings,
    )


def _as_measured(selection: Selection, elevation: Elevation) -> Selection:
    """Return the facades with the chosen one as it was measured: its surroundings may show the other side."""
    chosen = selection.chosen
    if chosen is None or np.cos(np.radians(chosen.azimuth - elevation.frame.azimuth)) > 0:
        return selection
    turned = replace(
        chosen, azimuth=(chosen.azimuth + 180) % 360, normal=-chosen.normal, ends=chosen.ends[::-1]
    )
    facades = tuple(turned if facade is chosen else facade for facade in selection.facades)
    return replace(selection, facades=facades, chosen=turned)


def _key_plan(selection: Selection) -> str:
    """Return the plan of the cloud with its facades; the chosen one is red."""
    facades = selection.facades
    ends = np.concatenate([facade.ends for facade in facades])
    margin = np.array([MARGIN, MARGIN])
    low, high = ends.min(axis=0) - margin, ends.max(axis=0) + margin
    with Map.around(np.array([low, high])) as plan:
        plan.picture(*_seen_in_plan(selection.even, low, high))
        for facade in facades:
            chosen = facade is selection.chosen
            colour, width = (RED, 3.0) if chosen else (COLOURS[0], 2.0)
            plan.lines(facade.ends[:1], facade.ends[1:], colour, width)
            middle = facade.ends.mean(axis=0)
            plan.arrows(middle[None], (middle + ARROW * facade.axes[1])[None], colour)
        places = np.array([facade.ends.mean(axis=0) + ARROW * facade.axes[1] for facade in facades])
        kinds = ["red" if facade is selection.chosen else "strong" for facade in facades]
        plan.names(places, [str(facade.number) for facade in facades], kinds, leading=len(facades))
        return plan.svg()


def _seen_in_plan(even: np.ndarray, low: np.ndarray, high: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return a picture of the points between two corners, and its north-west and south-east corners."""
    size = float(np.max(high - low)) / PIXELS
    columns, rows = np.ceil((high - low) / size).astype(int)
    places = np.floor((even - low) / size).astype(np.int64)
    places = places[((places >= 0) & (places < (columns, rows))).all(axis=1)]
    picture = np.full((rows, columns, 3), WHITE, np.uint8)
    picture[rows - 1 - places[:, 1], places[:, 0]] = SHADE
    return picture, np.array([[low[0], low[1] + rows * size], [low[0] + columns * size, low[1]]])


def _rolled_out(elevation: Elevation) -> str:
    if elevation.curve is None:
        return ""
    if elevation.radius is None:
        return "Its sides are rolled out beside each other: u runs along the wall."
    return f"It is round and rolled out: u runs along the arc, on a radius of {elevation.radius:.3f} m."


def _facade_row(facade: Facade) -> tuple[str, ...]:
    return (
        str(facade.number),
        number(facade.azimuth, 0),
        number(facade.length, 1),
        number(facade.height, 1),
        number(facade.area, 0),
        str(facade.planes),
        str(facade.points),
        "" if facade.seen is None else str(facade.seen),
    )


def _detail_row(detail: Detail) -> tuple[str, ...]:
    return (
        str(detail.number),
        detail.kind,
        detail.use or "",
        detail.shape,
        _with_std(detail.width, detail.width_std),
        _with_std(detail.height, detail.height_std),
        number(detail.sill, 2),
        number(detail.depth, 2),
        ", ".join(detail.measured),
        ", ".join(detail.completed),
    )


def _with_std(size: float, std: Optional[float]) -> str:
    if std is None or not np.isfinite(std):
        return f"({number(size, 3)})"
    return f"{number(size, 3)} ± {number(1000 * std, 0)} mm"
