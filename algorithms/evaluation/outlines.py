"""The polygons or lines of a layer as one shape, for the comparison of plans."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Optional

import numpy as np
from rasterio.crs import CRS
from rasterio.errors import RasterioError
from rasterio.warp import transform
from shapely import wkb
from shapely.geometry import MultiLineString, MultiPolygon, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union
from shapely.validation import make_valid

from ..errors import InputError
from ..reference_systems import name_of, parse_layer_wkt
from .settings import OutlineSettings


@dataclass(frozen=True)
class Outlines:
    """What a layer draws.

    Attributes
    ----------
    source : str
        What messages call it.
    shape : MultiPolygon or MultiLineString
        Polygons that touch are one.
    crs : CRS or None
    path : str or None
        The file it came from, if any.
    warnings : tuple of str
    parts : tuple of Polygon or LineString
        Its features one by one, also those that touch.
    """

    source: str
    shape: BaseGeometry
    crs: Optional[CRS]
    path: Optional[str] = None
    warnings: tuple[str, ...] = ()
    parts: tuple[BaseGeometry, ...] = ()


def outlines_of(
    source: str,
    geometries: Iterable[Optional[bytes]],
    wkt: str,
    path: Optional[str] = None,
    settings: OutlineSettings = OutlineSettings(),
) -> Outlines:
    """Join the geometries of a layer.

    Parameters
    ----------
    source : str
        What messages call it.
    geometries : iterable of bytes or None
        WKB. Heights are dropped, features without a geometry left out.
    wkt : str
        Coordinate reference system; empty if unknown.
    path : str, optional
        The file they came from.
    settings : OutlineSettings

    Raises
    ------
    InputError
        If there is neither polygon nor line, a coordinate is not a number, or the system is not in metres.
    """
    crs = parse_layer_wkt(wkt, source)
    polygons, lines, repaired = [], [], 0
    for number, data in enumerate(geometries, start=1):
        shape = wkb.loads(bytes(data)) if data else None
        if shape is None or shape.is_empty:
            continue
        if not np.isfinite(shape.length):
            raise InputError(
                f"Feature {number} of {source} has a coordinate that is not a number; remove it."
            )
        if not shape.is_valid:
            shape, repaired = make_valid(shape), repaired + 1
        parts = _parts(shape)
        polygons += [part for part in parts if part.geom_type == "Polygon"]
        lines += [part for part in parts if part.geom_type in ("LineString", "LinearRing") and part.length]
    if not polygons and not lines:
        raise InputError(f"{source} holds no outlines; choose a layer of polygons.")
    warnings = (f"Outlines of {source} that cross themselves were repaired: {repaired}.",) if repaired else ()
    # The lines that a repair leaves beside polygons were spikes.
    shape = dissolved(polygons, settings.seam_m) if polygons else MultiLineString(lines)
    return Outlines(source, shape, crs, path, warnings, tuple(polygons or lines))


def disagreements(
    walls: Outlines, reference: Outlines, tolerance: float, settings: OutlineSettings = OutlineSettings()
) -> tuple[str, ...]:
    """Return what makes a comparison of two layers doubtful.

    Returns
    -------
    tuple of str
        Sentences.

    Raises
    ------
    InputError
        If the layers are in different systems, or the walls are lines.
    """
    if not walls.shape.area:
        raise InputError(f"{walls.source} holds lines; choose a layer of polygons, as siteplan writes it.")
    _require_one_system(walls, reference, settings.same_position_m)
    doubts = [*walls.warnings, *reference.warnings]
    for one, other in ((walls, reference), (reference, walls)):
        if one.crs is None and other.crs is not None:
            doubts.append(
                f"{one.source} has no coordinate reference system; that of {other.source} is assumed."
            )
    apart = walls.shape.distance(reference.shape)
    if apart > tolerance:
        doubts.append(
            f"{walls.source} and {reference.source} have nothing in common: they are {apart:.1f} m apart; "
            "check that both show the same site in the same coordinate reference system."
        )
    return tuple(doubts)


def _require_one_system(walls: Outlines, reference: Outlines, same_position_m: float) -> None:
    if walls.crs is None or reference.crs is None or walls.crs == reference.crs:
        return
    # The same system can be written in ways that do not compare.
    middle = np.array(reference.shape.envelope.centroid.coords[0])
    try:
        moved = np.ravel(transform(reference.crs, walls.crs, *middle[:2, None]))
    except RasterioError:
        moved = np.full(2, np.inf)
    if not np.hypot(*(moved - middle)) <= same_position_m:
        raise InputError(
            f"{walls.source} is in {name_of(walls.crs)}, but {reference.source} in {name_of(reference.crs)}; "
            "reproject one of them with Reproject layer."
        )


def _parts(shape: BaseGeometry) -> list[BaseGeometry]:
    return [piece for part in shape.geoms for piece in _parts(part)] if hasattr(shape, "geoms") else [shape]


def dissolved(polygons: Sequence[Polygon], seam_m: float) -> MultiPolygon:
    """Return the union of polygons without the seams between those that touch."""
    grown = unary_union([polygon.buffer(seam_m / 2, join_style=2) for polygon in polygons])
    return MultiPolygon(_parts(grown.buffer(-seam_m / 2, join_style=2)))
