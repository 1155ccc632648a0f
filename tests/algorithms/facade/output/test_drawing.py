"""The drawing: true to scale, with its position in the site."""

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from ichnograph.algorithms.errors import MissingPackageError
from ichnograph.algorithms.facade.development.curves import Circle
from ichnograph.algorithms.facade.elevation import KINDS
from ichnograph.algorithms.facade.output.drawing import LAYERS, layer_of, write_drawing
from ichnograph.tests.algorithms.facade.samples import small_elevation
from ichnograph.tests.scenes.facades.streets.openings import round_arch
from shapely.geometry import Polygon

TOLERANCE = 1e-5
"""A hundredth of a millimetre (m)."""


@pytest.fixture
def document(tmp_path):
    ezdxf = pytest.importorskip("ezdxf", reason="ezdxf is not installed")
    write_drawing(tmp_path / "drawing.dxf", small_elevation())
    return ezdxf.readfile(tmp_path / "drawing.dxf")


def test_the_drawing_is_true_to_scale_with_a_layer_for_each_kind(document):
    lines = document.modelspace().query("LWPOLYLINE")
    outlines = {line.dxf.layer: np.array(line.get_points("xy")) for line in lines}

    assert not document.audit().errors
    assert document.header["$INSUNITS"] == 6
    assert set(outlines) == {"WALL", "UNSEEN", "OPENING", "RAW", "LEVELS"}
    assert all(line.closed for line in lines if line.dxf.layer != "LEVELS")
    assert {layer_of(kind) for kind in KINDS} <= {layer.dxf.name for layer in document.layers}
    np.testing.assert_allclose(np.ptp(outlines["OPENING"], axis=0), (1.0, 1.5))
    (number,) = document.modelspace().query("TEXT[layer=='TEXT']")
    assert number.dxf.text == "1"


def test_a_rectangle_has_four_vertices_where_they_were_measured(document):
    (opening,) = document.modelspace().query("LWPOLYLINE[layer=='OPENING']")
    corners = {(round(x, 6), round(y, 6)) for x, y in opening.get_points("xy")}
    assert corners == {(1.0, 1.0), (2.0, 1.0), (2.0, 2.5), (1.0, 2.5)}


def test_the_manual_names_every_layer():
    page = (Path(__file__).parents[4] / "docs" / "facadedetails.md").read_text(encoding="utf-8")
    table = page.split("## The drawing")[1].split("##")[0]
    assert [name for name in LAYERS if name not in table] == []


def test_a_tower_that_is_rolled_out_has_no_place_in_the_site(tmp_path):
    ezdxf = pytest.importorskip("ezdxf", reason="ezdxf is not installed")
    tower = replace(small_elevation(), curve=Circle(np.zeros(2), 2.0, 180.0))
    write_drawing(tmp_path / "drawing.dxf", tower)
    assert "FACADE" not in ezdxf.readfile(tmp_path / "drawing.dxf").ucs


def test_arches_are_drawn_as_lines_and_arcs(tmp_path):
    ezdxf = pytest.importorskip("ezdxf", reason="ezdxf is not installed")
    elevation = small_elevation()
    arch = replace(elevation.details[0], outline=round_arch(1.0, 1.0, 1.0, 1.5))
    write_drawing(tmp_path / "drawing.dxf", replace(elevation, details=(arch,)))
    model = ezdxf.readfile(tmp_path / "drawing.dxf").modelspace()
    (outline,) = model.query("LWPOLYLINE[layer=='OPENING']")
    assert len(outline) == 4 and max(np.abs(outline.get_points("b"))) == pytest.approx(1, abs=1e-3)


def test_details_without_a_raw_outline_are_drawn(tmp_path):
    ezdxf = pytest.importorskip("ezdxf", reason="ezdxf is not installed")
    elevation = small_elevation()
    bare = replace(elevation.details[0], raw=Polygon())
    write_drawing(tmp_path / "drawing.dxf", replace(elevation, details=(bare,)))
    model = ezdxf.readfile(tmp_path / "drawing.dxf").modelspace()
    assert len(model.query("LWPOLYLINE[layer=='OPENING']")) == 1
    assert not model.query("LWPOLYLINE[layer=='RAW']")


def test_programs_open_the_drawing_at_its_size(document):
    low, high = np.array(document.header["$EXTMIN"]), np.array(document.header["$EXTMAX"])
    assert np.all(low[:2] <= 0) and np.all(high[:2] >= (4, 3))
    assert np.all(high[:2] - low[:2] < 8)


def test_raw_outlines_are_switched_off(document):
    assert document.layers.get("RAW").is_off()


def test_the_drawing_knows_its_place_in_the_site(tmp_path):
    ezdxf = pytest.importorskip("ezdxf", reason="ezdxf is not installed")
    write_drawing(tmp_path / "drawing.dxf", small_elevation())
    frame, place = small_elevation().frame, ezdxf.readfile(tmp_path / "drawing.dxf").ucs.get("FACADE")

    np.testing.assert_allclose(place.dxf.origin.xyz, frame.origin, atol=TOLERANCE, rtol=0)
    np.testing.assert_allclose(place.dxf.xaxis.xyz, frame.axes[0], atol=1e-9)
    np.testing.assert_allclose(place.dxf.yaxis.xyz, frame.axes[1], atol=1e-9)


def test_the_same_elevation_gives_the_same_bytes(tmp_path):
    pytest.importorskip("ezdxf", reason="ezdxf is not installed")
    for name in "ab":
        write_drawing(tmp_path / f"{name}.dxf", small_elevation())
    assert (tmp_path / "a.dxf").read_bytes() == (tmp_path / "b.dxf").read_bytes()


def test_a_drawing_without_its_package_names_the_package(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "ezdxf", None)
    with pytest.raises(MissingPackageError, match="DRAWING cannot be written without ezdxf"):
        write_drawing(tmp_path / "drawing.dxf", small_elevation())
    assert list(tmp_path.iterdir()) == []
