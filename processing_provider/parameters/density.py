"""What the algorithms that compute a density image have in common."""

import math
from typing import TYPE_CHECKING, Any

from ..log import Log
from .destinations import RasterDestination
from .parameter import Choice, Number

if TYPE_CHECKING:
    from ...algorithms.site_plan.density.density_image import DensityImage
    from ...algorithms.site_plan.density.height_range import HeightRange

POINT_NUMBERS = (
    ("POINTS_IN", "Number of points in the clouds"),
    ("POINTS_KEPT", "Number of points after thinning"),
)

HEIGHT_PARAMETERS = (
    Number(
        "ZMIN",
        "Lowest height",
        "Points below are left out. For a storey, a height within the slab below its floor.",
        unit="m",
        minimum=-20_000,
        maximum=20_000,
    ),
    Number(
        "ZMAX",
        "Highest height",
        "Points from this height on are left out. For a storey, a height within the slab above it.",
        unit="m",
        minimum=-20_000,
        maximum=20_000,
    ),
    Choice(
        "HEIGHTS",
        "Heights are counted from",
        "What ZMIN and ZMAX are counted from. Choose the local ground on a slope.",
        options=("zero of the coordinates", "local ground"),
        optional=True,
    ),
)


def density_destination(optional: bool) -> RasterDestination:
    """Return the destination DENSITY."""
    help_text = (
        "GeoTIFF with the bands density, occupied height, base, top, ground, spread and hanging height."
    )
    return RasterDestination("DENSITY", "Density image", help_text, style="density", optional=optional)


def height_range(values: dict[str, Any]) -> "HeightRange":
    """Return the heights that the user chose."""
    from ...algorithms.site_plan.density.height_range import HeightRange

    low, high = values["ZMIN"], values["ZMAX"]
    return HeightRange(
        -math.inf if low is None else low, math.inf if high is None else high, values["HEIGHTS"] == 1
    )


def log_density(image: "DensityImage", log: Log) -> None:
    """Write to the log what was read and kept."""
    rows, columns = image.density.shape
    log.info(f"Points: {image.points_in} read, {image.points_kept} kept.")
    log.info(f"Density image: {columns} x {rows} pixels of {image.transform.a:g} m.")


def point_numbers(image: "DensityImage") -> dict[str, int]:
    """Return the values of `POINT_NUMBERS`."""
    return {"POINTS_IN": image.points_in, "POINTS_KEPT": image.points_kept}
