"""A scan of an E57 file: its fields, its pose, and the ranges of its values."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional

import numpy as np
from scipy.spatial.transform import Rotation

from ...errors import InputError
from .poses import pose_problem

CARTESIAN = ("cartesianX", "cartesianY", "cartesianZ")
SPHERICAL = ("sphericalRange", "sphericalAzimuth", "sphericalElevation")
COLOUR = ("colorRed", "colorGreen", "colorBlue")
INVALID = ("cartesianInvalidState", "sphericalInvalidState")
"""Fields that are not 0 where there is no point."""


DEPTHS = (1, 255, 65535)
"""The largest colours that programs write."""

UNKNOWN = (float("nan"), float("nan"))
"""The limits of a field for which none are announced."""

UNIT_LENGTH = 1e-3
"""By which the length of a quaternion may differ from 1: that of three written decimals."""


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
    intensity_limits : tuple of 2 float
        As they are announced; nan if they are not.
    brightest : float
        The largest colour that is announced; nan if none is.
    attributes : dict of str to dtype
        What else the points have.
    warnings : tuple of str
        What the user should know about the scan, in sentences.
    has_pose : bool
    intensity : tuple of 2 float
        Summand, then factor, that bring the intensity to 0..65535.
    rgb_factor : float
        Brings the colour to 0..65535.
    """

    number: int
    count: int
    fields: tuple[str, ...]
    rotation: np.ndarray
    shift: np.ndarray
    intensity_limits: tuple[float, float]
    brightest: float
    attributes: dict[str, np.dtype]
    warnings: tuple[str, ...] = ()
    has_pose: bool = False
    intensity: tuple[float, float] = (0.0, 1.0)
    rgb_factor: float = 1.0

    @property
    def coordinates(self) -> tuple[str, ...]:
        """The fields of the positions."""
        return CARTESIAN if set(CARTESIAN) <= set(self.fields) else SPHERICAL

    def is_colour_wider_than(self, colours: np.ndarray) -> bool:
        """Whether a greater depth is announced than that of a sample of colours, shape (n, 3); or none is."""
        if not len(colours):
            return False
        brightest = colours.max()
        return not self.brightest <= next((depth for depth in DEPTHS if brightest <= depth), np.inf)

    def is_intensity_wider_than(self, intensity: np.ndarray) -> bool:
        """Whether a sample, shape (n,), has less than one of 256 steps of the range that is announced."""
        low, high = self.intensity_limits
        return len(intensity) > 0 and not np.ptp(intensity) >= abs(high - low) / 256


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
        If its points have no coordinates, or its pose moves no points.
    """
    if not node.isDefined("points"):
        raise InputError(f"{path} has a scan without coordinates; export it again.")
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
    rotation, warnings = _rotation(path, node, number)
    shift = _vector(node, "translation", "xyz", np.zeros(3))
    problem = pose_problem(rotation, shift)
    if problem:
        raise InputError(
            f"The pose of scan {number + 1} of {path} {problem}; export the scan again with its pose."
        )
    return Scan(
        number=number,
        count=points.childCount(),
        fields=tuple(name for name in names if name in read),
        rotation=rotation,
        shift=shift,
        intensity_limits=_limits(node, prototype, "intensity"),
        brightest=max(_limits(node, prototype, name)[1] for name in COLOUR),
        attributes={plain_name(name): kind for name, kind in others.items()},
        warnings=warnings,
        has_pose=node.isDefined("pose"),
    )


def _kind(library: Any, field: Any) -> Optional[np.dtype]:
    """Return the type for the values of a field of the prototype; None if they are not numbers."""
    if isinstance(field, library.IntegerNode):
        return np.promote_types(np.min_scalar_type(field.minimum()), np.min_scalar_type(field.maximum()))
    return np.dtype(np.float64) if isinstance(field, (library.ScaledIntegerNode, library.FloatNode)) else None


def plain_name(name: str) -> str:
    """Return the name of a field without that of the extension it belongs to."""
    return name.split(":")[-1]


def _rotation(path: Path, node: Any, number: int) -> tuple[np.ndarray, tuple[str, ...]]:
    """Return the rotation of a pose, and what is doubtful about it."""
    quaternion = _vector(node, "rotation", "wxyz", np.array([1.0, 0, 0, 0]))
    if not np.isfinite(quaternion).all():
        return np.full((3, 3), np.nan), ()
    length = float(np.linalg.norm(quaternion))
    sentence = f"The rotation of scan {number + 1} of {path} {{}}; check how it was exported."
    if length == 0:
        return np.eye(3), (sentence.format("is all zero, so the scan is not turned"),)
    w, *axis = quaternion
    doubt = (
        (sentence.format(f"has the length {length:.3g} instead of 1"),)
        if abs(length - 1) > UNIT_LENGTH
        else ()
    )
    return Rotation.from_quat([*axis, w]).as_matrix(), doubt


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
        return UNKNOWN
    field = prototype[name]
    if hasattr(field, "scaledMaximum"):
        return field.scaledMinimum(), field.scaledMaximum()
    # A number without limits of its own has those of its type, which say nothing about its range.
    narrow = field.minimum() > -1e9 and field.maximum() < 1e9
    return (field.minimum(), field.maximum()) if narrow else UNKNOWN


def _value(node: Any) -> float:
    return float(node.scaledValue() if hasattr(node, "scaledValue") else node.value())
