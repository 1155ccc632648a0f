"""The parameters of the registration of scans."""

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from ...algorithms.errors import InputError
from .files import CloudFiles
from .parameter import Choice, Flag, Number, ReferenceSystem
from .point_lists import PointListFile, TargetListFiles

if TYPE_CHECKING:
    from ...algorithms.registration.lists.point_list import PointList
    from ...algorithms.registration.settings import Settings

CONTROL = PointListFile(
    "CONTROL",
    "Control points",
    "Surveyed points in metres: a text file with x y z or name x y z, or a layer of points with heights.",
)

CONTROL_IF_ANY = PointListFile(
    "CONTROL",
    "Control points",
    "Surveyed points in metres: a text file with x y z or name x y z, or a layer of points with heights. May "
    "be empty if REFINE is set and no scan has targets: surfaces then place the scans beside the first one.",
    optional=True,
)

TARGETS = TargetListFiles(
    "TARGETS",
    "Targets, one list for each scan, or the scans",
    "Targets picked in the scans, in the scanner's own frame: text files or layers as for control points. "
    "The name of the file is the name of the scan; give the cloud the same name. Scans themselves may be "
    "given instead, or a folder of them: their targets are found on the way, unless there is a list of the "
    "same name. On the command line, repeat TARGETS=file or separate the files by semicolons.",
)

MATCHING = Choice(
    "MATCHING",
    "Matching",
    "How targets are matched with control points. By distances, no names are needed. By names, the distances "
    "reveal wrong names.",
    options=("By distances", "By names"),
)

SIGMA = Number(
    "SIGMA",
    "Standard deviation of a target",
    "Of each coordinate of a picked target, before the adjustment. The statistics test whether it is right. "
    "Targets with standard deviations of their own, as 'Find targets in scans' writes them, are adjusted "
    "with these; SIGMA then says only how exactly distances match.",
    unit="m",
    default=0.003,
    minimum=0.000001,
    maximum=100,
    decimals=4,
)

CONTROL_SIGMA = Number(
    "CONTROL_SIGMA",
    "Standard deviation of a control point",
    "Of each coordinate of a surveyed point. 0 holds the surveyed points fixed; if targets have standard "
    "deviations of their own, 0 takes the one of targets without.",
    unit="m",
    default=0,
    minimum=0,
    maximum=100,
    decimals=4,
)

TOLERANCE = Number(
    "TOLERANCE",
    "Tolerance of distances",
    "Largest difference between a distance of targets and the matching distance of control points. If not "
    "set, it is derived from the standard deviations and written to the log.",
    unit="m",
    minimum=0.000001,
    maximum=100,
    decimals=4,
)

MAX_STD = Number(
    "MAX_STD",
    "Largest standard deviation of a scan without a warning",
    "A scan whose targets are less accurate after the adjustment is registered with a warning, as at the end "
    "of a chain of scans. If not set, it is ten times SIGMA.",
    unit="m",
    minimum=0.000001,
    maximum=100,
    decimals=4,
    advanced=True,
)

MODEL = Choice(
    "MODEL",
    "Transformation",
    "Which parameters are estimated. Choose levelled if the compensator of the scanner was on, and unknown "
    "scale for models that have none, for example from photographs.",
    options=(
        "Rigid, 6 parameters",
        "With a scale near 1, 7 parameters",
        "Levelled, 4 parameters",
        "Levelled with a scale near 1, 5 parameters",
        "Unknown scale, 7 parameters",
    ),
)

REFINE = Flag(
    "REFINE",
    "Tie scans by the surfaces that they share",
    "Walls, floors and other plane surfaces that two scans see tie the scans to each other, together with "
    "the targets and never against them. Scans with too few targets, or none, are placed by their surfaces "
    "if these show one pose only. Needs the clouds: in TARGETS or in SCANS.",
    default=False,
    optional=True,
)

SCANS = CloudFiles(
    "SCANS",
    "Clouds of the scans, to tie them by surfaces",
    "The clouds of scans whose targets are given as lists; each is named after its list. A cloud without a "
    "list is placed by its surfaces. Not needed for scans that are in TARGETS. Used only if scans are tied "
    "by surfaces.",
    optional=True,
)

CRS = ReferenceSystem(
    "CRS",
    "Coordinate reference system, if the control points have none",
    "Projected, in metres. Used only for control points without a reference system.",
)


def settings_of(values: dict[str, Any]) -> "Settings":
    """Return the settings that the user chose."""
    from ...algorithms.registration.settings import Matching, Model, Settings

    return Settings(
        matching=Matching(values["MATCHING"]),
        model=Model(values["MODEL"]),
        sigma=values["SIGMA"],
        control_sigma=values["CONTROL_SIGMA"],
        tolerance=values["TOLERANCE"],
        most_std=values["MAX_STD"],
    )


def control_of(values: dict[str, Any]) -> "PointList":
    """Return the control points, with their own reference system, or else the one that the user chose.

    Raises
    ------
    InputError
        If there are none, although targets need them, or the reference system cannot be used.
    """
    from ...algorithms.reference_systems import chosen_system, require_metres
    from ...algorithms.tables.remarks import system_remark

    control, chosen = values["CONTROL"], values["CRS"]
    if control is None:
        return _no_control(values)
    if control.crs is not None or chosen is None:
        return control
    crs = chosen_system(chosen.toWkt(), "CRS")
    require_metres(crs, "CRS")
    known = system_remark(control.path, str(crs.to_epsg())) if control.path else ""
    return replace(control, crs=crs, warnings=tuple(text for text in control.warnings if text != known))


def _no_control(values: dict[str, Any]) -> "PointList":
    """Return an empty list of control points, if surfaces alone can place all scans."""
    import numpy as np

    from ...algorithms.registration.lists.point_list import PointList

    if not values["REFINE"]:
        raise InputError(
            "CONTROL is empty; choose a text file or a layer of points, or set REFINE to place clouds "
            "without targets by their surfaces."
        )
    if values["TARGETS"].lists:
        raise InputError(
            "CONTROL is empty, but TARGETS has lists; choose the control points, or the list of one of the "
            "scans in their place."
        )
    return PointList("CONTROL", (), np.zeros((0, 3)))
