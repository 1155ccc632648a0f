"""Outputs that are either whole or not there at all."""

import errno
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Union

from .errors import InputError

# What belongs to an older output of the same name, and would contradict the new one.
APPENDED_SIDECARS = (".aux.xml", ".xml", ".ovr", ".msk", "-wal", "-shm", "-journal")
SIDECARS = {
    ".shp": (".shx", ".dbf", ".prj", ".cpg", ".qix", ".sbn", ".sbx", ".qpj"),
    ".tif": (".tfw",),
}


@contextmanager
def atomic_output(path: Union[str, Path]) -> Iterator[Path]:
    """Give a temporary path to write to, and move what was written to `path` at the end.

    Everything that is written next to the temporary path is moved along, such as the sidecars
    of a shapefile. If the body raises, an older output stays as it was.

    Parameters
    ----------
    path : str or Path
        Where the output shall be, in an existing folder.

    Yields
    ------
    Path
        The same file name in a hidden folder beside `path`.

    Raises
    ------
    InputError
        If the folder is missing or not writable, the disk is full, or the old output is locked.
    """
    target = Path(path)
    if not target.parent.is_dir():
        raise InputError(f"{target} cannot be written, for its folder is missing; create it first.")
    try:
        with tempfile.TemporaryDirectory(prefix=f".{target.name}.", dir=target.parent) as folder:
            yield Path(folder) / target.name
            _publish(Path(folder), target)
    except OSError as error:
        raise InputError(_explain(target, error)) from error


@contextmanager
def new_folder(path: Path) -> Iterator[None]:
    """Make a folder unless it is there; if the body raises, it is removed again.

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


def _publish(folder: Path, target: Path) -> None:
    """Move all files of `folder` beside `target`, or none if one of them is locked."""
    companions = [file for file in folder.iterdir() if file.name != target.name]
    placed = [target.parent / file.name for file in companions]
    retired = folder / "retired"
    retired.mkdir()
    try:
        for old in {*placed, *_sidecars(target)}:
            if old.exists():
                old.replace(retired / old.name)
        for file, place in zip(companions, placed):
            file.replace(place)
        # Last, and in one step: where this file is, there is all that belongs to it.
        (folder / target.name).replace(target)
    except BaseException:
        for place in placed:
            place.unlink(missing_ok=True)
        for old in retired.iterdir():
            old.replace(target.parent / old.name)
        raise


def _sidecars(target: Path) -> list[Path]:
    appended = [target.with_name(target.name + suffix) for suffix in APPENDED_SIDECARS]
    replaced = SIDECARS.get(target.suffix.lower(), ())
    return appended + [target.with_suffix(suffix) for suffix in replaced]


def _explain(target: Path, error: OSError) -> str:
    if error.errno == errno.ENOSPC:
        return f"{target} cannot be written, for the disk is full; free some space or choose another folder."
    if isinstance(error, PermissionError):
        return (
            f"{target} cannot be written; close it where it is open, or choose a folder "
            "that may be written to."
        )
    return f"{target} cannot be written ({error.strerror or error}); choose another name or folder."
