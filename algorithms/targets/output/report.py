"""The report: every target as the scanner saw it, with the fitted centre."""

from pathlib import Path

import numpy as np

from ...reporting.numbers import MISSING, number
from ...reporting.page import write_page
from ...reporting.pictures import embedded
from ..explanation import explanation
from ..results import StationTargets, Target, TargetSearch, View
from ..settings import TargetSettings

TEMPLATE = Path(__file__).parent / "templates" / "targets.html"

PIXELS = 320
"""Least side of a picture, so that the pixels of the scan can be seen."""

CROSS = (179, 38, 30)
"""Colour of the cross at the centre."""

HEADER = (
    "name",
    "kind",
    "size (mm)",
    "x",
    "y",
    "z",
    "std (mm)",
    "points",
    "distance (m)",
    "incidence (degrees)",
    "quality",
    "doubt",
)


def write_report(search: TargetSearch, settings: TargetSettings, path: Path) -> None:
    """Write the report as one HTML page.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    write_page(
        path,
        TEMPLATE,
        warnings=search.warnings,
        header=HEADER,
        scans=[_scan(station, settings) for station in search.stations],
    )


def marked(view: View) -> np.ndarray:
    """Return the picture of a target with a cross at its centre, uint8 of shape (rows, columns, 3).

    The cross leaves the centre itself free, so that one sees whether it is right.
    """
    factor = max(1, -(-PIXELS // max(view.picture.shape)))
    large = np.kron(view.picture, np.ones((factor, factor), np.uint8))
    rgb = np.repeat(large[:, :, None], 3, axis=2)
    column, row = (round((value + 0.5) * factor) for value in view.centre)
    gap, arm = max(3, PIXELS // 60), PIXELS // 7
    for start, stop in ((-arm, -gap), (gap + 1, arm + 1)):
        rgb[row - 1 : row + 1, column + start : column + stop] = CROSS
        rgb[row + start : row + stop, column - 1 : column + 1] = CROSS
    return rgb


def _scan(station: StationTargets, settings: TargetSettings) -> dict[str, object]:
    names = [MISSING if target.doubt else str(row) for row, target in enumerate(station.targets, start=1)]
    return {
        "name": station.name,
        "summary": _summary(station),
        "explanation": [] if station.sure else explanation(station, settings),
        "rows": [_row(name, station, target) for name, target in zip(names, station.targets)],
        "doubtful": [row for row, target in enumerate(station.targets) if target.doubt],
        "pictures": [
            (embedded(marked(view)), _caption(name, target, view))
            for name, target, view in zip(names, station.targets, station.views)
        ],
    }


def _summary(station: StationTargets) -> str:
    doubtful = len(station.targets) - len(station.sure)
    doubts = f", {doubtful} doubtful" if doubtful else ""
    return (
        f"{len(station.sure)} targets{doubts}, in {station.points} points with a step of "
        f"{10_000 * station.step:.1f} mm at 10 m."
    )


def _row(name: str, station: StationTargets, target: Target) -> tuple[str, ...]:
    return (
        name,
        target.kind.value,
        number(1000 * target.size, 0),
        *(number(value, 4) for value in station.place(target)),
        number(1000 * target.std, 2),
        str(target.points),
        number(float(np.linalg.norm(target.xyz)), 2),
        number(target.incidence_deg, 0),
        number(target.quality, 2),
        target.doubt,
    )


def _caption(name: str, target: Target, view: View) -> str:
    title = f"Doubtful: {target.doubt}" if target.doubt else name
    return (
        f"{title}. {target.kind.value}, {1000 * target.size:.0f} mm, {np.linalg.norm(target.xyz):.1f} m "
        f"away, centre to {1000 * target.std:.2f} mm. The picture is {1000 * view.height:.0f} mm high."
    )
