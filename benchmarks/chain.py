"""The chain as the toolbox runs it, from files to files, for the commands of this folder."""

import time
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.site_plan.density.density_image import sort_and_image
from ichnograph.algorithms.site_plan.faces.refinement import refine_on_points
from ichnograph.algorithms.site_plan.output.layers import write_density, write_plan, write_walls
from ichnograph.algorithms.site_plan.site_plan import SitePlan, extract_walls
from ichnograph.algorithms.site_plan.walls.extraction import WallParameters


@dataclass(frozen=True)
class Outputs:
    """Files and results of one run.

    Attributes
    ----------
    density, walls : Path
    plan : SitePlan
    points : int
    warnings : tuple of str
    seconds : float
    """

    density: Path
    walls: Path
    plan: SitePlan
    points: int
    warnings: tuple
    seconds: float


def run_chain(
    clouds: list,
    folder: Path,
    name: str,
    parameters: Optional[WallParameters] = None,
    spacing: float = 0.05,
    pixel_size: float = 0.10,
    refine: bool = True,
) -> Outputs:
    """Turn clouds into density raster, plan raster and walls in `folder`."""
    started = time.perf_counter()
    folder.mkdir(parents=True, exist_ok=True)
    density, walls = folder / f"{name}_density.tif", folder / f"{name}_walls.shp"
    with sort_and_image(open_cloud(clouds), spacing, pixel_size) as (image, points):
        plan = extract_walls(image.density, image.heights, image.transform, parameters or WallParameters())
        if refine:
            plan = refine_on_points(plan, points, image)
    write_density(density, image)
    write_plan(folder / f"{name}_plan.tif", plan, image.transform, image.crs)
    write_walls(walls, plan, image.crs)
    seconds = time.perf_counter() - started
    return Outputs(density, walls, plan, image.points_in, (*image.warnings, *plan.image.warnings), seconds)
