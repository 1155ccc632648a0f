"""Registered scans as clouds on the map, run as scripts run them."""

import json

import laspy
import numpy as np
import pytest
from ichnograph.tests.processing_provider.room import write_las
from rasterio.crs import CRS

QUARTER_TURN = [[0, -1, 0, 412345.678], [1, 0, 0, 5812345.789], [0, 0, 1, 71.234], [0, 0, 0, 1]]
POINTS = np.random.default_rng(3).uniform(-20, 20, (50, 3)).round(3)
MOVED = np.column_stack([-POINTS[:, 1], POINTS[:, 0], POINTS[:, 2]]) + [412345.678, 5812345.789, 71.234]


@pytest.fixture
def scans(tmp_path):
    """Write a LAZ and a text file, and transformations for them and a scan that failed."""
    folder = tmp_path / "scans"
    folder.mkdir()
    write_las(folder / "hall.laz", POINTS)
    np.savetxt(folder / "attic.xyz", POINTS, "%.3f")
    write_las(folder / "yard.laz", POINTS)
    document = {
        "crs": CRS.from_epsg(25833).to_wkt(),
        "scans": [
            {"name": "hall", "status": "registered", "matrix": QUARTER_TURN},
            {"name": "attic", "status": "registered", "matrix": QUARTER_TURN},
            {"name": "yard", "status": "too few", "reason": "Only two targets.", "matrix": None},
        ],
    }
    (folder / "transforms.json").write_text(json.dumps(document))
    return folder


@pytest.fixture
def transform(run, scans, tmp_path, feedback):
    def transform(*names, **parameters):
        files = {"INPUT": [str(scans / name) for name in names], "TRANSFORMS": str(scans / "transforms.json")}
        return run(
            "transformcloud", feedback, **{**files, "OUTPUT_FOLDER": str(tmp_path / "out"), **parameters}
        )

    return transform


@pytest.fixture
def refuse(transform):
    """Return the one sentence with which a run is refused."""
    from qgis.core import QgsProcessingException

    def refuse(*names, **parameters):
        with pytest.raises(QgsProcessingException) as caught:
            transform(*names, **parameters)
        sentence = str(caught.value).split("Unable to execute algorithm\n")[-1]
        assert sentence.endswith(".") and "\n" not in sentence
        return sentence

    return refuse


def test_each_cloud_is_written_where_its_scan_is_registered(transform, tmp_path, feedback):
    result = transform("hall.laz", "attic.xyz")

    assert result == {
        "OUTPUT_FOLDER": str(tmp_path / "out"),
        "CLOUDS": [str(tmp_path / "out" / name) for name in ("hall.laz", "attic.xyz")],
        "SCANS_TRANSFORMED": 2,
        "POINTS": 100,
    }
    assert {file.name for file in (tmp_path / "out").iterdir()} == {"hall.laz", "attic.xyz"}
    hall = laspy.read(tmp_path / "out" / "hall.laz")
    np.testing.assert_allclose(hall.xyz, MOVED, rtol=0, atol=6e-5)
    np.testing.assert_array_equal(hall.intensity, np.arange(50))
    assert CRS.from_wkt(hall.header.vlrs.get("WktCoordinateSystemVlr")[0].string).to_epsg() == 25833
    np.testing.assert_allclose(np.loadtxt(tmp_path / "out" / "attic.xyz"), MOVED, rtol=0, atol=6e-6)
    assert feedback.warnings == []
    assert "hall.laz: 50 points, moved as the scan hall." in feedback.infos


def test_a_temporary_folder_will_do(transform):
    result = transform("hall.laz", OUTPUT_FOLDER="TEMPORARY_OUTPUT")

    assert len(laspy.read(f"{result['OUTPUT_FOLDER']}/hall.laz")) == 50


def test_other_files_in_the_folder_are_kept(transform, tmp_path):
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "notes.txt").write_text("mine")
    transform("hall.laz")

    assert {file.name for file in (tmp_path / "out").iterdir()} == {"hall.laz", "notes.txt"}


def test_a_missing_reference_system_is_a_warning(transform, scans, feedback):
    document = {"scans": [{"name": "hall", "matrix": QUARTER_TURN}]}
    (scans / "by_hand.json").write_text(json.dumps(document))
    transform("hall.laz", TRANSFORMS=str(scans / "by_hand.json"))

    (warning,) = feedback.warnings
    assert warning.endswith("states no coordinate reference system, so the results have none either.")


def test_a_scan_that_is_not_registered_is_left_out_and_the_others_are_written(transform, tmp_path, feedback):
    result = transform("hall.laz", "yard.laz")

    assert result["SCANS_TRANSFORMED"] == 1
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["hall.laz"]
    assert any("its scan yard is not registered" in warning for warning in feedback.warnings)


def test_without_any_registered_scan_nothing_is_written(refuse, tmp_path):
    sentence = refuse("yard.laz")

    assert "its scan yard is not registered" in sentence and "(too few: Only two targets)" in sentence
    assert not (tmp_path / "out").exists()


def test_a_folder_stands_for_its_clouds_and_not_for_the_lists_beside_them(transform, scans, tmp_path):
    (scans / "yard.laz").unlink()
    np.savetxt(scans / "hall.txt", POINTS, "%.3f")
    transform(INPUT=str(scans))

    assert {path.name for path in (tmp_path / "out").iterdir()} == {"hall.laz", "attic.xyz"}


def test_nothing_is_written_if_one_cloud_turns_out_to_be_damaged(refuse, scans, tmp_path):
    (scans / "attic.xyz").write_text((scans / "attic.xyz").read_text() * 200 + "1 2 oops\n")

    assert "attic.xyz" in refuse("hall.laz", "attic.xyz")
    assert not (tmp_path / "out").exists()


def test_an_input_is_never_overwritten(refuse, scans):
    before = (scans / "hall.laz").read_bytes()

    assert refuse("hall.laz", OUTPUT_FOLDER=str(scans)).endswith(
        "is an input as well; choose another folder."
    )
    assert (scans / "hall.laz").read_bytes() == before


def test_two_clouds_of_one_name_are_refused(refuse, scans):
    (scans / "other").mkdir()
    write_las(scans / "other" / "hall.laz", POINTS)

    assert "would both become hall.laz" in refuse("hall.laz", "other/hall.laz")


@pytest.mark.parametrize(
    ("parameters", "part"),
    [
        ({"TRANSFORMS": ""}, "TRANSFORMS"),
        ({"TRANSFORMS": "missing.json"}, "missing.json cannot be read"),
        ({"OUTPUT_FOLDER": "/nowhere/at/all"}, "the folder /nowhere/at does not exist; create it first."),
    ],
)
def test_what_cannot_be_used_is_named(refuse, parameters, part):
    assert part in refuse("hall.laz", **parameters)


def test_a_file_is_no_folder(refuse, scans):
    assert "choose another folder." in refuse("hall.laz", OUTPUT_FOLDER=str(scans / "yard.laz"))


def test_cancelling_leaves_nothing(refuse, feedback, tmp_path):
    feedback.cancel()

    assert refuse("hall.laz") == "Cancelled."
    assert not (tmp_path / "out").exists()
