"""`registerscans` with REFINE: clouds that tie scans by their surfaces."""

import json
import shutil
from pathlib import Path

import numpy as np
import pytest
from ichnograph.tests.scenes.scanned_rooms import FURNISHED, stood
from ichnograph.tests.scenes.surface_rooms import box, in_frame, seen, tilted


@pytest.fixture
def outputs(tmp_path):
    return {"TRANSFORMS": str(tmp_path / "transforms.json"), "REPORT": str(tmp_path / "report.html")}


@pytest.fixture
def refuse(run):
    from qgis.core import QgsProcessingException

    def refuse(**parameters):
        with pytest.raises(QgsProcessingException) as caught:
            run("registerscans", **parameters)
        return str(caught.value)

    return refuse


@pytest.fixture(scope="module")
def two_clouds(tmp_path_factory):
    """Write the control points of a room, and two scans of it with their lists of targets."""
    folder = tmp_path_factory.mktemp("room")
    random = np.random.default_rng(4)
    faces = box((0, 0, 0), (6, 5, 3)) + box((2, 0, 0), (3, 0.6, 2))
    places = random.uniform((0, 0, 0), (6, 5, 3), (6, 3))
    np.savetxt(folder / "control.txt", places, fmt="%.4f")
    for number, station in enumerate([(1.5, 2.0, 1.6), (4.5, 3.0, 1.6)]):
        matrix = np.eye(4)
        matrix[:3, :3], matrix[:3, 3] = tilted(50 + 80 * number, (0.5, -0.4)), station
        own = (places - station) @ matrix[:3, :3] + random.normal(0, 0.003, places.shape)
        np.savetxt(folder / f"s{number}.txt", own, fmt="%.4f")
        points = in_frame(seen(faces, station, step_deg=1.2, seed=number), station, matrix)
        np.savetxt(folder / f"s{number}.xyz", points, fmt="%.4f")
    lists = [str(folder / f"s{number}.txt") for number in range(2)]
    return {"CONTROL": str(folder / "control.txt"), "TARGETS": lists, "CRS": "EPSG:25833"}


@pytest.fixture
def clouds(two_clouds):
    """Return the clouds of both scans."""
    return [path.replace(".txt", ".xyz") for path in two_clouds["TARGETS"]]


def test_scans_are_tied_by_the_surfaces_of_their_clouds(run, two_clouds, clouds, outputs, feedback):
    run("registerscans", feedback, **two_clouds, REFINE=True, SCANS=clouds, **outputs)
    document = json.loads(Path(outputs["TRANSFORMS"]).read_text(encoding="utf-8"))

    (shared,) = document["surfaces"]
    assert shared["scans"] == ["s0", "s1"]
    assert shared["patches"] > 50
    assert 0 < shared["rms"] < 0.003
    for scan in document["scans"]:
        assert scan["surfaces"]["used"]
        assert 0 < scan["surfaces"]["sigmas"] < 2.5
    assert any("s0 and s1 share" in line for line in feedback.infos)
    assert any(line.startswith("s1: Surfaces moved its targets") for line in feedback.infos)
    assert "Surfaces that tie the scans" in Path(outputs["REPORT"]).read_text(encoding="utf-8")


def test_without_refine_the_clouds_change_nothing(run, two_clouds, clouds, outputs):
    written = []
    for more in ({}, {"SCANS": clouds}):
        run("registerscans", **two_clouds, **more, TRANSFORMS=outputs["TRANSFORMS"])
        written.append(Path(outputs["TRANSFORMS"]).read_bytes())

    assert written[0] == written[1]


def test_surfaces_need_clouds(refuse, two_clouds, outputs):
    assert "needs the clouds of the scans; choose them in" in refuse(**two_clouds, REFINE=True, **outputs)


def test_a_list_without_a_cloud_is_said(run, two_clouds, clouds, outputs, feedback, tmp_path):
    alone = shutil.copy(two_clouds["TARGETS"][1], tmp_path / "alone.txt")
    given = {**two_clouds, "TARGETS": [*two_clouds["TARGETS"], alone], "SCANS": clouds}
    run("registerscans", feedback, **given, REFINE=True, **outputs)

    assert any(line.startswith("alone is not tied by surfaces, because no") for line in feedback.warnings)
    assert not any(line.startswith("s1 is not tied") for line in feedback.warnings)


class TestPlaced:
    """Clouds without lists."""

    @pytest.fixture(scope="class")
    def furnished(self, tmp_path_factory):
        folder = tmp_path_factory.mktemp("furnished")
        paths = []
        for number, station in enumerate([(2.0, 2.0, 1.6), (6.0, 3.2, 1.6)]):
            paths.append(str(folder / f"s{number}.xyz"))
            np.savetxt(paths[-1], stood(FURNISHED, station, number, step_deg=1.2), fmt="%.4f")
        return paths

    def test_without_control_points_the_first_scan_is_the_frame(self, run, furnished, outputs, feedback):
        layers = {
            name: str(Path(outputs["REPORT"]).with_name(f"{name}.gpkg"))
            for name in ("RESIDUALS", "CONTROL_OUT")
        }
        result = run("registerscans", feedback, REFINE=True, SCANS=furnished, MODEL=2, **outputs, **layers)
        first, second = json.loads(Path(outputs["TRANSFORMS"]).read_text(encoding="utf-8"))["scans"]
        report = Path(outputs["REPORT"]).read_text(encoding="utf-8")

        assert result["SCANS_REGISTERED"] == 2
        assert first["matrix"] == np.eye(4).tolist()
        assert first["placement"] is None
        assert second["placement"]["scans"] == ["s0"]
        assert second["placement"]["next_share"] < 0.8
        assert any(line.startswith("s0: Its frame is that of all scans") for line in feedback.infos)
        assert any(line.startswith("s1: Placed by surfaces: ") for line in feedback.infos)
        assert "Placed by surfaces: " in report and "by their surfaces alone" in report
        assert not [line for line in feedback.infos if " nan" in line and not line.startswith("Results")]

    def test_control_points_are_needed_unless_surfaces_are_used(self, refuse, furnished, outputs):
        assert "(CONTROL) is empty" in refuse(TARGETS=furnished, **outputs)
        assert "(TARGETS) is empty" in refuse(REFINE=True, **outputs)

    def test_lists_need_control_points(self, refuse, two_clouds, clouds, outputs):
        said = refuse(TARGETS=two_clouds["TARGETS"], SCANS=clouds, REFINE=True, **outputs)

        assert "(CONTROL) is empty, but Targets (TARGETS) has lists" in said


def test_one_cloud_ties_nothing(refuse, two_clouds, clouds, outputs):
    said = refuse(**two_clouds, REFINE=True, SCANS=clouds[:1], **outputs)

    assert "needs the clouds of at least two scans" in said


def test_two_clouds_of_one_list_are_refused_by_their_names(refuse, two_clouds, clouds, outputs, tmp_path):
    second = shutil.copy(clouds[0], tmp_path / "s0.xyz")
    said = refuse(**two_clouds, REFINE=True, SCANS=[*clouds, str(second)], **outputs)

    assert f"{clouds[0]} and {second} are both named after the list s0" in said


def test_a_cloud_given_in_two_ways_counts_once(run, two_clouds, clouds, outputs, feedback):
    again = Path(clouds[0]).parent / ".." / Path(clouds[0]).parent.name / Path(clouds[0]).name
    run("registerscans", feedback, **two_clouds, REFINE=True, SCANS=[*clouds, str(again)], **outputs)

    assert sum("plane cells" in line for line in feedback.infos) == 2


@pytest.mark.parametrize("chosen", [{"MODEL": 4}, {"MODEL": 1, "MATCHING": 1}])
def test_surfaces_need_scans_in_metres(refuse, two_clouds, clouds, outputs, chosen):
    said = refuse(**two_clouds, REFINE=True, SCANS=clouds, **chosen, **outputs)

    assert "needs scans in metres" in said


def test_control_points_without_any_targets_are_refused(refuse, two_clouds, clouds, outputs):
    said = refuse(
        CONTROL=two_clouds["CONTROL"], CRS=two_clouds.get("CRS"), REFINE=True, SCANS=clouds, **outputs
    )
    assert "No scan has targets" in said and "choose Targets" in said


def test_two_clouds_of_one_name_without_lists_are_refused(refuse, clouds, outputs, tmp_path):
    again = tmp_path / Path(clouds[0]).name
    shutil.copy(clouds[0], again)
    said = refuse(REFINE=True, SCANS=[*clouds, str(again)], **outputs)
    assert f"{clouds[0]} and {again} have the same name" in said
