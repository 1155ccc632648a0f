"""Drawings: DXF in metres, with named layers, complete or not written at all."""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from shapely.geometry import LineString, Point, Polygon

from .errors import MissingPackageError
from .files import atomic_output

METRES = 6
TEXT_CENTRE = 4
"""Codes of the format."""


class Drawing:
    """A drawing that is being made.

    Parameters
    ----------
    document : ezdxf document
    """

    def __init__(self, document: Any) -> None:
        self.document = document
        self._model = document.modelspace()

    def polygon(self, polygon: Polygon, layer: str) -> None:
        """Draw the rings of a polygon."""
        for ring in (polygon.exterior, *polygon.interiors):
            points = np.array(ring.coords)[:-1, :2].tolist()
            self._model.add_lwpolyline(points, close=True, dxfattribs={"layer": layer})

    def line(self, line: LineString, layer: str) -> None:
        """Draw a line."""
        points = np.array(line.coords)[:, :2].tolist()
        self._model.add_lwpolyline(points, dxfattribs={"layer": layer})

    def text(self, text: str, centre: Point, height_m: float, layer: str) -> None:
        """Write a line of text about a point."""
        entity = self._model.add_text(text, dxfattribs={"layer": layer, "height": height_m})
        entity.dxf.halign, entity.dxf.align_point = TEXT_CENTRE, (centre.x, centre.y)
        entity.dxf.insert = (centre.x, centre.y)


@contextmanager
def write_drawing(path: Path, layers: Mapping[str, int]) -> Iterator[Drawing]:
    """Yield an empty drawing, and write it at the end; the same content gives the same bytes.

    Parameters
    ----------
    path : Path
    layers : dict of str to int
        Names of the layers, and their colours by number.

    Raises
    ------
    MissingPackageError
        If ezdxf is not installed.
    InputError
        If the file cannot be written.
    """
    try:
        import ezdxf
    except ModuleNotFoundError as error:
        raise MissingPackageError("DRAWING", ("ezdxf",), "written") from error
    with _without_dates(ezdxf):
        document = ezdxf.new("R2000", units=METRES)
        for name, colour in layers.items():
            document.layers.add(name, color=colour)
        yield Drawing(document)
        with (
            atomic_output(path) as temporary,
            temporary.open("w", encoding="cp1252", errors="dxfreplace") as stream,
        ):
            document.write(stream)


@contextmanager
def _without_dates(ezdxf: Any) -> Iterator[None]:
    """Write no dates and random numbers."""
    before = ezdxf.options.write_fixed_meta_data_for_testing
    ezdxf.options.write_fixed_meta_data_for_testing = True
    try:
        yield
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = before
