"""The desktop of QGIS under a virtual screen: the zip in an empty profile, dialogs, layers, messages.

It takes some minutes, so that `make desktop` runs it and the other tests do not.
"""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from ichnograph.tests.processing_provider.room import covered_points, write_las
from PIL import Image

ROOT = Path(__file__).parents[2]
LIMIT = 900
"""Seconds; it takes three minutes, longer on a computer that is busy, and for ever if a window waits."""

pytestmark = [
    pytest.mark.skipif(not os.environ.get("DESKTOP"), reason="the desktop is run by make desktop"),
    pytest.mark.skipif(not shutil.which("xvfb-run"), reason="there is no virtual screen (xvfb)"),
    pytest.mark.skipif(not shutil.which("qgis"), reason="QGIS's desktop is not installed"),
]


def keep_pictures(results, folder):
    """Keep photographs for the manual, in 256 colours, as screens need no more."""
    for name in ("siteplan", "walls_3d", "facade"):
        picture = Image.open(results / f"{name}.png").convert("RGB")
        picture.quantize(256).save(folder / f"desktop_{name}.png", optimize=True)


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
        "TOUR_FOLDER": str(folder / "results"),
    }
    screen = ["xvfb-run", "-a", "-s", "-screen 0 1600x1000x24"]
    desktop = ["qgis", "--nologo", "--noversioncheck", "--profiles-path", str(folder / "profile")]
    tour = [*screen, *desktop, "--code", str(Path(__file__).with_name("tour.py"))]
    try:
        ended = subprocess.run(tour, env=environment, timeout=LIMIT, capture_output=True, text=True)
    except subprocess.TimeoutExpired as expired:
        pytest.fail(f"The desktop did not end within {LIMIT} s: {expired.stdout} {expired.stderr}")
    assert (folder / "results" / "seen.json").exists(), ended.stdout + ended.stderr
    if os.environ.get("PICTURES"):
        keep_pictures(folder / "results", Path(os.environ["PICTURES"]))
    return json.loads((folder / "results" / "seen.json").read_text(encoding="utf-8"))


def run_of(seen, name):
    return next(run for run in seen["runs"] if run["name"] == name)


def layer_in(run, file):
    return next(layer for layer in run["layers"] if layer["source"].endswith(file))


def said(seen, kind, cancelled):
    """Return the texts of one kind that warn, during the cancelled run or all others.

    What QGIS says of its own view in three dimensions, and of the font that it fetches for its basemaps where
    there is a network, is not counted.
    """
    own = ("Qgs3D", "Open Sans font installation")
    texts = [(during, text) for during, text in seen[kind] if not any(word in text for word in own)]
    return [text for during, text in texts if (during == "cancelled") == cancelled]


def test_the_zip_is_installed_without_an_error(seen):
    assert seen["errors"] == []
    assert seen["installed"]


def test_nothing_warns_in_the_log_or_above_the_map(seen, capsys):
    messages, bars = (said(seen, kind, cancelled=False) for kind in ("messages", "bars"))
    with capsys.disabled():
        sys.stdout.write(
            f"\nMessages of severity warning or worse: {messages or 'none'}; bars: {bars or 'none'}.\n"
        )
    assert messages == bars == []


def test_a_cancelled_run_says_that_it_was_cancelled_and_no_more(seen):
    assert said(seen, "messages", cancelled=True) == ["Processing: Cancelled."]
    assert said(seen, "bars", cancelled=True) == []


def test_every_run_ends_well_but_the_one_that_is_cancelled(seen):
    assert [run["name"] for run in seen["runs"] if not run["succeeded"]] == ["cancelled"]
    assert len(seen["runs"]) == 11


def test_the_history_keeps_the_scans(seen):
    assert "closed.laz" in seen["history"]
    assert "closed.laz" in run_of(seen, "from_history")["log"]


def test_a_run_from_the_history_makes_no_output_that_was_switched_off(seen):
    for name in ("again_1", "from_history"):
        assert [layer["name"] for layer in run_of(seen, name)["layers"]] == ["Walls"]


def test_a_model_loads_its_layers_as_its_algorithms_do(seen):
    drawn = run_of(seen, "model")
    assert [layer["name"] for layer in drawn["layers"]] == ["Elevation", "Orthoimage"]
    assert {layer["system"] for layer in drawn["layers"]} == {None}
    assert drawn["layers"][0]["renderer"] == run_of(seen, "facade")["layers"][0]["renderer"]
    assert drawn["layouts"] == ["Elevation 1:50"]


def test_the_history_keeps_models(seen):
    assert "facade.laz" in seen["history_of_model"]
    assert "'facadedetails:Schedule':None" in seen["history_of_model"]


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
    first = run_of(seen, "siteplan")["layers"]
    assert [layer["name"] for layer in first] == ["Walls", "Rooms", "Density image"]
    assert all(layer["visible"] for layer in first)
    assert first[0]["renderer"] == "categorizedSymbol"
    assert "Length (m)" in first[0]["aliases"]


def test_the_canvas_opens_on_the_walls(seen):
    run = run_of(seen, "siteplan")
    (left, bottom), (right, top) = (corner.split(",") for corner in run["layers"][0]["extent"].split(" : "))
    seen_left, seen_bottom, seen_right, seen_top = run["canvas"]
    assert seen_left < float(left) and seen_bottom < float(bottom)
    assert seen_right > float(right) and seen_top > float(top)
    assert (seen_right - seen_left) * (seen_top - seen_bottom) < 4 * (
        (float(right) - float(left)) * (float(top) - float(bottom))
    )


def test_layers_have_the_system_of_the_control_points_or_that_of_their_clouds(seen):
    assert {layer["system"] for layer in run_of(seen, "siteplan")["layers"]} == {"EPSG:25833"}
    assert {layer["system"] for layer in run_of(seen, "again_0")["layers"]} == {None}


def test_reports_are_in_the_results_viewer_under_their_names(seen):
    results = run_of(seen, "siteplan")["results"]
    assert results == ["Report of the registration", "Transformations", "Report of the site plan"]


def test_a_sheet_adds_a_layout_to_the_project_and_nothing_else(seen):
    before, after = (run_of(seen, name) for name in ("siteplan", "planlayout"))
    assert (before["layouts"], after["layouts"]) == ([], ["Walls 1:100"])
    assert after["layers"] == before["layers"]


def test_the_walls_rise_in_a_view_in_three_dimensions(seen):
    assert seen["clay"] > 0.02, "share of the view that has the colour of lit walls"


def test_a_second_run_into_the_same_file_shows_the_new_walls(seen):
    before, after = (layer_in(run_of(seen, name), "walls.gpkg") for name in ("again_0", "again_1"))
    assert before["source"] == after["source"]
    assert before["extent"] != after["extent"]


def test_the_log_names_the_scans(seen):
    runs = [run for run in seen["runs"] if run["name"] in ("siteplan", "again_0", "again_1", "facade")]
    assert all(".laz" in run["log"] for run in runs)
