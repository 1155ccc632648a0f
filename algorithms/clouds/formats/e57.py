"""E57, read by the libE57Format of the optional package pye57."""

from collections.abc import Iterator, Sequence
from contextlib import closing, contextmanager
from dataclasses import dataclass, replace
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
from .coordinate_steps import coordinate_warnings
from .e57_scan import CARTESIAN, COLOUR, INVALID, SPHERICAL, Scan, describe, plain_name
from .normals import find_normals, unnamed_normals
from .stated_crs import read_crs
from .value_ranges import intensity_scale, rgb_factor, scaled_colour, to_uint16

LARGEST_BLOCK = 2**28
"""Bytes of fields that are read at once, however many a scan has."""

LARGEST_AZIMUTH, LARGEST_ELEVATION = 2 * np.pi + 0.01, np.pi / 2 + 0.01
"""Radians, with some rounding."""


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
        samples = [(scan, _sample(path, scan, settings)) for scan in scans if scan.count]
        if not any(len(data[scan.coordinates[0]]) for scan, data in samples):
            raise no_points(path)
        for scan, data in samples:
            _refuse_degrees(path, scan, data)
        ranges = [_ranges(path, scan, data, settings) for scan, data in samples]
        factor = rgb_factor(np.concatenate([colours for colours, _ in ranges]))
        scans = tuple(
            replace(scan, rgb_factor=factor, intensity=intensity_scale(values, relative=True))
            for (scan, _), (_, values) in zip(samples, ranges)
        )
        crs, warnings = read_crs(path, lambda: parse_wkt(wkt) if wkt.strip() else None)
        first, sample = next(pair for pair in samples if len(pair[1][pair[0].coordinates[0]]))
        doubts = dict.fromkeys(
            sentence for scan, data in samples for sentence in (*scan.warnings, *_coarse(path, data))
        )
        return cls(
            path=path,
            crs=crs,
            warnings=(
                *warnings,
                *doubts,
                *_unlike(path, scans),
                *_unposed(path, scans),
                *unnamed_normals(path, {name: sample[name] for name in first.attributes}),
            ),
            middle=np.median(_positions(sample, first), axis=0),
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

    @property
    def expected_points(self) -> int:
        """See `Source.expected_points`."""
        return sum(scan.count for scan in self.scans)

    def chunks(self, origin: np.ndarray, progress: Progress, size: int) -> Iterator[Chunk]:
        """Yield all points in file order; see `Source.chunks`."""
        progress.update(0.0, f"Reading {self.path.name}")
        total, done = sum(scan.count for scan in self.scans), 0
        for scan in self.scans:
            left = scan.count
            for data in _blocks(self.path, scan, size):
                positions = _positions(data, scan)
                if len(positions):
                    yield self._chunk(data, scan, positions, origin)
                left = max(left - size, 0)
                progress.update((done + scan.count - left) / total)
            done += scan.count

    def _chunk(
        self, data: dict[str, np.ndarray], scan: Scan, positions: np.ndarray, origin: np.ndarray
    ) -> Chunk:
        xyz = positions - origin
        none = np.zeros(len(xyz))
        summand, factor = scan.intensity
        intensity = to_uint16((data["intensity"] + summand) * factor) if "intensity" in data else none
        rgb = np.stack([data.get(name, none) for name in COLOUR], axis=1)
        intensity[~_is_known(data, "isIntensityInvalid")] = 0
        rgb[~_is_known(data, "isColorInvalid")] = 0
        attributes = {name: data.get(name, none) for name, _ in self.attributes}
        normals = [list(attributes)[index] for index in find_normals(list(attributes)) or ()]
        if normals:
            rotated = product(np.stack([attributes[name] for name in normals], axis=1), scan.rotation)
            attributes.update(zip(normals, rotated.T))
        return Chunk(
            xyz,
            intensity.astype(np.uint16) if self.has_intensity else None,
            scaled_colour(self.path, rgb, scan.rgb_factor) if self.has_rgb else None,
            {name: attributes[name].astype(kind) for name, kind in self.attributes},
            np.full(len(xyz), scan.number),
            # Merged clouds have the pose of no scanner.
            scan.shift - origin if np.any(scan.shift) else None,
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
    except (libe57.E57Exception, UnicodeDecodeError) as error:
        # Some errors of the library have no text, or one with bytes of the file that are not letters.
        text = "" if isinstance(error, UnicodeDecodeError) else str(error).strip()
        detail = next(iter(text.splitlines()), "its parts contradict each other")
        raise InputError(f"{path} is truncated or damaged ({detail}); copy or export it again.") from error
    finally:
        if image is not None:
            image.close()


def _blocks(path: Path, scan: Scan, size: int) -> Iterator[dict[str, np.ndarray]]:
    """Yield the fields of the valid points, `size` points at a time with the others."""
    with _image(path) as (library, image):
        node = image.root()["data3D"][scan.number]
        size = max(min(size, scan.count, LARGEST_BLOCK // (8 * len(scan.fields))), 1)
        arrays = {name: np.empty(size) for name in scan.fields}
        buffers = library.VectorSourceDestBuffer()
        for name, array in arrays.items():
            buffers.append(library.SourceDestBuffer(image, name, array, size, True, True))
        # Whoever reads may stop early, and an open reader keeps its memory.
        with closing(node["points"].reader(buffers)) as reader:
            while count := reader.read():
                valid = np.ones(count, bool)
                for name in scan.fields:
                    if name in INVALID:
                        valid &= arrays[name][:count] == 0
                    elif name in CARTESIAN or name in SPHERICAL:
                        valid &= np.isfinite(arrays[name][:count])
                yield {plain_name(name): array[:count][valid] for name, array in arrays.items()}


def _sample(path: Path, scan: Scan, settings: ReadingSettings) -> dict[str, np.ndarray]:
    """Return the fields of some points of a scan: of all if it is small, else of the first that are valid.

    Points of an E57 are stored in packets that can only be read in sequence.
    """
    most = settings.whole_points
    found: list[dict[str, np.ndarray]] = []
    for data in _blocks(path, scan, most):
        found.append(data)
        if sum(len(block[scan.coordinates[0]]) for block in found):
            break
    return (
        {name: np.concatenate([block[name] for block in found]) for name in found[0]}
        if found
        else {plain_name(name): np.empty(0) for name in scan.fields}
    )


def _ranges(
    path: Path, scan: Scan, data: dict[str, np.ndarray], settings: ReadingSettings
) -> tuple[np.ndarray, np.ndarray]:
    """Return colours, shape (n, 3), and intensities that have the ranges of those of a scan.

    All points are looked at if the sample cannot show their range: where nothing, or a much wider range,
    is announced.
    """
    colours, intensity = _colours(data), _intensities(data)
    unsure = scan.is_colour_wider_than(colours) or scan.is_intensity_wider_than(intensity)
    is_sample = len(data[scan.coordinates[0]]) < scan.count
    if is_sample and unsure:
        for block in _blocks(path, scan, settings.chunk_points):
            colours = _extremes(np.concatenate([colours, _colours(block)]))
            intensity = _extremes(np.concatenate([intensity, _intensities(block)]))
    elif is_sample and len(colours) and scan.brightest > 1:
        colours = np.concatenate([colours, np.full((1, 3), scan.brightest)])
    if not scan.is_intensity_wider_than(intensity):
        intensity = np.concatenate([intensity, scan.intensity_limits])
    return colours, intensity


def _extremes(values: np.ndarray) -> np.ndarray:
    return np.stack([values.min(axis=0), values.max(axis=0)]) if len(values) else values


def _colours(data: dict[str, np.ndarray]) -> np.ndarray:
    """Return the colours that are known, shape (n, 3)."""
    if not set(COLOUR) <= data.keys():
        return np.empty((0, 3))
    colours = np.stack([data[name] for name in COLOUR], axis=1)
    return colours[_is_known(data, "isColorInvalid") & np.isfinite(colours).all(axis=1)]


def _intensities(data: dict[str, np.ndarray]) -> np.ndarray:
    """Return the intensities that are known, shape (n,)."""
    if "intensity" not in data:
        return np.empty(0)
    return data["intensity"][_is_known(data, "isIntensityInvalid") & np.isfinite(data["intensity"])]


def _is_known(data: dict[str, np.ndarray], mark: str) -> np.ndarray:
    """Return which points are not marked as having an invalid value."""
    count = len(next(iter(data.values())))
    return data[mark] == 0 if mark in data else np.ones(count, bool)


def _unlike(path: Path, scans: Sequence[Scan]) -> tuple[str, ...]:
    """Return a sentence if some scans have colour or intensity and others not."""
    lacking = [
        name
        for name, fields in (("intensity", {"intensity"}), ("colour", set(COLOUR)))
        if len({fields <= set(scan.fields) for scan in scans}) > 1
    ]
    if not lacking:
        return ()
    return (
        f"Some scans of {path} have no {' or '.join(lacking)}, which counts as 0 there; export all scans "
        "alike.",
    )


def _unposed(path: Path, scans: Sequence[Scan]) -> tuple[str, ...]:
    """Return a sentence if some scans have a pose and others not."""
    unposed = [str(scan.number + 1) for scan in scans if scan.count and not scan.has_pose]
    if not unposed or len(unposed) == sum(scan.count > 0 for scan in scans):
        return ()
    listed = ", ".join(unposed)
    return (
        f"Scan {listed} of {path} has no pose, though others have, and was not moved; check that it is "
        "registered.",
    )


def _refuse_degrees(path: Path, scan: Scan, data: dict[str, np.ndarray]) -> None:
    """Refuse angles of polar coordinates that cannot be the radians that E57 prescribes."""
    if scan.coordinates != SPHERICAL:
        return
    _, azimuth, elevation = (np.abs(data[name]).max(initial=0) for name in SPHERICAL)
    if azimuth > LARGEST_AZIMUTH or elevation > LARGEST_ELEVATION:
        raise InputError(
            f"{path} has angles of up to {max(azimuth, elevation):.0f}, though E57 prescribes radians; "
            "export it again with Cartesian coordinates."
        )


def _coarse(path: Path, data: dict[str, np.ndarray]) -> tuple[str, ...]:
    if not set(CARTESIAN) <= data.keys():
        return ()
    return coordinate_warnings(path, np.stack([data[name] for name in CARTESIAN], axis=1))


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
