"""The report of a comparison of plans: how much agrees, how well, and where it does not."""

from collections.abc import Iterable
from pathlib import Path

import numpy as np

from ..reporting.charts import curve_chart
from ..reporting.html import (
    Markup,
    bullets,
    definitions,
    figure,
    notes,
    number,
    paragraph,
    section,
    table,
    write_page,
)
from ..reporting.maps import Map
from ..reporting.svg import COLOURS, GREY, RED
from .plan import AGREES, MISSING, WRONG, PlanAgreement, Stretch

TOLERANCES = (0.01, 0.02, 0.05, 0.10, 0.20, 0.50)
"""At which the table tells completeness and correctness, metres, besides the chosen one."""

MOST_ERRORS = 20
"""Stretches that are listed; the layer has what remains."""

FARTHEST = 3.0
"""Where the curves end, in tolerances."""

BLUE = COLOURS[0]
GREEN = COLOURS[2]


def write_plan_report(path: Path, agreement: PlanAgreement, doubts: Iterable = ()) -> None:
    """Write the page; `doubts` are sentences that the reader must not miss.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    stretches = sorted(agreement.stretches(), key=lambda stretch: -stretch.line.length)
    write_page(
        path,
        "Plan and reference",
        _summary(agreement),
        notes(doubts),
        section("Where they agree", _map(stretches)),
        section("How far apart they are", *_offsets(agreement)),
        section("Longest errors", *_errors(stretches)),
        section("What the numbers mean", _meanings(agreement)),
    )


def _summary(agreement: PlanAgreement) -> Markup:
    tolerance = _centimetres(agreement.tolerance)
    sentences = [
        f"{agreement.completeness:.1%} of the reference is in the plan (completeness at {tolerance}).",
        f"{agreement.correctness:.1%} of the plan is in the reference (correctness at {tolerance}).",
    ]
    if agreement.completeness:
        median, most = _centimetres(agreement.median_offset), _centimetres(agreement.p95_offset)
        sentences.append(
            f"Where the reference is in the plan, half of it is within {median}, 95 % within {most}."
        )
    sentences.append(f"Intersection over union of the areas: {number(agreement.iou, 3)}.")
    return bullets(sentences)


def _map(stretches: list[Stretch]) -> Markup:
    corners = np.vstack([np.asarray(stretch.line.coords) for stretch in stretches])
    plan = Map.around(corners)

    def drawn(colour: str, width: float, *kinds: tuple[str, str]) -> Markup:
        lines = [
            np.asarray(stretch.line.coords) for stretch in stretches if (stretch.side, stretch.state) in kinds
        ]
        starts = np.vstack([np.empty((0, 2)), *(line[:-1] for line in lines)])
        ends = np.vstack([np.empty((0, 2)), *(line[1:] for line in lines)])
        return plan.lines(starts, ends, colour, width)

    sheet = plan.sheet(
        drawn(GREY, 3.0, ("reference", AGREES)),
        drawn(GREEN, 1.4, ("plan", AGREES)),
        drawn(BLUE, 2.4, ("reference", MISSING)),
        drawn(RED, 2.0, ("plan", WRONG)),
    )
    return figure(
        sheet,
        "Green: the plan, where it agrees with the reference (grey); red: the plan, where the reference has "
        "nothing within the tolerance; blue: the reference, where the plan has nothing.",
    )


def _offsets(agreement: PlanAgreement) -> tuple:
    ladder = sorted({*TOLERANCES, agreement.tolerance})
    rows = [
        (_centimetres(at.tolerance), *(number(100 * share, 1) for share in (at.completeness, at.correctness)))
        for at in map(agreement.at, ladder)
    ]
    distances = np.linspace(0, FARTHEST * agreement.tolerance, 121)
    curves = {
        name: (100 * distances, [100 * boundary.share_within(distance) for distance in distances])
        for name, boundary in (("reference", agreement.reference), ("plan", agreement.plan))
    }
    chart = curve_chart(curves, "distance (cm)", "%", [100 * agreement.tolerance])
    header = ("within", "of the reference: completeness (%)", "of the plan: correctness (%)")
    return (
        figure(
            chart,
            "Share of each boundary that is within a distance of the other one; the dashed line is the "
            "tolerance.",
        ),
        table(header, rows),
    )


def _errors(stretches: list[Stretch]) -> tuple:
    errors = [stretch for stretch in stretches if stretch.state != AGREES]
    if not errors:
        return (paragraph("There are none."),)
    shown = errors[:MOST_ERRORS]
    rows = []
    for stretch in shown:
        middle = stretch.line.interpolate(0.5, normalized=True)
        offsets = (_metres(stretch.offset), _metres(stretch.max_offset))
        rows.append(
            (stretch.state, number(stretch.line.length, 2), *offsets, f"{middle.x:.2f}", f"{middle.y:.2f}")
        )
    header = ("state", "length (m)", "median offset (m)", "largest offset (m)", "x of its middle", "y")
    total = {
        state: sum(item.line.length for item in errors if item.state == state) for state in (WRONG, MISSING)
    }
    more = f"The longest {len(shown)} of {len(errors)}." if len(errors) > len(shown) else None
    return (
        paragraph(f"{total[WRONG]:.1f} m are wrong, {total[MISSING]:.1f} m missing."),
        table(header, rows, caption=more),
    )


def _meanings(agreement: PlanAgreement) -> Markup:
    return definitions(
        {
            "Completeness": "Share of the reference's boundary that has the plan's boundary within the "
            f"tolerance, {_centimetres(agreement.tolerance)}.",
            "Correctness": "Share of the plan's boundary that has the reference's boundary within the "
            "tolerance.",
            "Median and 95 % offset": "Of the distances from the reference's boundary to the plan's, where "
            "it was found within the tolerance.",
            "Intersection over union": "Area that is wall in both, divided by the area that is wall in "
            "either; not known if the reference consists of lines.",
        }
    )


def _centimetres(metres: float) -> str:
    return f"{number(100 * metres, 1)} cm"


def _metres(value: float) -> str:
    return number(value if np.isfinite(value) else None, 3)
