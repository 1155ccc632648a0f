"""TRANSFORMS: the transformations of the scans, as a json file that other algorithms and scripts read."""

import json
import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional

import numpy as np
from pyproj.exceptions import ProjError
from rasterio.crs import CRS
from rasterio.errors import CRSError

from ...errors import InputError
from ...files import atomic_output
from ...reference_systems import horizontal, is_local, require_metres
from ...tables.units import METRES, as_unit
from ..lists.scan_names import scan_of_cloud
from ..results import REGISTERED, Correspondence, Registration, ScanRegistration

ORTHOGONAL = 5e-6
"""Largest difference between R'R of a matrix m R and the identity: that of six written decimals."""

MOST_BYTES = 64 * 2**20
"""Of a file; thousands of scans take less."""

SCALES = (1e-4, 1e4)
"""Smallest and largest scale: from a tenth of a millimetre, or from ten kilometres, to a metre."""

FARTHEST = 1e8
"""Largest shift (m); no two points of the earth are so far apart."""


@dataclass(frozen=True)
class ScanTransform:
    """One scan of a TRANSFORMS file.

    Attributes
    ----------
    name : str
    status, reason : str
        As in `ScanRegistration`.
    matrix : ndarray of float64, shape (4, 4), or None
        A similarity from the scan to the control frame; None if the scan is not registered.
    """

    name: str
    status: str
    reason: str
    matrix: Optional[np.ndarray]


@dataclass(frozen=True)
class Transforms:
    """A TRANSFORMS file.

    Attributes
    ----------
    path : Path
    scans : tuple of ScanTransform
        In the order of the file.
    crs : CRS or None
        Of the control frame.
    """

    path: Path
    scans: tuple[ScanTransform, ...]
    crs: Optional[CRS]


def write_transforms(registration: Registration, path: Path) -> None:
    """Write a registration as json; numbers are read back exactly, and unknown values are null.

    Raises
    ------
    InputError
        If `path` cannot be written.
    """
    document = {
        "model": registration.settings.model.name.lower(),
        "matching": registration.settings.matching.name.lower(),
        "sigma": registration.settings.sigma,
        "control_sigma": registration.settings.control_sigma,
        "tolerance": registration.tolerance,
        "max_std": registration.settings.std_limit,
        "sigma0": registration.test.sigma0,
        "redundancy": registration.test.redundancy,
        "probability": registration.test.probability,
        "crs": None if registration.crs is None else registration.crs.to_wkt(),
        "warnings": registration.warnings,
        "surfaces": [vars(item) for item in registration.surfaces],
        "scans": [_scan(scan) for scan in registration.scans],
    }
    text = json.dumps(_plain(document), indent=1, ensure_ascii=False, allow_nan=False)
    with atomic_output(path) as temporary:
        temporary.write_bytes(f"{text}\n".encode())


def _scan(scan: ScanRegistration) -> dict[str, Any]:
    test, scale_test = scan.test, scan.scale_test
    return {
        "name": scan.name,
        "status": scan.status,
        "reason": scan.reason,
        "matrix": scan.matrix,
        "scale": scan.scale,
        "std": scan.std,
        "sigma0": test and test.sigma0,
        "redundancy": test and test.redundancy,
        "probability": test and test.probability,
        "round": scan.round,
        "chance": scan.chance,
        "targets": scan.targets,
        "parameters": {item.name: {"value": item.value, "std": item.std} for item in scan.estimates},
        "correlations": scan.correlations,
        "scale_test": scale_test and vars(scale_test),
        "correspondences": [_correspondence(item) for item in scan.correspondences],
        "unmatched": scan.unmatched,
        "rivals": scan.rivals,
        "warnings": scan.warnings,
        "surfaces": scan.surfaces and vars(scan.surfaces),
        "placement": scan.placement and vars(scan.placement),
    }


def _correspondence(item: Correspondence) -> dict[str, Any]:
    vx, vy, vz = item.residual
    return {
        "target": item.target,
        "control": item.control,
        "surveyed": item.surveyed,
        "used": item.used,
        "vx": vx,
        "vy": vy,
        "vz": vz,
        "redundancy": item.redundancy,
        "normalized": item.normalized,
        "studentized": item.studentized,
        "detectable": item.detectable,
    }


def _plain(value: Any) -> Any:
    """Return `value` in the types of json."""
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    if isinstance(value, (np.ndarray, np.generic)):
        return _plain(value.tolist())
    return None if isinstance(value, float) and not math.isfinite(value) else value


def read_transforms(path: Path) -> Transforms:
    """Read a TRANSFORMS file, which may be written by hand: a name and a matrix make a scan.

    Raises
    ------
    InputError
        If the file cannot be read, is not a TRANSFORMS file, or holds a matrix that is not a similarity.
    """
    path = Path(path)
    try:
        if path.stat().st_size > MOST_BYTES:
            raise InputError(f"{path} is too large; choose the TRANSFORMS of registerscans.")
        document = json.loads(path.read_bytes())
    except OSError as error:
        raise InputError(
            f"{path} cannot be read ({error.strerror or error}); check that it exists and may be read."
        ) from error
    except (ValueError, RecursionError) as error:
        raise InputError(f"{path} is not json ({error}); choose the TRANSFORMS of registerscans.") from error
    entries = document.get("scans") if isinstance(document, dict) else None
    if not (isinstance(entries, list) and entries):
        raise InputError(f"{path} lists no scans; choose the TRANSFORMS of registerscans.")
    _refuse_other_units(path, document)
    scans = tuple(_read_scan(path, number, entry) for number, entry in enumerate(entries, start=1))
    counts = Counter(scan.name for scan in scans)
    repeated = next((name for name, count in counts.items() if count > 1), None)
    if repeated:
        raise InputError(f"{path} lists the scan {repeated} twice; remove one entry.")
    return Transforms(path, scans, _read_crs(path, document.get("crs")))


def _refuse_other_units(path: Path, document: dict[str, Any]) -> None:
    """Refuse matrices whose unit is stated and is not known to be the metre."""
    for key in ("unit", "units"):
        unit = document.get(key)
        if unit is not None and METRES.get(as_unit(str(unit)) or "") != 1:
            raise InputError(f"{path} gives matrices in {unit}; write shifts in metres.")


def _read_scan(path: Path, number: int, entry: Any) -> ScanTransform:
    name = entry.get("name") if isinstance(entry, dict) else None
    if not (isinstance(name, str) and name):
        raise InputError(f"Scan number {number} in {path} has no name; give it the name of its cloud.")
    status = entry.get("status", REGISTERED)
    reason = str(entry.get("reason") or "")
    if status != REGISTERED:
        return ScanTransform(name, str(status), reason, None)
    matrix = _matrix(entry.get("matrix"))
    problem = _problem(matrix)
    if problem:
        raise InputError(f"The matrix of the scan {name} in {path} {problem}; register the scan again.")
    return ScanTransform(name, status, reason, matrix)


def _matrix(given: Any) -> np.ndarray:
    try:
        return np.array(given, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        return np.empty(0)


def _problem(matrix: np.ndarray) -> str:
    """Return why `matrix` is not a similarity; empty if it is one."""
    if matrix.shape != (4, 4):
        return "is not four rows of four numbers"
    if not np.isfinite(matrix).all():
        return "holds something that is not a number"
    if not np.array_equal(matrix[3], [0, 0, 0, 1]):
        return "does not end in the row 0 0 0 1"
    if np.abs(matrix[:3, 3]).max() > FARTHEST:
        return f"moves the scan by {np.abs(matrix[:3, 3]).max():.0e} m"
    with np.errstate(over="ignore", invalid="ignore"):
        determinant = np.linalg.det(matrix[:3, :3])
    if determinant < 0:
        return "mirrors the scan"
    scale = np.cbrt(determinant)
    if scale and not SCALES[0] <= scale <= SCALES[1]:
        return f"has a scale of {scale:.1e}"
    rotation = matrix[:3, :3] / (scale or 1.0)
    if np.abs(rotation.T @ rotation - np.eye(3)).max() > ORTHOGONAL:
        return "distorts the scan because its rotation is not orthogonal"
    return ""


def _read_crs(path: Path, text: Any) -> Optional[CRS]:
    if not text:
        return None
    try:
        if not isinstance(text, str):
            raise ValueError("not a text")
        crs = horizontal(CRS.from_user_input(text))
        local = is_local(crs)
    except InputError as error:
        raise InputError(f"{path}: {error}") from error
    except (CRSError, ProjError, ValueError) as error:
        raise InputError(
            f"The coordinate reference system in {path} cannot be understood; "
            "write it as WKT or like EPSG:25832."
        ) from error
    require_metres(crs, f"the control points in {path}")
    return None if local else crs


def match_clouds(
    transforms: Transforms, clouds: Sequence[Path]
) -> tuple[tuple[Optional[ScanTransform], ...], tuple[str, ...]]:
    """Return the scan of each cloud, by the stems of the files, None if it is not registered; and warnings.

    The stem of `scan.copc.laz` is `scan`. Capitals matter only if names differ in nothing else. One cloud
    and one scan belong together, whatever their names.

    Raises
    ------
    InputError
        If a cloud has no scan of its name, or no scan of a cloud is registered.
    """
    names = [scan.name for scan in transforms.scans]
    numbers = [scan_of_cloud(names, cloud) for cloud in clouds]
    scans = tuple(None if number is None else transforms.scans[number] for number in numbers)
    warnings: tuple[str, ...] = ()
    if len(clouds) == len(transforms.scans) == 1 and scans[0] is None:
        (only,) = scans = transforms.scans
        warnings = (f"The only scan in {transforms.path}, {only.name}, is used for {clouds[0].name}.",)
    placed: list[Optional[ScanTransform]] = []
    refused = []
    for cloud, scan in zip(clouds, scans):
        if scan is None:
            raise InputError(
                f"There is no scan for {cloud} in {transforms.path}, only {', '.join(names)}; "
                "name the cloud after its scan."
            )
        placed.append(scan if scan.matrix is not None else None)
        if scan.matrix is None:
            refused.append(
                f"{cloud} is left out because its scan {scan.name} is not registered in {transforms.path} "
                f"({scan.status}{': ' if scan.reason else ''}{scan.reason.rstrip('.')})."
            )
    if len(refused) == len(clouds):
        raise InputError(" ".join([*refused, "Register at least one of them."]))
    return tuple(placed), (*warnings, *refused)
