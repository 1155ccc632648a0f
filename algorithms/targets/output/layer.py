"""The layer of targets."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from shapely.geometry import Point

from ...vector import write_vector
from ..results import StationTargets, TargetSearch
from .lists import correlations_of

TEXT = 80
"""Most letters of a text."""

FIELDS = {
    "scan": f"str:{TEXT}",
    "name": f"str:{TEXT}",
    "kind": f"str:{TEXT}",
    "size": "float:10.4",
    "std": "float:12.6",
    **dict.fromkeys(("sx", "sy", "sz"), "float:12.7"),
    **dict.fromkeys(("rxy", "rxz", "ryz"), "float:9.6"),
    "points": "int",
    "range": "float:12.3",
    "incidence": "float:8.2",
    "quality": "float:6.3",
    "doubtful": "int",
    "doubt": "str:254",
}
"""Fields of the layer. The name is the row in the list of the scan, null for doubtful targets; std is the
standard deviation of the centre in space, sx to sz are those along the axes, rxy to ryz their correlations;
range is the distance from the scanner, metres; incidence in degrees."""


def write_targets(search: TargetSearch, path: Path) -> None:
    """Write a point for each target with the fields `FIELDS`.

    Raises
    ------
    InputError
        If the extension is unknown or the file cannot be written.
    """
    features = (feature for station in search.stations for feature in _features(station))
    write_vector(path, "3D Point", FIELDS, features, search.crs)


def _features(station: StationTargets) -> Iterator[tuple[Point, dict[str, Any]]]:
    for row, target in enumerate(station.targets, start=1):
        deviations = np.sqrt(np.diag(target.covariance))
        yield (
            Point(station.place(target)),
            {
                "scan": station.name[:TEXT],
                "name": None if target.doubt else str(row),
                "kind": target.kind.value,
                "size": target.size,
                "std": target.std,
                **dict(zip(("sx", "sy", "sz"), map(float, deviations))),
                **dict(zip(("rxy", "rxz", "ryz"), map(float, correlations_of(target.covariance)))),
                "points": target.points,
                "range": float(np.linalg.norm(target.xyz)),
                "incidence": target.incidence_deg,
                "quality": target.quality,
                "doubtful": int(bool(target.doubt)),
                "doubt": target.doubt or None,
            },
        )
