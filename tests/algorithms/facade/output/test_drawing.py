"""The drawing: true to scale, with its position in the site."""

import sys

import numpy as np
import pytest
from ichnograph.algorithms.errors import MissingPackageError
from ichnograph.algorithms.facade.output.drawing import write_drawing
from ichnograph.tests.algorithms.facade.samples import small_elevation

TOLERANCE = 1e-5
"""A hundredth of a millimetre (m)."""


def test_the_drawing_is_true_to_scale_with_a_layer_for_each_kind(tmp_path):
    ezdxf = pytest.importorskip("ezdxf", reason="ezdxf is not installed")
    write_drawing(tmp_path / "drawing.dxf", small_elevation())
    document = ezdxf.readfile(tmp_path / "drawing.dxf")
    outlines = {
        line.dxf.layer: np.array(line.get_points("xy")) for line in document.modelspace().query("LWPOLYLINE")
    }

    assert not document.audit().errors
    assert document.header["$INSUNITS"] == 6
    assert set(outlines) == {"WALL", "UNSEEN", "OPENING", "RAW"}
    np.testing.assert_allclose(np.ptp(outlines["OPENING"], axis=0), (1.0, 1.5))
    (text,) = document.modelspace().query("TEXT")
    assert (text.dxf.text, text.dxf.layer) == ("1", "TEXT")


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
