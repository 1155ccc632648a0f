"""LAS, LAZ and COPC (which is a LAZ with an index), read by laspy and lazrs."""

import struct
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import BinaryIO, Optional

import laspy
import lazrs
import numpy as np
from rasterio.crs import CRS

from ...errors import InputError
from ...progress import Progress
from ...reference_systems import parse_wkt
from ..source import Chunk, Source, no_points, unreadable
from .geotiff_keys import parse_geotiff_keys
from .stated_crs import read_crs

SAMPLES = 8
SAMPLE_SIZE = 1000
LARGEST_CHUNK = 1_000_000

Selection = laspy.DecompressionSelection
EVERYTHING = Selection.all()


@dataclass(frozen=True)
class LasSource(Source):
    """A LAS or LAZ file.

    An intensity or a colour that is zero in all sampled points counts as absent, and a colour
    that stays below 256 there as 8 bits in a 16-bit field. The header's bounding box is never
    used: octree exports put the box of the tree there.

    Attributes
    ----------
    point_count : int
    point_format : laspy.PointFormat
    scales, offsets : ndarray of float64, shape (3,)
    colour_factor : int
        257 for 8-bit colour, else 1.
    """

    point_count: int
    point_format: laspy.PointFormat
    scales: np.ndarray
    offsets: np.ndarray
    colour_factor: int

    @classmethod
    def open(cls, path: Path) -> "LasSource":
        """Look into the header and a few thousand points of `path`.

        Raises
        ------
        InputError
            If the file is no LAS, is truncated, is damaged or holds no points.
        """
        with open_reader(path) as reader:
            header = reader.header
            _check_scales(path, header)
            sample = _sample(path, reader)
            crs, warnings = read_crs(path, partial(_parse_crs, header))
        xyz = coordinates(sample, header.scales, header.offsets)
        rgb = _colour(sample)
        brightest = 0 if rgb is None else rgb.max()
        return cls(
            path=path,
            crs=crs,
            warnings=warnings,
            middle=np.median(xyz, axis=0),
            has_intensity=bool(sample["intensity"].any()),
            has_rgb=brightest > 0,
            point_count=header.point_count,
            point_format=header.point_format,
            scales=header.scales,
            offsets=header.offsets,
            colour_factor=257 if brightest < 256 else 1,
        )

    def chunks(self, origin: np.ndarray, progress: Progress, size: int) -> Iterator[Chunk]:
        """Yield all points in file order; see `Source.chunks`."""
        wanted = (
            Selection.base() | Selection.INTENSITY | Selection.RGB | Selection.Z | Selection.POINT_SOURCE_ID
        )
        for points in self.records(progress, size, wanted):
            yield Chunk(
                coordinates(points, self.scales, self.offsets - origin),
                points["intensity"].copy() if self.has_intensity else None,
                self._scaled_colour(points) if self.has_rgb else None,
                scan=points["point_source_id"].copy(),
            )

    def records(
        self, progress: Progress, size: int, selection: Selection = EVERYTHING
    ) -> Iterator[np.ndarray]:
        """Yield the raw point records in file order, `size` at a time.

        Parameters
        ----------
        selection : laspy.DecompressionSelection
            The dimensions that matter; others may hold anything.

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
        with open_reader(self.path, selection) as reader:
            for start in range(0, self.point_count, size):
                points = _read(self.path, reader, min(size, self.point_count - start))
                yield points
                progress.update((start + len(points)) / self.point_count)

    def _scaled_colour(self, points: np.ndarray) -> np.ndarray:
        rgb = _colour(points)
        if self.colour_factor == 1:
            return rgb
        return np.minimum(rgb, 255) * np.uint16(self.colour_factor)


@contextmanager
def open_reader(path: Path, selection: Selection = EVERYTHING) -> Iterator[laspy.LasReader]:
    """Open `path` with laspy, once its header is found to agree with its length.

    Raises
    ------
    InputError
        If the file is no LAS, is truncated, is damaged or holds no points.
    """
    with _as_input_error(path):
        stream = path.open("rb")
    with stream:
        _check_layout(path, stream)
        stream.seek(0)
        with _as_input_error(path):
            reader = laspy.LasReader(stream, closefd=False, decompression_selection=selection)
            _check_chunk_size(path, reader.header)
        yield reader


@contextmanager
def _as_input_error(path: Path) -> Iterator[None]:
    try:
        yield
    except (KeyboardInterrupt, SystemExit, InputError):
        raise
    except OSError as error:
        raise unreadable(path, error) from error
    # A panic of lazrs derives from BaseException; damaged bytes raise nearly anything.
    except BaseException as error:
        raise _damaged(path, f"it cannot be decoded: {error}") from error


def _damaged(path: Path, detail: str) -> InputError:
    return InputError(f"{path} is truncated or damaged ({detail}); copy or export it again.")


def _check_layout(path: Path, stream: BinaryIO) -> None:
    """Refuse a header that contradicts the length of the file, before laspy trusts it."""
    size = path.stat().st_size
    head = stream.read(375)
    if head[:4] != b"LASF":
        raise InputError(f"{path} is not a LAS or LAZ file; give it the extension of its format.")
    if len(head) < 227 or (head[25] >= 4 and len(head) < 375):
        raise _damaged(path, "it ends within the header")
    header_size, data_start, vlrs, kind, record_size, count = struct.unpack_from("<HIIBHI", head, 94)
    evlr_start, evlrs = 0, 0
    if head[25] >= 4:
        evlr_start, evlrs, count = struct.unpack_from("<QIQ", head, 235)
    if header_size + 54 * vlrs > data_start or evlr_start + 60 * evlrs > size:
        raise _damaged(path, "its header announces more records than it has room for")
    if count == 0:
        raise no_points(path)
    compressed = kind & 0b1100_0000
    if not compressed and data_start + count * record_size > size:
        raise _damaged(path, f"its header announces {count} points, but it ends before the last")
    if compressed:
        _check_chunk_table(path, stream, data_start, size)


def _check_chunk_table(path: Path, stream: BinaryIO, data_start: int, size: int) -> None:
    """Refuse a table that lies beyond the end, or whose size would make lazrs abort."""

    def integer(position: int, code: str) -> int:
        stream.seek(position)
        value = stream.read(struct.calcsize(code))
        if len(value) < struct.calcsize(code):
            raise _damaged(path, "it ends before the table of its compressed chunks")
        return struct.unpack(code, value)[0]

    table = integer(data_start, "<q")
    if table == -1:
        table = integer(size - 8, "<q")
    if not data_start < table < size or integer(table + 4, "<I") > size:
        raise _damaged(path, "the table of its compressed chunks is missing")


def _check_chunk_size(path: Path, header: laspy.LasHeader) -> None:
    """Refuse a chunk for which lazrs would claim more memory than there is, and abort."""
    laszip = _laszip_record(header)
    if laszip is None or laszip.uses_variable_size_chunks():
        return
    if laszip.chunk_size() > max(header.point_count, LARGEST_CHUNK):
        raise _damaged(path, "its compressed chunks are larger than the file")


def _check_scales(path: Path, header: laspy.LasHeader) -> None:
    with np.errstate(over="ignore", invalid="ignore"):
        farthest = np.abs(header.scales) * 2.0**31 + np.abs(header.offsets)
    if not (np.isfinite(farthest).all() and np.all(header.scales)):
        raise InputError(
            f"{path} has coordinates that are not numbers, for the scale or offset in its "
            "header is not valid; export it again."
        )


def _sample(path: Path, reader: laspy.LasReader) -> np.ndarray:
    """Return the records of a few short runs spread over the whole file."""
    count = reader.header.point_count
    if _has_chunks_of_any_size(reader.header):
        # There lazrs seeks to the wrong point; a COPC starts with points from all over the site.
        return _read(path, reader, min(SAMPLES * SAMPLE_SIZE, count))
    runs = []
    for start in np.unique(np.linspace(0, max(count - SAMPLE_SIZE, 0), SAMPLES).astype(int)):
        with _as_input_error(path):
            reader.seek(int(start))
        runs.append(_read(path, reader, min(SAMPLE_SIZE, count)))
    return np.concatenate(runs)


def _has_chunks_of_any_size(header: laspy.LasHeader) -> bool:
    laszip = _laszip_record(header)
    return laszip is not None and laszip.uses_variable_size_chunks()


def _laszip_record(header: laspy.LasHeader) -> Optional[lazrs.LazVlr]:
    records = header.vlrs.get("LasZipVlr")
    return lazrs.LazVlr(records[0].record_data) if records else None


def _read(path: Path, reader: laspy.LasReader, count: int) -> np.ndarray:
    with _as_input_error(path):
        points = reader.read_points(count).array
    if len(points) < count:
        raise _damaged(path, "it ends before its last point")
    return points


def coordinates(points: np.ndarray, scales: np.ndarray, offsets: np.ndarray) -> np.ndarray:
    """Return the coordinates of raw records, shape (n, 3)."""
    xyz = np.empty((len(points), 3))
    for axis, name in enumerate("XYZ"):
        xyz[:, axis] = points[name]
    xyz *= scales
    xyz += offsets
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
