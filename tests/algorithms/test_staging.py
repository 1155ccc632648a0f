"""Outputs of one run are replaced together, even if the run is killed while it replaces them."""

import errno
import json
import os
import subprocess
import sys
import time
from pathlib import Path

import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.files import Outputs
from ichnograph.algorithms.staging import JOURNAL, LEADER, SUFFIX, Move, Stage, recover, replace_all

NAMES = ("walls.shp", "walls.shx", "walls.dbf", "walls.prj", "plan.tif", "report.html")
RUN = """
import os, sys
from pathlib import Path
from ichnograph.algorithms.files import Outputs

last, kinds = int(sys.argv[2]), ("os.rename", "os.remove", "os.rmdir", "os.mkdir")
seen = []
def killed(event, arguments):
    if event in kinds:
        seen.append(event)
        if len(seen) == last:
            os._exit(9)
sys.addaudithook(killed)
folders = [Path(sys.argv[1]), Path(sys.argv[1]) / "reports"]
with Outputs() as outputs:
    for folder, name in ((0, "walls.shp"), (0, "plan.tif"), (1, "report.html")):
        with outputs.staged(folders[folder] / name) as temporary:
            temporary.write_text("new")
            if name == "walls.shp":
                for suffix in (".shx", ".dbf", ".prj"):
                    temporary.with_suffix(suffix).write_text("new")
print(len(seen))
"""


def killed_run(folder, last):
    """Replace outputs in a process that dies at its operation number `last` on the file system."""
    done = subprocess.run(
        [sys.executable, "-c", RUN, str(folder), str(last)], capture_output=True, text=True, env=os.environ
    )
    assert done.returncode in (0, 9), done.stderr
    return done


def older_outputs(folder):
    (folder / "reports").mkdir(parents=True)
    for name in (*NAMES[:-1], "reports/report.html", "walls.qix"):
        (folder / name).write_text("old")


def contents(folder):
    return {str(path.relative_to(folder)): path.read_text() for path in folder.rglob("*") if path.is_file()}


def test_a_run_that_is_killed_at_any_operation_leaves_all_outputs_or_none(tmp_path):
    older_outputs(tmp_path / "whole")
    operations = int(killed_run(tmp_path / "whole", 0).stdout)
    new = contents(tmp_path / "whole")
    assert set(new.values()) == {"new"} and "walls.qix" not in new

    states = []
    for last in range(1, operations + 1):
        folder = tmp_path / str(last)
        older_outputs(folder)
        before = contents(folder)
        killed_run(folder, last)
        for each in (folder, folder / "reports"):
            for stage in each.glob(f".*{SUFFIX}"):
                # As if the next run came an hour later.
                os.utime(stage, (time.time() - 3600,) * 2)
            recover(each)
        states.append(contents(folder))
        assert states[-1] in (before, new), f"a mix after operation {last}"
        assert not list(folder.rglob(f".*{SUFFIX}")), f"litter after operation {last}"
    assert before in states and new in states


def test_the_next_run_rolls_back_before_it_writes(tmp_path):
    older_outputs(tmp_path)
    stage = Stage(tmp_path, "plan.tif")
    (stage.new / "plan.tif").write_text("half")
    (stage.path / JOURNAL).write_text(json.dumps([{"stage": ".", "name": "plan.tif", "staged": True}]))
    Move(stage.path, "plan.tif", True).apply()
    stage.close(keep=True)
    assert (tmp_path / "plan.tif").read_text() == "half"

    with Outputs() as outputs, outputs.staged(tmp_path / "other.txt") as temporary:
        assert (tmp_path / "plan.tif").read_text() == "old"
        temporary.write_text("new")
    assert not list(tmp_path.glob(f".*{SUFFIX}"))


def test_the_stage_of_a_living_run_is_left_alone(tmp_path):
    stage = Stage(tmp_path, "plan.tif")
    (stage.new / "plan.tif").write_text("new")
    recover(tmp_path)

    assert (stage.new / "plan.tif").exists()
    stage.close(keep=False)
    assert not stage.path.exists()


def test_the_stage_of_a_run_that_was_killed_before_its_lock_goes_when_it_is_old(tmp_path):
    stage = tmp_path / f".plan.tif.x{SUFFIX}"
    stage.mkdir()
    recover(tmp_path)
    assert stage.exists(), "its run may have just made it"
    os.utime(stage, (time.time() - 3600,) * 2)
    recover(tmp_path)
    assert not stage.exists()


def test_a_roll_back_may_be_interrupted_and_repeated(tmp_path):
    for done in range(3):
        folder = tmp_path / str(done)
        folder.mkdir()
        (folder / "plan.tif").write_text("old")
        stage = Stage(folder, "plan.tif")
        (stage.new / "plan.tif").write_text("new")
        move = Move(stage.path, "plan.tif", True)
        move.apply()
        if done == 1:
            move.final.replace(move.fresh)
        for _ in range(1 + done):
            move.undo()
        assert move.final.read_text() == "old" and move.fresh.read_text() == "new"
        stage.close(keep=False)


def test_all_outputs_stay_old_if_one_is_locked(tmp_path, monkeypatch):
    older_outputs(tmp_path)
    before = contents(tmp_path)
    replace = Path.replace

    def refuse(self, target):
        if Path(target) == tmp_path / "plan.tif" and self.parent.name == "new":
            raise PermissionError(13, "in use", str(self), None, str(target))
        return replace(self, target)

    monkeypatch.setattr(Path, "replace", refuse)
    locked = pytest.raises(InputError, match=r"plan\.tif cannot be written; close it")
    with locked, Outputs() as outputs:
        for name in ("walls.shp", "plan.tif", "reports/report.html"):
            with outputs.staged(tmp_path / name) as temporary:
                temporary.write_text("new")
    assert contents(tmp_path) == before


def test_a_journal_moves_nothing_but_files_beside_a_stage(tmp_path):
    (tmp_path / "inner").mkdir()
    (tmp_path / "victim").write_text("mine")
    stage = Stage(tmp_path / "inner", "plan.tif")
    stage.close(keep=True)
    for entry in ({"stage": "../..", "name": "victim"}, {"stage": ".", "name": "../victim"}):
        (stage.path / JOURNAL).write_text(json.dumps([{**entry, "staged": True}]))
        recover(tmp_path / "inner")
        assert (tmp_path / "victim").read_text() == "mine"


def test_files_are_replaced_and_the_journal_goes(tmp_path):
    (tmp_path / "plan.tif").write_text("old")
    stage = Stage(tmp_path, "plan.tif")
    (stage.new / "plan.tif").write_text("new")
    replace_all(stage.path, [Move(stage.path, "plan.tif", True)])

    assert (tmp_path / "plan.tif").read_text() == "new"
    assert not stage.pending
    stage.close(keep=False)


def test_a_disk_that_is_full_when_a_stage_is_made_keeps_no_litter(tmp_path, monkeypatch):
    def full(*_, **__):
        raise OSError(errno.ENOSPC, "No space left on device")

    first = Stage(tmp_path, "walls.shp")
    monkeypatch.setattr(Path, "write_text", full)
    with pytest.raises(OSError, match="No space left"):
        Stage(tmp_path, "plan.tif", first)
    first.close(keep=False)
    assert list(tmp_path.iterdir()) == []


def test_the_stage_of_a_run_that_was_killed_while_it_named_its_leader_goes(tmp_path):
    stage = Stage(tmp_path, "plan.tif")
    (stage.path / LEADER).write_text("")
    stage.close(keep=True)
    recover(tmp_path)
    assert list(tmp_path.iterdir()) == []
