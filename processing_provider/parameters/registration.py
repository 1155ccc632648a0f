"""What the algorithms that register scans have in common."""

from dataclasses import replace
from typing import TYPE_CHECKING

from .parameter import Choice, Number, ReferenceSystem
from .point_lists import PointListFile, PointListFiles

if TYPE_CHECKING:
    from ...algorithms.registration.lists.point_list import PointList
    from ...algorithms.registration.settings import Settings

CONTROL = PointListFile(
    "CONTROL",
    "Control points",
    "Surveyed points: a text file with x y z or name x y z, or a layer of points with heights. In metres.",
)

TARGETS = PointListFiles(
    "TARGETS",
    "Targets, a list for each scan",
    "Targets picked in the scans, in the scanner's own frame: text files or layers as for control points. "
    "A list is named as its file, and so should be the cloud. On the command line, repeat TARGETS=file or "
    "separate the files by semicolons.",
)

MATCHING = Choice(
    "MATCHING",
    "Matching",
    "How a target finds its control point. By distances no names are needed; by names, a wrong name is found "
    "out by the distances.",
    options=("By distances", "By names"),
)

SIGMA = Number(
    "SIGMA",
    "Standard deviation of a target",
    "Of each coordinate of a picked target, before the adjustment. The statistics tell whether it holds.",
    unit="m",
    default=0.003,
    minimum=0.000001,
    maximum=100,
    decimals=4,
)

CONTROL_SIGMA = Number(
    "CONTROL_SIGMA",
    "Standard deviation of a control point",
    "Of each coordinate of a surveyed point. 0 holds the surveyed points where they are.",
    unit="m",
    default=0,
    minimum=0,
    maximum=100,
    decimals=4,
)

TOLERANCE = Number(
    "TOLERANCE",
    "Tolerance of distances",
    "Largest difference between a distance of targets and one of control points that match. If not set, it "
    "is derived from the standard deviations; the log tells the value.",
    unit="m",
    minimum=0.000001,
    maximum=100,
    decimals=4,
)

MODEL = Choice(
    "MODEL",
    "Transformation",
    "What is unknown of a scan. Levelled is for scanners whose compensator keeps them upright; unknown scale "
    "for models without one, as from photographs.",
    options=(
        "Rigid, 6 parameters",
        "With a scale near 1, 7 parameters",
        "Levelled, 4 parameters",
        "Levelled with a scale near 1, 5 parameters",
        "Unknown scale, 7 parameters",
    ),
)

CRS = ReferenceSystem(
    "CRS",
    "Coordinate reference system, if the control points name none",
    "Projected, in metres. A system that the control points name themselves goes before it.",
)


def settings_of(values: dict) -> "Settings":
    """Return the settings that the user chose."""
    from ...algorithms.registration.settings import Matching, Model, Settings

    return Settings(
        matching=Matching(values["MATCHING"]),
        model=Model(values["MODEL"]),
        sigma=values["SIGMA"],
        control_sigma=values["CONTROL_SIGMA"],
        tolerance=values["TOLERANCE"],
    )


def control_of(values: dict) -> "PointList":
    """Return the control points, in the system that they name, or else the one that the user chose."""
    from ...algorithms.reference_systems import parse_wkt, require_metres

    control, chosen = values["CONTROL"], values["CRS"]
    if control.crs is not None or chosen is None:
        return control
    crs = parse_wkt(chosen.toWkt())
    require_metres(crs, "CRS")
    return replace(control, crs=crs)
