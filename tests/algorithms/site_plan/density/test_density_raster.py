"""The density raster is written and read back; rasters of other origin are used or refused."""

from pathlib import Path

import numpy as np
import pytest
import rasterio
from affine import Affine
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.raster import write_raster
from ichnograph.algorithms.site_plan.density.density_image import DensityImage
from ichnograph.algorithms.site_plan.density.density_raster import (
    BANDS,
    NO_CRS,
    DensityRaster,
    read_density,
    write_density,
)
from ichnograph.algorithms.site_plan.density.settings import SiteSettings
from rasterio.crs import CRS

GRID = Affine(0.1, 0, 412_300.0, 0, -0.1, 5_812_700.0)


def write(path, values, **profile):
    profile = {"driver": "GTiff", "count": 1, "dtype": "float32", "transform": GRID, **profile}
    with rasterio.open(path, "w", height=values.shape[0], width=values.shape[1], **profile) as raster:
        raster.write(values.astype(profile["dtype"]), 1)
    return path


def test_what_is_written_is_read_again(tmp_path):
    bands = np.random.default_rng(0).random((7, 20, 30)).astype(np.float32)
    bands[:, 3, 4] = np.nan
    image = DensityImage(*bands, GRID, CRS.from_epsg(25833), 10, 5, ())
    write_density(tmp_path / "density.tif", image)
    raster = read_density(tmp_path / "density.tif")
    assert (raster.transform, raster.crs) == (GRID, CRS.from_epsg(25833))
    np.testing.assert_array_equal(raster.density, bands[0])
    for read, band in zip(vars(raster.heights).values(), bands[1:]):
        np.testing.assert_array_equal(read, band)


def test_the_bands_of_an_image_are_taken_as_they_are():
    bands = np.random.default_rng(0).random((7, 20, 30)).astype(np.float32)
    image = DensityImage(*bands, GRID, CRS.from_epsg(25833), 10, 5, ("A warning.",))
    raster = DensityRaster.of(image)
    assert raster.density is image.density
    assert raster.heights.hanging is image.hanging
    assert (raster.transform, raster.crs, raster.warnings) == (GRID, CRS.from_epsg(25833), ("A warning.",))


def test_a_raster_without_a_reference_system_is_a_warning(tmp_path):
    assert read_density(write(tmp_path / "bare.tif", np.eye(4))).warnings == (NO_CRS,)
    assert read_density(write(tmp_path / "utm.tif", np.eye(4), crs=CRS.from_epsg(25833))).warnings == ()


def test_bands_are_recognised_by_their_names_in_any_order(tmp_path):
    bands = {name: np.full((4, 4), number, np.float32) for number, name in enumerate(BANDS, start=1)}
    write_raster(tmp_path / "reversed.tif", dict(reversed(bands.items())), GRID, None)
    raster = read_density(tmp_path / "reversed.tif")
    assert (raster.density[0, 0], raster.heights.occupied[0, 0], raster.heights.hanging[0, 0]) == (1, 2, 7)


def test_a_raster_that_lacks_a_band_of_heights_is_a_density_alone(tmp_path):
    bands = {name: np.full((4, 4), number, np.float32) for number, name in enumerate(BANDS[:-1], start=1)}
    write_raster(tmp_path / "short.tif", bands, GRID, None)
    raster = read_density(tmp_path / "short.tif")
    assert raster.heights is None
    assert raster.density[0, 0] == 1


def test_a_single_band_is_a_density_without_heights(tmp_path):
    raster = read_density(write(tmp_path / "counts.tif", np.eye(4), nodata=0))
    assert raster.heights is None
    assert np.isnan(raster.density[0, 1]) and raster.density[0, 0] == 1


@pytest.mark.parametrize(
    ("profile", "word"),
    [
        ({"transform": Affine(0.1, 0, 0, 0, -0.2, 0)}, "square"),
        ({"transform": Affine(0.09, 0.03, 412_300.0, 0.03, -0.09, 5_812_700.0)}, "north up"),
        ({"crs": CRS.from_epsg(4326)}, "metres"),
        ({"crs": CRS.from_epsg(2225)}, "metres"),
    ],
)
def test_an_unsuitable_grid_is_refused(tmp_path, profile, word):
    with pytest.raises(InputError, match=rf"bad\.tif.*{word}"):
        read_density(write(tmp_path / "bad.tif", np.eye(4), **profile))


def test_a_raster_of_too_many_pixels_is_refused_before_it_is_read(tmp_path):
    with pytest.raises(InputError, match=r"has 4 x 4 pixels, more than 15; cut it"):
        read_density(write(tmp_path / "large.tif", np.eye(4)), SiteSettings(most_pixels=15))


@pytest.mark.parametrize("value", [np.inf, -np.inf, 1e300])
def test_infinite_values_are_refused(tmp_path, value):
    values = np.eye(4)
    values[0, 0] = value
    with pytest.raises(InputError, match="holds infinite values"), np.errstate(over="ignore"):
        read_density(write(tmp_path / "inf.tif", values, dtype="float64"))


def test_a_raster_whose_texts_are_damaged_is_refused():
    path = Path(__file__).parents[5] / "shared" / "data" / "hostile" / "UnicodeDecodeError.tif"
    if not path.exists():
        pytest.skip("the shared data are not here")
    with pytest.raises(InputError, match="cannot be read as a raster"):
        read_density(path)


def test_a_raster_without_any_density_is_refused(tmp_path):
    with pytest.raises(InputError, match="no density"):
        read_density(write(tmp_path / "empty.tif", np.zeros((4, 4))))


def test_a_missing_file_and_a_text_file_are_refused(tmp_path):
    with pytest.raises(InputError, match="no such file"):
        read_density(tmp_path / "none.tif")
    (tmp_path / "text.tif").write_text("not a raster")
    with pytest.raises(InputError, match="cannot be read"):
        read_density(tmp_path / "text.tif")


@pytest.mark.parametrize("size", [1e-9, 1e6])
def test_pixels_of_an_absurd_size_are_refused(tmp_path, size):
    grid = Affine(size, 0, 0, 0, -size, 0)
    with pytest.raises(InputError, match="has pixels of"):
        read_density(write(tmp_path / "a.tif", np.ones((3, 3)), transform=grid))


def test_pictures_and_complex_numbers_are_refused(tmp_path):
    picture = {"count": 3, "dtype": "uint8", "photometric": "RGB"}
    for name, profile in (("a.tif", picture), ("b.tif", {"dtype": "complex64"})):
        with pytest.raises(InputError, match="holds a picture, not densities"):
            read_density(write(tmp_path / name, np.ones((3, 3)), **profile))


def test_a_scale_and_an_offset_of_the_values_are_applied(tmp_path):
    path = write(tmp_path / "a.tif", np.ones((3, 3)))
    with rasterio.open(path, "r+") as raster:
        raster.scales, raster.offsets = (0.5,), (7.0,)
    np.testing.assert_array_equal(read_density(path).density, np.full((3, 3), 7.5))


def test_values_below_0_are_refused(tmp_path):
    values = np.random.default_rng(0).random((20, 30))
    values[3, 4] = -9999
    with pytest.raises(InputError, match="holds values below 0, which no density has"):
        read_density(write(tmp_path / "a.tif", values))
    assert np.isnan(read_density(write(tmp_path / "b.tif", values, nodata=-9999)).density[3, 4])


def test_a_raster_whose_system_stretches_lengths_is_a_warning(tmp_path):
    grid = Affine(0.1, 0, 1_224_500.0, 0, -0.1, 6_106_900.0)
    path = write(tmp_path / "a.tif", np.ones((20, 30)), transform=grid, crs="EPSG:3857")
    assert "1.49 times those on the ground" in read_density(path).warnings[0]
