"""The desktop of QGIS under a virtual screen: the zip in an empty profile, dialogs, layers, messages.

It takes about a minute, so that `make desktop` runs it and the other tests do not.
"""

import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest
from ichnograph.tests.processing_provider.room import CORNER, covered_points, write_las

ROOT = Path(__file__).parents[2]
LOW, HIGH = CORNER[:2] + 1, CORNER[:2] + (7, 5)

pytestmark = [
    pytest.mark.skipif(not os.environ.get("DESKTOP"), reason="the desktop is run by make desktop"),
    pytest.mark.skipif(not shutil.which("xvfb-run"), reason="there is no virtual screen (xvfb)"),
    pytest.mark.skipif(not shutil.which("qgis"), reason="QGIS's desktop is not installed"),
]


@pytest.fixture(scope="session")
def seen(tmp_path_factory):
    """Run the tour, and return what was seen."""
    folder = tmp_path_factory.mktemp("desktop")
    for name in ("profile", "results", "runtime"):
        (folder / name).mkdir(mode=0o700)
    clouds = [folder / "open.laz", folder / "closed.laz"]
    write_las(clouds[0], covered_points(1.0))
    write_las(clouds[1], covered_points()[::2])
    tree = subprocess.run(["git", "write-tree"], cwd=ROOT, capture_output=True, text=True, check=True)
    archive = ["git", "archive", "--prefix=ichnograph/", "--output", str(folder / "plugin.zip")]
    subprocess.run([*archive, tree.stdout.strip()], cwd=ROOT, check=True)
    environment = {name: value for name, value in os.environ.items() if name != "QT_QPA_PLATFORM"}
    environment |= {
        "PYTHONPATH": str(ROOT / ".packages"),
        "XDG_RUNTIME_DIR": str(folder / "runtime"),
        "TOUR_ZIP": str(folder / "plugin.zip"),
        "TOUR_CLOUDS": ";".join(map(str, clouds)),
        "TOUR_FACADE": str(ROOT / "processing_provider" / "example" / "facade.laz"),
        "TOUR_FOLDER": str(folder / "results"),
    }
    screen = ["xvfb-run", "-a", "-s", "-screen 0 1600x1000x24"]
    desktop = ["qgis", "--nologo", "--noversioncheck", "--profiles-path", str(folder / "profile")]
    tour = [*screen, *desktop, "--code", str(Path(__file__).with_name("tour.py"))]
    subprocess.run(tour, env=environment, timeout=600, capture_output=True)
    return json.loads((folder / "results" / "seen.json").read_text(encoding="utf-8"))


def layer_in(run, file):
    return next(layer for layer in run["layers"] if layer["source"].endswith(file))


def test_the_zip_is_installed_without_an_error(seen):
    assert seen["errors"] == []
    assert seen["installed"]


def test_nothing_warns_in_the_log_or_above_the_map(seen):
    assert seen["messages"] == ["Processing: Cancelled."]
    assert seen["bars"] == []


def run_of(seen, name):
    return next(run for run in seen["runs"] if run["name"] == name)


def test_every_run_ends_well_but_the_one_that_is_cancelled(seen):
    ends = {run["name"]: run["succeeded"] for run in seen["runs"]}
    assert ends == {
        "siteplan": True,
        "again_0": True,
        "again_1": True,
        "from_history": True,
        "cancelled": False,
        "facade": True,
    }


def test_the_history_keeps_the_scans(seen):
    assert "closed.laz" in seen["history"]
    assert "closed.laz" in run_of(seen, "from_history")["log"]


def test_a_cancelled_run_loads_nothing_and_leaves_nothing(seen):
    before, after = (len(run_of(seen, name)["layers"]) for name in ("from_history", "cancelled"))
    assert after == before
    assert not [name for name in seen["left"] if name.startswith(".")]


def test_a_batch_of_three_scans_is_three_runs(seen):
    assert seen["batch"] == ["thin_0.laz", "thin_1.laz", "thin_2.laz"]


def test_of_a_facade_the_elevation_lies_on_the_orthoimage(seen):
    facade = run_of(seen, "facade")
    assert [layer["name"] for layer in facade["layers"]] == ["Elevation", "Orthoimage"]
    assert {layer["system"] for layer in facade["layers"]} == {None}
    assert facade["results"][-1] == "Schedule"


def test_the_first_picture_has_the_walls_on_top_in_their_colours(seen):
    first = seen["runs"][0]["layers"]
    assert [layer["name"] for layer in first] == ["Walls", "Rooms", "Density image"]
    assert all(layer["visible"] for layer in first)
    assert first[0]["renderer"] == "categorizedSymbol"
    assert "Length (m)" in first[0]["aliases"]


def test_the_canvas_opens_on_the_walls(seen):
    left, bottom, right, top = seen["runs"][0]["canvas"]
    assert left < LOW[0] and bottom < LOW[1] and right > HIGH[0] and top > HIGH[1]
    assert right - left < 2 * (HIGH[0] - LOW[0])


def test_layers_of_clouds_without_a_system_have_none(seen):
    assert {layer["system"] for run in seen["runs"] for layer in run["layers"]} == {None}


def test_the_report_is_in_the_results_viewer_under_its_name(seen):
    assert seen["runs"][0]["results"] == ["Report of the site plan"]


def test_a_second_run_into_the_same_file_shows_the_new_walls(seen):
    before, after = (layer_in(run_of(seen, name), "walls.gpkg") for name in ("again_0", "again_1"))
    assert before["source"] == after["source"]
    assert before["extent"] != after["extent"]


def test_the_log_names_the_scans(seen):
    assert all(".laz" in run["log"] for run in seen["runs"])
