"""Shapefiles that are damaged are refused, because GDAL reads what is there and says nothing."""

import fiona
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.shapefile import lacks_table, refuse_damaged


@pytest.fixture
def path(tmp_path):
    schema = {"geometry": "3D Point", "properties": {"name": "str"}}
    with fiona.open(tmp_path / "a.shp", "w", "ESRI Shapefile", schema) as layer:
        for number in range(5):
            shape = {"type": "Point", "coordinates": (number, 2.0, 3.0)}
            layer.write({"geometry": shape, "properties": {"name": f"T{number}"}})
    return tmp_path / "a.shp"


def shorten(path, suffix, size):
    part = path.with_suffix(suffix)
    part.write_bytes(part.read_bytes()[:size])


def test_a_sound_shapefile_passes_also_without_a_table_and_in_capitals(path):
    refuse_damaged(path)
    assert not lacks_table(path)
    path.with_suffix(".dbf").rename(path.with_suffix(".DBF"))
    refuse_damaged(path)
    assert not lacks_table(path)
    path.with_suffix(".DBF").unlink()
    refuse_damaged(path)
    assert lacks_table(path)


@pytest.mark.parametrize(
    ("suffix", "size", "problem"),
    [
        (".shp", -40, "it is cut off"),
        (".dbf", -60, "its table is cut off"),
        (".dbf", 5, "its table is cut off"),
        (".shx", -8, "it has 4 shapes, and its table 5 rows"),
    ],
)
def test_a_shapefile_that_is_cut_off_is_refused(path, suffix, size, problem):
    shorten(path, suffix, size)
    with pytest.raises(InputError, match=f"a.shp is damaged .{problem}"):
        refuse_damaged(path)


def test_other_layers_pass(tmp_path):
    (tmp_path / "a.gpkg").write_bytes(b"")
    refuse_damaged(tmp_path / "a.gpkg")
