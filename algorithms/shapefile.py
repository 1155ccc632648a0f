"""Shapefiles whose parts do not belong together, of which GDAL reads what is there and says nothing."""

import struct
from pathlib import Path

from .errors import InputError


def refuse_damaged(path: Path) -> None:
    """Refuse a shapefile that is cut off, or whose table has another number of rows than it has shapes.

    Files of other formats, and shapefiles without a table or an index, pass.

    Parameters
    ----------
    path : Path
        Of any vector layer.

    Raises
    ------
    InputError
        If rows or shapes are missing, or the system refuses to read them.
    """
    if path.suffix.lower() != ".shp":
        return
    try:
        _check(path)
    except OSError as error:
        raise _damaged(path, f"it cannot be read: {error.strerror or error}") from error


def _check(path: Path) -> None:
    head = _beginning(path, 100)
    if len(head) == 100 and 2 * struct.unpack_from(">I", head, 24)[0] > path.stat().st_size:
        raise _damaged(path, "it is cut off")
    index, table = _beside(path, ".shx"), _beside(path, ".dbf")
    if not (index.is_file() and table.is_file()):
        return
    shapes = max(index.stat().st_size - 100, 0) // 8
    head = _beginning(table, 12)
    if len(head) < 12:
        raise _damaged(path, "its table is cut off")
    rows, start, width = struct.unpack_from("<IHH", head, 4)
    if start + rows * width > table.stat().st_size:
        raise _damaged(path, "its table is cut off")
    if rows != shapes:
        raise _damaged(path, f"it has {shapes} shapes, and its table {rows} rows")


def lacks_table(path: Path) -> bool:
    """Whether the table of a shapefile is missing, which holds the names."""
    return path.suffix.lower() == ".shp" and not _beside(path, ".dbf").is_file()


def _beside(path: Path, suffix: str) -> Path:
    """Return another part of a shapefile, whose extension is in the letters of the first or in capitals."""
    candidates = [path.with_suffix(spelt) for spelt in (suffix, suffix.upper())]
    return next((part for part in candidates if part.is_file()), candidates[0])


def _beginning(path: Path, size: int) -> bytes:
    with path.open("rb") as stream:
        return stream.read(size)


def _damaged(path: Path, detail: str) -> InputError:
    return InputError(f"{path} is damaged ({detail}); copy or export it again, with all its parts.")
