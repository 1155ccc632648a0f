"""The elevation as a drawing: DXF in metres, a layer for each kind."""

from pathlib import Path

from ...drawing import Drawing
from ...drawing import write_drawing as write_dxf
from ..elevation import Elevation, Frame

LAYERS = {
    "WALL": 8,
    "OPENING": 1,
    "RECESS": 5,
    "COLOURED_DETAIL": 30,
    "PROJECTION": 3,
    "UNSEEN": 9,
    "RAW": 252,
    "TEXT": 7,
}
"""Names of the layers, and their colours by number."""

TEXT_HEIGHT = 0.12


def write_drawing(path: Path, elevation: Elevation) -> None:
    """Write outlines, raw outlines and numbers true to scale in u, v.

    The user coordinate system FACADE holds the position of the drawing in the site.

    Raises
    ------
    MissingPackageError
        If ezdxf is not installed.
    InputError
        If the file cannot be written.
    """
    with write_dxf(path, LAYERS) as drawing:
        _add_frame(drawing, elevation.frame)
        for part in elevation.wall.geoms:
            drawing.polygon(part, "WALL")
        for area in elevation.unseen:
            drawing.polygon(area, "UNSEEN")
        for detail in elevation.details:
            drawing.polygon(detail.outline, detail.kind.upper().replace(" ", "_"))
            drawing.polygon(detail.raw, "RAW")
            drawing.text(str(detail.number), detail.outline.centroid, TEXT_HEIGHT, "TEXT")


def _add_frame(drawing: Drawing, frame: Frame) -> None:
    right, up, _ = frame.axes
    vectors = {"origin": frame.origin, "xaxis": right, "yaxis": up}
    attributes = {name: tuple(float(value) for value in vector) for name, vector in vectors.items()}
    drawing.document.ucs.new("FACADE", dxfattribs=attributes)
