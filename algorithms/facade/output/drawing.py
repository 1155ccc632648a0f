"""The elevation as a drawing: DXF in metres, with lines and arcs, levels and dimensions, on named layers."""

from pathlib import Path

from shapely.geometry import LinearRing, Polygon

from ...drawing import Drawing
from ...drawing import write_drawing as write_dxf
from ..elevation import KINDS, Elevation, Frame
from .annotations import add_dimensions, add_levels
from .polylines import polyline
from .settings import DrawingSettings

COLOURS = (1, 5, 30, 3, 6, 40, 150, 200)
"""Of the layers of kinds, by number, in the order of `KINDS`."""


def layer_of(kind: str) -> str:
    """Return the name of the layer of a kind."""
    return kind.upper().replace(" ", "_")


LAYERS = {
    "WALL": 8,
    **dict(zip(map(layer_of, KINDS), COLOURS)),
    "UNSEEN": 9,
    "RAW": 252,
    "TEXT": 7,
    "DIMENSIONS": 4,
    "LEVELS": 2,
}
"""Names of the layers, and their colours by number."""


def write_drawing(path: Path, elevation: Elevation, settings: DrawingSettings = DrawingSettings()) -> None:
    """Write the elevation true to scale in u, v.

    Outlines are closed polylines of lines and arcs; raw outlines are on a layer that is switched off. The
    user coordinate system FACADE holds the position of the drawing of a flat facade in the site.

    Raises
    ------
    MissingPackageError
        If ezdxf is not installed.
    InputError
        If the file cannot be written.
    """
    with write_dxf(path, LAYERS) as drawing:
        drawing.document.layers.get("RAW").off()
        if elevation.curve is None:
            _add_frame(drawing, elevation.frame)
        for part in elevation.wall.geoms:
            _add(drawing, part, "WALL", elevation.spacing, settings)
        for area in elevation.unseen:
            _add(drawing, area, "UNSEEN", elevation.spacing, settings)
        for detail in elevation.details:
            _add(drawing, detail.outline, layer_of(detail.kind), elevation.spacing, settings)
            if not detail.raw.is_empty:
                drawing.polygon(detail.raw, "RAW")
            drawing.text(str(detail.number), detail.outline.centroid, settings.text_m, "TEXT")
        add_dimensions(drawing, elevation, settings)
        add_levels(drawing, elevation, settings)
        _set_extents(drawing, elevation, settings)


def _add(drawing: Drawing, polygon: Polygon, layer: str, spacing: float, settings: DrawingSettings) -> None:
    model = drawing.document.modelspace()
    for ring in (polygon.exterior, *polygon.interiors):
        vertices = polyline(LinearRing(ring.coords), spacing, settings).tolist()
        model.add_lwpolyline(vertices, format="xyb", close=True, dxfattribs={"layer": layer})


def _add_frame(drawing: Drawing, frame: Frame) -> None:
    right, up, _ = frame.axes
    vectors = {"origin": frame.origin, "xaxis": right, "yaxis": up}
    attributes = {name: tuple(float(value) for value in vector) for name, vector in vectors.items()}
    drawing.document.ucs.new("FACADE", dxfattribs=attributes)


def _set_extents(drawing: Drawing, elevation: Elevation, settings: DrawingSettings) -> None:
    """Let programs open the drawing at its size."""
    left, bottom, right, top = elevation.wall.bounds
    margin, document = 3 * settings.beside_m, drawing.document
    corners = (left - margin, bottom - margin, 0.0), (right + 2 * margin, top + margin, 0.0)
    document.header["$EXTMIN"], document.header["$EXTMAX"] = corners
    document.modelspace().reset_extents(*corners)
    middle = tuple(0.5 * (low + high) for low, high in zip(*corners))[:2]
    document.set_modelspace_vport(corners[1][1] - corners[0][1], middle)
