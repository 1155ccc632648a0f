"""What is written on a drawing: dimensions and levels."""

import math
from typing import Any

from shapely.geometry import LineString, Point, Polygon

from ...drawing import Drawing
from ..elevation import Elevation
from .settings import DrawingSettings

STYLE = "FACADE"
CENTIMETRES = 2

Place = tuple[float, float]


def add_dimensions(drawing: Drawing, elevation: Elevation, settings: DrawingSettings) -> None:
    """Dimension the wall and each detail, on the layer DIMENSIONS.

    A size of which an edge was not seen is in brackets.
    """
    _add_style(drawing.document, settings)
    left, bottom, right, top = elevation.wall.bounds
    away = settings.beside_m
    _dimension(drawing, (left, bottom), (right, bottom), (left, bottom - away), 0.0, True)
    _dimension(drawing, (left, bottom), (left, top), (left - away, bottom), 90.0, True)
    for detail in elevation.details:
        low_u, low_v, high_u, high_v = detail.outline.bounds
        if min(detail.width, detail.height) < settings.room_m:
            continue
        # Beside the number in the middle.
        sill, jamb = low_v + 0.2 * detail.height, low_u + 0.2 * detail.width
        wide, high = math.isfinite(detail.width_std), math.isfinite(detail.height_std)
        _dimension(drawing, (low_u, sill), (high_u, sill), (low_u, sill), 0.0, wide)
        _dimension(drawing, (jamb, low_v), (jamb, high_v), (jamb, low_v), 90.0, high)


def add_levels(drawing: Drawing, elevation: Elevation, settings: DrawingSettings) -> None:
    """Mark the foot and the top of the wall, and sills and heads, beside the wall on the layer LEVELS.

    Levels are above the foot of the wall; its height in the site is written there.
    """
    _, bottom, right, top = elevation.wall.bounds
    ends = [v for detail in elevation.details for v in (detail.outline.bounds[1], detail.outline.bounds[3])]
    start, stop = right + 0.5 * settings.beside_m, right + settings.beside_m
    corner = 0.4 * settings.text_m
    for v in _apart([bottom, top, *sorted(ends)], settings.apart_m):
        drawing.line(LineString([(start, v), (stop, v)]), "LEVELS")
        drawing.polygon(
            Polygon([(stop, v), (stop + corner, v + corner), (stop - corner, v + corner)]), "LEVELS"
        )
        text = f"{v - bottom:+.{CENTIMETRES}f}"
        if v == bottom:
            height = elevation.frame.world([[0.0, v, 0.0]])[0, 2]
            text = f"%%p{0:.{CENTIMETRES}f} = {height:.{CENTIMETRES}f}"
        # The sign plus or minus is three characters in the file.
        length = settings.text_m * len(text.replace("%%p", "+"))
        drawing.text(text, Point(stop + 2 * corner + 0.5 * length, v), settings.text_m, "LEVELS")


def _add_style(document: Any, settings: DrawingSettings) -> None:
    style = document.dimstyles.duplicate_entry("Standard", STYLE)
    style.dxf.dimtxt = settings.text_m
    style.dxf.dimexe = style.dxf.dimexo = style.dxf.dimtsz = 0.5 * settings.text_m
    style.dxf.dimgap, style.dxf.dimtad = 0.3 * settings.text_m, 1
    style.dxf.dimdec, style.dxf.dimscale, style.dxf.dimlfac = settings.decimals, 1.0, 1.0


def _apart(levels: list[float], least: float) -> list[float]:
    """Return the levels, without those nearer to one before."""
    kept: list[float] = []
    for level in levels:
        if all(abs(level - other) >= least for other in kept):
            kept.append(level)
    return kept


def _dimension(drawing: Drawing, start: Place, stop: Place, base: Place, angle: float, seen: bool) -> None:
    dimension = drawing.document.modelspace().add_linear_dim(
        base=base,
        p1=start,
        p2=stop,
        angle=angle,
        dimstyle=STYLE,
        text="<>" if seen else "(<>)",
        dxfattribs={"layer": "DIMENSIONS"},
    )
    dimension.render()
