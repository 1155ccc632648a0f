"""The kept points arrive with all that their format can hold."""

import laspy
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.clouds.settings import WritingSettings
from ichnograph.algorithms.clouds.writing.point_selection import write_cloud
from ichnograph.algorithms.errors import CancelledError, InputError, NothingFoundError
from ichnograph.algorithms.progress import Progress
from ichnograph.tests.algorithms.clouds.sample_files import leave_usable
from laspy.vlrs.known import WktCoordinateSystemVlr
from laspy.vlrs.vlrlist import VLRList
from rasterio.crs import CRS


def las(path, count=50, point_format=3, scale=0.001, offset=(600000, 5000000, 0), epsg=None):
    """Write random points with GPS time, an extra dimension and a record of their own."""
    rng = np.random.default_rng(count)
    header = laspy.LasHeader(version="1.4", point_format=point_format)
    header.scales, header.offsets = np.full(3, scale), np.array(offset, float)
    header.vlrs.append(laspy.VLR("surveyor", 7, "note", b"kept"))
    header.add_extra_dim(laspy.ExtraBytesParams("deviation", np.uint16))
    header.add_extra_dim(
        laspy.ExtraBytesParams("range", np.int32, scales=np.array([0.01]), offsets=np.zeros(1))
    )
    if epsg:
        header.vlrs.append(WktCoordinateSystemVlr(CRS.from_epsg(epsg).to_wkt()))
    points = laspy.ScaleAwarePointRecord.zeros(count, header=header)
    for name in points.array.dtype.names:
        points.array[name] = rng.integers(1, 200, count)
    leave_usable(points.array)
    with laspy.open(path, "w", header=header) as writer:
        writer.write_points(points)
    return path


def text(path, rows, header=""):
    path.write_text(header + "".join(" ".join(map(str, row)) + "\n" for row in rows))
    return path


def all_xyz(paths):
    cloud = open_cloud(paths)
    return np.concatenate([chunk.xyz for chunk in cloud.chunks()]) + cloud.origin


@pytest.mark.parametrize("point_format", [1, 3, 6, 7, 8])
@pytest.mark.parametrize("name", ["out.las", "out.laz"])
def test_las_keeps_every_attribute_and_record(tmp_path, name, point_format):
    path = las(tmp_path / "in.laz", point_format=point_format, epsg=25832)
    kept = np.array([0, 3, 4, 49])
    assert write_cloud(open_cloud([path]), kept, tmp_path / name) == 4
    before, after = laspy.read(path), laspy.read(tmp_path / name)
    np.testing.assert_array_equal(after.points.array, before.points.array[kept])
    np.testing.assert_array_equal(after.header.scales, before.header.scales)
    np.testing.assert_array_equal(after.header.offsets, before.header.offsets)
    assert after.header.vlrs.get_by_id("surveyor", (7,))[0].record_data == b"kept"
    assert open_cloud([tmp_path / name]).crs == CRS.from_epsg(25832)


def test_the_header_of_the_output_is_that_of_the_kept_points(tmp_path):
    write_cloud(open_cloud([las(tmp_path / "in.las")]), np.array([5]), tmp_path / "out.las")
    header = laspy.read(tmp_path / "out.las").header
    assert header.point_count == 1
    np.testing.assert_array_equal(header.mins, header.maxs)


def test_records_behind_the_points_are_kept(tmp_path):
    header = laspy.LasHeader(version="1.4", point_format=6)
    with laspy.open(tmp_path / "in.laz", "w", header=header) as writer:
        writer.write_points(laspy.ScaleAwarePointRecord.zeros(3, header=header))
        writer.write_evlrs(VLRList([laspy.VLR("surveyor", 7, "note", b"kept")]))
    write_cloud(open_cloud([tmp_path / "in.laz"]), np.array([1]), tmp_path / "out.laz")
    assert laspy.read(tmp_path / "out.laz").evlrs[0].record_data == b"kept"


def test_files_of_one_format_are_joined_with_all_attributes(tmp_path):
    paths = [las(tmp_path / "a.las", 20), las(tmp_path / "b.laz", 30, offset=(600001, 5000000, 0))]
    kept = np.arange(0, 50, 2)
    write_cloud(open_cloud(paths), kept, tmp_path / "out.laz")
    after = laspy.read(tmp_path / "out.laz")
    stamps = np.concatenate([laspy.read(path).gps_time for path in paths])
    np.testing.assert_array_equal(after.gps_time, stamps[kept])
    np.testing.assert_array_equal(after.header.scales, [0.001] * 3)
    np.testing.assert_allclose(all_xyz([tmp_path / "out.laz"]), all_xyz(paths)[kept], atol=1e-9)


def test_grids_that_do_not_coincide_are_joined_at_a_tenth_of_a_millimetre(tmp_path):
    offset = (600000.0004, 5000000, 0)
    paths = [las(tmp_path / "a.las", 20), las(tmp_path / "b.las", 30, offset=offset)]
    write_cloud(open_cloud(paths), np.arange(50), tmp_path / "out.las")
    np.testing.assert_array_equal(laspy.read(tmp_path / "out.las").header.scales, [0.0001] * 3)
    np.testing.assert_allclose(all_xyz([tmp_path / "out.las"]), all_xyz(paths), atol=1e-9)


def test_files_of_unlike_formats_keep_what_they_share_and_say_so(tmp_path):
    rows = [[600001.12345, 5000000.5, 3, 255, 0, 0]]
    paths = [las(tmp_path / "a.las", 20, 1), text(tmp_path / "b.xyz", rows, "x y z r g b\n")]
    said = []
    progress = Progress(report=lambda fraction, message: said.append(message))
    write_cloud(open_cloud(paths, CRS.from_epsg(25832)), np.arange(21), tmp_path / "o.laz", progress)
    after = laspy.read(tmp_path / "o.laz")
    assert after.header.point_format.id == 7
    assert after.red[-1] == 65535
    assert after.intensity[:20].all()
    np.testing.assert_allclose(all_xyz([tmp_path / "o.laz"]), all_xyz(paths), atol=0.5001e-4)
    assert any(message.startswith("Left out of o.laz: ") for message in said)


def test_text_becomes_las_with_the_reference_system(tmp_path):
    path = text(tmp_path / "b.xyz", [[600001.5, 5000000.5, 3.25], [600002.5, 5000001.5, 4.25]])
    write_cloud(open_cloud([path], CRS.from_epsg(25832)), np.array([1]), tmp_path / "out.las")
    after = laspy.read(tmp_path / "out.las")
    assert (str(after.header.version), after.header.point_format.id) == ("1.4", 6)
    np.testing.assert_allclose(after.xyz, [[600002.5, 5000001.5, 4.25]], atol=1e-9)
    assert open_cloud([tmp_path / "out.las"]).crs == CRS.from_epsg(25832)


def test_a_chosen_reference_system_is_written_into_an_old_las(tmp_path):
    path = tmp_path / "old.las"
    header = laspy.LasHeader(version="1.2", point_format=1)
    with laspy.open(path, "w", header=header) as writer:
        writer.write_points(laspy.ScaleAwarePointRecord.zeros(3, header=header))
    write_cloud(open_cloud([path], CRS.from_epsg(25832)), np.array([1]), tmp_path / "out.las")
    assert open_cloud([tmp_path / "out.las"]).crs == CRS.from_epsg(25832)
    assert laspy.read(tmp_path / "out.las").header.global_encoding.wkt


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("out.xyz", "x y z intensity red green blue\n600001.50000 5000000.50000 3.25000 900 255 0 1\n"),
        ("out.txt", "x y z intensity red green blue\n600001.50000 5000000.50000 3.25000 900 255 0 1\n"),
        ("out.CSV", "x,y,z,intensity,red,green,blue\n600001.50000,5000000.50000,3.25000,900,255,0,1\n"),
    ],
)
def test_text_output_has_a_header_and_can_be_read_again(tmp_path, name, content):
    path = text(tmp_path / "in.xyz", [[600001.5, 5000000.5, 3.25, 900, 255, 0, 1]])
    write_cloud(open_cloud([path]), np.array([0]), tmp_path / name)
    assert (tmp_path / name).read_text() == content
    before, after = (next(open_cloud([p]).chunks()) for p in (path, tmp_path / name))
    np.testing.assert_array_equal(before.xyz, after.xyz)
    np.testing.assert_array_equal(before.intensity, after.intensity)
    np.testing.assert_array_equal(before.rgb, after.rgb)


@settings(deadline=None, max_examples=30)
@given(kept=st.sets(st.integers(0, 49), min_size=1), size=st.integers(1, 60))
def test_exactly_the_kept_points_are_written_whatever_the_chunks(tmp_path_factory, kept, size):
    folder = tmp_path_factory.mktemp("writing")
    paths = [las(folder / "a.las", 20), las(folder / "b.las", 30)]
    kept = np.array(sorted(kept))
    pieces = WritingSettings(chunk_points=size)
    assert write_cloud(open_cloud(paths), kept, folder / "out.las", settings=pieces) == len(kept)
    np.testing.assert_array_equal(all_xyz([folder / "out.las"]), all_xyz(paths)[kept])


@pytest.mark.parametrize("name", ["out.e57", "out", "out.copc.laz", "out.pts"])
def test_an_extension_that_cannot_be_written_lists_those_that_can(tmp_path, name):
    cloud = open_cloud([las(tmp_path / "in.las")])
    with pytest.raises(InputError, match=r"choose LAZ, LAS or text \(XYZ, TXT, CSV\)"):
        write_cloud(cloud, np.array([0]), tmp_path / name)


def test_an_input_is_never_overwritten(tmp_path):
    path = las(tmp_path / "in.las")
    with pytest.raises(InputError, match=r"in\.las is an input as well"):
        write_cloud(open_cloud([path]), np.array([0]), path)


def test_nothing_to_write_is_said(tmp_path):
    with pytest.raises(NothingFoundError, match="No point is left"):
        write_cloud(open_cloud([las(tmp_path / "in.las")]), np.array([], int), tmp_path / "o.las")


def test_points_too_far_apart_for_las_are_refused(tmp_path):
    path = text(tmp_path / "in.xyz", [[1.5, 2.5, 3.5], [900000.5, 2.5, 3.5], [1.5, 2.5, 3.5]])
    with pytest.raises(InputError, match=r"out\.laz cannot hold points that lie so far apart"):
        write_cloud(open_cloud([path]), np.arange(3), tmp_path / "out.laz")


@pytest.mark.parametrize("name", ["out.las", "out.laz", "out.csv"])
def test_cancelling_leaves_no_output(tmp_path, name):
    cloud = open_cloud([las(tmp_path / "in.las")])
    with pytest.raises(CancelledError):
        write_cloud(cloud, np.array([0]), tmp_path / name, Progress(is_cancelled=lambda: True))
    assert [file.name for file in tmp_path.iterdir()] == ["in.las"]
