"""The layout of a text cloud is found from its beginning."""

import numpy as np
import pytest
from ichnograph.algorithms.clouds.formats.text_columns import Columns
from ichnograph.algorithms.clouds.formats.text_dialect import Dialect
from ichnograph.algorithms.clouds.formats.text_layout import read_layout
from ichnograph.algorithms.clouds.settings import TextSettings
from ichnograph.algorithms.errors import InputError


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
    assert found.intensity_scale == (0.0, 65535.0)
    assert found.rgb_factor == 257.0
    np.testing.assert_array_equal(found.middle, [2.5, 2, 3])


def test_a_pts_announces_its_points_and_has_signed_intensity(layout):
    found = layout("2\n1.5 2.5 3.5 100 1 2 3\n1.5 2.5 3.5 200 1 2 3\n", "scan.pts")
    assert (found.announced, found.preamble) == (2, 1)
    assert found.intensity_scale[0] == 2048.0


def test_a_byte_order_mark_decides_the_encoding(layout):
    assert layout("1 2 3\n", encoding="utf-8-sig").encoding == "utf-8-sig"
    assert layout("1 2 3\n", encoding="utf-16").encoding == "utf-16"


def test_only_the_sample_is_examined(layout):
    content = "1.5 2.5 3.5 10 10 10\n" * 10 + "1.5 2.5 3.5 999 10 10\n"
    assert layout(content).rgb_factor == 1.0
    assert layout(content, settings=TextSettings(sample_bytes=100)).rgb_factor == 257.0


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
