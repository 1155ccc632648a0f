"""REPORT: a site plan as a page to read: how it came about, and which parameter to change."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple, Optional

import numpy as np

from ...reporting.charts import histogram
from ...reporting.maps import Map
from ...reporting.numbers import number
from ...reporting.page import write_page
from ...reporting.pictures import embedded, grey
from ..density.density_image import DensityImage
from ..rooms.rooms import Room
from ..site_plan import SitePlan
from ..walls.extraction import select_by_threshold
from ..walls.height_gate import Gate, make_gate
from ..walls.thresholds import surface_rule
from .plan_pictures import COLOURS, THUMBNAIL, Fate, View, coloured, fates, fates_at, fitted

TEMPLATE = Path(__file__).parent / "templates" / "site_plan.html"

MOST_PICTURES = 12
"""Thresholds of which the page shows what they find; evenly chosen if there are more."""

MOST_ROWS = 300
"""Walls and rooms that the tables list at most; the layers hold all."""

FACE, ROOM = "#a8321a", "#2a8a96"


@dataclass(frozen=True)
class _Steps:
    """What the criteria did over the thresholds.

    Attributes
    ----------
    small, misshapen : ndarray of bool, shape (rows, columns)
        Pixels of regions that were removed at any threshold.
    rows : list of (float, int, int, int)
        Threshold, regions, of them too small, of them misshapen.
    pictures : list of (str, str)
        Captions and addresses.
    """

    small: np.ndarray
    misshapen: np.ndarray
    rows: list[tuple[float, int, int, int]]
    pictures: list[tuple[str, str]]


class _FateRow(NamedTuple):
    """A row of the table of fates: the area in m2, and which parameter to change."""

    colour: str
    pixels: str
    area: float
    remedy: str


def write_report(
    path: Path, plan: SitePlan, image: DensityImage, settings: Mapping[str, str], rooms: Sequence[Room] = ()
) -> None:
    """Write the report as one HTML page.

    Parameters
    ----------
    path : Path
    plan : SitePlan
    image : DensityImage
        What the plan was made from.
    settings : mapping of str to str
        Further parameters of the run and their values.
    rooms : sequence of Room
        If they were looked for.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    gate = make_gate(image.density, image.heights, plan.image.parameters.min_height, image.transform.a)
    view = View.around(plan.image.gated > 0, image.transform)
    steps = _steps(plan, gate, view, image.transform.a)
    fate = fates(plan, view, gate, np.isfinite(image.density), steps.small, steps.misshapen)
    write_page(
        path,
        TEMPLATE,
        plan=plan,
        image=image,
        rooms=rooms,
        warnings=(*image.warnings, *plan.image.warnings),
        plan_map=_plan_map(plan, image, view, rooms),
        fate_map=_map(view, coloured(fate)),
        fates=_fate_rows(plan, np.bincount(fate.ravel(), minlength=len(Fate)) * image.transform.a**2, steps),
        pictures=steps.pictures,
        histogram=_histogram(plan),
        steps=[(number(value, 2), *map(str, counts)) for value, *counts in steps.rows],
        density_map=_map(view, _grey(image, view)),
        parameters=_parameters(plan, image, gate, settings),
        wall_rows=_wall_rows(plan),
        room_rows=_room_rows(rooms),
    )


def _steps(plan: SitePlan, gate: Gate, view: View, pixel_size: float) -> _Steps:
    """Repeat the thresholds of the extraction, and note what it removed."""
    found = plan.image
    values = found.thresholds.values
    shown = set(np.linspace(0, len(values) - 1, min(len(values), MOST_PICTURES)).round().astype(int).tolist())
    steps = _Steps(np.zeros(found.walls.shape, bool), np.zeros(found.walls.shape, bool), [], [])
    selections = select_by_threshold(found.gated, found.thresholds, pixel_size, found.criteria, gate.column)
    for i, selection in enumerate(selections):
        np.logical_or(steps.small, selection.small, out=steps.small)
        np.logical_or(steps.misshapen, selection.misshapen, out=steps.misshapen)
        counts = (selection.regions, selection.too_small, selection.wrong_shape)
        steps.rows.append((values[i], *counts))
        if i in shown:
            kept = counts[0] - counts[1] - counts[2]
            picture = embedded(coloured(fates_at(selection, view), THUMBNAIL))
            steps.pictures.append((f"{values[i]:.2f}: {kept} of {counts[0]} regions kept", picture))
    return steps


def _plan_map(plan: SitePlan, image: DensityImage, view: View, rooms: Sequence[Room]) -> str:
    with Map.around(view.corners) as sheet:
        sheet.picture(_grey(image, view, 2.0), view.corners)
        sheet.areas([room.outline for room in rooms], ROOM, 0.15)
        sheet.areas([wall.outline for wall in plan.walls], FACE, 0.35)
        return sheet.svg()


def _map(view: View, rgb: np.ndarray) -> str:
    with Map.around(view.corners) as sheet:
        sheet.picture(rgb, view.corners)
        return sheet.svg()


def _grey(image: DensityImage, view: View, paler: float = 1.0) -> np.ndarray:
    held = image.density[np.isfinite(image.density)]
    return grey(fitted(view.part(image.density)), paler * float(held.mean() + 2 * held.std()))


def _fate_rows(plan: SitePlan, areas: np.ndarray, steps: _Steps) -> list[_FateRow]:
    found = plan.image
    regions, small, misshapen = (sum(column) for column in list(zip(*steps.rows))[1:])
    rows = [
        (Fate.WALL, "wall", "THRESHOLD up, MIN_AREA up or MAX_FILL down where there is no wall"),
        (
            Fate.CLOSED,
            f"added by CLOSING {found.gap:g} m",
            "CLOSING down if it fills niches or passages, up if the two faces of a wall stay apart",
        ),
        (
            Fate.MISSHAPEN,
            f"neither straight nor curved: {misshapen} of {regions} regions",
            f"MIN_ELONGATION {found.criteria.min_elongation:g} down for short straight walls, MAX_FILL "
            f"{found.criteria.max_fill:g} up for curved or angled ones",
        ),
        (
            Fate.SMALL,
            f"smaller than MIN_AREA {found.criteria.min_area:g} m²: {small} of {regions} regions",
            "MIN_AREA down if walls are among it",
        ),
        (
            Fate.FAINT,
            f"fainter than THRESHOLD {found.thresholds.values[0]:.2f}",
            "THRESHOLD down if walls are among it",
        ),
        (
            Fate.FOLIAGE,
            "foliage: points spread over the plan, not along a face",
            "MIN_HEIGHT=0 keeps it, and all else",
        ),
        (
            Fate.FURNITURE,
            "furniture: ends below a ceiling that walls reach",
            "ZMAX below the ceiling if low walls are among it",
        ),
        (
            Fate.LOW,
            f"above the ground, but less occupied than MIN_HEIGHT {found.parameters.min_height:g} m",
            "MIN_HEIGHT down if walls are among it, low or sparsely scanned ones",
        ),
        (Fate.SURFACE, "floor, ground and the like", ""),
    ]
    return [
        _FateRow("rgb({}, {}, {})".format(*COLOURS[kind]), pixels, float(areas[kind]), remedy)
        for kind, pixels, remedy in rows
    ]


def _histogram(plan: SitePlan) -> str:
    """Return how dense the pixels are that may be wall, with the lowest and the highest threshold."""
    thresholds = plan.image.thresholds
    tall = plan.image.gated[plan.image.gated > 0] / thresholds.deviation
    ends = (thresholds.values[0], thresholds.values[-1])
    return histogram(np.minimum(tall, 2 * ends[1]), "density of pixels that may be wall", limits=ends)


def _parameters(
    plan: SitePlan, image: DensityImage, gate: Gate, settings: Mapping[str, str]
) -> list[tuple[str, str, str]]:
    found, given = plan.image, plan.image.parameters
    held = np.isfinite(image.density)
    rule = surface_rule(gate.flat[held], gate.tall[held])
    values, deviation = found.thresholds.values, found.thresholds.deviation

    def density(value: float) -> str:
        return f"{value:.3g} standard deviations = {value * deviation:.3g} points per pixel"

    def origin(value: Optional[float], derived: str) -> str:
        return "given" if value is not None else f"derived: {derived}"

    seen = "heights show where the ground was seen" if gate.open_ground is not None else "no heights are used"
    return [
        ("THRESHOLD", density(values[0]), origin(given.threshold, rule.value)),
        (
            "THRESHOLD_MAX",
            density(values[-1]),
            origin(given.threshold_max, "the median density of the pixels above THRESHOLD that may be wall"),
        ),
        ("THRESHOLD_STEPS", str(len(values)), "given"),
        (
            "MIN_AREA",
            f"{found.criteria.min_area:g} m²",
            origin(given.min_area, "a metre of wall one pixel thick"),
        ),
        ("MAX_FILL", f"{found.criteria.max_fill:g}", "given"),
        ("MIN_ELONGATION", f"{found.criteria.min_elongation:g}", "given"),
        ("CLOSING", f"{found.gap:g} m", origin(given.closing, seen)),
        ("MIN_HEIGHT", f"{given.min_height:g} m", "given" if gate.column is not None else "not applied"),
        ("PIXEL_SIZE", f"{image.transform.a:g} m", "given"),
        *((name, value, "given") for name, value in settings.items()),
        ("CRS", image.crs.to_string() if image.crs else "none", "of the files, or given"),
    ]


def _wall_rows(plan: SitePlan) -> list[tuple[str, ...]]:
    fields = ("length", "thickness", "z_base", "z_top", "height")
    return [
        (
            str(wall.wall_id),
            wall.kind,
            *(number(getattr(wall, field, None), 2) for field in fields),
            number(wall.azimuth, 1),
            number(wall.outline.area, 2),
            str(wall.votes),
        )
        for wall in plan.walls[:MOST_ROWS]
    ]


def _room_rows(rooms: Sequence[Room]) -> list[tuple[str, ...]]:
    return [
        (
            str(room.room_id),
            number(room.area, 2),
            number(room.perimeter, 2),
            str(room.openings),
            number(room.z_floor, 2),
        )
        for room in rooms[:MOST_ROWS]
    ]
