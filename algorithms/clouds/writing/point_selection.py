"""Write chosen points of a cloud to a new file."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Optional, TextIO, Union

import laspy
import lazrs
import numpy as np
import pandas as pd
from laspy.vlrs.known import WktCoordinateSystemVlr
from laspy.vlrs.vlrlist import VLRList
from rasterio.crs import CRS

from ...errors import InputError, NothingFoundError
from ...files import atomic_output
from ...progress import Progress
from ..cloud import Cloud, parts
from ..formats import format_of, writable_formats
from ..formats.las import LasSource, open_reader
from ..source import Chunk

CHUNK_SIZE = 1_000_000

# Coordinates that must be stored anew: to a tenth of a millimetre, finer if the input is finer,
# but not so fine that 32 bits no longer span a site.
COARSEST_SCALE, FINEST_SCALE = 1e-4, 1e-5


def write_cloud(
    cloud: Cloud,
    kept: np.ndarray,
    path: Union[str, Path],
    progress: Progress = Progress(),
) -> int:
    """Write the points `kept` of `cloud` to `path` and return their number.

    LAS and LAZ files of one point format keep every attribute. Anything else becomes LAS 1.4 with
    coordinates, intensity and colour, or text with a header line if `path` asks for it, with
    colours 0..255.

    Parameters
    ----------
    cloud : Cloud
    kept : ndarray of int64, shape (k,)
        Positions of the points in the sequence of all points of the cloud, ascending.
    path : str or Path
        Ends in .las, .laz, .xyz, .txt or .csv.
    progress : Progress

    Raises
    ------
    InputError
        If an input is damaged, or `path` is an input, cannot be written or has an extension
        that is not known.
    NothingFoundError
        If `kept` is empty.
    """
    target = Path(path)
    check_target(cloud, target)
    if not len(kept):
        raise NothingFoundError(f"No point is left to write to {target}.")
    with atomic_output(target) as temporary:
        if is_text(target):
            written = _write_text(cloud, kept, temporary, progress)
        elif have_one_point_format(cloud):
            written = _copy_records(cloud, kept, temporary, progress)
        else:
            written = _write_las(cloud, kept, temporary, progress)
    if written != len(kept):
        raise ValueError(f"{len(kept) - written} of the kept points are not in the cloud")
    return written


def check_target(cloud: Cloud, target: Path) -> None:
    """Refuse a path that cannot be written.

    Raises
    ------
    InputError
        If its extension is not known, or it is an input.
    """
    known = format_of(target)
    if known is None or not known.is_written or target.name.lower().endswith(".copc.laz"):
        raise InputError(f"{target} has an extension that cannot be written; choose {writable_formats()}.")
    if target.resolve() in [source.path.resolve() for source in cloud.sources]:
        raise InputError(f"{target} is an input as well; choose another name for the output.")


def is_text(target: Path) -> bool:
    """Whether a file that can be written holds lines of text."""
    known = format_of(target)
    return known is not None and known.is_text


def _rows(kept: np.ndarray, start: int, count: int) -> np.ndarray:
    """Return which rows of the chunk that begins at point `start` are kept."""
    first, last = np.searchsorted(kept, [start, start + count])
    return kept[first:last] - start


def _kept_chunks(cloud: Cloud, kept: np.ndarray, progress: Progress) -> Iterator[Chunk]:
    start = 0
    for chunk in cloud.chunks(progress, CHUNK_SIZE):
        rows = _rows(kept, start, len(chunk.xyz))
        start += len(chunk.xyz)
        yield Chunk(
            chunk.xyz[rows],
            None if chunk.intensity is None else chunk.intensity[rows],
            None if chunk.rgb is None else chunk.rgb[rows],
        )


def _write_text(cloud: Cloud, kept: np.ndarray, path: Path, progress: Progress) -> int:
    written = 0
    with path.open("w", encoding="utf-8", newline="") as stream:
        for chunk in _kept_chunks(cloud, kept, progress):
            append_rows(table_of(cloud, chunk), stream, path)
            written += len(chunk.xyz)
    return written


def table_of(cloud: Cloud, chunk: Chunk) -> pd.DataFrame:
    """Return points as rows of what all text files of a cloud have."""
    table = pd.DataFrame(chunk.xyz + cloud.origin, columns=["x", "y", "z"])
    if any(source.has_intensity for source in cloud.sources):
        table["intensity"] = 0 if chunk.intensity is None else chunk.intensity
    if any(source.has_rgb for source in cloud.sources):
        colour = 0 if chunk.rgb is None else np.rint(chunk.rgb / 257).astype(np.uint8)
        table[["red", "green", "blue"]] = colour
    return table


def append_rows(table: pd.DataFrame, stream: TextIO, path: Path) -> None:
    """Write rows to a text file, after a header if they are its first."""
    table.to_csv(
        stream,
        sep=format_of(path).separator,
        header=stream.tell() == 0,
        index=False,
        float_format="%.5f",
    )


def have_one_point_format(cloud: Cloud) -> bool:
    """Tell whether the raw records of all files fit into one output."""
    if not all(isinstance(source, LasSource) for source in cloud.sources):
        return False
    formats = [source.point_format for source in cloud.sources]
    # Waveforms stand elsewhere in the file, where the records of a new file would not find them.
    return not formats[0].has_waveform_packet and all(
        other.id == formats[0].id and _extra(other) == _extra(formats[0]) for other in formats
    )


def _extra(point_format: laspy.PointFormat) -> list[tuple]:
    return [
        (extra.name, extra.dtype, *np.ravel([extra.scales, extra.offsets]).tolist())
        for extra in point_format.extra_dimensions
    ]


def _copy_records(cloud: Cloud, kept: np.ndarray, path: Path, progress: Progress) -> int:
    """Write the records as they are, with the header of the first file."""
    first = cloud.sources[0]
    header, evlrs = copied_header(first.path)
    if first.crs is None and cloud.crs is not None:
        evlrs = replace_crs(header, evlrs, cloud.crs)
    header.scales = common_scales(cloud)
    start = written = 0
    with las_writer(path, header) as writer:
        for source, part in parts(cloud.sources, progress):
            for records in source.records(part, CHUNK_SIZE):
                points = records[_rows(kept, start, len(records))]
                start += len(records)
                rescale(points, source, header, path)
                writer.write_points(laspy.PackedPointRecord(points, writer.header.point_format))
                written += len(points)
        if evlrs:
            writer.write_evlrs(VLRList(evlrs))
    return written


def copied_header(path: Path) -> tuple[laspy.LasHeader, list[laspy.VLR]]:
    """Return the header of a LAS file for a new one, and the records that follow its points."""
    with open_reader(path) as reader:
        header = reader.header
    header.vlrs[:] = [record for record in header.vlrs if record.user_id != "copc"]
    if header.version < laspy.header.Version(1, 2):
        header.version = laspy.header.Version(1, 2)
    return header, [record for record in header.evlrs or [] if record.user_id != "copc"]


def replace_crs(header: laspy.LasHeader, evlrs: list[laspy.VLR], crs: Optional[CRS]) -> list[laspy.VLR]:
    """Make `crs` the reference system of `header`; return `evlrs` without those that name another."""
    header.vlrs[:] = [record for record in header.vlrs if record.user_id != "LASF_Projection"]
    if crs is not None:
        if header.version < laspy.header.Version(1, 4):
            header.version = laspy.header.Version(1, 4)
        header.vlrs.append(WktCoordinateSystemVlr(crs.to_wkt()))
    # The newer point formats know nothing else than WKT.
    header.global_encoding.wkt = crs is not None or header.point_format.id >= 6
    return [record for record in evlrs if record.user_id != "LASF_Projection"]


def _write_las(cloud: Cloud, kept: np.ndarray, path: Path, progress: Progress) -> int:
    """Write what all formats have in common."""
    if any(isinstance(source, LasSource) for source in cloud.sources):
        progress.update(0.0, "The point formats differ, so only coordinates, intensity and colour are kept.")
    has_rgb = any(source.has_rgb for source in cloud.sources)
    header = laspy.LasHeader(version="1.4", point_format=7 if has_rgb else 6)
    header.scales, header.offsets = common_scales(cloud), cloud.origin
    replace_crs(header, [], cloud.crs)
    written = 0
    with las_writer(path, header) as writer:
        for chunk in _kept_chunks(cloud, kept, progress):
            writer.write_points(las_points(chunk, header, path))
            written += len(chunk.xyz)
    return written


def las_points(chunk: Chunk, header: laspy.LasHeader, path: Path) -> laspy.PackedPointRecord:
    """Return records with what all formats have in common; the offset of `header` is the chunk's origin.

    Raises
    ------
    InputError
        If a coordinate needs more than 32 bits.
    """
    points = laspy.PackedPointRecord.zeros(len(chunk.xyz), header.point_format)
    for axis, name in enumerate("XYZ"):
        points[name] = stored(chunk.xyz[:, axis], header.scales[axis], path)
    points["return_number"] = points["number_of_returns"] = np.ones(len(points), np.uint8)
    if chunk.intensity is not None:
        points["intensity"] = chunk.intensity
    if chunk.rgb is not None:
        points[["red", "green", "blue"]] = chunk.rgb
    return points


@contextmanager
def las_writer(path: Path, header: laspy.LasHeader) -> Iterator[laspy.LasWriter]:
    """Open `path` to write points after `header`, compressed if its extension says so.

    Raises
    ------
    OSError
        If the points cannot be written.
    """
    compress = path.suffix.lower() == ".laz"
    try:
        with (
            path.open("wb") as stream,
            laspy.LasWriter(stream, header, do_compress=compress, closefd=False) as writer,
        ):
            yield writer
    except lazrs.LazrsError as error:
        raise OSError(str(error)) from error


def common_scales(cloud: Cloud) -> np.ndarray:
    """Return the scales (m) at which the coordinates of all files can be stored."""
    files = [source for source in cloud.sources if isinstance(source, LasSource)]
    if len(files) == len(cloud.sources):
        scales = files[0].scales
        steps = [(file.offsets - files[0].offsets) / scales for file in files]
        same = all(np.array_equal(file.scales, scales) for file in files)
        if same and np.allclose(steps, np.rint(steps), rtol=0, atol=1e-6):
            return scales
    finest = np.min([np.full(3, COARSEST_SCALE), *(file.scales for file in files)], axis=0)
    return np.maximum(finest, FINEST_SCALE)


def rescale(points: np.ndarray, source: LasSource, header: laspy.LasHeader, path: Path) -> None:
    """Bring the coordinates from the scale and offset of `source` to those of `header`."""
    for axis, name in enumerate("XYZ"):
        scale, shift = source.scales[axis], source.offsets[axis] - header.offsets[axis]
        if scale != header.scales[axis] or shift:
            points[name] = stored(points[name] * scale + shift, header.scales[axis], path)


def stored(values: np.ndarray, scale: float, path: Path) -> np.ndarray:
    """Return the integers that stand for `values` in a LAS file.

    Raises
    ------
    InputError
        If they need more than 32 bits.
    """
    whole = np.rint(values / scale)
    if np.any(np.abs(whole) > np.iinfo(np.int32).max):
        raise InputError(
            f"{path.name} cannot hold points that lie so far apart; remove the points far away, "
            "or choose a text file."
        )
    return whole.astype(np.int32)
