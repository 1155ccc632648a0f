"""E57, read by the libE57Format of the optional package pye57."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional

import numpy as np
from scipy.spatial.transform import Rotation

from ...errors import InputError, MissingPackageError
from ...geometry.motion import product
from ...progress import Progress
from ...reference_systems import parse_wkt
from ..source import Chunk, Source, no_points, unreadable
from . import E57_PACKAGES
from .normals import find_normals
from .stated_crs import read_crs
from .value_ranges import to_uint16

SAMPLE = 10_000

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
        Its place in the file, from 0.
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


@dataclass(frozen=True)
class E57Source(Source):
    """An E57 file; the points of all scans, moved by their poses, without those that are marked invalid.

    Where some scans have an attribute and others not, it is 0 in the others.

    Attributes
    ----------
    scans : tuple of Scan
        Those that hold points.
    """

    scans: tuple[Scan, ...]

    @classmethod
    def open(cls, path: Path) -> "E57Source":
        """Look into the headers and the first points of `path`.

        Raises
        ------
        MissingPackageError
            If pye57 is not installed.
        InputError
            If the file is no E57, is damaged or holds no points.
        """
        with _image(path) as (library, image):
            root = image.root()
            nodes = root["data3D"] if root.isDefined("data3D") else []
            scans = tuple(_scan(library, path, nodes[number], number) for number in range(len(nodes)))
            wkt = root["coordinateMetadata"].value() if root.isDefined("coordinateMetadata") else ""
        scans = tuple(scan for scan in scans if scan.count)
        blocks = (_places(data, scan) for scan in scans for data in _blocks(path, scan, SAMPLE))
        sample = next((points for points in blocks if len(points)), None)
        if sample is None:
            raise no_points(path)
        crs, warnings = read_crs(path, lambda: parse_wkt(wkt) if wkt.strip() else None)
        return cls(
            path=path,
            crs=crs,
            warnings=warnings,
            middle=np.median(sample, axis=0),
            has_intensity=any("intensity" in scan.fields for scan in scans),
            has_rgb=any(set(COLOUR) <= set(scan.fields) for scan in scans),
            scans=scans,
        )

    @property
    def attributes(self) -> tuple[tuple[str, np.dtype], ...]:
        """See `Source.attributes`."""
        kinds: dict[str, np.dtype] = {}
        for scan in self.scans:
            for name, kind in scan.attributes.items():
                kinds[name] = np.promote_types(kinds.get(name, kind), kind)
        return tuple(kinds.items())

    def chunks(self, origin: np.ndarray, progress: Progress, size: int) -> Iterator[Chunk]:
        """Yield all points in file order; see `Source.chunks`."""
        progress.update(0.0, f"Reading {self.path.name}")
        total, done = sum(scan.count for scan in self.scans), 0
        for scan in self.scans:
            left = scan.count
            for data in _blocks(self.path, scan, size):
                places = _places(data, scan)
                if len(places):
                    yield self._chunk(data, scan, places - origin)
                left = max(left - size, 0)
                progress.update((done + scan.count - left) / total)
            done += scan.count

    def _chunk(self, data: dict[str, np.ndarray], scan: Scan, xyz: np.ndarray) -> Chunk:
        none = np.zeros(len(xyz))
        summand, factor = scan.intensity
        intensity = to_uint16((data["intensity"] + summand) * factor) if "intensity" in data else none
        rgb = np.stack([data.get(name, none) for name in COLOUR], axis=1) * scan.rgb_factor
        attributes = {name: data.get(name, none) for name, _ in self.attributes}
        normals = [list(attributes)[place] for place in find_normals(list(attributes)) or ()]
        if normals:
            turned = product(np.stack([attributes[name] for name in normals], axis=1), scan.rotation)
            attributes.update(zip(normals, turned.T))
        return Chunk(
            xyz,
            intensity.astype(np.uint16) if self.has_intensity else None,
            to_uint16(rgb) if self.has_rgb else None,
            {name: attributes[name].astype(kind) for name, kind in self.attributes},
            np.full(len(xyz), scan.number),
        )


@contextmanager
def _image(path: Path) -> Iterator[tuple[Any, Any]]:
    """Open `path` and yield the module libe57 and the open file."""
    try:
        from pye57 import libe57
    except ModuleNotFoundError as error:
        raise MissingPackageError(str(path), E57_PACKAGES) from error
    try:
        with path.open("rb") as stream:
            if stream.read(8) != b"ASTM-E57":
                raise InputError(f"{path} is not an E57 file; give it the extension of its format.")
    except OSError as error:
        raise unreadable(path, error) from error
    image = None
    try:
        image = libe57.ImageFile(str(path), "r")
        yield libe57, image
    except libe57.E57Exception as error:
        detail = str(error).strip().splitlines()[0]
        raise InputError(f"{path} is truncated or damaged ({detail}); copy or export it again.") from error
    finally:
        if image is not None:
            image.close()


def _scan(library: Any, path: Path, node: Any, number: int) -> Scan:
    points = node["points"]
    prototype = library.StructureNode(points.prototype())
    names = [prototype.get(place).elementName() for place in range(prototype.childCount())]
    places = next((fields for fields in (CARTESIAN, SPHERICAL) if set(fields) <= set(names)), None)
    if places is None:
        raise InputError(f"{path} has a scan without coordinates; export it again.")
    kinds = {name: _kind(library, prototype[name]) for name in names}
    known = {*CARTESIAN, *SPHERICAL, *INVALID, *COLOUR, "intensity"}
    others = {name: kind for name, kind in kinds.items() if name not in known and kind is not None}
    read = {*places, *INVALID, *COLOUR, "intensity", *others}
    return Scan(
        number=number,
        count=points.childCount(),
        fields=tuple(name for name in names if name in read),
        rotation=_rotation(node),
        shift=_vector(node, "translation", "xyz", np.zeros(3)),
        intensity=_intensity_scale(_limits(node, prototype, "intensity")),
        rgb_factor=_rgb_factor(max(_limits(node, prototype, name)[1] for name in COLOUR)),
        attributes={_plain_name(name): kind for name, kind in others.items()},
    )


def _kind(library: Any, field: Any) -> Optional[np.dtype]:
    """Return the type for the values of a field of the prototype; None if they are no numbers."""
    if isinstance(field, library.IntegerNode):
        return np.promote_types(np.min_scalar_type(field.minimum()), np.min_scalar_type(field.maximum()))
    return np.dtype(np.float64) if isinstance(field, (library.ScaledIntegerNode, library.FloatNode)) else None


def _plain_name(name: str) -> str:
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
    field = prototype[name] if prototype.isDefined(name) else None
    if hasattr(field, "scaledMaximum"):
        return field.scaledMinimum(), field.scaledMaximum()
    # A number without limits of its own has those of its type, which tell nothing.
    narrow = field is not None and field.minimum() > -1e9 and field.maximum() < 1e9
    return (field.minimum(), field.maximum()) if narrow else (0.0, 1.0)


def _value(node: Any) -> float:
    return float(node.scaledValue() if hasattr(node, "scaledValue") else node.value())


def _intensity_scale(limits: tuple[float, float]) -> tuple[float, float]:
    low, high = limits
    # Many programs announce the range that occurs, which would make scans differ that do not.
    if low >= 0 and high <= 1:
        return 0.0, 65535.0
    return (-low, 65535 / (high - low)) if high > low else (0.0, 1.0)


def _rgb_factor(brightest: float) -> float:
    if brightest <= 1:
        return 65535.0
    return 257.0 if brightest <= 255 else 1.0


def _blocks(path: Path, scan: Scan, size: int) -> Iterator[dict[str, np.ndarray]]:
    """Yield the fields of the valid points, `size` points at a time with the others."""
    with _image(path) as (library, image):
        node = image.root()["data3D"][scan.number]
        arrays = {name: np.empty(size) for name in scan.fields}
        buffers = library.VectorSourceDestBuffer()
        for name, array in arrays.items():
            buffers.append(library.SourceDestBuffer(image, name, array, size, True, True))
        reader = node["points"].reader(buffers)
        while count := reader.read():
            valid = np.ones(count, bool)
            for name in scan.fields:
                if name in INVALID:
                    valid &= arrays[name][:count] == 0
                elif name in CARTESIAN or name in SPHERICAL:
                    valid &= np.isfinite(arrays[name][:count])
            yield {_plain_name(name): array[:count][valid] for name, array in arrays.items()}
        reader.close()


def _places(data: dict[str, np.ndarray], scan: Scan) -> np.ndarray:
    """Return where points lie in the file's coordinates, shape (n, 3)."""
    if set(CARTESIAN) <= data.keys():
        xyz = np.stack([data[name] for name in CARTESIAN], axis=1)
    else:
        distance, azimuth, elevation = (data[name] for name in SPHERICAL)
        level = distance * np.cos(elevation)
        xyz = np.stack(
            [level * np.cos(azimuth), level * np.sin(azimuth), distance * np.sin(elevation)], axis=1
        )
    return product(xyz, scan.rotation) + scan.shift
