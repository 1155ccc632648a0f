"""`scripts/qgis_process`, as a user types it."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "scripts" / "qgis_process"

pytestmark = pytest.mark.skipif(
    not (shutil.which("qgis_process") and (ROOT / ".plugins" / "ichnograph").exists()),
    reason="needs qgis_process and `make setup`",
)


@pytest.fixture
def command(tmp_path):
    """Run the script in an empty folder."""

    def command(*arguments, **environment):
        return subprocess.run(
            [str(SCRIPT), *arguments],
            cwd=tmp_path,
            env={**os.environ, **environment},
            capture_output=True,
            text=True,
        )

    return command


def test_siteplan_needs_only_clouds_and_a_name(command, room, tmp_path):
    done = command("run", "ichnograph:siteplan", "--", f"INPUT={room}", "WALLS=walls.shp")

    assert done.returncode == 0
    assert "WALL_COUNT:\t1" in done.stdout
    expected = {f"walls.{ending}" for ending in ("shp", "shx", "dbf", "prj", "cpg", "qml")}
    assert {file.name for file in tmp_path.iterdir()} == expected


def test_repeated_inputs_are_one_site(command, room, tmp_path):
    shutil.copy(room, tmp_path / "b.laz")
    done = command(
        "run", "ichnograph:thincloud", "--", f"INPUT={room}", "INPUT=b.laz", "OUTPUT=thin.laz", "SPACING=0.5"
    )

    assert done.returncode == 0
    assert "Reading room.laz" in done.stdout
    assert "Reading b.laz" in done.stdout


def test_a_plan_is_compared_with_a_reference(command, room, tmp_path):
    assert command("run", "ichnograph:siteplan", "--", f"INPUT={room}", "WALLS=walls.gpkg").returncode == 0
    done = command(
        "run", "ichnograph:compareplan", "--", "WALLS=walls.gpkg", "REFERENCE=walls.gpkg", "ERRORS=e.shp"
    )

    assert done.returncode == 0
    assert "COMPLETENESS:\t1" in done.stdout
    assert (tmp_path / "e.qml").exists()


@pytest.mark.parametrize(
    ("locale", "label"), [("de_DE.UTF-8", "Punktabstand (m)"), ("fr_FR.UTF-8", "Espacement des points (m)")]
)
def test_the_language_is_that_of_the_system(command, locale, label):
    assert label in command("help", "ichnograph:thincloud", LC_ALL=locale).stdout


def test_an_error_is_a_sentence_and_exit_code_1(command, tmp_path):
    (tmp_path / "walls.shp").write_text("older")
    (tmp_path / "empty.laz").touch()
    done = command("run", "ichnograph:siteplan", "--", "INPUT=empty.laz", "WALLS=walls.shp")

    assert done.returncode == 1
    assert "empty.laz is empty; copy or export it again." in done.stderr
    assert "Traceback" not in done.stdout + done.stderr
    assert {file.name for file in tmp_path.iterdir()} == {"walls.shp", "empty.laz"}
    assert (tmp_path / "walls.shp").read_text() == "older"


def test_all_algorithms_are_listed_and_explained_without_the_packages(command, room, tmp_path):
    # Without numpy, QGIS's own Processing does not start.
    blocked = ["scipy", "skimage", "pandas", "numba", "shapely", "fiona", "rasterio", "laspy", "lazrs"]
    start_up = tmp_path / "start-up"
    start_up.mkdir()
    (start_up / "sitecustomize.py").write_text(f"import sys\nsys.modules.update(dict.fromkeys({blocked}))\n")
    path = str(start_up)

    listed = command("list", PYTHONPATH=path).stdout
    for name in ("thincloud", "densityimage", "extractwalls", "siteplan"):
        assert f"ichnograph:{name}\t" in listed
    explained = command("help", "ichnograph:thincloud", PYTHONPATH=path).stdout
    assert "SPACING: Point spacing (m)" in explained
    arguments = ("--", f"INPUT={room}", "OUTPUT=thin.laz")
    done = command("run", "ichnograph:thincloud", *arguments, PYTHONPATH=path)
    assert done.returncode == 1
    assert "lacks scipy, pandas, numba, rasterio, laspy, lazrs; run" in done.stderr
    assert "Traceback" not in done.stdout + done.stderr
