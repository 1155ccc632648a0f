"""The schedule of a facade: a table with one row a detail."""

from pathlib import Path

import pandas as pd

from ...files import atomic_output
from ..elevation import Elevation
from .elevation_layers import frame_values

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
}


def write_schedule(path: Path, elevation: Elevation) -> None:
    """Write the schedule as csv; unknown values are empty.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    frame = frame_values(elevation.frame)
    columns = ["id", "kind", "shape", *DECIMALS, "points", *frame]
    rows = [
        {
            "id": detail.number,
            "kind": detail.kind,
            "shape": detail.shape,
            **{name: getattr(detail, name) for name in list(DECIMALS)[:-2]},
            "u": detail.outline.centroid.x,
            "v": detail.outline.centroid.y,
            "points": detail.points,
            **frame,
        }
        for detail in elevation.details
    ]
    table = pd.DataFrame(rows, columns=columns)
    for name, decimals in DECIMALS.items():
        table[name] = table[name].astype(float).round(decimals)
    with atomic_output(path) as temporary:
        table.to_csv(temporary, index=False, lineterminator="\n")
