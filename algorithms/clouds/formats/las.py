"""LAS, LAZ and COPC (which is a LAZ with an index), read by laspy and lazrs."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Optional

import laspy
import numpy as np
from rasterio.crs import CRS

from ...errors import InputError
from ...kernels import kernel
from ...parallel import ahead
from ...progress import Progress
from ...reference_systems import parse_wkt
from ..settings import PrecisionSettings, ReadingSettings
from ..source import Chunk, Source, no_points
from .coordinate_steps import coordinate_warnings
from .geotiff_keys import parse_geotiff_keys
from .las_layout import count_warning
from .las_reader import (
    EVERYTHING,
    LARGEST_BLOCK,
    Selection,
    can_seek,
    open_reader,
    read_records,
    seek,
    surplus_points,
)
from .normals import unnamed_normals
from .stated_crs import read_crs
from .value_ranges import scaled_colour

POSITIONS = Selection.base() | Selection.Z | Selection.CLASSIFICATION | Selection.FLAGS
"""What is decoded for the positions of the points that count."""

LOW_NOISE, HIGH_NOISE = 7, 18
"""Classes of the LAS specification; the second one of the newer point formats only."""

RETURNS = ("return_number", "number_of_returns")
"""Dimensions that are 0 or 1 where nothing else is known."""


@dataclass(frozen=True)
class LasSource(Source):
    """A LAS or LAZ file.

    Points that are flagged as withheld or classified as noise are left out. An intensity or a colour that is
    zero in all sampled points counts as absent. A colour that is below
    256 in all of them counts as 8 bits in a 16-bit field. The header's bounding box is never used,
    because octree exports write the box of their tree there.

    Attributes
    ----------
    point_count : int
    point_format : laspy.PointFormat
    scales, offsets : ndarray of float64, shape (3,)
    colour_factor : int
        257 for 8-bit colour, else 1.
    dimensions : tuple of str
        The dimensions besides coordinates, intensity and colour that hold anything in the sampled points.
    start : int
        Number of the first point in the file.
    can_start_anywhere : bool
        Whether points can be read without those before.
    """

    point_count: int
    point_format: laspy.PointFormat
    scales: np.ndarray
    offsets: np.ndarray
    colour_factor: int
    dimensions: tuple[str, ...]
    start: int = 0
    can_start_anywhere: bool = False

    @classmethod
    def open(cls, path: Path, settings: ReadingSettings = ReadingSettings()) -> "LasSource":
        """Examine the header and a few thousand points of `path`.

        Raises
        ------
        InputError
            If the file is not a LAS, is truncated, is damaged or holds no points.
        """
        with open_reader(path) as reader:
            header = reader.header
            _check_scales(path, header)
            sample = _sample(path, reader, settings)
            can_start_anywhere = can_seek(reader)
            crs, warnings = read_crs(path, partial(_parse_crs, header))
        usable = is_usable(sample)
        if not usable.any():
            raise no_points(path)
        share, sample = float(usable.mean()), sample[usable]
        xyz = coordinates(sample, header.scales, header.offsets)
        rgb = _colour(sample)
        brightest = 0 if rgb is None else rgb.max()
        return cls(
            path=path,
            crs=crs,
            warnings=(
                *warnings,
                *count_warning(path),
                *surplus_points(path),
                *_left_out(path, 1 - share),
                *_coordinate_warnings(path, header.scales, xyz, crs),
                *unnamed_normals(path, _extra(sample, header.point_format)),
            ),
            middle=np.median(xyz, axis=0),
            has_intensity=bool(sample["intensity"].any()),
            has_rgb=brightest > 0,
            point_count=header.point_count,
            point_format=header.point_format,
            scales=header.scales,
            offsets=header.offsets,
            colour_factor=257 if brightest < 256 else 1,
            dimensions=_dimensions(sample, header.point_format),
            can_start_anywhere=can_start_anywhere,
        )

    @property
    def others(self) -> tuple[str, ...]:
        """See `Source.others`."""
        return self.dimensions

    def chunks(self, origin: np.ndarray, progress: Progress, size: int) -> Iterator[Chunk]:
        """Yield all points in file order; see `Source.chunks`."""
        wanted = POSITIONS | Selection.INTENSITY | Selection.RGB | Selection.POINT_SOURCE_ID
        for points in self.records(progress, size, wanted):
            yield Chunk(
                coordinates(points, self.scales, self.offsets - origin),
                points["intensity"].copy() if self.has_intensity else None,
                self._scaled_colour(points) if self.has_rgb else None,
                scan=points["point_source_id"].copy(),
            )

    def positions(self, origin: np.ndarray, progress: Progress, size: int) -> Iterator[np.ndarray]:
        """Yield the positions of all points in file order; see `Source.positions`."""
        for points in self.records(progress, size, POSITIONS):
            yield coordinates(points, self.scales, self.offsets - origin)

    def runs(self, points: int) -> tuple[Source, ...]:
        """See `Source.runs`."""
        if not self.can_start_anywhere:
            return (self,)
        stop = self.start + self.point_count
        return tuple(
            replace(self, start=start, point_count=min(points, stop - start))
            for start in range(self.start, stop, points)
        )

    @property
    def expected_points(self) -> int:
        """See `Source.expected_points`."""
        return self.point_count

    def records(
        self,
        progress: Progress,
        size: int,
        selection: laspy.DecompressionSelection = EVERYTHING,
        with_unusable: bool = False,
    ) -> Iterator[np.ndarray]:
        """Yield the raw point records in file order, `size` at a time.

        Parameters
        ----------
        selection : laspy.DecompressionSelection
            The dimensions that are needed; the others are undefined.
        with_unusable : bool
            Whether points that are withheld or noise are among them.

        Yields
        ------
        ndarray, shape (n,)
            Structured, with the dtype of the point format.

        Raises
        ------
        InputError
            If the file ends early or cannot be decompressed.
        """
        progress.update(0.0, f"Reading {self.path.name}")
        read = left_out = 0
        for points in ahead(self._decoded(size, selection)):
            read += len(points)
            if not with_unusable:
                usable = is_usable(points)
                left_out += len(points) - int(usable.sum())
                points = points if usable.all() else points[usable]
            yield points
            progress.update(read / self.point_count)
        if left_out:
            progress.update(
                1.0, f"{self.path.name}: {left_out} withheld points and points of noise were left out."
            )

    def _decoded(self, size: int, selection: laspy.DecompressionSelection) -> Iterator[np.ndarray]:
        size = min(size, LARGEST_BLOCK // self.point_format.size)
        with open_reader(self.path, selection) as reader:
            if self.start:
                seek(self.path, reader, self.start)
            for start in range(0, self.point_count, size):
                yield read_records(self.path, reader, min(size, self.point_count - start))

    def _scaled_colour(self, points: np.ndarray) -> np.ndarray:
        rgb = _colour(points)
        return rgb if self.colour_factor == 1 else scaled_colour(self.path, rgb, self.colour_factor)


def is_usable(points: np.ndarray) -> np.ndarray:
    """Return which raw records are neither flagged as withheld nor classified as noise; bool, shape (n,)."""
    if "raw_classification" in points.dtype.names:
        flags, withheld = points["raw_classification"], 0b1000_0000
        noise = flags & 0b1_1111 == LOW_NOISE
    else:
        flags, withheld = points["classification_flags"], 0b100
        noise = np.isin(points["classification"], (LOW_NOISE, HIGH_NOISE))
    return ~(noise | (flags & withheld > 0))


def _left_out(path: Path, share: float) -> tuple[str, ...]:
    if not share:
        return ()
    return (
        f"{share:.1%} of the points of {path} are flagged as withheld or classified as noise, and are left "
        "out; change their class where they are wanted.",
    )


def _extra(sample: np.ndarray, point_format: laspy.PointFormat) -> dict[str, np.ndarray]:
    """Return the single numbers among the extra dimensions, by name."""
    return {
        item.name: sample[item.name] * np.ravel(1.0 if item.scales is None else item.scales)[0]
        for item in point_format.extra_dimensions
        if sample[item.name].ndim == 1
    }


def _dimensions(sample: np.ndarray, point_format: laspy.PointFormat) -> tuple[str, ...]:
    """Return the names of the dimensions besides coordinates, intensity and colour that are not empty."""
    records = laspy.PackedPointRecord(sample, point_format)
    common = {"X", "Y", "Z", "intensity", "red", "green", "blue"}
    return tuple(
        name
        for name in point_format.dimension_names
        if name not in common and np.any(~np.isin(records[name], (0, 1) if name in RETURNS else 0))
    )


def _coordinate_warnings(
    path: Path, scales: np.ndarray, xyz: np.ndarray, crs: Optional[CRS]
) -> tuple[str, ...]:
    """Return the sentences on the coordinates, of which a reference system states the unit."""
    return _coarse_scale(path, scales) or coordinate_warnings(path, xyz, unit_stated=crs is not None)


def _coarse_scale(
    path: Path, scales: np.ndarray, settings: PrecisionSettings = PrecisionSettings()
) -> tuple[str, ...]:
    """Return a sentence if the scale of the header rounds coordinates by more than scanners measure."""
    step = float(np.abs(scales).max())
    if step < settings.coarsest_scale_m:
        return ()
    return (
        f"The coordinates of {path} lie in steps of {step:.2g} m, the scale in its header; export it with a "
        "scale of 0.001 m or finer.",
    )


def _check_scales(path: Path, header: laspy.LasHeader) -> None:
    with np.errstate(over="ignore", invalid="ignore"):
        farthest = np.abs(header.scales) * 2.0**31 + np.abs(header.offsets)
    if not (np.isfinite(farthest).all() and np.all(header.scales)):
        raise InputError(
            f"{path} has coordinates that are not numbers because the scale or offset in "
            "its header is not valid; export it again."
        )
    if np.prod(np.sign(header.scales)) < 0:
        raise InputError(f"{path} is mirrored by a negative scale in its header; export it again.")


def _sample(path: Path, reader: laspy.LasReader, settings: ReadingSettings) -> np.ndarray:
    """Return the records of a few short runs spread over the whole file."""
    count, size = reader.header.point_count, settings.run_points
    if count <= settings.whole_points:
        return read_records(path, reader, count)
    if not can_seek(reader):
        # lazrs seeks to the wrong point in a COPC, which starts with points from all over the site.
        return read_records(path, reader, min(settings.runs * size, count))
    runs = []
    for start in np.unique(np.linspace(0, max(count - size, 0), settings.runs).astype(np.int64)):
        seek(path, reader, int(start))
        runs.append(read_records(path, reader, min(size, count)))
    return np.concatenate(runs)


def coordinates(points: np.ndarray, scales: np.ndarray, offsets: np.ndarray) -> np.ndarray:
    """Return the coordinates of raw records, shape (n, 3)."""
    return _coordinates(points["X"], points["Y"], points["Z"], scales, offsets)


@kernel
def _coordinates(
    x: np.ndarray, y: np.ndarray, z: np.ndarray, scales: np.ndarray, offsets: np.ndarray
) -> np.ndarray:
    xyz = np.empty((len(x), 3))
    for i in range(len(x)):
        xyz[i, 0] = x[i] * scales[0] + offsets[0]
        xyz[i, 1] = y[i] * scales[1] + offsets[1]
        xyz[i, 2] = z[i] * scales[2] + offsets[2]
    return xyz


def _colour(points: np.ndarray) -> Optional[np.ndarray]:
    if "red" not in points.dtype.names:
        return None
    return np.stack([points["red"], points["green"], points["blue"]], axis=1)


def _parse_crs(header: laspy.LasHeader) -> Optional[CRS]:
    """Return the horizontal system in the records of `header`; ValueError if it cannot be understood."""
    records = {
        record.record_id: record.record_data_bytes()
        for record in [*(header.evlrs or []), *header.vlrs]
        if record.user_id == "LASF_Projection"
    }
    wkt = records.get(2112, b"").decode("utf-8").strip("\0 \n")
    if wkt:
        return parse_wkt(wkt)
    if 34735 in records:
        return parse_geotiff_keys(*[records.get(key, b"") for key in (34735, 34736, 34737)])
    return None
