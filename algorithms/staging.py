"""Folders in which the outputs of a run wait until all are complete, and what a killed run left in them.

A stage is a hidden folder beside its output. A lock on a file in it says that its run is alive; the system
releases the lock when the run ends, however it ends. While outputs are replaced, a journal lists what moves,
and old files are kept. Without a journal, all outputs of a run are new, or none. With one, it is rolled back.
"""

import json
import os
import shutil
import tempfile
import time
from collections.abc import Iterable
from contextlib import ExitStack, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any, Optional

try:
    import fcntl
except ImportError:  # Windows
    import msvcrt

    fcntl = None  # type: ignore[assignment]

SUFFIX = ".ichnograph"
JOURNAL = "journal.json"
LEADER = "leader.json"
LOCK = "lock"
YOUNG_S = 60.0
"""A stage without a lock may be that of a run that has just made it, for less than this time."""


@dataclass(frozen=True)
class Move:
    """A file beside a stage that is replaced, or removed if nothing new is staged under its name."""

    stage: Path
    name: str
    staged: bool

    @property
    def final(self) -> Path:
        """The file beside the stage."""
        return self.stage.parent / self.name

    @property
    def fresh(self) -> Path:
        """The new file, in the stage."""
        return self.stage / "new" / self.name

    @property
    def retired(self) -> Path:
        """The old file, in the stage."""
        return self.stage / "old" / self.name

    def apply(self) -> None:
        """Retire the old file, and move the new one to its name."""
        if self.final.is_dir():
            raise IsADirectoryError(f"{self.final} is a folder")
        if self.final.exists():
            self.final.replace(self.retired)
        if self.staged:
            self.fresh.replace(self.final)

    def undo(self) -> None:
        """Bring the old file back; may be repeated after any interruption."""
        if self.staged and not self.fresh.exists() and self.final.exists():
            self.final.replace(self.fresh)
        if self.retired.exists():
            self.retired.replace(self.final)


class Stage:
    """The stage of one output.

    Parameters
    ----------
    folder : Path
        In which the output will be.
    name : str
        Of the output.
    leader : Stage, optional
        The first stage of the run, which keeps the journal.

    Raises
    ------
    OSError
        If the folder is not writable.
    """

    def __init__(self, folder: Path, name: str, leader: Optional["Stage"] = None) -> None:
        self.path = Path(tempfile.mkdtemp(prefix=f".{name[:16]}.", suffix=SUFFIX, dir=folder))
        self._lock: Optional[IO[Any]] = None
        try:
            self._lock = _locked(self.path / LOCK)
            for part in ("new", "old"):
                (self.path / part).mkdir()
            if leader is not None:
                named = json.dumps(_relative(leader.path, self.path))
                (self.path / LEADER).write_text(named, encoding="utf-8")
        except BaseException:
            # A full disk has room for the folder only.
            self.close(keep=False)
            raise

    @property
    def new(self) -> Path:
        """The folder of the new files."""
        return self.path / "new"

    @property
    def pending(self) -> bool:
        """Whether its journal shows that outputs are half replaced."""
        return (self.path / JOURNAL).exists()

    def close(self, keep: bool) -> None:
        """Release the stage, and remove it unless a later run shall roll it back."""
        if self._lock is not None:
            self._lock.close()
        if not keep:
            shutil.rmtree(self.path, ignore_errors=True)


def replace_all(leader: Path, moves: Iterable[Move]) -> None:
    """Replace files by those in the stages, or leave all as they are if one cannot be replaced.

    Parameters
    ----------
    leader : Path
        The stage that keeps the journal.
    moves : iterable of Move

    Raises
    ------
    OSError
        If a file cannot be replaced; its `filename` is that of the file.
    """
    moves = list(moves)
    journal = leader / JOURNAL
    entries = [
        {"stage": _relative(move.stage, leader), "name": move.name, "staged": move.staged} for move in moves
    ]
    draft = journal.with_suffix(".draft")
    with draft.open("w", encoding="utf-8") as file:
        json.dump(entries, file)
        file.flush()
        os.fsync(file.fileno())
    draft.replace(journal)
    try:
        for move in moves:
            move.apply()
        # From here on the new outputs are valid; the old ones go with the stages.
        journal.unlink()
    except BaseException:
        # If the journal is gone, all outputs are new.
        if journal.exists():
            _roll_back(leader, moves)
        raise


def recover(folder: Path) -> None:
    """Roll back what killed runs left half replaced in a folder, and remove their stages.

    Stages whose run is alive are left alone, and so is what cannot be read or removed.
    """
    with suppress(OSError):
        for stage in sorted(folder.glob(f".*{SUFFIX}")):
            with suppress(OSError, ValueError, KeyError, TypeError):
                _recover(stage)


def _recover(stage: Path) -> None:
    with ExitStack() as locks:
        if not _abandoned(stage, locks):
            return
        leader = _leader_of(stage)
        # It may be on a drive that is not connected, or just be rolled back by another run.
        if not leader.parent.is_dir() or (
            leader != stage and leader.exists() and not _abandoned(leader, locks)
        ):
            return
        if (leader / JOURNAL).exists():
            _roll_back(leader, _moves(leader))
    shutil.rmtree(stage, ignore_errors=True)


def _roll_back(leader: Path, moves: list[Move]) -> None:
    for move in reversed(moves):
        move.undo()
    (leader / JOURNAL).unlink(missing_ok=True)


def _leader_of(stage: Path) -> Path:
    named = stage / LEADER
    if not named.exists():
        return stage
    try:
        return Path(os.path.normpath(stage / json.loads(named.read_text(encoding="utf-8"))))
    except ValueError:
        # Its run ended while it wrote this, and so before anything was replaced.
        return stage


def _moves(leader: Path) -> list[Move]:
    """Return the moves of a journal; a journal can name nothing but files beside a stage."""
    entries = json.loads((leader / JOURNAL).read_text(encoding="utf-8"))
    moves = []
    for entry in entries:
        stage, name = Path(os.path.normpath(leader / entry["stage"])), str(entry["name"])
        if not stage.name.endswith(SUFFIX) or Path(name).name != name:
            raise ValueError(f"{leader / JOURNAL} is damaged")
        moves.append(Move(stage, name, bool(entry["staged"])))
    return moves


def _relative(path: Path, start: Path) -> str:
    """Return a path that remains right if the folder of both is moved; an absolute one between drives."""
    try:
        return os.path.relpath(path, start)
    except ValueError:
        return str(path)


def _abandoned(stage: Path, locks: ExitStack) -> bool:
    """Return whether the run of a stage has ended; then lock the stage."""
    # Its run may not have locked it yet.
    if not (stage / LOCK).exists() and time.time() - stage.stat().st_mtime < YOUNG_S:
        return False
    lock = _locked(stage / LOCK)
    if lock is None:
        return False
    locks.enter_context(lock)
    return True


def _locked(path: Path) -> Optional[IO[Any]]:
    """Return a file that is open and locked until it is closed; None if another has locked it.

    Where the file system has no locks, nothing is ever locked, so that no stage is taken from a living run.
    """
    file = path.open("a+b")
    try:
        if fcntl is not None:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        else:
            file.seek(0)
            msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)  # type: ignore[attr-defined,unused-ignore]
    except OSError:
        file.close()
        return None
    return file
