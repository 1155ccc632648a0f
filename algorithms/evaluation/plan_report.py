"""The report of a comparison of plans: how much agrees, how well, and where it does not."""

import math
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Optional

import numpy as np

from ..reporting.charts import curve_chart
from ..reporting.figures import COLOURS, GREY, RED
from ..reporting.maps import Map
from ..reporting.numbers import number
from ..reporting.page import write_page
from .drawn_plan import RoomAgreement
from .plan import AGREES, MISSING, WRONG, PlanAgreement, Stretch

TEMPLATE = Path(__file__).parent / "templates" / "plan.html"

TOLERANCES = (0.01, 0.02, 0.05, 0.10, 0.20, 0.50)
"""At which the table shows completeness and correctness, besides the chosen one; metres."""

MOST_ERRORS = 20
"""Stretches that are listed; the layer has all."""

FARTHEST = 3.0
"""Where the curves end, in tolerances."""

BLUE, GREEN = COLOURS[0], COLOURS[2]


def write_plan_report(
    path: Path,
    agreement: PlanAgreement,
    doubts: Iterable[str] = (),
    rooms: Optional[RoomAgreement] = None,
) -> None:
    """Write the page; `doubts` are sentences that the reader must not miss.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    stretches = sorted(agreement.stretches(), key=lambda stretch: -stretch.line.length)
    errors = [stretch for stretch in stretches if stretch.state != AGREES]
    write_page(
        path,
        TEMPLATE,
        agreement=agreement,
        tolerance=_centimetres(agreement.tolerance),
        doubts=doubts,
        rooms=rooms,
        map=_map(stretches),
        curves=_curves(agreement),
        shares=_shares(agreement),
        errors=[_error(stretch) for stretch in errors[:MOST_ERRORS]],
        error_count=len(errors),
        wrong_m=_length(errors, WRONG),
        missing_m=_length(errors, MISSING),
    )


def _map(stretches: Sequence[Stretch]) -> str:
    corners = np.vstack([np.asarray(stretch.line.coords) for stretch in stretches])
    kinds = (
        ("reference", AGREES, GREY, 3.0),
        ("plan", AGREES, GREEN, 1.4),
        ("reference", MISSING, BLUE, 2.4),
        ("plan", WRONG, RED, 2.0),
    )
    with Map.around(corners) as plan:
        for side, state, colour, width in kinds:
            chosen = [stretch for stretch in stretches if (stretch.side, stretch.state) == (side, state)]
            lines = [np.asarray(stretch.line.coords) for stretch in chosen]
            starts = np.vstack([np.empty((0, 2)), *(line[:-1] for line in lines)])
            ends = np.vstack([np.empty((0, 2)), *(line[1:] for line in lines)])
            plan.lines(starts, ends, colour, width)
        return plan.svg()


def _curves(agreement: PlanAgreement) -> str:
    distances = np.linspace(0, FARTHEST * agreement.tolerance, 121)
    curves = {
        name: (100 * distances, [100 * boundary.share_within(distance) for distance in distances])
        for name, boundary in (("reference", agreement.reference), ("plan", agreement.plan))
    }
    return curve_chart(curves, "distance (cm)", "%", [100 * agreement.tolerance])


def _shares(agreement: PlanAgreement) -> list[tuple[str, ...]]:
    """Return the rows of the table of completeness and correctness at several tolerances."""
    return [
        (_centimetres(at.tolerance), *(number(100 * share, 1) for share in (at.completeness, at.correctness)))
        for at in map(agreement.at, sorted({*TOLERANCES, agreement.tolerance}))
    ]


def _error(stretch: Stretch) -> tuple[str, ...]:
    middle = stretch.line.interpolate(0.5, normalized=True)
    offsets = (_metres(stretch.offset), _metres(stretch.max_offset))
    return stretch.state, number(stretch.line.length, 2), *offsets, f"{middle.x:.2f}", f"{middle.y:.2f}"


def _length(errors: Sequence[Stretch], state: str) -> float:
    return sum(stretch.line.length for stretch in errors if stretch.state == state)


def _centimetres(metres: float) -> str:
    return f"{number(100 * metres, 1)} cm"


def _metres(value: float) -> str:
    return number(value if math.isfinite(value) else None, 3)
