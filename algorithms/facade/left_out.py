"""What is left out of an elevation, and why: holes, colours and surfaces that are not details."""

from collections.abc import Collection, Iterator, Sequence
from typing import Optional

import numpy as np
from shapely.geometry import MultiPolygon, Polygon
from shapely.ops import unary_union

from ..geometry.polygons import made_valid, polygons_of
from ..geometry.triangulation import triangulate
from .colour.appearance import Appearance
from .colour.steps import reason_against_colour
from .elevation import COLOURED, Frame, LeftOut, Points, Segmentation, frame_of
from .outlines.acceptance import is_regular, reason_against_opening
from .outlines.alpha_shape import alpha_shape
from .outlines.details import TracedDetail
from .outlines.regular_outlines import Outline, make_outline
from .outlines.surface import Surface
from .planes.voxels import square_means
from .settings import ALL_REGIONS, FacadeSettings

SURFACE = "surface"
"""The kind of a plane that is left out."""

NOT_STRAIGHT = "no straight sides, as of a stain"
BEHIND = "parallel to the wall, but not a part of it"
OBLIQUE = "at {:.0f} degrees to the wall"


def reason_against(
    item: TracedDetail,
    outline: Outline,
    wall: Surface,
    looks: Optional[Appearance],
    settings: FacadeSettings,
) -> Optional[str]:
    """Return why a region is not a detail; None if it is one.

    Parameters
    ----------
    item : TracedDetail
    outline : Outline
        Of the region.
    wall : Surface
    looks : Appearance or None
        Of the points of the wall; None without colour.
    settings : FacadeSettings
    """
    acceptance = settings.outlines.acceptance
    if item.opening is not None:
        return reason_against_opening(item.opening, item.border, outline, acceptance)
    if item.kind != COLOURED or settings.coloured == ALL_REGIONS or looks is None:
        return None
    if not settings.regularise:
        outline = make_outline(item.border, True, settings.outlines)
    if not is_regular(outline, acceptance):
        return NOT_STRAIGHT
    return reason_against_colour(
        wall.mesh.points, looks, outline.polygon, wall.spacing, settings.seed_colour, settings.colour.steps
    )


def summary(left_out: Sequence[LeftOut]) -> list[tuple[str, str, int, float]]:
    """Return kind, reason, number and area (m2) of what is left out, the largest area first."""
    groups: dict[tuple[str, str], list[float]] = {}
    for item in left_out:
        groups.setdefault((item.kind, item.reason), []).append(item.area)
    rows = [(kind, reason, len(areas), sum(areas)) for (kind, reason), areas in groups.items()]
    return sorted(rows, key=lambda row: -row[3])


def surfaces_left_out(
    points: Points,
    segmentation: Segmentation,
    drawn: Collection[int],
    explained: np.ndarray,
    frame: Frame,
    spacing: float,
    settings: FacadeSettings,
) -> Iterator[LeftOut]:
    """Yield the planes of a facade that its elevation does not show, with their own areas.

    The inner face of the wall is not one of them.

    Parameters
    ----------
    points : Points
    segmentation : Segmentation
    drawn : collection of int
        Labels of the planes that are details.
    explained : ndarray of bool, shape (n,)
        The points that lie on the wall, or in an opening.
    frame : Frame
        Of the elevation.
    spacing : float
        Of the points of the wall (m).
    settings : FacadeSettings
    """
    constants = settings.left_out
    square = constants.square_spacings * spacing
    main, inner = segmentation.planes[0], segmentation.side.inner
    for label, plane in enumerate(segmentation.planes[1:], start=2):
        rows = segmentation.labels == label
        if label in drawn or explained[rows].mean() > constants.on_wall:
            continue
        if inner is not None and abs(main.distances(plane.centre) + inner.offset) <= settings.distance_m:
            continue
        own = frame_of(plane, points.origin)
        flat = own.local(points.xyz[rows], points.origin)[:, :2]
        outline = alpha_shape(triangulate(square_means(flat, square)))
        shape = _projected(outline, own, frame, square)
        if not shape.is_empty:
            angle = float(np.degrees(np.arccos(min(plane.normal @ main.normal, 1.0))))
            reason = BEHIND if angle < constants.parallel_deg else OBLIQUE.format(angle)
            yield LeftOut(shape, SURFACE, reason, outline.area)


def _projected(outline: MultiPolygon, own: Frame, frame: Frame, spacing: float) -> MultiPolygon:
    """Return an outline in u, v of another frame, at least a spacing wide."""
    parts = []
    for part in outline.geoms:
        ring = np.array(part.exterior.coords)[:, :2]
        site = own.world(np.column_stack([ring, np.zeros(len(ring))]))
        parts.append(made_valid(Polygon(frame.local(site, np.zeros(3))[:, :2])).buffer(0.5 * spacing))
    return MultiPolygon(polygons_of(unary_union(parts)))
