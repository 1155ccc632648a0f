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
    "std_left": 5,
    "std_right": 5,
    "std_bottom": 5,
    "std_top": 5,
    "wall_depth": 4,
}
OWN = ("width", "height", "sill", "area", "width_std", "height_std", "depth")
"""Numbers that a detail has by the same name."""


def write_schedule(path: Path, elevation: Elevation) -> None:
    """Write the schedule as csv; unknown values are empty.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    frame = frame_values(elevation.frame)
    columns = ["id", "kind", "shape", *DECIMALS, "use", "head", "measured", "open_side", "points", *frame]
    rows = [
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
            "open_side": " ".join(detail.open_sides),
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
