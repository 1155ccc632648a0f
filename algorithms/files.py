"""Outputs that are either complete or not written at all."""

import errno
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from types import TracebackType
from typing import Optional, Union

from .errors import InputError
from .staging import Move, Stage, recover, replace_all

# Files that belong to an older output of the same name and would contradict the new one.
APPENDED_SIDECARS = (".aux.xml", ".xml", ".ovr", ".msk", "-wal", "-shm", "-journal")
SIDECARS = {
    ".shp": (".shx", ".dbf", ".prj", ".cpg", ".qix", ".sbn", ".sbx", ".qpj"),
    ".tif": (".tfw",),
}

LEAST_FREE = 2**16
"""Bytes; files and their folders grow by less at a time."""


class Outputs:
    """The outputs of one run, which are replaced together at the end of a `with` block, or not at all.

    If the block raises, older outputs are not changed. If the process is killed while outputs are replaced,
    the next run that writes to one of their folders brings all older outputs back.
    """

    def __init__(self) -> None:
        self._stages: dict[Path, Stage] = {}

    def __enter__(self) -> "Outputs":
        return self

    @contextmanager
    def staged(self, path: Union[str, Path]) -> Iterator[Path]:
        """Yield a temporary path for an output; what is written next to it, as sidecars are, moves along.

        Parameters
        ----------
        path : str or Path
            The output, in an existing folder.

        Yields
        ------
        Path
            The same file name in a hidden folder beside `path`.

        Raises
        ------
        InputError
            If the folder does not exist or is not writable, or the disk is full.
        """
        target = Path(path)
        if not target.parent.is_dir():
            raise InputError(
                f"{target} cannot be written because its folder does not exist; create it first."
            )
        if target.parent not in {path.parent for path in self._stages}:
            recover(target.parent)
        try:
            leader = next(iter(self._stages.values()), None)
            self._stages[target] = stage = Stage(target.parent, target.name, leader)
            yield stage.new / target.name
        except OSError as error:
            raise InputError(_explain(target, error)) from error

    def __exit__(
        self,
        kind: Optional[type[BaseException]],
        error: Optional[BaseException],
        trace: Optional[TracebackType],
    ) -> None:
        """Replace all outputs if the block succeeded.

        Raises
        ------
        InputError
            If an older output is locked.
        """
        try:
            if kind is None and self._stages:
                self._replace()
        finally:
            # If an output could not even be rolled back, a later run tries again.
            pending = any(stage.pending for stage in self._stages.values())
            for stage in self._stages.values():
                stage.close(keep=pending)

    def _replace(self) -> None:
        moves = {move.final: move for move in self._moves()}
        leader = next(iter(self._stages.values()))
        try:
            replace_all(leader.path, moves.values())
        except OSError as error:
            named = {Path(str(name)) for name in (error.filename, error.filename2) if name}
            target = next((path for path in self._stages if path in named), next(iter(self._stages)))
            raise InputError(_explain(target, error)) from error

    def _moves(self) -> Iterator[Move]:
        """Yield what has to be moved: old sidecars, then new ones, and the outputs themselves last."""
        for target, stage in self._stages.items():
            for old in _sidecars(target):
                if old.is_file():
                    yield Move(stage.path, old.name, False)
        for last in (False, True):
            for target, stage in self._stages.items():
                for file in sorted(stage.new.iterdir()):
                    if (file.name == target.name) == last:
                        yield Move(stage.path, file.name, True)


@contextmanager
def atomic_output(path: Union[str, Path]) -> Iterator[Path]:
    """Yield a temporary path to write to, and move what was written to `path` at the end; see `Outputs`.

    Raises
    ------
    InputError
        If the folder does not exist or is not writable, the disk is full, or the old output is locked.
    """
    with Outputs() as outputs, outputs.staged(path) as temporary:
        yield temporary


@contextmanager
def new_folder(path: Path) -> Iterator[None]:
    """Make a folder unless it exists; if the body raises, remove it again.

    Raises
    ------
    InputError
        If it cannot be made.
    """
    made = not path.is_dir()
    try:
        if made:
            path.mkdir()
    except OSError as error:
        raise InputError(_explain(path, error)) from error
    try:
        yield
    except BaseException:
        if made:
            with suppress(OSError):
                path.rmdir()
        raise


def _sidecars(target: Path) -> list[Path]:
    appended = [target.with_name(target.name + suffix) for suffix in APPENDED_SIDECARS]
    replaced = SIDECARS.get(target.suffix.lower(), ())
    return appended + [target.with_suffix(suffix) for suffix in replaced]


def is_full(folder: Path) -> bool:
    """Whether a disk has less space left than outputs take; not every library says why it cannot write."""
    try:
        return shutil.disk_usage(folder).free < LEAST_FREE
    except OSError:
        return False


def _explain(target: Path, error: OSError) -> str:
    if error.errno == errno.ENOSPC or (error.errno is None and is_full(target.parent)):
        return (
            f"{target} cannot be written because the disk is full; free some space or choose another folder."
        )
    if isinstance(error, PermissionError):
        return (
            f"{target} cannot be written; close it where it is open, or choose a folder "
            "that may be written to."
        )
    return f"{target} cannot be written ({error.strerror or error}); choose another name or folder."
