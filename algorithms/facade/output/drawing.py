"""The elevation as a drawing: DXF in metres, a layer for each kind."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from ...errors import MissingPackageError
from ...files import atomic_output
from ..elevation import Elevation, Frame

METRES = 6
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
TEXT_CENTRE = 4


def load_ezdxf() -> Any:
    """Return the module ezdxf.

    Raises
    ------
    MissingPackageError
        If it is not installed.
    """
    try:
        import ezdxf
    except ModuleNotFoundError as error:
        raise MissingPackageError("DRAWING", ("ezdxf",), "written") from error
    return ezdxf


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
    ezdxf = load_ezdxf()
    with _without_dates(ezdxf):
        document = _draw(ezdxf, elevation)
        with (
            atomic_output(path) as temporary,
            temporary.open("w", encoding="cp1252", errors="dxfreplace") as stream,
        ):
            document.write(stream)


def _draw(ezdxf: Any, elevation: Elevation) -> Any:
    document = ezdxf.new("R2000", units=METRES)
    for name, colour in LAYERS.items():
        document.layers.add(name, color=colour)
    _add_frame(document, elevation.frame)
    model = document.modelspace()
    for part in elevation.wall.geoms:
        _add(model, part, "WALL")
    for area in elevation.unseen:
        _add(model, area, "UNSEEN")
    for detail in elevation.details:
        _add(model, detail.outline, detail.kind.upper().replace(" ", "_"))
        _add(model, detail.raw, "RAW")
        text = model.add_text(str(detail.number), dxfattribs={"layer": "TEXT", "height": TEXT_HEIGHT})
        centre = detail.outline.centroid
        text.dxf.halign, text.dxf.align_point = TEXT_CENTRE, (centre.x, centre.y)
        text.dxf.insert = (centre.x, centre.y)
    return document


def _add(model: Any, polygon: Any, layer: str) -> None:
    for ring in (polygon.exterior, *polygon.interiors):
        model.add_lwpolyline(np.array(ring.coords)[:-1, :2].tolist(), close=True, dxfattribs={"layer": layer})


def _add_frame(document: Any, frame: Frame) -> None:
    right, up, _ = frame.axes
    vectors = {"origin": frame.origin, "xaxis": right, "yaxis": up}
    attributes = {name: tuple(float(value) for value in vector) for name, vector in vectors.items()}
    document.ucs.new("FACADE", dxfattribs=attributes)


@contextmanager
def _without_dates(ezdxf: Any) -> Iterator[None]:
    """Write no dates and random numbers, so that the same elevation gives the same file."""
    before = ezdxf.options.write_fixed_meta_data_for_testing
    ezdxf.options.write_fixed_meta_data_for_testing = True
    try:
        yield
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = before
