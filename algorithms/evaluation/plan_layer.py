"""The layer of a comparison of plans: where the two agree, and where and how far they do not."""

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Optional, Union

from rasterio.crs import CRS
from shapely.geometry import LineString

from ..vector import write_vector
from .plan import PlanAgreement

FIELDS = {
    "side": "str:10",
    "state": "str:10",
    "offset": "float:12.4",
    "max_offset": "float:12.4",
    "length": "float:12.3",
}


def write_errors(path: Path, agreement: PlanAgreement, crs: Optional[CRS]) -> None:
    """Write the stretches of both boundaries as lines, those that agree first, so that errors lie on top.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    write_vector(path, "LineString", FIELDS, _features(agreement), crs)


def _features(agreement: PlanAgreement) -> Iterator[tuple[LineString, dict[str, Union[str, float, None]]]]:
    for stretch in sorted(agreement.stretches(), key=lambda stretch: stretch.max_offset):
        offsets = {"offset": stretch.offset, "max_offset": stretch.max_offset}
        known = {name: value if math.isfinite(value) else None for name, value in offsets.items()}
        yield (
            stretch.line,
            {"side": stretch.side, "state": stretch.state, "length": stretch.line.length, **known},
        )
