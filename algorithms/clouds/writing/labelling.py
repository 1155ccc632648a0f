"""Write points of a cloud with one more attribute."""

from dataclasses import dataclass
from pathlib import Path
from typing import Optional, Union

import laspy
import numpy as np
from laspy.vlrs.vlrlist import VLRList

from ...files import atomic_output
from ...progress import Progress
from ..cloud import Cloud, parts
from ..formats.las import LasSource
from ..settings import WritingSettings
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


@dataclass(frozen=True)
class Labels:
    """The values of an attribute, and the positions of their points in the cloud; see `write_labelled`."""

    name: str
    values: np.ndarray
    kept: np.ndarray

    def of_chunk(self, start: int, count: int) -> tuple[np.ndarray, np.ndarray]:
        """Return the rows of the chunk that begins at point `start` that are kept, and their values."""
        first, last = np.searchsorted(self.kept, [start, start + count])
        return self.kept[first:last] - start, self.values[first:last]


def write_labelled(
    cloud: Cloud,
    name: str,
    values: np.ndarray,
    path: Union[str, Path],
    kept: Optional[np.ndarray] = None,
    progress: Progress = Progress(),
    settings: WritingSettings = WritingSettings(),
) -> None:
    """Write points of `cloud` to `path`, each with its value.

    LAS and LAZ files of one point format keep every attribute and get an extra dimension. Anything else
    becomes LAS 1.4 with coordinates, intensity, colour and the attributes that all files have, or text
    with a header line if `path` asks for it.

    Parameters
    ----------
    cloud : Cloud
    name : str
        Of the attribute.
    values : ndarray of an integer type, shape (k,)
    path : str or Path
        Ends in .las, .laz, .xyz, .txt or .csv.
    kept : ndarray of int64, shape (k,), optional
        Positions of the points in the sequence of all points of the cloud, ascending; all if not given.
    progress : Progress
    settings : WritingSettings

    Raises
    ------
    InputError
        If an input is damaged, or `path` is an input, cannot be written or has an extension that is not
        known.
    """
    target = Path(path)
    check_target(cloud, target)
    files = () if is_text(target) else of_one_point_format(cloud)
    doubts = (
        (*unlike_values(cloud, target), *unlike_times(files, target))
        if files
        else losses(cloud, target, _shared_attributes(cloud))
    )
    for sentence in doubts:
        progress.update(0.0, sentence)
    labels = Labels(name, values, np.arange(len(values)) if kept is None else kept)
    with atomic_output(target) as temporary:
        if is_text(target):
            _write_text(cloud, labels, temporary, progress, settings)
        elif files:
            _write_records(cloud, files, labels, temporary, progress, settings)
        else:
            _write_las(cloud, labels, temporary, progress, settings)


def _write_records(
    cloud: Cloud,
    files: tuple[LasSource, ...],
    labels: Labels,
    path: Path,
    progress: Progress,
    settings: WritingSettings,
) -> None:
    first = files[0]
    header, evlrs = copied_header(first.path)
    if labels.name not in header.point_format.dimension_names:
        header.add_extra_dim(laspy.ExtraBytesParams(labels.name, labels.values.dtype))
    if first.crs is None and cloud.crs is not None:
        evlrs = replace_crs(header, evlrs, cloud.crs)
    header.scales = common_scales(cloud, settings)
    depths = {source.colour_factor for source in files if source.has_rgb}
    done = 0
    with las_writer(path, header) as writer:
        for source, part in parts(files, progress):
            for records in source.records(part, settings.chunk_points):
                rows, values = labels.of_chunk(done, len(records))
                done += len(records)
                points = np.empty(len(rows), header.point_format.dtype())
                for field in records.dtype.names:
                    points[field] = records[field][rows]
                points[labels.name] = values
                rescale(points, source, header, path)
                if len(depths) > 1 and source.has_rgb:
                    widen_colour(points, source)
                writer.write_points(laspy.PackedPointRecord(points, header.point_format))
        if evlrs:
            writer.write_evlrs(VLRList(evlrs))


def _write_las(
    cloud: Cloud,
    labels: Labels,
    path: Path,
    progress: Progress,
    settings: WritingSettings,
) -> None:
    shared = _shared_attributes(cloud)
    has_rgb = any(source.has_rgb for source in cloud.sources)
    header = new_header(cloud.origin, common_scales(cloud, settings), has_rgb, cloud.crs)
    taken = {"x", "y", "z", labels.name, *header.point_format.dimension_names}
    shared = {attribute: kind for attribute, kind in shared.items() if attribute.lower() not in taken}
    for attribute, kind in (*shared.items(), (labels.name, labels.values.dtype)):
        header.add_extra_dim(laspy.ExtraBytesParams(attribute, kind))
    done = 0
    with las_writer(path, header) as writer:
        for chunk in cloud.chunks(progress, settings.chunk_points):
            rows, values = labels.of_chunk(done, len(chunk.xyz))
            done += len(chunk.xyz)
            points = las_points(chunk.subset(rows), header, path)
            for attribute in shared:
                points.array[attribute] = chunk.attributes[attribute][rows]
            points.array[labels.name] = values
            writer.write_points(points)


def _write_text(
    cloud: Cloud,
    labels: Labels,
    path: Path,
    progress: Progress,
    settings: WritingSettings,
) -> None:
    shared = _shared_attributes(cloud)
    done = 0
    with path.open("w", encoding="utf-8", newline="") as stream:
        for chunk in cloud.chunks(progress, settings.chunk_points):
            rows, values = labels.of_chunk(done, len(chunk.xyz))
            done += len(chunk.xyz)
            table = table_of(cloud, chunk.subset(rows))
            for attribute in shared:
                table[attribute] = chunk.attributes[attribute][rows]
            table[labels.name] = values
            append_rows(table, stream, path, settings)


def _shared_attributes(cloud: Cloud) -> dict[str, np.dtype]:
    """Return names and types of the attributes that all files have."""
    first, *others = (dict(source.attributes) for source in cloud.sources)
    return {name: kind for name, kind in first.items() if all(name in other for other in others)}
