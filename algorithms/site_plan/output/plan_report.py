"""REPORT: a site plan as a page to read: how it came about, and which parameter to turn."""

from collections.abc import Sequence
from pathlib import Path
from typing import Optional

import numpy as np

from ...reporting.charts import histogram
from ...reporting.html import Markup, element, figure, notes, number, paragraph, section, table, write_page
from ...reporting.pictures import embedded, grey
from ..density.density_image import DensityImage
from ..results import SitePlan
from ..rooms.rooms import Room
from ..settings import SitePlanSettings
from ..walls.extraction import ThresholdStep
from .plan_pictures import COLOURS, FACE, ROOM, THUMBNAIL, Fate, View, coloured, fates, fates_at, fitted

MOST_PICTURES = 12
"""Of so many thresholds the page shows what they find; evenly chosen if there are more."""

MOST_ROWS = 300
"""The tables list so many walls and rooms at most; the layers hold all."""


def write_report(path: Path, plan: SitePlan) -> None:
    """Write the report as one HTML page.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    view = View.around(plan.image.gated > 0, plan.transform)
    write_page(
        path,
        "Site plan",
        paragraph(_totals(plan)),
        notes(plan.warnings),
        section("Plan", _final(plan, view)),
        section("What became of the pixels", *_removed(plan, view)),
        section("Thresholds", *_thresholds(plan, view)),
        section("Density image", _density(plan.density, view)),
        section("Parameters", _parameters(plan)),
        section("Walls", _walls(plan)),
        section("Rooms", _rooms(plan.rooms)) if plan.rooms else Markup(),
    )


def _totals(plan: SitePlan) -> str:
    walls = f"Walls: {len(plan.walls)}, {plan.area:.2f} m² in plan, {plan.length:.1f} m long"
    return f"{walls}. Rooms: {len(plan.rooms)}, {plan.room_area:.2f} m²." if plan.rooms else f"{walls}."


def _final(plan: SitePlan, view: View) -> Markup:
    parts = [view.areas([room.outline for room in plan.rooms], ROOM, 0.15)] if plan.rooms else []
    parts.append(view.areas([wall.outline for wall in plan.walls], FACE, 0.35))
    return figure(
        view.sheet(_grey(plan.density, view, 2.0), *parts),
        "The walls over the density image. A wall of the image without a colour is missing: see below which "
        "criterion removed it. A colour where no wall stands: see below what let it pass.",
    )


def _grey(image: DensityImage, view: View, paler: float = 1.0) -> np.ndarray:
    held = image.density[np.isfinite(image.density)]
    return grey(fitted(view.part(image.density)), paler * float(held.mean() + 2 * held.std()))


def _density(image: DensityImage, view: View) -> Markup:
    return figure(
        view.sheet(_grey(image, view)),
        f"Points per pixel, of the {image.points_kept:,} of {image.points_in:,} points that thinning kept; "
        "black is two standard deviations above the mean. Walls should stand out as lines. If they are "
        "dotted, raise PIXEL_SIZE; if neighbouring faces run into each other, lower it, and SPACING with it.",
    )


def _removed(plan: SitePlan, view: View) -> tuple[Markup, ...]:
    fate = fates(plan, view)
    area = np.bincount(fate.ravel(), minlength=len(Fate)) * plan.transform.a**2
    found = plan.image
    regions = sum(step.regions for step in found.steps)
    small = sum(step.too_small for step in found.steps)
    misshapen = sum(step.wrong_shape for step in found.steps)
    rows = [
        (Fate.WALL, "wall", "THRESHOLD up, MIN_AREA up or MAX_FILL down if it is none"),
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
    listed = [(_swatch(kind), what, number(float(area[kind]), 2), turn) for kind, what, turn in rows]
    return (
        figure(
            view.sheet(coloured(fate)),
            "Each pixel by the last criterion that it met. Look for a missing wall, read its colour, and "
            "turn the parameter beside that colour.",
        ),
        table(("", "pixels that are", "m²", "turn"), listed, words=(0, 1, 3)),
        paragraph("Regions are counted anew at each threshold."),
    )


def _swatch(kind: Fate) -> Markup:
    colour = "rgb({}, {}, {})".format(*COLOURS[kind])
    style = f"display:inline-block;width:1.6em;height:1em;border:1px solid #90a4ae;background:{colour}"
    return element("span", style=style)


def _thresholds(plan: SitePlan, view: View) -> tuple[Markup, ...]:
    thresholds, steps = plan.image.thresholds, plan.image.steps
    shown = np.unique(np.linspace(0, len(steps) - 1, min(len(steps), MOST_PICTURES)).round().astype(int))
    tall = plan.image.gated[plan.image.gated > 0] / thresholds.deviation
    pictures = [
        element(
            "figure",
            element("img", src=address, alt=caption, style="width:100%;border:1px solid #cfd8dc"),
            element("figcaption", caption),
            style="width:31%;margin:0",
        )
        for caption, address in (_picture(plan, steps[i], view) for i in shown)
    ]
    rows = [
        (number(step.threshold, 2), *map(str, (step.regions, step.too_small, step.wrong_shape)))
        for step in steps
    ]
    ends = (thresholds.values[0], thresholds.values[-1])
    return (
        element("div", *pictures, style="display:flex;flex-wrap:wrap;gap:1rem 3%;margin:1rem 0"),
        paragraph(
            "The regions above each threshold, in the colours of the picture above. If floors or clutter are "
            "kept in the first pictures, raise THRESHOLD; if faint walls show in none, lower it. If the last "
            "pictures find nothing more, THRESHOLD_MAX may be lower."
        ),
        figure(
            histogram(np.minimum(tall, 2 * ends[1]), "density of pixels that may be wall", limits=ends),
            "In standard deviations of the density image; the last bar holds all that is denser. Lines mark "
            "the lowest and the highest threshold, as far as they lie in between.",
        ),
        table(("threshold", "regions", "too small", "misshapen"), rows, words=()),
    )


def _picture(plan: SitePlan, step: ThresholdStep, view: View) -> tuple[str, str]:
    """Return the caption and the address of the picture of a threshold."""
    kept = step.regions - step.too_small - step.wrong_shape
    fate = fates_at(plan.image.verdicts(step), view)
    caption = f"{step.threshold:.2f}: {kept} of {step.regions} regions kept"
    return caption, embedded(coloured(fate, THUMBNAIL))


def _parameters(plan: SitePlan) -> Markup:
    found, given, gate = plan.image, plan.image.parameters, plan.image.gate
    values, deviation, rule = found.thresholds.values, found.thresholds.deviation, found.thresholds.rule

    def density(value: float) -> str:
        return f"{value:.3g} standard deviations = {value * deviation:.3g} points per pixel"

    def origin(value: Optional[float], derived: str) -> str:
        return "given" if value is not None else f"derived: {derived}"

    seen = "heights tell where the ground was seen" if gate.open_ground is not None else "no heights are used"
    rows = [
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
    return table(("parameter", "value", "origin"), rows, words=(1, 2), caption="Defaults count as given.")


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
        **({"DOOR_WIDTH": f"{settings.door_width_m:g} m"} if settings.with_rooms else {}),
    }


def _walls(plan: SitePlan) -> Markup:
    header = ("wall", "kind", "length", "thickness", "base", "top", "height", "azimuth", "area", "votes")
    fields = ("length", "thickness", "z_base", "z_top", "height")
    rows = [
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
    caption = "Metres, degrees from grid north, square metres; votes are thresholds. " + _cut(plan.walls)
    return table(header, rows, words=(0, 1), caption=caption)


def _rooms(rooms: Sequence[Room]) -> Markup:
    rows = [
        (
            str(room.room_id),
            number(room.area, 2),
            number(room.perimeter, 2),
            str(room.openings),
            number(room.z_floor, 2),
        )
        for room in rooms[:MOST_ROWS]
    ]
    caption = "Square metres and metres. If a room is missing, a gap in its walls is wider than DOOR_WIDTH. "
    header = ("room", "area", "perimeter", "openings", "floor")
    return table(header, rows, words=(0,), caption=caption + _cut(rooms))


def _cut(items: Sequence[object]) -> str:
    return f"The first {MOST_ROWS} of {len(items)}." if len(items) > MOST_ROWS else ""
