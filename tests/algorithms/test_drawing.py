"""Drawings: true to scale, the same bytes for the same content, complete or not written."""

import sys

import numpy as np
import pytest
from ichnograph.algorithms.drawing import write_drawing
from ichnograph.algorithms.errors import MissingPackageError
from shapely.geometry import LineString, Point, box

LAYERS = {"WALL": 1, "TEXT": 7}


def draw(path):
    with write_drawing(path, LAYERS) as drawing:
        outline = box(412_300, 5_812_300, 412_304, 5_812_303)
        drawing.polygon(outline.difference(outline.buffer(-0.5)), "WALL")
        drawing.line(LineString([(0, 0), (3, 4)]), "WALL")
        drawing.text("Küche 12 m²", Point(1, 2), 0.15, "TEXT")


@pytest.fixture
def document(tmp_path):
    ezdxf = pytest.importorskip("ezdxf", reason="ezdxf is not installed")
    draw(tmp_path / "a.dxf")
    return ezdxf.readfile(tmp_path / "a.dxf")


def test_lengths_are_in_metres_and_exact_in_large_coordinates(document):
    lines = [np.array(line.get_points("xy")) for line in document.modelspace().query("LWPOLYLINE")]

    assert document.header["$INSUNITS"] == 6
    np.testing.assert_allclose(np.ptp(lines[0], axis=0), (4, 3), atol=1e-6)
    np.testing.assert_allclose(np.ptp(lines[1], axis=0), (3, 2), atol=1e-6)
    np.testing.assert_allclose(lines[2], [(0, 0), (3, 4)])


def test_it_has_its_layers_and_no_errors(document):
    assert set(LAYERS) <= {layer.dxf.name for layer in document.layers}
    assert not document.audit().errors


def test_umlauts_and_squares_come_back(document):
    (text,) = document.modelspace().query("TEXT")
    assert text.dxf.text == "Küche 12 m²"


def test_the_same_content_gives_the_same_bytes(tmp_path):
    pytest.importorskip("ezdxf", reason="ezdxf is not installed")
    draw(tmp_path / "a.dxf"), draw(tmp_path / "b.dxf")
    assert (tmp_path / "a.dxf").read_bytes() == (tmp_path / "b.dxf").read_bytes()


def test_nothing_is_written_if_drawing_fails(tmp_path):
    pytest.importorskip("ezdxf", reason="ezdxf is not installed")
    with pytest.raises(ZeroDivisionError), write_drawing(tmp_path / "a.dxf", LAYERS):
        raise ZeroDivisionError
    assert not list(tmp_path.iterdir())


def test_a_drawing_without_its_package_names_the_package(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "ezdxf", None)
    with pytest.raises(MissingPackageError, match="DRAWING cannot be written without ezdxf"):
        draw(tmp_path / "a.dxf")
