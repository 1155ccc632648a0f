"""The layout of a text cloud is found from its beginning."""

import numpy as np
import pytest
from ichnograph.algorithms.clouds.formats.text_columns import Columns
from ichnograph.algorithms.clouds.formats.text_layout import read_layout
from ichnograph.algorithms.clouds.settings import TextSettings
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.tables.dialect import Dialect


@pytest.fixture
def layout(tmp_path):
    def layout(content, name="scan.txt", encoding="utf-8", settings=TextSettings()):
        path = tmp_path / name
        path.write_bytes(content.encode(encoding))
        return read_layout(path, settings)

    return layout


def test_everything_that_reading_needs_is_found(layout):
    found = layout(
        "# site\nx;y;z;intensity;r;g;b\n1,5;2;3;0,5;10;20;30\n2,5;2;3;0,7;10;20;255\n3,5;2;9;1;0;0;0\n"
    )
    assert found.dialect == Dialect(";", ",", 7)
    assert found.columns == Columns((0, 1, 2), 3, (4, 5, 6))
    assert (found.preamble, found.announced, found.encoding) == (2, None, "utf-8")
    assert found.metres == (1.0, 1.0, 1.0)
    np.testing.assert_array_equal(found.middle, [2.5, 2, 3])


def test_a_pts_announces_its_points(layout):
    found = layout("2\n1.5 2.5 3.5 100 1 2 3\n1.5 2.5 3.5 200 1 2 3\n", "scan.pts")
    assert (found.announced, found.preamble) == (2, 1)


def test_rows_whose_name_begins_as_a_remark_does_are_points_and_it_is_said(layout):
    found = layout("# site\n#1 1.5 2.5 3.5\n#2 4.5 5.5 6.5\nT3 7.5 8.5 9.5\nT4 7.5 8.5 9.5\n")
    assert found.preamble == 1
    assert any("2 of the first rows of" in warning and "line 2," in warning for warning in found.warnings)


def test_a_remark_with_three_numbers_is_no_point(layout):
    found = layout("# 500000 5700000 0\nT1 1.5 2.5 3.5\nT2 4.5 5.5 6.5\nT3 7.5 8.5 9.5\n")
    assert found.preamble == 1
    assert not any("remarks" in warning for warning in found.warnings)


def test_a_byte_order_mark_decides_the_encoding(layout):
    assert layout("1 2 3\n", encoding="utf-8-sig").encoding == "utf-8-sig"
    assert layout("1 2 3\n", encoding="utf-16").encoding == "utf-16"


def test_units_other_than_metres_are_said(layout):
    found = layout("X [mm];Y [mm];Z [mm]\n1500;2500;3500\n")
    assert found.metres == (1e-3, 1e-3, 1e-3)
    np.testing.assert_allclose(found.middle, [1.5, 2.5, 3.5])
    assert "gives coordinates in mm; they were converted to metres" in found.warnings[0]


@pytest.mark.parametrize(
    ("content", "problem"),
    [
        ("1 2 3\0\n", "is not a text file"),
        ("ncols 4\nnrows 4\n1 2 3 4\n", "is a raster grid, not a point cloud"),
        ("nan nan nan\n", "has coordinates that are not numbers"),
    ],
)
def test_what_is_not_a_text_cloud_is_refused(layout, content, problem):
    with pytest.raises(InputError, match=problem):
        layout(content)


@pytest.mark.parametrize(
    "text",
    [
        pytest.param("v 1.5 2.5 3.5\nv 2.5 3.5 4.5\nvn 0.0 0.6 0.8\nvn 0.0 0.6 0.8\n", id="OBJ with normals"),
        pytest.param("v 1.5 2.5 3.5\nv 2.5 3.5 4.5\nv 4 5 6\nf 1 2 3\n", id="OBJ with triangles"),
        pytest.param("v 1.5 2.5 3.5\nv 2.5 3.5 4.5\nv 4 5 6\nf 1//1 2//2 3//1\n", id="OBJ with indices"),
        pytest.param(
            # Triangles behind more than is read at once.
            "".join(f"v {n}.5 {n % 7}.25 {n % 5}.75\n" for n in range(4000))
            + "".join(f"f {n} {n + 1} {n + 2}\n" for n in range(1, 4000)),
            id="large OBJ",
        ),
        pytest.param("OFF\n3 1 0\n1.5 2.5 3.5\n2.5 3.5 4.5\n3 4 5\n", id="OFF"),
    ],
)
def test_a_model_of_surfaces_is_refused(tmp_path, text):
    path = tmp_path / "model.txt"
    path.write_text(text)
    with pytest.raises(InputError, match="is a model of surfaces, not a point cloud"):
        read_layout(path)
    path.write_text("v 1.5 2.5 3.5\nv 2.5 3.5 4.5\n")
    assert read_layout(path).columns.xyz == (1, 2, 3)


def test_points_may_be_called_v_and_f(layout):
    rows = [f"{'vf'[n % 2]} {n}.5 {n + 1}.25 {n % 7}.75\n" for n in range(6)]
    assert layout("".join(rows)).columns.xyz == (1, 2, 3)


@pytest.mark.parametrize(
    ("value", "said"),
    [
        pytest.param(lambda n: f"{n * 37 % 256}", False, id="8 bits"),
        pytest.param(lambda n: f"{n * 37 % 4096 - 2048}", False, id="11 bits with sign"),
        pytest.param(lambda n: f"{n * 37 % 101 / 101:.4f}", False, id="part of 1"),
        pytest.param(lambda n: f"{n * 37 % 8}", True, id="class"),
        pytest.param(lambda n: f"{n * 37 % 101 / 20:.3f}", True, id="distance"),
        pytest.param(lambda n: f"{n * 37 % 101 / 101 - 0.5:.4f}", True, id="deviation"),
    ],
)
def test_only_what_may_be_something_else_than_intensity_is_said(layout, value, said):
    rows = [f"{n * 7 % 11}.25 {n % 5}.5 {n % 3}.75 {value(n)}\n" for n in range(300)]
    found = layout("".join(rows))
    assert found.columns.intensity == 3
    assert any("was read as intensity" in warning for warning in found.warnings) == said
