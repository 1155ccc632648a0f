"""The algorithm `facadedetails`."""

from functools import partial
from typing import TYPE_CHECKING, Any

from ..algorithm import Algorithm, Outcome
from ..log import Log
from ..parameters.clouds import CLOUDS, CRS, open_upright_site
from ..parameters.destinations import (
    DrawingDestination,
    HtmlDestination,
    PolygonDestination,
    RasterDestination,
    TableDestination,
)
from ..parameters.facade import FACADE, FACADE_ALONG, FACADE_NEAR, FILL_HOLES, PIXEL_SIZE, SETTINGS
from ..parameters.facade_files import FOLDER, facade_writers, folder_writers

if TYPE_CHECKING:
    from ...algorithms.facade.elevation import Elevation


class FacadeDetailsAlgorithm(Algorithm):
    """Measure the details of a facade."""

    key = "facadedetails"
    title = "Details of a facade"
    chapter = "Facade"
    summary = "Measures openings, recesses, projections and coloured details of a scanned facade."
    about = (
        "Finds the main plane of the facade; coplanar details by colour and intensity; openings and recesses "
        "by the points behind the wall; projections by the planes in front of it. An outline is the mean of "
        "both sides of a border, with standard deviations. The clouds are enough; without colour, only "
        "openings, recesses and projections are found (Aitelkadi, Tahiri, Simonetto, Sebari and Boulaassal "
        "2014)."
    )
    words = (
        "facade",
        "elevation",
        "windows",
        "doors",
        "openings",
        "orthoimage",
        "dxf",
        "segmentation",
        "laser scan",
        "point cloud",
        "tls",
        "heritage",
        "architecture",
    )
    inputs = (CLOUDS, FACADE, FACADE_NEAR, FACADE_ALONG, *SETTINGS.values(), CRS, PIXEL_SIZE, FILL_HOLES)
    destinations = (
        RasterDestination(
            "ORTHOIMAGE",
            "Orthoimage",
            "GeoTIFF in u, v: the colours of the facade projected onto its plane, or its intensity.",
            style=None,
            optional=True,
        ),
        PolygonDestination(
            "DETAILS",
            "Details in space",
            "The polygons of the elevation in x, y, z of the site, with the same ids and areas.",
            style="facade_details",
            optional=True,
            by_default=False,
        ),
        PolygonDestination(
            "ELEVATION",
            "Elevation",
            "Polygons in u (right) and v (up), in metres: the wall, its details, and areas that were not "
            "seen.",
            style="elevation",
            focus=True,
        ),
        TableDestination(
            "SCHEDULE",
            "Schedule",
            "CSV file with a row for each detail: kind, width, height, sill, area, standard deviations.",
            optional=True,
        ),
        DrawingDestination(
            "DRAWING",
            "Drawing",
            "DXF file in metres, with a layer for each kind; needs the package ezdxf.",
            optional=True,
        ),
        PolygonDestination(
            "LEFT_OUT",
            "Left out",
            "Polygons in u, v, with reason and area: holes of the wall, regions of another colour and "
            "surfaces that are not drawn.",
            style="facade_left_out",
            optional=True,
            by_default=False,
        ),
        HtmlDestination(
            "REPORT",
            "Report of the facade",
            "HTML page with a key plan of all facades of the cloud, and the details of the one drawn.",
            optional=True,
        ),
        FOLDER,
    )
    numbers = (
        ("DETAIL_COUNT", "Number of details"),
        ("FACADE_COUNT", "Number of facades in the cloud"),
        ("WALL_AREA", "Area of the wall without openings and recesses (m²)"),
    )

    def compute(self, values: dict[str, Any], log: Log) -> Outcome:
        """Measure the facade."""
        from ...algorithms.facade.every_facade import measure_every, measure_selection
        from ...algorithms.facade.points import read_points
        from ...algorithms.facade.selection import select_facade
        from ...algorithms.facade.settings import FacadeSettings

        settings = FacadeSettings(**{name: values[parameter.name] for name, parameter in SETTINGS.items()})
        cloud = open_upright_site(values, log)
        log.warn(cloud.warnings)
        points = read_points(cloud, log.progress.part(0.0, 0.2), settings.thinning)
        log.warn(points.warnings)
        selection = select_facade(
            points,
            settings,
            values["FACADE"],
            values["FACADE_NEAR"],
            values["FACADE_ALONG"].shapes,
            log.progress.part(0.2, 0.35),
        )
        first = log.progress.part(0.35, 0.5 if values["ALL"] else 0.95)
        drawn = measure_selection(selection, settings, first)
        elevation = drawn.elevation
        log.warn(elevation.warnings)
        _log(elevation, log)
        make = partial(facade_writers, values=values, settings=settings, crs=cloud.crs)
        writers: dict[str, Any] = make(drawn, with_report=bool(values["REPORT"]))
        if values["ALL"]:
            every = measure_every(drawn, settings, log.progress.part(0.5, 0.95))
            log.warn(every.warnings)
            log.info(f"Facades drawn into the folder: {len(every.drawn)}.")
            writers["ALL"] = folder_writers(every.drawn, make)
        return Outcome(
            writers,
            {
                "DETAIL_COUNT": len(elevation.details),
                "FACADE_COUNT": len(selection.facades),
                "WALL_AREA": elevation.wall.area,
            },
        )


def _log(elevation: "Elevation", log: Log) -> None:
    from ...algorithms.facade.left_out import summary

    for kind, reason, count, area in summary(elevation.left_out):
        log.info(f"Left out: {count} of kind {kind}, {area:.2f} m² in all: {reason}.")
    for part in elevation.parts[1:]:
        log.info(f"A part of {part.area:.1f} m² lies {part.depth:+.2f} m from the main wall.")
    log.info(f"Details: {len(elevation.details)}.")
