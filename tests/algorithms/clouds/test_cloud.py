"""Several files of any format are one site."""

import laspy
import numpy as np
import pytest
from ichnograph.algorithms.clouds.cloud import clouds_in, open_cloud, open_scans
from ichnograph.algorithms.clouds.formats import FORMATS
from ichnograph.algorithms.errors import CancelledError, InputError
from ichnograph.algorithms.progress import Progress
from ichnograph.tests.algorithms.clouds.sample_files import write_e57, write_ply, write_ptx
from laspy.vlrs.known import WktCoordinateSystemVlr
from rasterio.crs import CRS


def las(path, xyz, epsg=None):
    header = laspy.LasHeader(version="1.4", point_format=6)
    header.scales, header.offsets = np.full(3, 0.001), np.min(xyz, axis=0)
    if epsg:
        header.vlrs.append(WktCoordinateSystemVlr(CRS.from_epsg(epsg).to_wkt()))
    data = laspy.LasData(header)
    data.x, data.y, data.z = np.transpose(xyz)
    data.write(path)
    return path


def text(path, xyz):
    np.savetxt(path, xyz, fmt="%.3f")
    return path


FIRST = [[600050.25, 5000150.5, 12.0], [600051.0, 5000151.0, 13.0]]
SECOND = [[600250.25, 5000350.5, 12.0]]


def test_files_follow_each_other_around_one_local_origin(tmp_path):
    cloud = open_cloud([las(tmp_path / "a.las", FIRST), str(text(tmp_path / "b.xyz", SECOND))])
    np.testing.assert_array_equal(cloud.origin, [600000, 5000100, 0])
    chunks = list(cloud.chunks())
    xyz = np.concatenate([chunk.xyz for chunk in chunks])
    np.testing.assert_allclose(xyz + cloud.origin, FIRST + SECOND, rtol=0, atol=1e-9)
    assert chunks[0].xyz.dtype == np.float64


def test_a_cloud_can_be_iterated_again_in_chunks_of_any_size(tmp_path):
    cloud = open_cloud([las(tmp_path / "a.laz", FIRST), text(tmp_path / "b.xyz", SECOND)])
    once = np.concatenate([chunk.xyz for chunk in cloud.chunks()])
    again = [chunk.xyz for chunk in cloud.chunks(size=1)]
    assert len(again) == 3
    np.testing.assert_array_equal(once, np.concatenate(again))


def test_progress_runs_from_0_to_1_over_all_files(tmp_path):
    cloud = open_cloud([las(tmp_path / "a.laz", FIRST), text(tmp_path / "b.xyz", SECOND)])
    reported = []
    list(cloud.chunks(Progress(report=lambda fraction, message: reported.append(fraction)), size=1))
    assert reported == sorted(reported)
    assert reported[0] == 0.0
    assert reported[-1] == pytest.approx(1.0)


def test_cancelling_stops(tmp_path):
    cloud = open_cloud([text(tmp_path / "b.xyz", SECOND)])
    with pytest.raises(CancelledError):
        list(cloud.chunks(Progress(is_cancelled=lambda: True)))


@pytest.mark.parametrize("extension", [item.extension for item in FORMATS])
def test_extensions_are_known_in_any_case(tmp_path, extension):
    writers = {
        ".las": las,
        ".laz": las,
        ".copc.laz": las,
        ".ptx": write_ptx,
        ".ply": write_ply,
        ".e57": write_e57,
    }
    path = writers.get(extension, text)(tmp_path / f"scan{extension}", FIRST)
    shouting = path.rename(tmp_path / f"SCAN{extension.upper()}")
    assert sum(len(chunk.xyz) for chunk in open_cloud([shouting]).chunks()) == 2


def test_the_files_own_reference_system_wins(tmp_path):
    cloud = open_cloud([las(tmp_path / "a.las", FIRST, 25832)], CRS.from_epsg(25833))
    assert cloud.crs == CRS.from_epsg(25832)
    assert "the chosen EPSG:25833 is not used" in cloud.warnings[0]


def test_the_chosen_reference_system_fills_in(tmp_path):
    cloud = open_cloud([text(tmp_path / "b.xyz", SECOND)], CRS.from_epsg(25832))
    assert cloud.crs == CRS.from_epsg(25832)
    assert cloud.warnings == ()


def test_no_reference_system_is_a_warning(tmp_path):
    cloud = open_cloud([text(tmp_path / "b.xyz", SECOND)])
    assert cloud.crs is None
    assert "no coordinate reference system in b.xyz" in cloud.warnings[0]


def test_a_file_without_reference_system_takes_that_of_the_others(tmp_path):
    cloud = open_cloud([text(tmp_path / "b.xyz", SECOND), las(tmp_path / "a.las", FIRST, 25832)])
    assert cloud.crs == CRS.from_epsg(25832)
    assert "in b.xyz, so EPSG:25832 of the other files is used for them" in cloud.warnings[0]


def test_different_reference_systems_are_refused(tmp_path):
    paths = [las(tmp_path / "a.las", FIRST, 25832), las(tmp_path / "b.las", SECOND, 25833)]
    with pytest.raises(InputError, match=r"in EPSG:25832, but .*b\.las in EPSG:25833; reproject"):
        open_cloud(paths)


@pytest.mark.parametrize("epsg", [4326, 2992])
def test_degrees_and_feet_are_refused(tmp_path, epsg):
    path = las(tmp_path / "a.las", [[11.5, 48.1, 500.0]], epsg)
    for read in (open_cloud, open_scans):
        with pytest.raises(InputError, match=r"a\.las are in .*; reproject"):
            read([path])
    with pytest.raises(InputError, match="the chosen coordinate reference system are in"):
        open_cloud([text(tmp_path / "b.xyz", SECOND)], CRS.from_epsg(epsg))


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(InputError, match=r"nowhere\.laz does not exist"):
        open_cloud([tmp_path / "nowhere.laz"])


def test_a_folder_is_no_file(tmp_path):
    (tmp_path / "scan.las").mkdir()
    with pytest.raises(InputError, match=r"scan\.las does not exist or is not a file"):
        open_cloud([tmp_path / "scan.las"])


@pytest.mark.parametrize("name", ["a.las", "a.laz", "a.xyz", "a.pts"])
def test_an_empty_file_among_others_is_refused(tmp_path, name):
    (tmp_path / name).write_bytes(b"")
    with pytest.raises(InputError, match=f"{name} is empty; copy or export it again"):
        open_cloud([text(tmp_path / "b.xyz", SECOND), tmp_path / name])


@pytest.mark.parametrize("name", ["scan.doc", "scan", "scan.e57x"])
def test_an_unknown_extension_lists_the_known_ones(tmp_path, name):
    with pytest.raises(
        InputError, match=r"unknown extension; convert it to LAZ, LAS, COPC, E57, .* or text \(XYZ,"
    ):
        open_cloud([tmp_path / name])


def test_no_file_at_all_is_refused():
    with pytest.raises(InputError, match="choose at least one file"):
        open_cloud([])


def test_a_file_given_twice_is_refused(tmp_path):
    path = text(tmp_path / "b.xyz", SECOND)
    with pytest.raises(InputError, match=r"b\.xyz is listed twice"):
        open_cloud([path, str(path)])


def test_a_las_named_txt_and_a_text_named_las_are_refused(tmp_path):
    wrong_text = las(tmp_path / "a.las", FIRST).rename(tmp_path / "a.txt")
    wrong_las = text(tmp_path / "b.xyz", SECOND).rename(tmp_path / "b.las")
    with pytest.raises(InputError, match=r"a\.txt is not a text file"):
        open_cloud([wrong_text])
    with pytest.raises(InputError, match=r"b\.las is not a LAS or LAZ file"):
        open_cloud([wrong_las])


def names_in(folder, *names):
    for name in names:
        (folder / name).write_text("1 2 3\n")
    return [path.name for path in clouds_in(folder)]


def test_a_folder_holds_its_clouds_by_name_without_lists_of_points(tmp_path):
    assert names_in(tmp_path, "b.LAZ", "a.ply", "targets.txt", "control.csv", "readme.md") == [
        "a.ply",
        "b.LAZ",
    ]


def test_text_files_are_clouds_where_a_folder_holds_no_others(tmp_path):
    assert names_in(tmp_path, "b.txt", "a.csv", "readme.md") == ["a.csv", "b.txt"]


def test_a_folder_without_clouds_is_refused(tmp_path):
    with pytest.raises(InputError, match="holds no point cloud"):
        names_in(tmp_path, "readme.md")
    with pytest.raises(InputError, match="nowhere cannot be read"):
        clouds_in(tmp_path / "nowhere")


def test_a_cloud_with_northings_before_eastings_is_said_to_be_mirrored(tmp_path):
    (tmp_path / "a.xyz").write_text("5812345.5 412345.5 71.5\n" * 3)
    cloud = open_cloud([tmp_path / "a.xyz"], CRS.from_epsg(25833))
    assert "x and y of" in cloud.warnings[-1]
    assert "the plan would be mirrored" in cloud.warnings[-1]


def test_each_file_outside_the_area_of_the_reference_system_is_named_once(tmp_path):
    fits = text(tmp_path / "a.xyz", FIRST)
    local = [text(tmp_path / name, [[1.25, 2.5, 3.0]]) for name in ("b.xyz", "c.xyz")]
    cloud = open_cloud([fits, *local], CRS.from_epsg(25833))
    (said,) = [warning for warning in cloud.warnings if "outside the area" in warning]
    assert said.startswith("The points of b.xyz, c.xyz lie")


def test_scans_that_are_not_registered_may_have_different_systems_or_none(tmp_path):
    paths = [las(tmp_path / "a.las", FIRST, 25832), las(tmp_path / "b.las", SECOND, 25833)]
    scans = open_scans([*paths, text(tmp_path / "c.xyz", FIRST)])

    assert [source.path.name for source in scans.sources] == ["a.las", "b.las", "c.xyz"]
    assert scans.crs is None and not scans.origin.any() and scans.warnings == ()


def test_a_reference_system_in_a_remark_is_said_unless_it_is_the_chosen_one(tmp_path):
    path = tmp_path / "a.xyz"
    path.write_text("# EPSG:25833\n412345.678 5812345.123 71.251\n412346.114 5812347.871 72.333\n")
    said = f"A remark in {path} names EPSG:25833"
    for code, known in ((25833, True), (25832, False), (None, False)):
        warnings = open_cloud([path], CRS.from_epsg(code) if code else None).warnings
        assert any(warning.startswith(said) for warning in warnings) != known
