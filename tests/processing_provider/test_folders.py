"""Folders of files: what an earlier run left in them is said."""


def test_folders_of_an_earlier_run_are_named(plugin, tmp_path):
    from ichnograph.processing_provider.parameters.facade_files import FOLDER

    for name in ("facade_01", "facade_02", "facade_05", "photographs"):
        (tmp_path / name).mkdir()
    writers = dict.fromkeys(("schedule.csv", "facade_01/elevation.gpkg", "facade_02/elevation.gpkg"), None)

    (sentence,) = FOLDER.warnings(tmp_path, writers)
    assert "still holds facade_05 of an earlier run" in sentence
    assert FOLDER.warnings(tmp_path, {**writers, "facade_05/elevation.gpkg": None}) == []
