"""REPORT: a site plan as a page to read: how it came about, and which parameter to change."""

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple, Optional

import numpy as np

from ...reporting.charts import histogram
from ...reporting.maps import Map
from ...reporting.numbers import number
from ...reporting.page import write_page
from ...reporting.pictures import embedded, grey
from ..density.density_image import DensityImage
from ..results import SitePlan
from ..rooms.rooms import Room
from ..settings import SitePlanSettings
from ..walls.extraction import ThresholdStep
from .plan_pictures import COLOURS, THUMBNAIL, Fate, View, coloured, fates, fates_at, fitted
from .storey_report import FACE, ROOM, decided_by, shown

TEMPLATE = Path(__file__).parent / "templates" / "site_plan.html"

MOST_PICTURES = 12
"""Thresholds of which the page shows what they find; evenly chosen if there are more."""

MOST_ROWS = 300
"""Walls and rooms that the tables list at most; the layers hold all."""


class _FateRow(NamedTuple):
    """A row of the table of fates: the area in m2, and which parameter to change."""

    colour: str
    pixels: str
    area: float
    remedy: str


def write_report(path: Path, plan: SitePlan) -> None:
    """Write the report as one HTML page.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    view = View.around(plan.image.gated > 0, plan.transform)
    fate = fates(plan, view)
    areas = np.bincount(fate.ravel(), minlength=len(Fate)) * plan.transform.a**2
    write_page(
        path,
        TEMPLATE,
        plan=plan,
        image=plan.density,
        rooms=plan.rooms or (),
        warnings=plan.warnings,
        plan_map=_plan_map(plan, view),
        decided_by=decided_by(plan),
        storey=shown(plan.storey) if plan.storey else None,
        fate_map=_map(view, coloured(fate)),
        fates=_fate_rows(plan, areas),
        pictures=_pictures(plan, view),
        histogram=_histogram(plan),
        steps=[_step_row(step) for step in plan.image.steps],
        density_map=_map(view, _grey(plan.density, view)),
        parameters=_parameters(plan),
        wall_rows=_wall_rows(plan),
        room_rows=_room_rows(plan.rooms or ()),
    )


def _step_row(step: ThresholdStep) -> tuple[str, ...]:
    return number(step.threshold, 2), *map(str, (step.regions, step.too_small, step.wrong_shape))


def _pictures(plan: SitePlan, view: View) -> list[tuple[str, str]]:
    """Return captions and addresses of pictures of what was found at thresholds."""
    steps = plan.image.steps
    shown = np.unique(np.linspace(0, len(steps) - 1, min(len(steps), MOST_PICTURES)).round().astype(int))
    return [_picture(plan, steps[i], view) for i in shown]


def _picture(plan: SitePlan, step: ThresholdStep, view: View) -> tuple[str, str]:
    kept = step.regions - step.too_small - step.wrong_shape
    fate = fates_at(plan.image.verdicts(step), view)
    caption = f"{step.threshold:.2f}: {kept} of {step.regions} regions kept"
    return caption, embedded(coloured(fate, THUMBNAIL))


def _plan_map(plan: SitePlan, view: View) -> str:
    with Map.around(view.corners) as sheet:
        sheet.picture(_grey(plan.density, view, 2.0), view.corners)
        sheet.areas([room.outline for room in plan.rooms or ()], ROOM, 0.15)
        sheet.areas([wall.outline for wall in plan.walls], FACE, 0.35)
        return sheet.svg()


def _map(view: View, rgb: np.ndarray) -> str:
    with Map.around(view.corners) as sheet:
        sheet.picture(rgb, view.corners)
        return sheet.svg()


def _grey(image: DensityImage, view: View, paler: float = 1.0) -> np.ndarray:
    held = image.density[np.isfinite(image.density)]
    return grey(fitted(view.part(image.density)), paler * float(held.mean() + 2 * held.std()))


def _fate_rows(plan: SitePlan, areas: np.ndarray) -> list[_FateRow]:
    found = plan.image
    regions = sum(step.regions for step in found.steps)
    small = sum(step.too_small for step in found.steps)
    misshapen = sum(step.wrong_shape for step in found.steps)
    rows = [
        (Fate.WALL, "wall", "THRESHOLD up, MIN_AREA up or MAX_FILL down where there is no wall"),
        (
            Fate.CLOSED,
            f"added by CLOSING {found.gap:g} m",
            "CLOSING down if it fills niches or passages, up if the two faces of a wall remain apart",
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
            "MIN_HEIGHT 0 keeps it, and all else",
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


def _parameters(plan: SitePlan) -> list[tuple[str, str, str]]:
    found, given, gate = plan.image, plan.image.parameters, plan.image.gate
    values, deviation, rule = found.thresholds.values, found.thresholds.deviation, found.thresholds.rule

    def density(value: float) -> str:
        return f"{value:.3g} standard deviations = {value * deviation:.3g} points per pixel"

    def origin(value: Optional[float], derived: str) -> str:
        return "given" if value is not None else f"derived: {derived}"

    seen = "heights show where the ground was seen" if gate.open_ground is not None else "no heights are used"
    return [
        ("THRESHOLD", density(values[0]), origin(given.threshold, rule.value if rule else "")),
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
        ("PIXEL_SIZE", f"{plan.transform.a:g} m", "given"),
        *((name, value, "given") for name, value in _run(plan.settings).items()),
        ("CRS", plan.crs.to_string() if plan.crs else "none", "of the files, or given"),
    ]


def _run(settings: SitePlanSettings) -> dict[str, str]:
    """Return the parameters of the run beyond those of the walls."""
    heights = settings.height_range
    limits = {"ZMIN": heights.low, "ZMAX": heights.high}
    return {
        "SPACING": f"{settings.spacing_m:g} m",
        "NEIGHBOURHOOD": f"{settings.neighbourhood_px} pixels",
        "REFINE": "yes" if settings.refine else "no",
        **{name: f"{value:g} m" for name, value in limits.items() if np.isfinite(value)},
        **({"HEIGHTS": "above the local ground"} if heights.above_ground else {}),
        **({"DOOR_WIDTH": f"{settings.rooms.door_width_m:g} m"} if settings.with_rooms else {}),
    }


def _wall_rows(plan: SitePlan) -> list[tuple[str, ...]]:
    fields = ("length", "thickness", "z_base", "z_top", "height")
    return [
        (
            str(wall.wall_id),
            wall.kind,
            *(number(getattr(wall, field, None), 2) for field in fields),
            number(wall.azimuth, 1),
            number(wall.outline.area, 2),
            number(wall.votes, 0),
        )
        for wall in plan.walls[:MOST_ROWS]
    ]


def _room_rows(rooms: Sequence[Room]) -> list[tuple[str, ...]]:
    return [
        (
            str(room.room_id),
            number(room.area, 2),
            number(room.perimeter, 2),
            number(room.openings, 0),
            number(room.z_floor, 2),
            number(room.z_ceiling, 2),
            number(None if room.seen is None else 100 * room.seen, 0),
        )
        for room in rooms[:MOST_ROWS]
    ]
