"""The schedule of a facade: a table with one row a detail."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import pandas as pd

from ...files import atomic_output
from ..elevation import Elevation
from .elevation_layers import FRAME_FIELDS, frame_values

DECIMALS = {
    "width": 4,
    "height": 4,
    "sill": 4,
    "area": 5,
    "width_std": 5,
    "height_std": 5,
    "depth": 4,
    "u": 4,
    "v": 4,
    "std_left": 5,
    "std_right": 5,
    "std_bottom": 5,
    "std_top": 5,
    "wall_depth": 4,
}
OWN = ("width", "height", "sill", "area", "width_std", "height_std", "depth")
"""Numbers that a detail has by the same name."""

COLUMNS = (
    "id", "kind", "shape", *DECIMALS, "use", "head", "measured", "completed", "open_side", "points",
    *FRAME_FIELDS, "radius",
)  # fmt: skip


def write_schedule(path: Path, elevation: Elevation) -> None:
    """Write the schedule as csv; unknown values are empty.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    _write(path, _rows(elevation), COLUMNS)


def write_common_schedule(path: Path, elevations: Mapping[int, Elevation]) -> None:
    """Write one schedule of several facades; its first column is the number of the facade.

    Parameters
    ----------
    path : Path
    elevations : dict of int to Elevation
        By the number of the facade.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    rows = [{"facade": number, **row} for number, elevation in elevations.items() for row in _rows(elevation)]
    _write(path, rows, ("facade", *COLUMNS))


def _rows(elevation: Elevation) -> list[dict[str, Any]]:
    frame = {**frame_values(elevation.frame), "radius": elevation.radius}
    return [
        {
            "id": detail.number,
            "kind": detail.kind,
            "shape": detail.shape,
            **{name: getattr(detail, name) for name in OWN},
            **{f"std_{name}": deviation for name, deviation in vars(detail.edges).items()},
            "wall_depth": detail.layer,
            "use": detail.use,
            "head": detail.head,
            "measured": " ".join(detail.measured),
            "completed": " ".join(detail.completed),
            "open_side": " ".join(detail.open_sides),
            "u": detail.outline.centroid.x,
            "v": detail.outline.centroid.y,
            "points": detail.points,
            **frame,
        }
        for detail in elevation.details
    ]


def _write(path: Path, rows: list[dict[str, Any]], columns: Sequence[str]) -> None:
    table = pd.DataFrame(rows, columns=list(columns))
    for name, decimals in DECIMALS.items():
        table[name] = table[name].astype(float).round(decimals)
    with atomic_output(path) as temporary:
        table.to_csv(temporary, index=False, lineterminator="\n")
