"""Write chosen points of a cloud to a new file."""

from collections.abc import Iterator
from pathlib import Path
from typing import Union

import laspy
import numpy as np
from laspy.vlrs.vlrlist import VLRList

from ...errors import NothingFoundError
from ...files import atomic_output
from ...progress import Progress
from ..cloud import Cloud, parts
from ..formats.las import LasSource
from ..settings import WritingSettings
from ..source import Chunk
from .las_files import (
    common_scales,
    copied_header,
    las_points,
    las_writer,
    new_header,
    of_one_point_format,
    replace_crs,
    rescale,
    widen_colour,
)
from .losses import losses, unlike_times, unlike_values
from .target import check_target, is_text
from .text_files import append_rows, table_of


def write_cloud(
    cloud: Cloud,
    kept: np.ndarray,
    path: Union[str, Path],
    progress: Progress = Progress(),
    settings: WritingSettings = WritingSettings(),
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
    settings : WritingSettings

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
    files = () if is_text(target) else of_one_point_format(cloud)
    doubts = (*unlike_values(cloud, target), *unlike_times(files, target)) if files else losses(cloud, target)
    for sentence in doubts:
        progress.update(0.0, sentence)
    with atomic_output(target) as temporary:
        if is_text(target):
            written = _write_text(cloud, kept, temporary, progress, settings)
        elif files:
            written = _copy_records(cloud, files, kept, temporary, progress, settings)
        else:
            written = _write_las(cloud, kept, temporary, progress, settings)
    if written != len(kept):
        raise ValueError(f"{len(kept) - written} of the kept points are not in the cloud")
    return written


def _rows(kept: np.ndarray, start: int, count: int) -> np.ndarray:
    """Return which rows of the chunk that begins at point `start` are kept."""
    first, last = np.searchsorted(kept, [start, start + count])
    return kept[first:last] - start


def _kept_chunks(cloud: Cloud, kept: np.ndarray, progress: Progress, size: int) -> Iterator[Chunk]:
    start = 0
    for chunk in cloud.chunks(progress, size):
        rows = _rows(kept, start, len(chunk.xyz))
        start += len(chunk.xyz)
        yield chunk.subset(rows)


def _write_text(
    cloud: Cloud, kept: np.ndarray, path: Path, progress: Progress, settings: WritingSettings
) -> int:
    written = 0
    with path.open("w", encoding="utf-8", newline="") as stream:
        for chunk in _kept_chunks(cloud, kept, progress, settings.chunk_points):
            append_rows(table_of(cloud, chunk), stream, path, settings)
            written += len(chunk.xyz)
    return written


def _copy_records(
    cloud: Cloud,
    files: tuple[LasSource, ...],
    kept: np.ndarray,
    path: Path,
    progress: Progress,
    settings: WritingSettings,
) -> int:
    """Write the records as they are, with the header of the first file."""
    first = files[0]
    header, evlrs = copied_header(first.path)
    if first.crs is None and cloud.crs is not None:
        evlrs = replace_crs(header, evlrs, cloud.crs)
    header.scales = common_scales(cloud, settings)
    depths = {source.colour_factor for source in files if source.has_rgb}
    start = written = 0
    with las_writer(path, header) as writer:
        for source, part in parts(files, progress):
            for records in source.records(part, settings.chunk_points):
                points = records[_rows(kept, start, len(records))]
                start += len(records)
                rescale(points, source, header, path)
                if len(depths) > 1 and source.has_rgb:
                    widen_colour(points, source)
                writer.write_points(laspy.PackedPointRecord(points, writer.header.point_format))
                written += len(points)
        if evlrs:
            writer.write_evlrs(VLRList(evlrs))
    return written


def _write_las(
    cloud: Cloud, kept: np.ndarray, path: Path, progress: Progress, settings: WritingSettings
) -> int:
    """Write what all formats have in common."""
    has_rgb = any(source.has_rgb for source in cloud.sources)
    header = new_header(cloud.origin, common_scales(cloud, settings), has_rgb, cloud.crs)
    written = 0
    with las_writer(path, header) as writer:
        for chunk in _kept_chunks(cloud, kept, progress, settings.chunk_points):
            writer.write_points(las_points(chunk, header, path))
            written += len(chunk.xyz)
    return written
