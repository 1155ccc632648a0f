"""The example that the plugin ships."""

from pathlib import Path

import pytest


@pytest.fixture(scope="module")
def folder(run, tmp_path_factory):
    folder = tmp_path_factory.mktemp("example") / "house"
    result = run("exampledata", OUTPUT_FOLDER=str(folder))
    assert sorted(result["FILES"]) == sorted(str(file) for file in folder.iterdir())
    return folder


def test_every_scan_has_the_list_of_its_targets(folder):
    scans = {file.stem for file in folder.glob("house_*.laz")}
    assert scans == {file.stem for file in folder.glob("house_*.txt")}
    assert len(scans) == 8


def test_the_example_is_small(folder):
    assert sum(file.stat().st_size for file in folder.iterdir()) < 4e6


def test_all_scans_of_the_example_are_registered(run, folder, tmp_path):
    result = run(
        "registerscans",
        CONTROL=str(folder / "control.txt"),
        TARGETS=[str(file) for file in folder.glob("house_*.txt")],
        TRANSFORMS=str(tmp_path / "transforms.json"),
    )
    assert result["SCANS_REGISTERED"] == 8
    assert result["MAX_RESIDUAL"] < 0.01


def test_copies_never_replace_what_is_being_copied(run):
    from ichnograph.processing_provider.algorithms.example_data import EXAMPLE

    before = {file.name: file.stat().st_size for file in Path(EXAMPLE).iterdir()}
    run("exampledata", OUTPUT_FOLDER=str(EXAMPLE))
    assert {file.name: file.stat().st_size for file in Path(EXAMPLE).iterdir()} == before
