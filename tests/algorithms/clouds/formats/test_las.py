"""LAS, LAZ and COPC stream the stored coordinates, and damage is always noticed."""

import pickle
import struct
from pathlib import Path

import laspy
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.clouds.formats.las import LasSource
from ichnograph.algorithms.errors import CancelledError, InputError
from ichnograph.algorithms.progress import Progress
from ichnograph.tests.algorithms.clouds.sample_files import las_records, write_copc, write_las
from laspy.vlrs.known import WktCoordinateSystemVlr
from laspy.vlrs.vlrlist import VLRList
from rasterio.crs import CRS

DATA = Path(__file__).parents[5] / "shared" / "data"


def records(count, point_format=3, seed=0):
    """Return a header and points with everything at random that matters here."""
    rng = np.random.default_rng(seed)
    header = laspy.LasHeader(point_format=point_format)
    header.scales, header.offsets = np.full(3, 0.001), np.array([600000.0, 5000000.0, 0.0])
    points = laspy.ScaleAwarePointRecord.zeros(count, header=header)
    for name in "XYZ":
        points[name] = rng.integers(-100_000, 100_000, count)
    points["intensity"] = rng.integers(1, 65535, count)
    if "red" in header.point_format.dimension_names:
        for name in ("red", "green", "blue"):
            points[name] = rng.integers(1, 65535, count)
    return header, points


def write(path, header, points):
    with laspy.open(path, "w", header=header) as writer:
        writer.write_points(points)
    return path


def read(source, size=1000, origin=(600000.0, 5000000.0, 0.0)):
    chunks = list(source.chunks(np.array(origin), Progress(), size))
    return np.concatenate([chunk.xyz for chunk in chunks]), chunks


@pytest.mark.parametrize("name", ["scan.las", "scan.laz", "scan.LAZ"])
@pytest.mark.parametrize("point_format", [0, 2, 3, 6, 7, 8])
def test_coordinates_intensity_and_colour_are_those_stored(tmp_path, name, point_format):
    header, points = records(2500, point_format)
    source = LasSource.open(write(tmp_path / name, header, points))
    xyz, chunks = read(source)
    assert [len(chunk.xyz) for chunk in chunks] == [1000, 1000, 500]
    for axis, name_ in enumerate("XYZ"):
        np.testing.assert_array_equal(xyz[:, axis], points[name_] * 0.001)
    np.testing.assert_array_equal(np.concatenate([chunk.intensity for chunk in chunks]), points["intensity"])
    assert source.has_rgb == (point_format in (2, 3, 7, 8))
    for chunk, start in zip(chunks, (0, 1000, 2000)):
        if source.has_rgb:
            np.testing.assert_array_equal(chunk.rgb[:, 1], points["green"][start : start + 1000])
        else:
            assert chunk.rgb is None


def test_copc_is_streamed(tmp_path):
    header, points = records(70_000, 7)
    path = write_copc(tmp_path / "scan.copc.laz", header, points, nodes=5)
    with laspy.CopcReader.open(path) as reader:
        assert len(reader.query()) == 70_000
    source = LasSource.open(path)
    xyz, chunks = read(source, size=30_000)
    assert [len(chunk.xyz) for chunk in chunks] == [30_000, 30_000, 10_000]
    np.testing.assert_array_equal(xyz[:, 0], points["X"] * 0.001)
    assert source.has_rgb


def test_a_file_can_be_streamed_twice_and_sent_to_another_process(tmp_path):
    source = LasSource.open(write(tmp_path / "scan.laz", *records(100)))
    again = pickle.loads(pickle.dumps(source))
    np.testing.assert_array_equal(read(source)[0], read(source)[0])
    np.testing.assert_array_equal(read(source)[0], read(again)[0])


@settings(deadline=None, max_examples=30)
@given(cut=st.integers(1, 99), size=st.integers(1, 100))
def test_the_cut_into_files_and_chunks_does_not_change_a_bit(tmp_path_factory, cut, size):
    folder = tmp_path_factory.mktemp("las")
    header, points = records(100)
    whole = read(LasSource.open(write(folder / "whole.las", header, points)))[0]
    first = LasSource.open(write(folder / "first.las", header, points[:cut]))
    second = LasSource.open(write(folder / "second.las", header, points[cut:]))
    parts = np.concatenate([read(first, size)[0], read(second, size)[0]])
    np.testing.assert_array_equal(parts, whole)


@pytest.mark.parametrize("point_format", [0, 3, 6, 7])
@pytest.mark.parametrize("name", ["a.las", "a.laz"])
@pytest.mark.parametrize("size", [1, 70, 1000])
def test_positions_alone_are_the_same_as_with_all_fields(tmp_path, name, point_format, size):
    header, points = records(300, point_format)
    write(tmp_path / name, header, points)
    source, origin = LasSource.open(tmp_path / name), np.array([600_000.0, 5_000_000.0, 0.0])
    positions = np.concatenate(list(source.positions(origin, Progress(), size)))
    np.testing.assert_array_equal(positions, read(source)[0])
    assert source.expected_points == 300


def test_empty_intensity_and_colour_count_as_absent(tmp_path):
    header, points = records(100)
    for name in ("intensity", "red", "green", "blue"):
        points[name] = np.zeros(100, np.uint16)
    source = LasSource.open(write(tmp_path / "scan.las", header, points))
    assert not source.has_intensity
    assert not source.has_rgb
    chunk = read(source)[1][0]
    assert chunk.intensity is None
    assert chunk.rgb is None


def test_8_bit_colour_is_brought_to_16_bits(tmp_path):
    header, points = records(3)
    for name in ("red", "green", "blue"):
        points[name] = np.array([0, 1, 255])
    source = LasSource.open(write(tmp_path / "scan.las", header, points))
    np.testing.assert_array_equal(read(source)[1][0].rgb[:, 0], [0, 257, 65535])


def test_colour_is_judged_by_the_whole_file(tmp_path):
    header, points = records(20_000)
    points["red"][:5000] = points["green"][:5000] = points["blue"][:5000] = 0
    source = LasSource.open(write(tmp_path / "scan.laz", header, points))
    assert source.has_rgb
    assert source.colour_factor == 1


def test_the_middle_comes_from_the_points_and_not_from_the_header(tmp_path):
    path = write(tmp_path / "scan.las", *records(1000))
    data = bytearray(path.read_bytes())
    data[179:227] = struct.pack("<6d", *[1e9] * 6)
    path.write_bytes(data)
    np.testing.assert_allclose(LasSource.open(path).middle, [600000, 5000000, 0], atol=20)


def test_the_reference_system_is_read_from_wkt(tmp_path):
    header, points = records(3, 6)
    header.vlrs.append(WktCoordinateSystemVlr(CRS.from_epsg(25832).to_wkt()))
    assert LasSource.open(write(tmp_path / "a.las", header, points)).crs == CRS.from_epsg(25832)


def test_whole_metres_of_a_reference_system_are_not_doubted(tmp_path):
    header, points = records(20)
    for name in "XYZ":
        points[name] *= 1000
    assert "are whole numbers" in LasSource.open(write(tmp_path / "a.las", header, points)).warnings[0]
    header.vlrs.append(WktCoordinateSystemVlr(CRS.from_epsg(25832).to_wkt()))
    warnings = LasSource.open(write(tmp_path / "a.las", header, points)).warnings
    assert not [sentence for sentence in warnings if "whole numbers" in sentence]


def test_the_reference_system_is_read_from_wkt_behind_the_points(tmp_path):
    header, points = records(3, 6)
    with laspy.open(tmp_path / "a.laz", "w", header=header) as writer:
        writer.write_points(points)
        writer.write_evlrs(VLRList([WktCoordinateSystemVlr(CRS.from_epsg(25832).to_wkt())]))
    assert LasSource.open(tmp_path / "a.laz").crs == CRS.from_epsg(25832)


def test_the_reference_system_is_read_from_geotiff_keys(tmp_path):
    header, points = records(3)
    keys = struct.pack("<12H", 1, 1, 0, 2, 1024, 0, 1, 1, 3072, 0, 1, 32633)
    header.vlrs.append(laspy.VLR("LASF_Projection", 34735, "", keys))
    assert LasSource.open(write(tmp_path / "a.las", header, points)).crs == CRS.from_epsg(32633)


def test_a_broken_reference_system_is_a_warning(tmp_path):
    header, points = records(3, 6)
    header.vlrs.append(WktCoordinateSystemVlr("PROJCS[oops"))
    source = LasSource.open(write(tmp_path / "a.las", header, points))
    assert source.crs is None
    assert "a.las cannot be understood" in source.warnings[0]


def test_a_file_that_shrinks_after_it_was_opened_is_an_input_error(tmp_path):
    path = write(tmp_path / "scan.laz", *records(60_000))
    source = LasSource.open(path)
    path.write_bytes(path.read_bytes()[:-1000])
    with pytest.raises(InputError, match="truncated or damaged"):
        read(source)
    path.unlink()
    with pytest.raises(InputError, match="cannot be read"):
        read(source)


@pytest.mark.parametrize("scale", [0.0, np.nan, np.inf, 1e300])
def test_a_scale_that_makes_no_coordinates_is_refused(tmp_path, scale):
    path = write(tmp_path / "scan.las", *records(3))
    data = bytearray(path.read_bytes())
    data[131:139] = struct.pack("<d", scale)
    path.write_bytes(data)
    with pytest.raises(InputError, match="coordinates that are not numbers"):
        LasSource.open(path)


def test_cancelling_stops_between_chunks(tmp_path):
    source = LasSource.open(write(tmp_path / "scan.laz", *records(100)))
    seen = []
    progress = Progress(is_cancelled=lambda: len(seen) >= 2)
    with pytest.raises(CancelledError):
        seen.extend(source.chunks(np.zeros(3), progress, 10))


@pytest.mark.skipif(not DATA.exists(), reason="the shared test data are not here")
@pytest.mark.parametrize(
    ("name", "count"),
    [
        ("plan_slices_mit/planimetria.las", 17913),
        ("plan_slices_mit/stairs_merged.laz", 357003),
        ("indoor_two_storey_loadersgl/indoor.laz", 808042),
        ("vegetation_tls_plots/pine_plot.laz", 114024),
        ("vegetation_tls_plots/TLS_Clip.laz", 400754),
    ],
)
def test_files_of_other_programs(name, count):
    source = LasSource.open(DATA / name)
    assert sum(len(chunk.xyz) for chunk in source.chunks(source.middle, Progress(), 300_000)) == count


@pytest.mark.parametrize(
    ("point_format", "fields"),
    [
        (3, {"raw_classification": [2, 7, 2 | 128, 18, 0]}),
        (6, {"classification": [2, 7, 2, 18, 0], "classification_flags": [0, 0, 4, 0, 0]}),
    ],
)
def test_points_that_are_withheld_or_noise_are_left_out_and_said(tmp_path, point_format, fields):
    header, points = las_records(5, point_format)
    for name, values in fields.items():
        points.array[name] = values
    path = write_las(tmp_path / "scan.las", header, points)
    source, said = LasSource.open(path), []
    progress = Progress(lambda fraction, message: said.append(message))
    (chunk,) = source.chunks(np.zeros(3), progress, 100)

    # The newer formats alone have a class for high noise.
    kept = [0, 3, 4] if point_format == 3 else [0, 4]
    np.testing.assert_allclose(chunk.xyz[:, 0], points["X"][kept] * 0.001)
    assert f"scan.las: {5 - len(kept)} withheld points and points of noise were left out." in said
    assert f"{1 - len(kept) / 5:.1%} of the points of" in source.warnings[0]
    (everything,) = source.records(Progress(), 100, with_unusable=True)
    assert len(everything) == 5


def test_a_file_of_noise_alone_holds_no_points(tmp_path):
    header, points = las_records(5)
    points.array["raw_classification"] = 7
    with pytest.raises(InputError, match="holds no points"):
        LasSource.open(write_las(tmp_path / "scan.las", header, points))


def test_a_negative_scale_mirrors_and_is_refused(tmp_path):
    header, points = las_records(5)
    header.scales = np.array([-0.001, 0.001, 0.001])
    with pytest.raises(InputError, match="is mirrored by a negative scale"):
        LasSource.open(write_las(tmp_path / "scan.las", header, points))


def test_points_that_are_left_out_do_not_decide_the_range_of_the_colours(tmp_path):
    header, points = records(300)
    for name in ("red", "green", "blue"):
        points[name] = points[name] % 256
    points["red"][:5] = 60_000
    points["withheld"] = np.arange(300) < 5
    (chunk,) = LasSource.open(write(tmp_path / "scan.las", header, points)).chunks(
        np.zeros(3), Progress(), 1000
    )
    np.testing.assert_array_equal(chunk.rgb[:, 0], points["red"][5:] * 257)


@pytest.mark.parametrize(("scale", "said"), [(0.001, False), (0.01, True), (0.5, True)])
def test_a_coarse_scale_is_said_with_its_step(tmp_path, scale, said):
    header, points = records(300)
    header.scales = np.full(3, scale)
    warnings = LasSource.open(write(tmp_path / "scan.las", header, points)).warnings
    assert any(f"in steps of {scale} m" in sentence for sentence in warnings) == said


@pytest.mark.parametrize("name", ["scan.las", "scan.laz"])
def test_runs_of_a_file_are_read_each_on_its_own(tmp_path, name):
    source = LasSource.open(write(tmp_path / name, *records(2500)))
    runs = source.runs(1100)
    assert [run.expected_points for run in runs] == [1100, 1100, 300]
    np.testing.assert_array_equal(np.concatenate([read(run)[0] for run in runs]), read(source)[0])
    np.testing.assert_array_equal(read(runs[2].runs(200)[1])[0], read(source)[0][2400:])
