"""Outputs that are either complete or not written at all."""

import errno
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Union

from .errors import InputError

# Files that belong to an older output of the same name and would contradict the new one.
APPENDED_SIDECARS = (".aux.xml", ".xml", ".ovr", ".msk", "-wal", "-shm", "-journal")
SIDECARS = {
    ".shp": (".shx", ".dbf", ".prj", ".cpg", ".qix", ".sbn", ".sbx", ".qpj"),
    ".tif": (".tfw",),
}


@contextmanager
def atomic_output(path: Union[str, Path]) -> Iterator[Path]:
    """Yield a temporary path to write to, and move what was written to `path` at the end.

    Everything that is written next to the temporary path is moved along, such as the sidecars
    of a shapefile. If the body raises, an older output is not changed.

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
        If the folder does not exist or is not writable, the disk is full, or the old output is locked.
    """
    target = Path(path)
    if not target.parent.is_dir():
        raise InputError(f"{target} cannot be written because its folder does not exist; create it first.")
    try:
        with tempfile.TemporaryDirectory(prefix=f".{target.name}.", dir=target.parent) as folder:
            yield Path(folder) / target.name
            _publish(Path(folder), target)
    except OSError as error:
        raise InputError(_explain(target, error)) from error


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


def _publish(folder: Path, target: Path) -> None:
    """Move all files of `folder` beside `target`, or none if one of them is locked."""
    companions = [file for file in folder.iterdir() if file.name != target.name]
    destinations = [target.parent / file.name for file in companions]
    retired = folder / "retired"
    retired.mkdir()
    try:
        for old in {*destinations, *_sidecars(target)}:
            if old.exists():
                old.replace(retired / old.name)
        for file, destination in zip(companions, destinations):
            file.replace(destination)
        # Last and in one step, so that this file never exists without its companions.
        (folder / target.name).replace(target)
    except BaseException:
        for destination in destinations:
            destination.unlink(missing_ok=True)
        for old in retired.iterdir():
            old.replace(target.parent / old.name)
        raise


def _sidecars(target: Path) -> list[Path]:
    appended = [target.with_name(target.name + suffix) for suffix in APPENDED_SIDECARS]
    replaced = SIDECARS.get(target.suffix.lower(), ())
    return appended + [target.with_suffix(suffix) for suffix in replaced]


def _explain(target: Path, error: OSError) -> str:
    if error.errno == errno.ENOSPC:
        return (
            f"{target} cannot be written because the disk is full; free some space or choose another folder."
        )
    if isinstance(error, PermissionError):
        return (
            f"{target} cannot be written; close it where it is open, or choose a folder "
            "that may be written to."
        )
    return f"{target} cannot be written ({error.strerror or error}); choose another name or folder."
