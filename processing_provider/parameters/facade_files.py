"""The files of a facade, and the folder of the files of every facade."""

from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable

from ..dependencies import lacking
from .destinations import DRAWING_MODULES, PAGE_MODULES, FolderWriters, Writer
from .folders import FolderDestination

if TYPE_CHECKING:
    from rasterio.crs import CRS

    from ...algorithms.facade.every_facade import DrawnFacade
    from ...algorithms.facade.settings import FacadeSettings

NAMES = {
    "ORTHOIMAGE": "orthoimage.tif",
    "DETAILS": "details.gpkg",
    "LEFT_OUT": "left_out.gpkg",
    "ELEVATION": "elevation.gpkg",
    "DRAWING": "drawing.dxf",
    "REPORT": "report.html",
}
"""The files of each facade in the folder."""

FOLDER = FolderDestination(
    "ALL",
    "Folder of every facade",
    "Draws every facade of the cloud, or those along FACADE_ALONG, each into a folder of its own by its "
    "number: elevation, orthoimage, details in space, what is left out, report, and drawing if ezdxf is "
    "installed. One schedule lists the details of all. Takes as long for each facade as for one.",
    optional=True,
    by_default=False,
    listing="ALL_FILES",
    parts="facade_*",
    styles=(("elevation", "elevation"), ("details", "facade_details"), ("left_out", "facade_left_out")),
)


def facade_writers(
    drawn: "DrawnFacade",
    with_report: bool,
    values: dict[str, Any],
    settings: "FacadeSettings",
    crs: "CRS | None",
) -> dict[str, Writer]:
    """Return what writes the files of a facade, by the names of their destinations."""
    from ...algorithms.facade.output.drawing import write_drawing
    from ...algorithms.facade.output.elevation_layers import write_details, write_elevation, write_left_out
    from ...algorithms.facade.output.orthoimage import automatic_pixel_size, write_orthoimage
    from ...algorithms.facade.output.schedule import write_schedule

    elevation = drawn.elevation
    size = values["PIXEL_SIZE"] or automatic_pixel_size(elevation.spacing)

    def write_image(path: Path) -> None:
        points = drawn.selection.points
        write_orthoimage(path, points, elevation, size, values["FILL_HOLES"], settings.orthoimage)

    writers: dict[str, Writer] = {
        "ELEVATION": partial(write_elevation, elevation=elevation),
        "LEFT_OUT": partial(write_left_out, elevation=elevation),
        "DETAILS": partial(write_details, elevation=elevation, crs=crs),
        "ORTHOIMAGE": write_image,
        "SCHEDULE": partial(write_schedule, elevation=elevation),
        "DRAWING": partial(write_drawing, elevation=elevation),
    }
    if with_report:
        # Only a report needs the packages that it is made with.
        from ...algorithms.facade.output.report import write_report

        writers["REPORT"] = partial(write_report, selection=drawn.selection, elevation=elevation)
    return writers


def folder_writers(every: "Sequence[DrawnFacade]", make: Callable[..., dict[str, Writer]]) -> FolderWriters:
    """Return what writes the folder of every facade, by the names of the files in it."""
    from ...algorithms.facade.output.schedule import write_common_schedule

    elevations = {drawn.number: drawn.elevation for drawn in every}
    lacks = {"DRAWING": bool(lacking(DRAWING_MODULES)), "REPORT": bool(lacking(PAGE_MODULES))}
    # First, so that the folder is there before the folders in it.
    writers: dict[str, Writer] = {"schedule.csv": partial(write_common_schedule, elevations=elevations)}
    for drawn in every:
        own = make(drawn, with_report=not lacks["REPORT"])
        for key, name in NAMES.items():
            if not lacks.get(key):
                writers[f"facade_{drawn.number:02d}/{name}"] = own[key]
    return writers
