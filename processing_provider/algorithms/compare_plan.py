"""The algorithm `compareplan`."""

import math
from functools import partial
from typing import Any, Optional

from ..algorithm import Algorithm, Outcome
from ..dependencies import FOR_LAYERS
from ..log import Log
from ..parameters.destinations import HtmlDestination, LineDestination
from ..parameters.outlines import OutlineLayer, ReferenceLayer
from ..parameters.parameter import Number


class ComparePlanAlgorithm(Algorithm):
    """Compare a plan with a reference."""

    key = "compareplan"
    title = "Compare a plan with a reference"
    chapter = "Site plan"
    summary = "Measures how complete, correct and accurate a plan is, compared with a reference."
    about = (
        "The boundaries of both layers are compared every 2 cm. Completeness is the share of the reference's "
        "boundary with a boundary of the plan within the tolerance. Correctness is the share of the plan's "
        "boundary with one of the reference within the tolerance. The offsets are the distances of the "
        "two, where the reference was found."
    )
    words = (
        "site plan",
        "accuracy",
        "validation",
        "completeness",
        "correctness",
        "iou",
        "walls",
        "reference",
    )
    needs = FOR_LAYERS
    inputs = (
        OutlineLayer(
            "WALLS", "Walls of the plan", "Polygons, as siteplan writes them. Polygons that touch are joined."
        ),
        ReferenceLayer(
            "REFERENCE",
            "Reference",
            "The true walls as polygons, or their faces as lines, in metres. In the coordinate reference "
            "system of the walls. A layer with a polygon whose field kind is judged is a plan drawn by hand: "
            "its kinds say what a plan must have, what it may have, and where nothing is judged.",
        ),
        OutlineLayer(
            "ROOMS",
            "Rooms of the plan",
            "Polygons, as siteplan writes them: they are compared with the rooms of a plan drawn by hand.",
            optional=True,
        ),
        Number(
            "TOLERANCE",
            "Tolerance",
            "Up to this distance a boundary counts as found. Choose it from the accuracy the plan needs.",
            unit="m",
            minimum=0.001,
            default=0.10,
        ),
    )
    destinations = (
        LineDestination(
            "ERRORS",
            "Errors",
            "Lines with side (plan or reference), state (agrees, wrong, missing), median and largest offset, "
            "length. GeoPackage or shapefile, by extension.",
            style="plan_errors",
        ),
        HtmlDestination(
            "REPORT", "Report of the comparison", "HTML page with a map, curves and tables.", optional=True
        ),
    )
    numbers = (
        ("COMPLETENESS", "Share of the reference that is in the plan (0 to 1)"),
        ("CORRECTNESS", "Share of the plan that is in the reference (0 to 1)"),
        ("IOU", "Intersection over union of the areas (0 to 1)"),
        ("MEDIAN_OFFSET", "Median offset of the reference that was found (m)"),
        ("P95_OFFSET", "Offset that 95 % of the reference that was found does not exceed (m)"),
        ("ROOMS_FOUND", "Number of drawn rooms that the plan has"),
        ("ROOMS_MISSED", "Number of drawn rooms that it lacks"),
        ("ROOMS_INVENTED", "Number of its rooms that are not drawn"),
    )

    def compute(self, values: dict[str, Any], log: Log) -> Outcome:
        """Compare the outlines."""
        from ...algorithms.evaluation.outlines import disagreements
        from ...algorithms.evaluation.plan_layer import write_errors
        from ...algorithms.evaluation.reference import compare_drawn_rooms, compare_with_reference

        walls, reference, tolerance = values["WALLS"], values["REFERENCE"], values["TOLERANCE"]
        doubts = disagreements(walls, reference.outlines, tolerance)
        log.warn(doubts)
        found = compare_with_reference(walls, reference, tolerance)
        rooms = compare_drawn_rooms(values["ROOMS"], reference)
        log.info(f"Completeness {found.completeness:.3f}, correctness {found.correctness:.3f}.")
        if reference.drawn:
            log.info("The reference is a plan drawn by hand: only its judged region is compared.")
        if values["ROOMS"] and not rooms:
            log.warn(["ROOMS are not compared, because REFERENCE has no rooms drawn by hand."])
        if rooms:
            log.info(f"Rooms: {rooms.found} found, {rooms.missed} missed, {rooms.invented} invented.")
        if found.completeness:
            log.info(f"Offset: median {found.median_offset:.4f} m, 95 % {found.p95_offset:.4f} m.")
        writers = {"ERRORS": partial(write_errors, agreement=found, crs=walls.crs or reference.outlines.crs)}
        if values["REPORT"]:
            from ...algorithms.evaluation.plan_report import write_plan_report

            writers["REPORT"] = partial(write_plan_report, agreement=found, doubts=doubts, rooms=rooms)
        return Outcome(
            writers,
            {
                "COMPLETENESS": found.completeness,
                "CORRECTNESS": found.correctness,
                "IOU": _known(found.iou),
                "MEDIAN_OFFSET": _known(found.median_offset),
                "P95_OFFSET": _known(found.p95_offset),
                "ROOMS_FOUND": rooms.found if rooms else None,
                "ROOMS_MISSED": rooms.missed if rooms else None,
                "ROOMS_INVENTED": rooms.invented if rooms else None,
            },
            {"ERRORS": {"tolerance": tolerance, "quarter": tolerance / 4, "half": tolerance / 2}},
        )


def _known(value: float) -> Optional[float]:
    return value if math.isfinite(value) else None
