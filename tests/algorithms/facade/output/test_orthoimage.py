"""The orthoimage: colours where they lie in the elevation."""

from dataclasses import replace

import numpy as np
import pytest
import rasterio
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.facade.elevation import Points
from ichnograph.algorithms.facade.output.orthoimage import automatic_pixel_size, paint, write_orthoimage
from ichnograph.tests.algorithms.facade.samples import lattice, small_elevation


@pytest.mark.parametrize(("spacing", "size"), [
    (0.0023, 0.005), (0.005, 0.005), (0.0051, 0.01), (0.012, 0.02), (0.02, 0.02), (0.3, 0.5),
])  # fmt: skip
def test_the_pixel_size_is_not_less_than_the_spacing(spacing, size):
    assert automatic_pixel_size(spacing) == pytest.approx(size)


def painted(colour=True, step=0.01):
    """Points of the small wall, red to the left and blue to the right, in its own frame."""
    uv = lattice(0, 0, 4, 3, step)
    uv = uv[~((uv > (1, 1)) & (uv < (2, 2.5))).all(axis=1)]
    frame = small_elevation().frame
    xyz = frame.world(np.column_stack([uv, np.zeros(len(uv))])) - frame.origin
    rgb = np.where(uv[:, :1] < 2.5, (200.0, 10.0, 10.0), (10.0, 10.0, 200.0)).astype(np.float32)
    intensity = np.where(uv[:, 0] < 2.5, 1000, 5000).astype(np.float32)
    return Points(xyz, frame.origin, rgb if colour else None, intensity, np.zeros(len(uv), np.int32))


def elevation_of(points):
    return replace(small_elevation(), rows=np.arange(len(points.xyz)))


def image(path):
    with rasterio.open(path) as raster:
        return raster.read(), raster.transform, raster.descriptions, raster.tags()


def test_the_orthoimage_lies_where_the_elevation_lies(tmp_path):
    points = painted()
    write_orthoimage(tmp_path / "o.tif", points, elevation_of(points), 0.02, fill=False)
    bands, transform, names, tags = image(tmp_path / "o.tif")

    assert names == ("red", "green", "blue", "alpha")
    assert (transform.c, transform.f, transform.a, transform.e) == pytest.approx((0, 3, 0.02, -0.02))
    left, right = bands[:3, 10, 50], bands[:3, 10, 150]
    assert tuple(left) == (200, 10, 10) and tuple(right) == (10, 10, 200)
    assert float(tags["azimuth"]) == pytest.approx(213.4)


def test_an_orthoimage_of_too_many_pixels_is_refused(tmp_path):
    points = painted(step=0.1)
    with pytest.raises(InputError, match="would have 4000000 x 3000000 pixels"):
        write_orthoimage(tmp_path / "o.tif", points, elevation_of(points), 1e-6, fill=False)
    assert not list(tmp_path.iterdir())


def test_holes_of_the_orthoimage_are_filled_only_where_asked(tmp_path):
    points = painted()
    for fill in (False, True):
        write_orthoimage(tmp_path / f"{fill}.tif", points, elevation_of(points), 0.02, fill)
    hole = (slice(40, 90), slice(60, 90))

    assert (image(tmp_path / "False.tif")[0][3][hole] == 0).all()
    assert (image(tmp_path / "True.tif")[0][3][hole] == 255).all()


def test_without_colour_the_orthoimage_is_grey(tmp_path):
    points = painted(colour=False)
    write_orthoimage(tmp_path / "o.tif", points, elevation_of(points), 0.02, fill=False)
    bands, _, names, _ = image(tmp_path / "o.tif")

    assert names == ("intensity", "alpha")
    assert bands[0, 10, 50] < bands[0, 10, 150]


def test_a_pixel_shows_the_foremost_points_only():
    uvw = np.array([(0.05, 0.05, 0.0), (0.05, 0.05, -0.02), (0.05, 0.05, -0.2), (0.15, 0.05, -0.2)])
    values = np.array([[10], [20], [200], [200]], np.float32)
    pixels, filled = paint(uvw, values, (0.0, 0.1), (1, 3), 0.1, 0.05)

    assert pixels[0, :, 0].tolist() == [15, 200, 0]
    assert filled[0].tolist() == [True, True, False]
