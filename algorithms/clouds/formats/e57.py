"""E57, read by the libE57Format of the optional package pye57."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ...errors import InputError, MissingPackageError
from ...geometry.motion import product
from ...progress import Progress
from ...reference_systems import parse_wkt
from ..settings import ReadingSettings
from ..source import Chunk, Source, no_points, unreadable
from . import E57_PACKAGES
from .e57_scan import CARTESIAN, COLOUR, INVALID, SPHERICAL, Scan, describe, plain_name
from .normals import find_normals
from .stated_crs import read_crs
from .value_ranges import to_uint16


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
    def open(cls, path: Path, settings: ReadingSettings = ReadingSettings()) -> "E57Source":
        """Examine the headers and the first points of `path`.

        Raises
        ------
        MissingPackageError
            If pye57 is not installed.
        InputError
            If the file is not an E57, is damaged or holds no points.
        """
        with _image(path) as (library, image):
            root = image.root()
            nodes = root["data3D"] if root.isDefined("data3D") else []
            scans = tuple(describe(library, path, nodes[number], number) for number in range(len(nodes)))
            wkt = root["coordinateMetadata"].value() if root.isDefined("coordinateMetadata") else ""
        scans = tuple(scan for scan in scans if scan.count)
        blocks = (
            _positions(data, scan) for scan in scans for data in _blocks(path, scan, settings.sample_points)
        )
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
                positions = _positions(data, scan)
                if len(positions):
                    yield self._chunk(data, scan, positions - origin)
                left = max(left - size, 0)
                progress.update((done + scan.count - left) / total)
            done += scan.count

    def _chunk(self, data: dict[str, np.ndarray], scan: Scan, xyz: np.ndarray) -> Chunk:
        none = np.zeros(len(xyz))
        summand, factor = scan.intensity
        intensity = to_uint16((data["intensity"] + summand) * factor) if "intensity" in data else none
        rgb = np.stack([data.get(name, none) for name in COLOUR], axis=1) * scan.rgb_factor
        attributes = {name: data.get(name, none) for name, _ in self.attributes}
        normals = [list(attributes)[index] for index in find_normals(list(attributes)) or ()]
        if normals:
            rotated = product(np.stack([attributes[name] for name in normals], axis=1), scan.rotation)
            attributes.update(zip(normals, rotated.T))
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
            yield {plain_name(name): array[:count][valid] for name, array in arrays.items()}
        reader.close()


def _positions(data: dict[str, np.ndarray], scan: Scan) -> np.ndarray:
    """Return the positions of points in the file's coordinates, shape (n, 3)."""
    if set(CARTESIAN) <= data.keys():
        xyz = np.stack([data[name] for name in CARTESIAN], axis=1)
    else:
        distance, azimuth, elevation = (data[name] for name in SPHERICAL)
        level = distance * np.cos(elevation)
        xyz = np.stack(
            [level * np.cos(azimuth), level * np.sin(azimuth), distance * np.sin(elevation)], axis=1
        )
    return product(xyz, scan.rotation) + scan.shift
