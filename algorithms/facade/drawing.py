"""The elevation as a drawing: DXF in metres, a layer for each kind."""

from pathlib import Path
from typing import Any

import numpy as np

from ..errors import MissingPackageError
from ..files import atomic_output
from .model import Elevation, Frame

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
NOWHEN = 2451545.0
"""The date in every drawing, 1 January 2000, so that the same elevation gives the same file."""

NOBODY = "{00000000-0000-0000-0000-000000000000}"


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

    The user coordinate system FACADE holds the place of the drawing in the site.

    Raises
    ------
    MissingPackageError
        If ezdxf is not installed.
    InputError
        If the file cannot be written.
    """
    ezdxf = load_ezdxf()
    document = ezdxf.new("R2000", units=METRES)
    for name, colour in LAYERS.items():
        document.layers.add(name, color=colour)
    _add_frame(document, elevation.frame)
    model = document.modelspace()
    for part in elevation.wall.geoms:
        _add(model, part, "WALL")
    for place in elevation.unseen:
        _add(model, place, "UNSEEN")
    for detail in elevation.details:
        _add(model, detail.outline, detail.kind.upper().replace(" ", "_"))
        _add(model, detail.raw, "RAW")
        text = model.add_text(str(detail.number), dxfattribs={"layer": "TEXT", "height": TEXT_HEIGHT})
        centre = detail.outline.centroid
        text.dxf.halign, text.dxf.align_point = TEXT_CENTRE, (centre.x, centre.y)
        text.dxf.insert = (centre.x, centre.y)
    _make_reproducible(document)
    with (
        atomic_output(path) as temporary,
        temporary.open("w", encoding="cp1252", errors="dxfreplace") as stream,
    ):
        document.write(stream)


def _add(model: Any, polygon: Any, layer: str) -> None:
    for ring in (polygon.exterior, *polygon.interiors):
        model.add_lwpolyline(np.array(ring.coords)[:-1, :2].tolist(), close=True, dxfattribs={"layer": layer})


def _add_frame(document: Any, frame: Frame) -> None:
    right, up, _ = frame.axes
    places = {"origin": frame.origin, "xaxis": right, "yaxis": up}
    attributes = {name: tuple(float(value) for value in place) for name, place in places.items()}
    document.ucs.new("FACADE", dxfattribs=attributes)


def _make_reproducible(document: Any) -> None:
    """Leave out what differs from run to run: dates and random numbers."""
    document.ezdxf_metadata()["CREATED_BY_EZDXF"] = "Ichnograph"
    document.ezdxf_metadata()["WRITTEN_BY_EZDXF"] = "Ichnograph"
    for name in ("$TDCREATE", "$TDUCREATE", "$TDUPDATE", "$TDUUPDATE"):
        document.header[name] = NOWHEN
    for name in ("$FINGERPRINTGUID", "$VERSIONGUID"):
        document.header[name] = NOBODY
