"""Pictures of a density image, with a plan over it."""

from pathlib import Path
from typing import Optional

import matplotlib
import numpy as np
from ichnograph.algorithms.site_plan.layers import read_density
from shapely.geometry.base import BaseGeometry

from .chain import Outputs

matplotlib.use("Agg")
from matplotlib import pyplot as plt

KINDS = {"straight": "#b2182b", "curved": "#d6604d", "column": "#8073ac"}


def draw_plan(outputs: Outputs, path: Path, truth: Optional[BaseGeometry] = None) -> None:
    """Draw the density image, and beside it the walls over it, in red; the truth as a green line."""
    raster = read_density(outputs.density)
    figure, (left, right) = plt.subplots(1, 2, figsize=(16, 8), constrained_layout=True)
    for axes in (left, right):
        show_density(axes, raster.density, raster.transform)
    for wall in outputs.plan.walls:
        draw_polygon(right, wall.outline, facecolor=KINDS[wall.kind] + "66", edgecolor=KINDS[wall.kind])
    shown = [wall.outline for wall in outputs.plan.walls]
    if truth is not None:
        shown = list(truth.geoms)
        for part in shown:
            draw_polygon(right, part, facecolor="none", edgecolor="#1b7837", linewidth=0.8)
    frame(left, right, shown)
    left.set_title("density image")
    right.set_title("walls" + (" (red) and truth (green)" if truth is not None else ""))
    figure.savefig(path, dpi=75)
    plt.close(figure)


def show_density(axes, density: np.ndarray, transform) -> None:
    """Show a density image in grey, dark where dense, up to two standard deviations above the mean."""
    rows, columns = density.shape
    left, top, size = transform.c, transform.f, transform.a
    bright = np.nanmean(density) + 2 * np.nanstd(density)
    extent = (left, left + columns * size, top - rows * size, top)
    axes.imshow(density, cmap="gray_r", vmin=0, vmax=bright, extent=extent, interpolation="antialiased")
    axes.ticklabel_format(useOffset=False, style="plain")
    axes.tick_params(labelsize=7)


def draw_polygon(axes, polygon, **style) -> None:
    """Draw a polygon with its holes."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path as Outline

    rings = [np.asarray(ring.coords)[:, :2] for ring in (polygon.exterior, *polygon.interiors)]
    codes = [code for ring in rings for code in [Outline.MOVETO] + [Outline.LINETO] * (len(ring) - 1)]
    axes.add_patch(PathPatch(Outline(np.concatenate(rings), codes), **style))


def frame(left, right, polygons: list, margin: float = 2.0) -> None:
    """Show the surroundings of the polygons in both axes."""
    boxes = np.array([polygon.bounds for polygon in polygons])
    low, high = boxes[:, :2].min(axis=0) - margin, boxes[:, 2:].max(axis=0) + margin
    for axes in (left, right):
        axes.set_xlim(low[0], high[0])
        axes.set_ylim(low[1], high[1])
        axes.set_aspect("equal")
