"""Outlines on the faces of the walls, in place of outlines of pixels (beyond the paper)."""

from dataclasses import replace
from itertools import chain
from typing import Optional

import numpy as np
from affine import Affine
from shapely.affinity import translate
from shapely.geometry import Polygon
from shapely.geometry.polygon import orient
from shapely.ops import unary_union
from shapely.validation import make_valid

from ..progress import Progress
from .backs import tell_backs
from .density import DensityImage, SortedPoints
from .face_points import FacePoints, gather_face_points
from .measures import measure
from .outlines import overlaps
from .plan import SitePlan
from .redrawing import INSIDE, redraw
from .sides import find_sides
from .walls import Wall, band_length

BRIDGE = 0.002
"""Overlap (m) of the bridge between parts of a wall that its sides have come apart into."""

FARTHEST = 0.2
"""Parts farther from each other than this (m) are not joined, and only the largest is kept."""


def refine_on_points(
    plan: SitePlan, points: SortedPoints, image: DensityImage, progress: Progress = Progress()
) -> SitePlan:
    """Gather the points near the walls of a plan, and move its outlines onto the faces; see `refine_plan`."""
    near = gather_face_points(points, image, plan.image.walls, progress.part(0.0, 0.5))
    return refine_plan(plan, near, image.density, image.transform, progress.part(0.5, 1.0))


def refine_plan(
    plan: SitePlan,
    points: FacePoints,
    density: np.ndarray,
    transform: Affine,
    progress: Progress = Progress(),
) -> SitePlan:
    """Move the outlines of a plan onto the faces that the points show, and measure the walls by them.

    Parameters
    ----------
    plan : SitePlan
        With outlines of pixels.
    points : FacePoints
        Near them, relative to the lower left corner of the image.
    density : ndarray of float, shape (rows, columns)
        Nan where there is none.
    transform : Affine
        From (column, row) to world coordinates.
    progress : Progress
        Reports and cancels.
    """
    size, height = transform.a, density.shape[0]
    origin = transform.c, transform.f - height * size
    local = Affine(size, 0.0, 0.0, 0.0, -size, height * size)
    held = np.isfinite(density)
    walls = []
    for number, wall in enumerate(plan.walls):
        progress.update(number / len(plan.walls), "Fitting faces")
        walls.append(_refined(wall, points, held, local, origin))
    return replace(plan, walls=tuple(_apart(walls)))


def _refined(wall: Wall, points: FacePoints, held: np.ndarray, local: Affine, origin: tuple) -> Wall:
    pixels = orient(translate(wall.outline, -origin[0], -origin[1]))
    rings = [
        find_sides(np.asarray(ring.coords), points, local.a) for ring in (pixels.exterior, *pixels.interiors)
    ]
    if not any(ring.sides for ring in rings):
        return replace(wall, outline=_unbiased(wall.outline, local.a), coverage=0.0)
    rings = tell_backs(rings, held, local)
    corners, sides = zip(*(redraw(ring, local.a) for ring in rings))
    outline = _polygon(corners, origin)
    if outline is None:
        return replace(wall, coverage=0.0)
    measures = measure([*chain.from_iterable(sides)], translate(outline, -origin[0], -origin[1]))
    return replace(
        wall,
        outline=outline,
        length=band_length(outline),
        **{**vars(measures), "azimuth": measures.azimuth if wall.kind == "straight" else None},
    )


def _unbiased(outline: Polygon, pixel_size: float) -> Polygon:
    """Return an outline of pixels freed of its bias, unless nothing would be left of it."""
    inner = outline.buffer(-INSIDE * pixel_size, join_style=2)
    return inner if inner.geom_type == "Polygon" and not inner.is_empty else outline


def _polygon(rings: tuple, origin: tuple) -> Optional[Polygon]:
    """Return the polygon of an outer ring and its holes, made valid, in world coordinates."""
    outer, *holes = (_valid(Polygon(ring) if len(ring) >= 3 else Polygon()) for ring in rings)
    outline = translate(outer.difference(unary_union(holes)) if holes else outer, *origin)
    if outline.geom_type == "Polygon" and outline.is_valid:
        return outline
    return _joined(_valid(outline))


def _valid(geometry):
    return geometry if geometry.is_valid else make_valid(geometry).buffer(0)


def _joined(geometry) -> Optional[Polygon]:
    """Return the parts of a geometry as one polygon, bridged where they are nearest."""
    whole, *parts = sorted(_polygons(geometry), key=lambda part: -part.area) or [None]
    while parts:
        distances = [whole.distance(part) for part in parts]
        part, reach = parts.pop(int(np.argmin(distances))), min(distances) + BRIDGE
        if reach > FARTHEST:
            break
        bridge = whole.buffer(reach).intersection(part.buffer(reach))
        joined = _polygons(unary_union([whole, part, bridge]))
        whole = max(joined, key=lambda one: one.area)
    return whole


def _polygons(geometry) -> list:
    return [part for part in getattr(geometry, "geoms", [geometry]) if part.area > 0 and part.is_valid]


def _apart(walls: list) -> list:
    """Cut from walls what they share with others before them."""
    outlines = {number: wall.outline for number, wall in enumerate(walls)}
    for one, other in overlaps(outlines):
        first, second = sorted((one, other))
        parts = _polygons(outlines[second].difference(outlines[first]))
        outlines[second] = max(parts, key=lambda part: part.area, default=outlines[second])
    return [replace(wall, outline=outlines[number]) for number, wall in enumerate(walls)]
