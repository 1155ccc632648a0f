"""Rasters are whole, tiled, compressed, placed and described."""

import numpy as np
import pytest
import rasterio
from affine import Affine
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.raster import NODATA, write_raster
from rasterio.crs import CRS

GRID = Affine(0.1, 0, 412_300.0, 0, -0.1, 5_812_700.0)


def test_a_float_raster_keeps_values_place_names_and_nodata(tmp_path):
    values = np.array([[1.5, np.nan], [2.5, 3.5]], np.float32)
    path = tmp_path / "density.tif"
    write_raster(path, {"density": values, "top": values + 1}, GRID, CRS.from_epsg(25833))
    with rasterio.open(path) as raster:
        assert raster.transform == GRID
        assert raster.crs == CRS.from_epsg(25833)
        assert raster.descriptions == ("density", "top")
        assert raster.nodata == NODATA
        assert raster.profile["tiled"] and raster.profile["compress"] == "deflate"
        np.testing.assert_array_equal(raster.read(1, masked=True).filled(np.nan), values)
        assert float(raster.tags(1)["STATISTICS_MEAN"]) == 2.5


def test_a_byte_raster_stays_bytes(tmp_path):
    write_raster(tmp_path / "plan.tif", {"wall": np.eye(3, dtype=np.uint8)}, GRID, None)
    with rasterio.open(tmp_path / "plan.tif") as raster:
        assert raster.dtypes == ("uint8",)
        assert raster.read(1).sum() == 3


def test_a_missing_folder_is_named(tmp_path):
    with pytest.raises(InputError, match="nowhere"):
        write_raster(tmp_path / "nowhere" / "a.tif", {"a": np.zeros((2, 2), np.uint8)}, GRID, None)


def test_a_failed_write_leaves_the_old_raster_untouched(tmp_path):
    path = tmp_path / "plan.tif"
    write_raster(path, {"wall": np.eye(3, dtype=np.uint8)}, GRID, None)
    before = path.read_bytes()
    with pytest.raises(TypeError):
        write_raster(path, {"wall": np.full((3, 3), None)}, GRID, None)
    assert path.read_bytes() == before
    assert list(tmp_path.iterdir()) == [path]


def test_a_raster_that_cannot_be_read_as_it_was_written_is_not_published(tmp_path, monkeypatch):
    """GDAL says nothing of a disk that fills up while it closes the file."""
    path = tmp_path / "plan.tif"
    path.write_bytes(b"old")
    monkeypatch.setattr(np, "array_equal", lambda one, other: False)
    with pytest.raises(InputError, match=r"plan\.tif was not written completely"):
        write_raster(path, {"wall": np.eye(3, dtype=np.uint8)}, GRID, None)
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]
