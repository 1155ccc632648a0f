"""Text files hold what all clouds have, under one header line."""

import io
from pathlib import Path

import numpy as np
import pytest
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.clouds.source import Chunk
from ichnograph.algorithms.clouds.writing.text_files import append_rows, table_of


@pytest.fixture
def cloud(tmp_path):
    (tmp_path / "in.csv").write_text("x,y,z,intensity,red,green,blue\n600123.5,5000150,1.25,7,255,0,10\n")
    return open_cloud([tmp_path / "in.csv"])


def test_coordinates_are_those_of_the_map_and_colours_go_to_255(cloud):
    table = table_of(cloud, next(cloud.chunks()))
    assert list(table.columns) == ["x", "y", "z", "intensity", "red", "green", "blue"]
    assert table.iloc[0].tolist() == [600123.5, 5000150, 1.25, 7, 255, 0, 10]


def test_points_of_a_file_without_intensity_and_colour_have_zeros(cloud):
    table = table_of(cloud, Chunk(np.array([[1.0, 2.0, 3.0]]), None, None))
    assert table.iloc[0, 3:].tolist() == [0, 0, 0, 0]


@pytest.mark.parametrize(("name", "separator"), [("a.xyz", " "), ("a.txt", " "), ("a.csv", ",")])
def test_the_header_is_written_once_with_the_separator_of_the_format(cloud, name, separator):
    table = table_of(cloud, next(cloud.chunks()))
    stream = io.StringIO()
    for _ in range(2):
        append_rows(table, stream, Path(name))
    header, *rows = stream.getvalue().splitlines()
    assert header == separator.join(["x", "y", "z", "intensity", "red", "green", "blue"])
    assert rows == [separator.join(["600123.50000", "5000150.00000", "1.25000", "7", "255", "0", "10"])] * 2
