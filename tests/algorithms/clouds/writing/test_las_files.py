"""LAS files hold coordinates as integers, exactly enough and never too large."""

from pathlib import Path

import laspy
import numpy as np
import pytest
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.clouds.settings import WritingSettings
from ichnograph.algorithms.clouds.source import Chunk
from ichnograph.algorithms.clouds.writing.las_files import (
    common_scales,
    copied_header,
    las_points,
    las_sources,
    new_header,
    of_one_point_format,
    replace_crs,
    stored,
)
from ichnograph.algorithms.errors import InputError
from rasterio.crs import CRS

OUT = Path("out.las")
UTM = CRS.from_epsg(25832)


@pytest.fixture
def las(tmp_path):
    def las(name, scale=1e-3, offset=0.0, point_format=6, version="1.4", extra=None):
        header = laspy.LasHeader(version=version, point_format=point_format)
        header.scales, header.offsets = np.full(3, scale), np.full(3, offset)
        if extra:
            header.add_extra_dim(laspy.ExtraBytesParams(extra, np.uint8))
        data = laspy.LasData(header)
        data.x, data.y, data.z = np.ones((3, 4))
        data.write(tmp_path / name)
        return tmp_path / name

    return las


@pytest.fixture
def text(tmp_path):
    (tmp_path / "in.xyz").write_text("1 2 3\n")
    return tmp_path / "in.xyz"


def test_records_are_of_one_format_if_all_files_are_las_of_it(las, text):
    one, other = las("a.las"), las("b.laz")
    assert len(of_one_point_format(open_cloud([one, other]))) == 2
    assert of_one_point_format(open_cloud([one, text])) == ()
    assert of_one_point_format(open_cloud([one, las("c.las", point_format=7)])) == ()
    assert of_one_point_format(open_cloud([one, las("d.las", extra="class2")])) == ()
    assert [source.path for source in las_sources(open_cloud([text, one]).sources)] == [one]


def test_equal_scales_are_kept_where_offsets_differ_by_whole_steps(las):
    cloud = open_cloud([las("a.las", 2e-3), las("b.las", 2e-3, offset=0.5)])
    np.testing.assert_array_equal(common_scales(cloud), np.full(3, 2e-3))


@pytest.mark.parametrize(
    ("scale", "expected"), [(2e-3, 1e-4), (5e-5, 5e-5), (1e-7, 1e-5)], ids=["coarse", "fine", "too fine"]
)
def test_coordinates_beside_other_formats_are_stored_to_a_tenth_of_a_millimetre_or_finer(
    las, text, scale, expected
):
    cloud = open_cloud([las("a.las", scale), text])
    np.testing.assert_allclose(common_scales(cloud), np.full(3, expected), rtol=1e-12)


def test_the_steps_are_those_of_the_settings(text):
    assert common_scales(open_cloud([text]), WritingSettings(coarsest_step_m=0.01))[0] == 0.01


def test_coordinates_are_rounded_to_the_nearest_integer():
    np.testing.assert_array_equal(stored(np.array([0.0014, -0.0016]), 1e-3, OUT), [1, -2])
    with pytest.raises(InputError, match=r"out\.las cannot hold points that lie so far apart"):
        stored(np.array([3e6]), 1e-3, OUT)


@pytest.mark.parametrize(("has_rgb", "point_format"), [(False, 6), (True, 7)])
def test_a_new_header_states_the_system_and_has_room_for_colour(has_rgb, point_format):
    header = new_header(np.array([100.0, 200, 0]), np.full(3, 1e-4), has_rgb, UTM)
    assert (header.point_format.id, str(header.version)) == (point_format, "1.4")
    assert [record.string for record in header.vlrs] == [UTM.to_wkt()]
    assert header.global_encoding.wkt


def test_points_without_colour_are_single_returns_at_their_integers():
    header = new_header(np.zeros(3), np.full(3, 1e-3), True, None)
    points = las_points(Chunk(np.array([[1.0, 2.0, -3.0]]), np.array([7], np.uint16), None), header, OUT)
    assert [int(points[name][0]) for name in ("X", "Y", "Z", "intensity", "red")] == [1000, 2000, -3000, 7, 0]
    assert (points["return_number"][0], points["number_of_returns"][0]) == (1, 1)


def test_another_system_replaces_all_records_of_the_old_one(las):
    header, evlrs = copied_header(las("a.las", version="1.2", point_format=2))
    first = replace_crs(header, evlrs, UTM)
    assert (first, str(header.version), len(header.vlrs)) == ([], "1.4", 1)
    replace_crs(header, evlrs, CRS.from_epsg(25833))
    assert [record.string for record in header.vlrs] == [CRS.from_epsg(25833).to_wkt()]
    replace_crs(header, evlrs, None)
    assert (len(header.vlrs), header.global_encoding.wkt) == (0, False)


def test_a_version_without_the_point_format_is_corrected(las):
    path = las("a.las")
    data = bytearray(path.read_bytes())
    data[25] = 2
    path.write_bytes(data)
    header, _ = copied_header(path)
    assert (header.version.minor, header.point_format.id) == (4, 6)
