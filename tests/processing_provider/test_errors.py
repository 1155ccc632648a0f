"""Bad input: one sentence, nothing left behind, an existing output untouched."""

import numpy as np
import pytest
from ichnograph.tests.processing_provider.room import CORNER, write_las


@pytest.fixture
def refuse(run):
    """Return the one sentence with which a run is refused."""
    from qgis.core import QgsProcessingException

    def refuse(algorithm, **parameters):
        with pytest.raises(QgsProcessingException) as caught:
            run(algorithm, **parameters)
        sentence = str(caught.value).split("Unable to execute algorithm\n")[-1]
        assert sentence.endswith(".")
        assert "\n" not in sentence
        return sentence

    return refuse


@pytest.mark.parametrize(
    ("parameters", "sentence"),
    [
        ({"SPACING": 0}, "Point spacing (SPACING) must be a number, from 0.001 to 100 (m), not 0."),
        ({"SPACING": "wide"}, "Point spacing (SPACING) must be a number, from 0.001 to 100 (m), not wide."),
        (
            {"PIXEL_SIZE": float("nan")},
            "Pixel size (PIXEL_SIZE) must be a number, from 0.001 to 100 (m), not nan.",
        ),
        (
            {"MAX_FILL": 1.5},
            "Largest fill of connected or curved walls (MAX_FILL) must be a number, from 0 to 1 (ratio), "
            "not 1.5.",
        ),
        (
            {"NEIGHBOURHOOD": 6},
            "Neighbourhood (NEIGHBOURHOOD) must be a whole number, from 0 to 5 (pixels), not 6.",
        ),
        (
            {"NEIGHBOURHOOD": 0.5},
            "Neighbourhood (NEIGHBOURHOOD) must be a whole number, from 0 to 5 (pixels), not 0.5.",
        ),
        ({"ZMIN": "low"}, "Lowest height (ZMIN) must be a number, from -20000 to 20000 (m), not low."),
        (
            {"ZMIN": 3, "ZMAX": 2},
            "Lowest height (ZMIN) 3 m is not below Highest height (ZMAX) 2 m; correct one of them.",
        ),
        (
            {"CRS": "EPSG:999999"},
            "Coordinate reference system (CRS) EPSG:999999 is not known; write it like EPSG:25832.",
        ),
        ({"INPUT": " ; "}, "Point clouds (INPUT) is empty; choose at least one point cloud file."),
    ],
)
def test_a_value_that_makes_no_sense_is_refused_with_its_limits(refuse, room, tmp_path, parameters, sentence):
    good = {"INPUT": room, "WALLS": str(tmp_path / "walls.shp")}

    assert refuse("siteplan", **{**good, **parameters}) == sentence


def test_heights_that_hold_no_point_are_refused_with_those_of_the_cloud(refuse, room, tmp_path):
    sentence = refuse("siteplan", INPUT=room, ZMAX=60, WALLS=str(tmp_path / "walls.shp"))

    assert sentence.endswith("the heights reach from 70.00 to 72.48 m.")


def test_a_missing_cloud_is_named(refuse, tmp_path):
    missing = str(tmp_path / "missing.laz")

    assert missing in refuse("siteplan", INPUT=missing, WALLS=str(tmp_path / "walls.shp"))
    assert not list(tmp_path.iterdir())


def test_a_file_that_is_not_a_raster_is_named(refuse, room, tmp_path):
    outputs = {"PLAN": str(tmp_path / "plan.tif"), "WALLS": str(tmp_path / "walls.shp")}

    assert room in refuse("extractwalls", INPUT=room, **outputs)
    assert "missing.tif" in refuse("extractwalls", INPUT=str(tmp_path / "missing.tif"), **outputs)


@pytest.mark.parametrize(
    ("algorithm", "output", "name", "remedy"),
    [
        ("siteplan", "WALLS", "walls.geojson", "end the name in .gpkg or .shp."),
        ("siteplan", "DENSITY", "density.png", "end the name in .tif or .tiff."),
        ("siteplan", "PLAN", "nowhere/plan.tif", "create it first."),
        ("siteplan", "WALLS", "density.tif", "end the name in .gpkg or .shp."),
        ("siteplan", "PLAN", "density.tif", "choose another name."),
        ("thincloud", "OUTPUT", "thin.zip", "end the name in .laz or .las or .xyz or .txt or .csv."),
    ],
)
def test_an_output_that_cannot_be_written_is_refused(refuse, room, tmp_path, algorithm, output, name, remedy):
    outputs = {
        "siteplan": {"DENSITY": str(tmp_path / "density.tif"), "WALLS": str(tmp_path / "walls.shp")},
        "thincloud": {},
    }[algorithm]
    outputs[output] = str(tmp_path / name)
    sentence = refuse(algorithm, INPUT=room, **outputs)

    assert f"({output}) {tmp_path / name} " in sentence
    assert sentence.endswith(remedy)
    assert not list(tmp_path.iterdir())


def test_an_input_is_never_overwritten(refuse, tmp_path):
    cloud = tmp_path / "cloud.las"
    write_las(cloud, CORNER + np.random.default_rng(0).random((100, 3)))
    before = cloud.read_bytes()

    assert "an input as well" in refuse("thincloud", INPUT=str(cloud), OUTPUT=str(cloud))
    assert cloud.read_bytes() == before


def test_older_outputs_and_their_styles_are_kept_if_no_wall_is_found(run, refuse, room, tmp_path):
    outputs = {"DENSITY": "density.tif", "PLAN": "plan.tif", "WALLS": "walls.shp"}
    outputs = {name: str(tmp_path / file) for name, file in outputs.items()}
    run("siteplan", INPUT=room, **outputs)
    before = {file.name: file.read_bytes() for file in tmp_path.iterdir()}
    sentence = refuse("siteplan", INPUT=room, MIN_AREA=1000, **outputs)

    assert "MIN_AREA" in sentence
    assert {file.name: file.read_bytes() for file in tmp_path.iterdir()} == before


def test_no_output_is_written_if_one_of_them_fails(monkeypatch, refuse, room, tmp_path):
    import ichnograph.algorithms.site_plan.output.layers as layers
    from ichnograph.algorithms.errors import InputError

    def fail(path, *_, **__):
        raise InputError(f"{path} cannot be written because the disk is full.")

    monkeypatch.setattr(layers, "write_walls", fail)
    walls = tmp_path / "walls.shp"
    sentence = refuse("siteplan", INPUT=room, DENSITY=str(tmp_path / "density.tif"), WALLS=str(walls))

    assert sentence == f"{walls} cannot be written because the disk is full."
    assert not list(tmp_path.iterdir())


def test_a_cancelled_run_leaves_nothing_behind(refuse, feedback, room, tmp_path):
    feedback.progressChanged.connect(lambda percent: feedback.cancel() if percent > 30 else None)
    sentence = refuse("siteplan", feedback=feedback, INPUT=room, WALLS=str(tmp_path / "walls.shp"))

    assert sentence == "Cancelled."
    assert not list(tmp_path.iterdir())
