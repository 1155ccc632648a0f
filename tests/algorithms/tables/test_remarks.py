"""What a header says of the position of its points, and no reader applies, is said."""

from pathlib import Path

import pytest
from ichnograph.algorithms.tables.remarks import unapplied_remarks

PATH = Path("scan.ply")


@pytest.mark.parametrize(
    "remark",
    [
        "offset 412345.6 5812345.7 71.3",
        "# offset: 412345,6; 5812345,7; 0",
        "// Global shift: -412000 -5812000 0",
        "shift_x 412345.6",
        "point offset [412345.6, 5812345.7, 0]",
        "scan origin: 0 0 1.7",
        "TRANSLATION (10,20,30)",
        "scale 0.001",
        "matrix 0 -1 0 10 1 0 0 20 0 0 1 0 0 0 0 1",
    ],
)
def test_a_shift_a_scale_or_a_matrix_is_quoted(remark):
    (sentence,) = unapplied_remarks(PATH, [remark])
    assert f"says '{remark.lstrip('#/ ')}', which is not applied" in sentence


@pytest.mark.parametrize(
    "remark",
    [
        "offset 0 0 0",
        "scale 1.0",
        "matrix 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1",
        "time offset 3600",
        "scale of intensity 255",
        "original file: scan 12.txt",
        "transformed on 2024-05-01",
        "Created by CloudCompare v2.12 (Kyiv)",
        "X Y Z R G B",
        "15 columns, 3 of them coordinates",
    ],
)
def test_what_moves_no_points_is_passed_over(remark):
    assert unapplied_remarks(PATH, [remark]) == ()


@pytest.mark.parametrize(("remark", "axis"), [("up axis: Y", "y"), ("Y-up", "y"), ("axis_up = +x", "x")])
def test_another_axis_that_is_up_is_said(remark, axis):
    assert f"says that {axis} is up" in unapplied_remarks(PATH, [remark])[0]


@pytest.mark.parametrize("remark", ["crs EPSG:2994", "WGS 84 / UTM zone 33N (EPSG::2994)", "epsg 2994"])
def test_a_reference_system_is_said(remark):
    assert "names EPSG:2994, which is not read" in unapplied_remarks(PATH, [remark])[0]


def test_a_remark_that_is_repeated_is_said_once():
    assert len(unapplied_remarks(PATH, ["offset 1 2 3", "# offset 1 2 3"])) == 1
