"""What the algorithms that compute a density image have in common."""

from typing import TYPE_CHECKING

from ..algorithms.progress import Progress
from .cloud_parameters import open_site
from .destinations import RasterDestination
from .log import Log

if TYPE_CHECKING:
    from ..algorithms.site_plan.density import DensityImage

POINT_NUMBERS = (
    ("POINTS_IN", "Number of points in the clouds"),
    ("POINTS_KEPT", "Number of points after thinning"),
)


def density_destination(optional: bool) -> RasterDestination:
    """Return the destination DENSITY."""
    help_text = "GeoTIFF with the bands density, occupied height, base, top and ground."
    return RasterDestination("DENSITY", "Density image", help_text, style="density", optional=optional)


def compute_density(values: dict, log: Log, progress: Progress) -> "DensityImage":
    """Compute the density image with the parameters that the user chose, and tell what was kept."""
    from ..algorithms.site_plan.density import density_image

    image = density_image(
        open_site(values), values["SPACING"], values["PIXEL_SIZE"], values["NEIGHBOURHOOD"], progress
    )
    log.warn(image.warnings)
    rows, columns = image.density.shape
    log.info(f"Points: {image.points_in} read, {image.points_kept} kept.")
    log.info(f"Density image: {columns} x {rows} pixels of {values['PIXEL_SIZE']:g} m.")
    return image


def point_numbers(image: "DensityImage") -> dict:
    """Return the values of `POINT_NUMBERS`."""
    return {"POINTS_IN": image.points_in, "POINTS_KEPT": image.points_kept}
