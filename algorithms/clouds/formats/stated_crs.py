"""The reference system that a cloud's file states itself."""

from pathlib import Path
from typing import Callable, Optional

from rasterio.crs import CRS

from ...errors import InputError
from ...reference_systems import has_only_heights, is_local, name_of, require_metres


def read_crs(path: Path, parse: Callable[[], Optional[CRS]]) -> tuple[Optional[CRS], tuple[str, ...]]:
    """Return the horizontal system that `parse` finds in a file, and what the user should know about it.

    Raises
    ------
    InputError
        If the heights of the system, or the axes of a local one, are not in metres.
    """
    try:
        crs = parse()
    except InputError as error:
        raise InputError(f"{path}: {error}") from error
    except ValueError:
        return None, (f"The coordinate reference system in {path} cannot be understood.",)
    if crs is not None and has_only_heights(crs):
        return None, (f"{path} states a system of heights only ({name_of(crs)}), which is ignored.",)
    if crs is not None and is_local(crs):
        require_metres(crs, str(path))
        return None, (
            f"{path} states a local system ({name_of(crs)}), which ties it to no position on the earth, so "
            "it counts as none.",
        )
    return crs, ()
