"""The layers of a site plan in a folder, for the other benchmarks."""

from pathlib import Path

from ichnograph.algorithms.site_plan.density.density_raster import write_density
from ichnograph.algorithms.site_plan.output.layers import write_plan, write_walls
from ichnograph.algorithms.site_plan.results import SitePlan


def write_layers(plan: SitePlan, folder: Path, name: str) -> tuple[Path, Path]:
    """Write density raster, plan raster and walls; return the paths of the first and the last."""
    folder.mkdir(parents=True, exist_ok=True)
    density, walls = folder / f"{name}_density.tif", folder / f"{name}_walls.shp"
    write_density(density, plan.density)
    write_plan(folder / f"{name}_plan.tif", plan)
    write_walls(walls, plan)
    return density, walls
