"""Draw an orthoimage and the elevation that was measured, side by side.

python3 scripts/elevation_picture.py orthoimage.tif elevation.shp out.png
"""

import argparse
from pathlib import Path
from typing import Any

import fiona
import numpy as np
import rasterio
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch
from matplotlib.path import Path as Outline
from shapely.geometry import shape
from shapely.geometry.base import BaseGeometry

COLOURS = {
    "wall": "#e1d5be",
    "opening": "#232d3b",
    "recess": "#3d7ec8",
    "coloured detail": "#e18c28",
    "projection": "#5aa05a",
    "unseen": "#ffffff",
}

NARROW = 0.8
"""Narrower details that are higher than this have their height on a line of its own (m)."""


def draw(orthoimage: Path, elevation: Path, out: Path) -> None:
    """Write the picture of both layers, with ids, widths and heights in metres."""
    with rasterio.open(orthoimage) as raster:
        image, bounds = raster.read(), raster.bounds
    with fiona.open(elevation) as layer:
        features = [(shape(feature["geometry"]), dict(feature["properties"])) for feature in layer]
    figure = Figure(figsize=(18, 7.3), layout="constrained")
    axes = figure.subplots(1, 2, sharex=True, sharey=True)
    extent = (bounds.left, bounds.right, bounds.bottom, bounds.top)
    colours = image[:3] if len(image) == 4 else np.repeat(image[:1], 3, axis=0)
    axes[0].imshow(np.moveaxis(np.concatenate([colours, image[-1:]]), 0, -1), extent=extent)
    for polygon, values in features:
        _add(axes[1], polygon, values)
    for axis, title in zip(axes, ("Orthoimage", "Elevation: id, width x height (m)")):
        axis.set(title=title, aspect="equal", xlabel="u (m)", ylabel="v (m)")
    figure.savefig(out, dpi=80)


def _add(axis: Axes, polygon: BaseGeometry, values: dict[str, Any]) -> None:
    parts = getattr(polygon, "geoms", [polygon])
    rings = [ring for part in parts for ring in (part.exterior, *part.interiors)]
    path = Outline.make_compound_path(
        *(Outline(np.asarray(ring.coords)[:, :2], closed=True) for ring in rings)
    )
    hatch = "///" if values["kind"] == "unseen" else None
    axis.add_patch(
        PathPatch(path, facecolor=COLOURS[values["kind"]], edgecolor="black", linewidth=0.8, hatch=hatch)
    )
    if values["id"]:
        number, width, height = str(values["id"]), f"{values['width']:.3f}", f"x {values['height']:.3f}"
        narrow = values["width"] < NARROW < values["height"]
        label = "\n".join([number, width, height] if narrow else [number, f"{width} {height}"])
        box = {"facecolor": "white", "alpha": 0.7, "edgecolor": "none", "pad": 1}
        middle = polygon.centroid
        axis.text(middle.x, middle.y, label, ha="center", va="center", fontsize=8, bbox=box)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name in ("orthoimage", "elevation", "out"):
        parser.add_argument(name, type=Path)
    arguments = parser.parse_args()
    draw(arguments.orthoimage, arguments.elevation, arguments.out)
