"""What the algorithms that read clouds have in common."""

from typing import TYPE_CHECKING, Any

from ...algorithms.clouds.formats import readable_formats
from .files import CloudFiles
from .parameter import Number, ReferenceSystem, Text

if TYPE_CHECKING:
    from ...algorithms.clouds.cloud import Cloud
    from ...algorithms.clouds.tiles.tiles import Sorter
    from ..log import Log

CLOUDS = CloudFiles(
    "INPUT",
    "Point clouds",
    f"One or more scans of one site: {readable_formats()}; or a folder of them. "
    "On the command line, repeat INPUT=file or separate the files by semicolons.",
)

SPACING = Number(
    "SPACING",
    "Point spacing",
    "Points closer than this to a point that is kept are left out, so that a surface counts the same near "
    "the scanner and far from it. 0.05 m suits most sites; a finer spacing needs denser scans.",
    unit="m",
    default=0.05,
    minimum=0.001,
    maximum=100,
)

PIXEL_SIZE = Number(
    "PIXEL_SIZE",
    "Pixel size",
    "Edge of a pixel of the rasters. 0.10 m suits most sites; it should be about twice the point spacing.",
    unit="m",
    default=0.10,
    minimum=0.001,
    maximum=100,
)

CRS = ReferenceSystem(
    "CRS",
    "Coordinate reference system, if the clouds name none",
    "Projected, in metres. Used only for files without a reference system.",
)

SCHEDULER = Text(
    "SCHEDULER",
    "Dask scheduler",
    "Address of the scheduler of a Dask cluster, like tcp://192.168.0.10:8786. Its workers read the clouds "
    "and work on them instead of this computer, with the same result; they must find the files by the same "
    "paths. Leave it empty to work on this computer.",
    advanced=True,
)


def neighbourhood(advanced: bool) -> Number:
    """Return the parameter NEIGHBOURHOOD, shown at once or among the advanced ones."""
    return Number(
        "NEIGHBOURHOOD",
        "Neighbourhood",
        "A point spreads over the pixels up to this far from its own, by inverse distance. "
        "0 counts points per pixel; more than 1 blurs.",
        unit="pixels",
        default=1,
        minimum=0,
        maximum=5,
        whole=True,
        advanced=advanced,
    )


def open_site(values: dict[str, Any]) -> "Cloud":
    """Open the clouds that the user chose as one site."""
    from ...algorithms.clouds.cloud import open_cloud
    from ...algorithms.reference_systems import chosen_system

    crs = values.get("CRS")
    return open_cloud(values["INPUT"], chosen_system(crs.toWkt(), "CRS") if crs else None)


def open_upright_site(values: dict[str, Any], log: "Log") -> "Cloud":
    """Open the clouds that the user chose as one site, and say if it does not stand upright."""
    from ...algorithms.clouds.uprightness import upright_warnings

    cloud = open_site(values)
    log.warn(upright_warnings(cloud, log.progress))
    return cloud


def sorter(values: dict[str, Any]) -> "Sorter":
    """Return where the clouds are worked on: on the cluster that the user chose, or on this computer."""
    from ...algorithms.clouds.cluster.sorting import sorter_at

    return sorter_at(values["SCHEDULER"])
