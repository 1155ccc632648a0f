"""Draw a density image and the walls that were found in it, side by side; north is up.

python3 scripts/picture.py density.tif walls.shp out.png
"""

import argparse
from pathlib import Path
from typing import Any, Optional

import fiona
import numpy as np
import rasterio
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch
from matplotlib.path import Path as Outline
from shapely.geometry import mapping
from shapely.geometry.base import BaseGeometry

MARGIN = 2.0
"""Metres shown around the walls."""


def draw(
    density: Path,
    walls: Path,
    out: Path,
    truth: Optional[BaseGeometry] = None,
    before: Optional[Path] = None,
) -> None:
    """Write the picture of both layers, with the true walls, or with other walls beside them, if given."""
    with rasterio.open(density) as raster:
        values, bounds = raster.read(1, masked=True), raster.bounds
    layers = [("Outlines of pixels", before), ("Walls", walls)] if before else [("Walls", walls)]
    extent = (bounds.left, bounds.right, bounds.bottom, bounds.top)
    darkest = values.mean() + 2 * values.std()
    figure = Figure(figsize=(7 * (1 + len(layers)), 7.3), layout="constrained")
    axes = figure.subplots(1, 1 + len(layers), sharex=True, sharey=True)
    for axis, (title, path) in zip(axes, [("Density image", None), *layers]):
        shade = values * 0.4 if path else values
        axis.imshow(shade, extent=extent, cmap="gray_r", vmin=0, vmax=darkest, interpolation="nearest")
        axis.set(title=title, xticks=[], yticks=[], aspect="equal")
        if path:
            west, south, east, north = _add_walls(axis, path)
    if truth is not None:
        for part in truth.geoms:
            axes[-1].add_patch(PathPatch(_outline(mapping(part)), fill=False, edgecolor="#1b7837"))
        axes[-1].set_title("Walls, and the true walls in green")
        west, south, east, north = truth.bounds
    axes[0].set_xlim(west - MARGIN, east + MARGIN)
    axes[0].set_ylim(south - MARGIN, north + MARGIN)
    _draw_scale_bar(axes[-1], east - west)
    figure.savefig(out, dpi=80)


def _add_walls(axis: Axes, path: Path) -> tuple[float, float, float, float]:
    """Draw a layer of walls, and return its bounds."""
    with fiona.open(path) as layer:
        for feature in layer:
            patch = PathPatch(_outline(feature["geometry"]), facecolor="#c8553d99", edgecolor="#8c2814")
            patch.set_linewidth(0.8)
            axis.add_patch(patch)
        return layer.bounds


def _outline(geometry: dict[str, Any]) -> Outline:
    polygons = geometry["coordinates"]
    if geometry["type"] == "Polygon":
        polygons = [polygons]
    return Outline.make_compound_path(
        *(Outline(np.asarray(ring)[:, :2], closed=True) for rings in polygons for ring in rings)
    )


def _draw_scale_bar(axis: Axes, width: float) -> None:
    """Draw a bar of 1, 2 or 5 times a power of ten metres below the plan."""
    steps = [factor * 10.0**power for power in range(-1, 4) for factor in (1, 2, 5)]
    length = max(step for step in steps if step <= max(width / 4, steps[0]))
    (left, _), (bottom, top) = axis.get_xlim(), axis.get_ylim()
    x, y = left + 0.5, bottom + 0.02 * (top - bottom)
    axis.plot([x, x + length], [y, y], color="black", linewidth=3, solid_capstyle="butt")
    axis.annotate(f"{length:g} m", (x + length / 2, y), (0, 4), textcoords="offset points", ha="center")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name in ("density", "walls", "out"):
        parser.add_argument(name, type=Path)
    arguments = parser.parse_args()
    draw(arguments.density, arguments.walls, arguments.out)
