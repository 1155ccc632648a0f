"""The algorithm `registerscans`."""

from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from ...algorithms.errors import InputError, NothingFoundError
from ..algorithm import Algorithm, Outcome
from ..dependencies import FOR_LAYERS
from ..found_targets import lists_of
from ..log import Log
from ..parameters.destinations import HtmlDestination, JsonDestination, PointDestination
from ..parameters.registration import (
    CONTROL_IF_ANY,
    CONTROL_SIGMA,
    CRS,
    MATCHING,
    MAX_STD,
    MODEL,
    REFINE,
    SCANS,
    SIGMA,
    TARGETS,
    TOLERANCE,
    control_of,
    settings_of,
)
from ..scan_surfaces import surfaces_of_scans, with_clouds_alone

if TYPE_CHECKING:
    from ...algorithms.registration.results import Registration, ScanRegistration, SharedSurfaces


NO_SYSTEM = "The control points have no coordinate reference system, so the results have none; set CRS."


class RegisterScansAlgorithm(Algorithm):
    """Identify the control points behind the targets, and georeference the scans."""

    key = "registerscans"
    title = "Register scans to control points"
    chapter = "Registration"
    summary = "Identifies the control point behind each target, without names, and georeferences the scans."
    about = (
        "Targets picked or found in each scan are matched with surveyed control points by their distances, "
        "and the transformations of all scans are adjusted together. Targets that are not control points tie "
        "the scans to each other. A scan without an unambiguous solution is refused, with the reason "
        "(Herbig, Mayer, Mortada and Rasztovits 2013)."
    )
    words = (
        "registration",
        "georeference",
        "targets",
        "control points",
        "total station",
        "transformation",
        "helmert",
        "adjustment",
        "laser scan",
        "point cloud",
        "tls",
    )
    needs = FOR_LAYERS
    inputs = (
        *(CONTROL_IF_ANY, TARGETS, MATCHING, SIGMA, CONTROL_SIGMA, TOLERANCE, MODEL, CRS, MAX_STD),
        *(REFINE, SCANS),
    )
    destinations = (
        JsonDestination(
            "TRANSFORMS",
            "Transformations",
            "JSON file with the status and the matrix of each scan, for 'Transform laser scans'.",
        ),
        PointDestination(
            "CONTROL_OUT",
            "Control points, surveyed and appended",
            "Points with their standard deviations and the scans that use them. GeoPackage or shapefile, by "
            "extension.",
            style="control_points",
            optional=True,
        ),
        PointDestination(
            "RESIDUALS",
            "Residuals",
            "Points with the difference between target and control point, drawn as arrows, and their tests. "
            "GeoPackage or shapefile, by extension.",
            style="residuals",
            optional=True,
        ),
        HtmlDestination(
            "REPORT",
            "Report of the registration",
            "HTML page with plan, residuals and statistics of every scan; see the results viewer.",
            optional=True,
        ),
    )
    numbers = (
        ("SCANS_REGISTERED", "Number of registered scans"),
        ("SIGMA0", "Standard deviation of unit weight, a posteriori over a priori"),
        ("MAX_RESIDUAL", "Longest residual of the targets that were used (m)"),
    )

    def compute(self, values: dict[str, Any], log: Log) -> Outcome:
        """Register the scans."""
        from ...algorithms.reference_systems import position_warning
        from ...algorithms.registration.output.layers import exaggeration, write_control, write_residuals
        from ...algorithms.registration.output.transforms import write_transforms
        from ...algorithms.registration.registration import register_scans

        control, settings, given = control_of(values), settings_of(values), values["TARGETS"]
        surveyed = bool(control.names)
        if surveyed:
            if control.crs is None:
                log.warn([NO_SYSTEM])
            middle = np.median(control.xyz, axis=0)
            log.warn(position_warning(control.crs, middle, str(control.path or control.name)))
        searched = 0.8 if given.clouds and surveyed else 0.0
        read = searched + (1 - searched) / 2 if values["REFINE"] else searched
        clouds = [*given.scans, *values["SCANS"]] if values["REFINE"] else []
        if not (given.lists or given.clouds or clouds):
            raise InputError("TARGETS is empty; choose at least one list of points, or scan.")
        scans = []
        if surveyed:
            scans = lists_of(given, settings.named, log, log.progress.part(0.0, searched))
            if not any(points.names for points in scans):
                raise InputError(
                    "No scan has targets, so that CONTROL cannot be used; choose TARGETS, or leave CONTROL "
                    "empty to join the scans in the frame of the first."
                )
        surfaces = {}
        if values["REFINE"]:
            scans, progress = with_clouds_alone(scans, clouds), log.progress.part(searched, read)
            surfaces = surfaces_of_scans(clouds, scans, settings, log, progress)
        registration = register_scans(control, scans, settings, log.progress.part(read, 1.0), surfaces)
        _log(registration, log)
        if not registration.registered:
            reasons = " ".join(scan.reason for scan in registration.scans)
            raise NothingFoundError(f"No scan could be registered. {reasons}")
        writers = {
            "TRANSFORMS": write_transforms,
            "RESIDUALS": write_residuals,
            "CONTROL_OUT": write_control,
        }
        if values["REPORT"]:
            from ...algorithms.registration.output.report import write_report

            writers["REPORT"] = write_report
        return Outcome(
            {name: partial(write, registration) for name, write in writers.items()},
            {
                "SCANS_REGISTERED": len(registration.registered),
                "SIGMA0": registration.test.sigma0,
                "MAX_RESIDUAL": registration.max_residual,
            },
            {"RESIDUALS": {"exaggeration": exaggeration(registration.registered)}},
        )


def _log(registration: "Registration", log: Log) -> None:
    from ...algorithms.registration.output.report_scan import IS_FRAME, by_surfaces, change_by_surfaces

    log.warn(registration.warnings)
    log.info(f"Tolerance of distances: {1000 * registration.tolerance:.1f} mm.")
    for scan in registration.scans:
        if scan.test is None:
            log.warn([f"{scan.name} is not registered ({scan.status}): {scan.reason}"])
        elif scan.is_frame:
            log.info(f"{scan.name}: {IS_FRAME}")
        elif scan.placement is not None:
            log.info(f"{scan.name}: {by_surfaces(scan.placement)}")
        else:
            log.info(_line(scan, scan.test.sigma0))
        if scan.surfaces is not None:
            log.info(f"{scan.name}: {change_by_surfaces(scan.surfaces)}")
        log.warn(scan.warnings)
    for shared in registration.surfaces:
        log.info(_tie(shared))


def _tie(shared: "SharedSurfaces") -> str:
    one, other = shared.scans
    return (
        f"{one} and {other} share {shared.patches} patches of surface, an overlap of "
        f"{100 * shared.overlap:.0f} %; after the adjustment they lie {1000 * shared.rms:.2f} mm apart (rms)."
    )


def _line(scan: "ScanRegistration", sigma0: float) -> str:
    """Return what the log says of a registered scan."""
    used = [item for item in scan.correspondences if item.used]
    longest = 1000 * max(item.length for item in used)
    chance = "" if scan.chance is None else f", {scan.chance:.1g} accidental matches expected"
    return (
        f"{scan.name}: {len(used)} of {scan.targets} targets matched, sigma0 {sigma0:.2f}, "
        f"longest residual {longest:.1f} mm, standard deviation up to "
        f"{1000 * (scan.std or 0.0):.1f} mm{chance}."
    )
