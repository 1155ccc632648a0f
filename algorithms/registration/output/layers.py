"""The layers of a registration: the residuals, and the control points."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any, Optional

import numpy as np
from scipy import stats
from shapely.geometry import Point

from ...reporting.numbers import round_step
from ...vector import write_vector
from ..results import ControlPoint, Correspondence, Registration, ScanRegistration

CONFIDENCE = 0.95
"""Of ellipses and ellipsoids."""

PLANE_FACTOR, SPACE_FACTOR = (float(np.sqrt(stats.chi2.ppf(CONFIDENCE, size))) for size in (2, 3))
"""Ratios of the semi-axes to the standard deviations: 2.448 and 2.795."""

NAME = 80
LIST = 254
"""Most bytes of a text; a shapefile holds at most 254."""

AXES = ("x", "y", "z")

RESIDUAL_FIELDS = {
    "scan": f"str:{NAME}",
    "target": f"str:{NAME}",
    "control": f"str:{NAME}",
    "surveyed": "int",
    "used": "int",
    **dict.fromkeys(("vx", "vy", "vz", "v"), "float:14.5"),
    **dict.fromkeys(("rx", "ry", "rz", "wx", "wy", "wz", "tx", "ty", "tz"), "float:12.3"),
    **dict.fromkeys(("mdbx", "mdby", "mdbz", "ell_a", "ell_b", "ell_c"), "float:14.5"),
}
"""Fields of the residuals layer: v residual, r redundancy number, w Baarda's, t Pope's test statistic, mdb
minimal detectable bias along each axis; semi-axes of the confidence ellipsoid of the transformed target."""

CONTROL_FIELDS = {
    "name": f"str:{NAME}",
    "origin": f"str:{NAME}",
    **dict.fromkeys(("sx", "sy", "sz"), "float:14.5"),
    "scans": "int",
    "seen_by": f"str:{LIST}",
}
"""Fields of the control points layer: s standard deviation along each axis."""


def write_residuals(registration: Registration, path: Path) -> None:
    """Write a point for each correspondence, at its control point, with the fields `RESIDUAL_FIELDS`.

    Raises
    ------
    InputError
        If the extension is unknown or the file cannot be written.
    """
    features = (
        (Point(item.position), _residual(scan.name, item))
        for scan in registration.registered
        for item in scan.correspondences
    )
    write_vector(path, "3D Point", RESIDUAL_FIELDS, features, registration.crs)


def write_control(registration: Registration, path: Path) -> None:
    """Write the surveyed and the appended points with the fields `CONTROL_FIELDS`.

    Raises
    ------
    InputError
        If the extension is unknown or the file cannot be written.
    """
    features = ((Point(point.position), _control(point)) for point in registration.points)
    write_vector(path, "3D Point", CONTROL_FIELDS, features, registration.crs)


def exaggeration(scans: Sequence[ScanRegistration]) -> int:
    """Return the exaggeration that draws the longest residual as a tenth of the map."""
    used = [item for scan in scans for item in scan.correspondences if item.used]
    longest = max((float(np.linalg.norm(item.residual[:2])) for item in used), default=0.0)
    if longest == 0.0:
        return 1
    places = np.array([item.position[:2] for item in used])
    return max(1, round(round_step(0.1 * float(np.linalg.norm(np.ptp(places, axis=0))) / longest)))


def semi_axes(covariance: np.ndarray) -> np.ndarray:
    """Return the semi-axes of the confidence ellipsoid, longest first, metres.

    Parameters
    ----------
    covariance : ndarray, shape (3, 3)
        Square metres; if unknown, so are the semi-axes.
    """
    if not np.all(np.isfinite(covariance)):
        return np.full(3, np.nan)
    return SPACE_FACTOR * np.sqrt(np.maximum(np.linalg.eigvalsh(covariance)[::-1], 0.0))


def _residual(scan: str, item: Correspondence) -> dict[str, Any]:
    vectors = {
        "v": item.residual,
        "r": item.redundancy,
        "w": item.normalized,
        "t": item.studentized,
        "mdb": item.detectable,
    }
    values = {f"{name}{axis}": value for name, vector in vectors.items() for axis, value in zip(AXES, vector)}
    values["v"] = item.length
    values.update(zip(("ell_a", "ell_b", "ell_c"), semi_axes(item.covariance)))
    return {
        "scan": _cut(scan),
        "target": _cut(item.target),
        "control": _cut(item.control),
        "surveyed": int(item.surveyed),
        "used": int(item.used),
        **_known(values),
    }


def _control(point: ControlPoint) -> dict[str, Any]:
    deviations = np.sqrt(np.diag(point.covariance))
    return {
        "name": _cut(point.name),
        "origin": _cut(point.origin),
        **_known(dict(zip(("sx", "sy", "sz"), deviations))),
        "scans": len(point.scans),
        "seen_by": _joined(point.scans),
    }


def _known(values: dict[str, float]) -> dict[str, Optional[float]]:
    """Return the values as numbers, None if unknown."""
    return {name: float(value) if np.isfinite(value) else None for name, value in values.items()}


def _cut(text: str, size: int = NAME) -> str:
    """Return a text of at most `size` bytes, whole letters, with an ellipsis where it was longer."""
    encoded = text.encode("utf-8", errors="replace")
    if len(encoded) <= size:
        return encoded.decode("utf-8")
    ellipsis = "\N{HORIZONTAL ELLIPSIS}"
    return encoded[: size - len(ellipsis.encode())].decode("utf-8", errors="ignore") + ellipsis


def _joined(names: Sequence[str]) -> str:
    """Return names in one text, as many whole ones as fit."""
    for count in range(len(names), 0, -1):
        rest = [] if count == len(names) else ["\N{HORIZONTAL ELLIPSIS}"]
        text = ", ".join([*names[:count], *rest])
        if len(text.encode("utf-8", errors="replace")) <= LIST:
            return text
    return _cut(", ".join(names), LIST)
