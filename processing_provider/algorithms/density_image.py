"""The algorithm `densityimage`."""

from functools import partial
from typing import Any

from ..algorithm import Algorithm, Outcome
from ..dependencies import FOR_CLOUDS
from ..log import Log
from ..parameters.clouds import (
    CLOUDS,
    CRS,
    PIXEL_SIZE,
    SCHEDULER,
    SPACING,
    neighbourhood,
    open_upright_site,
    sorter,
)
from ..parameters.density import (
    HEIGHT_PARAMETERS,
    POINT_NUMBERS,
    density_destination,
    height_range,
    log_density,
    point_numbers,
)


class DensityImageAlgorithm(Algorithm):
    """Compute a density image of clouds."""

    key = "densityimage"
    title = "Density image from laser scans"
    chapter = "Site plan"
    summary = "Counts the points above each pixel of the ground plan, after thinning."
    about = (
        "The clouds are thinned, and the points above each pixel are counted: walls stand out because many "
        "points lie above each other there. Further bands hold the height that points fill above the local "
        "ground, the lowest and highest point, the ground, and two measures that separate foliage and "
        "furniture from walls (Mueller, Kohoutek and Theiler 2012)."
    )
    words = ("density", "raster", "point cloud", "laser scan", "tls", "lidar", "las", "laz", "walls", "dtm")
    needs = FOR_CLOUDS
    inputs = (CLOUDS, SPACING, PIXEL_SIZE, neighbourhood(advanced=False), CRS, *HEIGHT_PARAMETERS, SCHEDULER)
    destinations = (density_destination(optional=False),)
    numbers = POINT_NUMBERS

    def compute(self, values: dict[str, Any], log: Log) -> Outcome:
        """Compute the image."""
        from ...algorithms.site_plan.density.density_image import density_image
        from ...algorithms.site_plan.density.density_raster import write_density

        size = values["SPACING"], values["PIXEL_SIZE"], values["NEIGHBOURHOOD"]
        chosen = *size, log.progress, height_range(values)
        image = density_image(open_upright_site(values, log), *chosen, sort=sorter(values))
        log.warn(image.warnings)
        log_density(image, log)
        return Outcome({"DENSITY": partial(write_density, image=image)}, point_numbers(image))
