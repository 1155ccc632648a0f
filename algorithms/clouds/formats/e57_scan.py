"""A scan of an E57 file: its fields, its pose, and the ranges of its values."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional

import numpy as np
from scipy.spatial.transform import Rotation

from ...errors import InputError

CARTESIAN = ("cartesianX", "cartesianY", "cartesianZ")
SPHERICAL = ("sphericalRange", "sphericalAzimuth", "sphericalElevation")
COLOUR = ("colorRed", "colorGreen", "colorBlue")
INVALID = ("cartesianInvalidState", "sphericalInvalidState")
"""Fields that are not 0 where there is no point."""


@dataclass(frozen=True)
class Scan:
    """One of the scans of a file.

    Attributes
    ----------
    number : int
        Its position in the file, from 0.
    count : int
        Number of points, also of invalid ones.
    fields : tuple of str
        What is read.
    rotation : ndarray, shape (3, 3)
    shift : ndarray, shape (3,)
        Of the pose.
    intensity : tuple of 2 float
        Summand, then factor, that bring the intensity to 0..65535.
    rgb_factor : float
        Brings the colour to 0..65535.
    attributes : dict of str to dtype
        What else the points have.
    """

    number: int
    count: int
    fields: tuple[str, ...]
    rotation: np.ndarray
    shift: np.ndarray
    intensity: tuple[float, float]
    rgb_factor: float
    attributes: dict[str, np.dtype]


def describe(library: Any, path: Path, node: Any, number: int) -> Scan:
    """Return what the header of a scan says.

    Parameters
    ----------
    library : module
        libe57.
    path : Path
        The file, for messages.
    node : libe57.StructureNode
        The scan.
    number : int
        Its position in the file, from 0.

    Raises
    ------
    InputError
        If its points have no coordinates.
    """
    points = node["points"]
    prototype = library.StructureNode(points.prototype())
    names = [prototype.get(index).elementName() for index in range(prototype.childCount())]
    coordinates = next((fields for fields in (CARTESIAN, SPHERICAL) if set(fields) <= set(names)), None)
    if coordinates is None:
        raise InputError(f"{path} has a scan without coordinates; export it again.")
    kinds = {name: _kind(library, prototype[name]) for name in names}
    known = {*CARTESIAN, *SPHERICAL, *INVALID, *COLOUR, "intensity"}
    others = {name: kind for name, kind in kinds.items() if name not in known and kind is not None}
    read = {*coordinates, *INVALID, *COLOUR, "intensity", *others}
    return Scan(
        number=number,
        count=points.childCount(),
        fields=tuple(name for name in names if name in read),
        rotation=_rotation(node),
        shift=_vector(node, "translation", "xyz", np.zeros(3)),
        intensity=_intensity_scale(_limits(node, prototype, "intensity")),
        rgb_factor=_rgb_factor(max(_limits(node, prototype, name)[1] for name in COLOUR)),
        attributes={plain_name(name): kind for name, kind in others.items()},
    )


def _kind(library: Any, field: Any) -> Optional[np.dtype]:
    """Return the type for the values of a field of the prototype; None if they are not numbers."""
    if isinstance(field, library.IntegerNode):
        return np.promote_types(np.min_scalar_type(field.minimum()), np.min_scalar_type(field.maximum()))
    return np.dtype(np.float64) if isinstance(field, (library.ScaledIntegerNode, library.FloatNode)) else None


def plain_name(name: str) -> str:
    """Return the name of a field without that of the extension it belongs to."""
    return name.split(":")[-1]


def _rotation(node: Any) -> np.ndarray:
    quaternion = _vector(node, "rotation", "xyzw", np.zeros(4))
    return Rotation.from_quat(quaternion).as_matrix() if quaternion.any() else np.eye(3)


def _vector(node: Any, name: str, components: str, default: np.ndarray) -> np.ndarray:
    path = f"pose/{name}"
    if not node.isDefined(path):
        return default
    return np.array([node[f"{path}/{component}"].value() for component in components], np.float64)


def _limits(node: Any, prototype: Any, name: str) -> tuple[float, float]:
    """Return the range of a field as the scan announces it, or else as its type does."""
    group = "intensityLimits" if name == "intensity" else "colorLimits"
    ends = [f"{group}/{name}{end}" for end in ("Minimum", "Maximum")]
    if all(node.isDefined(end) for end in ends):
        low, high = (_value(node[end]) for end in ends)
        return low, high
    if not prototype.isDefined(name):
        return 0.0, 1.0
    field = prototype[name]
    if hasattr(field, "scaledMaximum"):
        return field.scaledMinimum(), field.scaledMaximum()
    # A number without limits of its own has those of its type, which say nothing about its range.
    narrow = field.minimum() > -1e9 and field.maximum() < 1e9
    return (field.minimum(), field.maximum()) if narrow else (0.0, 1.0)


def _value(node: Any) -> float:
    return float(node.scaledValue() if hasattr(node, "scaledValue") else node.value())


def _intensity_scale(limits: tuple[float, float]) -> tuple[float, float]:
    low, high = limits
    # Many programs announce the range that occurs, which differs between scans of equal brightness.
    if low >= 0 and high <= 1:
        return 0.0, 65535.0
    return (-low, 65535 / (high - low)) if high > low else (0.0, 1.0)


def _rgb_factor(brightest: float) -> float:
    if brightest <= 1:
        return 65535.0
    return 257.0 if brightest <= 255 else 1.0
