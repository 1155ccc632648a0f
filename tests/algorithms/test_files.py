"""An output is whole or not there at all."""

import errno
from pathlib import Path

import pytest
from ichnograph.algorithms import files
from ichnograph.algorithms.errors import CancelledError, InputError
from ichnograph.algorithms.files import atomic_output, new_folder


def test_what_is_written_arrives_under_its_name(tmp_path):
    with atomic_output(tmp_path / "plan.txt") as temporary:
        temporary.write_text("new")
        assert not (tmp_path / "plan.txt").exists()
    assert (tmp_path / "plan.txt").read_text() == "new"


def test_nothing_but_the_output_remains(tmp_path):
    with atomic_output(tmp_path / "plan.txt") as temporary:
        temporary.write_text("new")
    assert [file.name for file in tmp_path.iterdir()] == ["plan.txt"]


def test_a_shapefile_moves_with_its_sidecars(tmp_path):
    with atomic_output(tmp_path / "walls.shp") as temporary:
        for suffix in (".shp", ".shx", ".dbf", ".prj", ".cpg"):
            temporary.with_suffix(suffix).write_text(suffix)
    assert sorted(file.suffix for file in tmp_path.iterdir()) == [
        ".cpg",
        ".dbf",
        ".prj",
        ".shp",
        ".shx",
    ]


def test_stale_sidecars_of_the_old_output_go(tmp_path):
    for name in ("walls.prj", "walls.qix", "walls.shp.aux.xml", "other.prj"):
        (tmp_path / name).write_text("old")
    with atomic_output(tmp_path / "walls.shp") as temporary:
        temporary.write_text("new")
    assert sorted(file.name for file in tmp_path.iterdir()) == ["other.prj", "walls.shp"]


def test_a_raster_keeps_the_prj_of_a_namesake_shapefile(tmp_path):
    (tmp_path / "site.prj").write_text("of site.shp")
    with atomic_output(tmp_path / "site.tif") as temporary:
        temporary.write_text("new")
    assert (tmp_path / "site.prj").exists()


@pytest.mark.parametrize("failure", [CancelledError, ValueError, KeyboardInterrupt])
def test_a_failure_leaves_the_old_output_and_no_remains(tmp_path, failure):
    (tmp_path / "walls.shp").write_text("old")
    (tmp_path / "walls.prj").write_text("old")
    with pytest.raises(failure), atomic_output(tmp_path / "walls.shp") as temporary:
        temporary.write_text("half")
        raise failure
    assert {file.name: file.read_text() for file in tmp_path.iterdir()} == {
        "walls.shp": "old",
        "walls.prj": "old",
    }


def test_a_locked_output_keeps_its_sidecars_too(tmp_path, monkeypatch):
    replace = Path.replace

    def refuse(self, target):
        if tmp_path / "walls.shp" in (self, Path(target)):
            raise PermissionError(errno.EACCES, "in use")
        return replace(self, target)

    monkeypatch.setattr(Path, "replace", refuse)
    for suffix in (".shp", ".dbf", ".qix"):
        (tmp_path / "walls").with_suffix(suffix).write_text("old")
    locked = pytest.raises(InputError, match=r"walls\.shp cannot be written; close it")
    with locked, atomic_output(tmp_path / "walls.shp") as temporary:
        for suffix in (".shp", ".dbf", ".cpg"):
            temporary.with_suffix(suffix).write_text("new")
    assert {file.name: file.read_text() for file in tmp_path.iterdir()} == {
        "walls.shp": "old",
        "walls.dbf": "old",
        "walls.qix": "old",
    }


def test_a_missing_folder_is_named(tmp_path):
    missing = pytest.raises(InputError, match="folder does not exist; create it first")
    with missing, atomic_output(tmp_path / "nowhere" / "plan.tif"):
        pass


def test_a_file_is_not_a_folder(tmp_path):
    (tmp_path / "file").write_text("")
    missing = pytest.raises(InputError, match="folder does not exist")
    with missing, atomic_output(tmp_path / "file" / "plan.tif"):
        pass


def test_a_full_disk_is_said_in_one_sentence(tmp_path):
    full = pytest.raises(InputError, match="the disk is full; free some space")
    with full, atomic_output(tmp_path / "plan.tif"):
        raise OSError(errno.ENOSPC, "No space left on device")


def test_a_folder_in_the_place_of_the_output_is_an_input_error(tmp_path):
    (tmp_path / "plan.tif").mkdir()
    blocked = pytest.raises(InputError, match=r"plan\.tif cannot be written")
    with blocked, atomic_output(tmp_path / "plan.tif") as temporary:
        temporary.write_text("new")


def test_a_new_folder_is_removed_if_what_should_fill_it_fails(tmp_path):
    with pytest.raises(CancelledError), new_folder(tmp_path / "clouds"):
        raise CancelledError
    assert not (tmp_path / "clouds").exists()
    with new_folder(tmp_path / "clouds"):
        pass
    assert (tmp_path / "clouds").is_dir()


def test_a_folder_that_existed_is_kept(tmp_path):
    with pytest.raises(CancelledError), new_folder(tmp_path):
        raise CancelledError
    assert tmp_path.is_dir()


def test_a_folder_that_cannot_be_made_is_an_input_error(tmp_path):
    with pytest.raises(InputError, match="cannot be written"), new_folder(tmp_path / "a" / "b"):
        pass


def test_a_full_disk_is_said_also_where_a_library_does_not_say_why_it_cannot_write(tmp_path, monkeypatch):
    monkeypatch.setattr(files, "is_full", lambda folder: True)
    full = pytest.raises(InputError, match="the disk is full; free some space")
    with full, atomic_output(tmp_path / "cloud.laz"):
        raise OSError("IoError: Failed to call write")


def test_a_disk_is_full_if_less_is_left_than_outputs_take(tmp_path):
    assert not files.is_full(tmp_path)
    assert not files.is_full(tmp_path / "missing")
