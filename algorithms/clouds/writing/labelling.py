"""Write points of a cloud with one more attribute."""

from collections.abc import Collection, Mapping
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
    labelled: np.ndarray

    def of_chunk(self, start: int, count: int) -> np.ndarray:
        """Return the values of the chunk that begins at point `start`, 0 where there are none."""
        first, last = np.searchsorted(self.labelled, [start, start + count])
        values = np.zeros(count, self.values.dtype)
        values[self.labelled[first:last] - start] = self.values[first:last]
        return values


def write_labelled(
    cloud: Cloud,
    name: str,
    values: np.ndarray,
    path: Union[str, Path],
    labelled: Optional[np.ndarray] = None,
    progress: Progress = Progress(),
    settings: WritingSettings = WritingSettings(),
) -> None:
    """Write all points of `cloud` to `path`, each with its value.

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
    labelled : ndarray of int64, shape (k,), optional
        Positions of the points with these values in the sequence of all points of the cloud, ascending; all
        if not given. The others have 0.
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
    shared = {} if files else _shared_attributes(cloud, target, name, settings)
    doubts = (
        (*unlike_values(cloud, target), *unlike_times(files, target))
        if files
        else losses(cloud, target, shared)
    )
    for sentence in doubts:
        progress.update(0.0, sentence)
    labels = Labels(name, values, np.arange(len(values)) if labelled is None else labelled)
    with atomic_output(target) as temporary:
        if is_text(target):
            _write_text(cloud, shared, labels, temporary, progress, settings)
        elif files:
            _write_records(cloud, files, labels, temporary, progress, settings)
        else:
            _write_las(cloud, shared, labels, temporary, progress, settings)


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
                points = np.empty(len(records), header.point_format.dtype())
                for field in records.dtype.names:
                    points[field] = records[field]
                points[labels.name] = labels.of_chunk(done, len(records))
                done += len(records)
                rescale(points, source, header, path)
                if len(depths) > 1 and source.has_rgb:
                    widen_colour(points, source)
                writer.write_points(laspy.PackedPointRecord(points, header.point_format))
        if evlrs:
            writer.write_evlrs(VLRList(evlrs))


def _write_las(
    cloud: Cloud,
    shared: Mapping[str, np.dtype],
    labels: Labels,
    path: Path,
    progress: Progress,
    settings: WritingSettings,
) -> None:
    header = _new_header(cloud, settings)
    for attribute, kind in (*shared.items(), (labels.name, labels.values.dtype)):
        header.add_extra_dim(laspy.ExtraBytesParams(attribute, kind))
    done = 0
    with las_writer(path, header) as writer:
        for chunk in cloud.chunks(progress, settings.chunk_points):
            points = las_points(chunk, header, path)
            for attribute in shared:
                points.array[attribute] = chunk.attributes[attribute]
            points.array[labels.name] = labels.of_chunk(done, len(chunk.xyz))
            done += len(chunk.xyz)
            writer.write_points(points)


def _write_text(
    cloud: Cloud,
    shared: Collection[str],
    labels: Labels,
    path: Path,
    progress: Progress,
    settings: WritingSettings,
) -> None:
    done = 0
    with path.open("w", encoding="utf-8", newline="") as stream:
        for chunk in cloud.chunks(progress, settings.chunk_points):
            table = table_of(cloud, chunk)
            for attribute in shared:
                table[attribute] = chunk.attributes[attribute]
            table[labels.name] = labels.of_chunk(done, len(chunk.xyz))
            done += len(chunk.xyz)
            append_rows(table, stream, path, settings)


def _new_header(cloud: Cloud, settings: WritingSettings) -> laspy.LasHeader:
    has_rgb = any(source.has_rgb for source in cloud.sources)
    return new_header(cloud.origin, common_scales(cloud, settings), has_rgb, cloud.crs)


def _shared_attributes(
    cloud: Cloud, target: Path, name: str, settings: WritingSettings
) -> dict[str, np.dtype]:
    """Return names and types of the attributes that all files have and the target can hold beside `name`."""
    first, *others = (dict(source.attributes) for source in cloud.sources)
    shared = {
        attribute: kind for attribute, kind in first.items() if all(attribute in other for other in others)
    }
    if is_text(target):
        return shared
    # A new LAS file has dimensions of its own.
    taken = {"x", "y", "z", name, *_new_header(cloud, settings).point_format.dimension_names}
    return {attribute: kind for attribute, kind in shared.items() if attribute.lower() not in taken}
