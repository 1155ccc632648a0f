"""Targets found in scans, run as scripts run them."""

import shutil

import fiona
import numpy as np
import pytest
from ichnograph.tests.algorithms.targets.made_targets import one_target


@pytest.fixture(scope="module")
def truth():
    return one_target("black and white", 0.15, 4.0)


@pytest.fixture
def scan(truth, tmp_path):
    path = tmp_path / "hall.xyz"
    columns = np.column_stack([truth.xyz, truth.intensity])
    np.savetxt(path, columns, "%.5f %.5f %.5f %d", header="x y z intensity", comments="")
    return str(path)


@pytest.fixture
def find(run, scan, tmp_path, feedback):
    def find(**parameters):
        outputs = {
            "OUTPUT_FOLDER": str(tmp_path / "targets"),
            "TARGETS_LAYER": str(tmp_path / "targets.gpkg"),
            "REPORT": str(tmp_path / "report.html"),
        }
        return run("findtargets", feedback, **{"INPUT": [scan], **outputs, **parameters})

    return find


@pytest.fixture
def refuse(find):
    from qgis.core import QgsProcessingException

    def refuse(**parameters):
        with pytest.raises(QgsProcessingException) as caught:
            find(**parameters)
        return str(caught.value).split("Unable to execute algorithm\n")[-1]

    return refuse


def test_list_layer_and_report_are_written(find, truth, tmp_path):
    results = find()

    assert results["TARGET_COUNT"] == 1
    assert results["LISTS"] == [str(tmp_path / "targets" / "hall.txt")]
    place = np.loadtxt(results["LISTS"][0], skiprows=1)[:3]
    assert np.linalg.norm(place - truth.targets[0].centre) < 0.001
    with fiona.open(results["TARGETS_LAYER"]) as layer:
        assert [item["properties"]["kind"] for item in layer] == ["black and white"]
    assert "<img" in (tmp_path / "report.html").read_text(encoding="utf-8")


def test_what_is_missing_is_explained_and_nothing_is_written(refuse, tmp_path, feedback):
    sentence = refuse(SIZE=0.3)

    assert sentence == "No target was found; the log says which tests failed, and how near."
    assert any("width of the pattern" in warning for warning in feedback.warnings)
    assert any("up to" in warning for warning in feedback.warnings)
    assert not (tmp_path / "targets").exists()


def test_a_station_is_three_numbers(refuse):
    assert refuse(STATION="1, 2").endswith("(STATION) must be three numbers, x y z in metres, not 1, 2.")


def test_one_station_is_not_that_of_two_scans(refuse, scan, tmp_path):
    other = tmp_path / "attic.xyz"
    shutil.copy(scan, other)

    assert "there are several" in refuse(INPUT=[scan, str(other)], STATION="0 0 0")


def test_a_chosen_station_is_used(find):
    assert find(STATION="0, 0, 0")["TARGET_COUNT"] == 1
