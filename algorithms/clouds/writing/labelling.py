"""Write all points of a cloud with one more attribute."""

from pathlib import Path
from typing import Union

import laspy
import numpy as np
from laspy.vlrs.vlrlist import VLRList

from ...files import atomic_output
from ...progress import Progress
from ..cloud import Cloud, parts
from .point_selection import (
    CHUNK_SIZE,
    append_rows,
    check_target,
    common_scales,
    copied_header,
    have_one_point_format,
    is_text,
    las_points,
    las_writer,
    replace_crs,
    rescale,
    table_of,
)


def write_labelled(
    cloud: Cloud, name: str, values: np.ndarray, path: Union[str, Path], progress: Progress = Progress()
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
    values : ndarray of an integer type, shape (n,)
        In the sequence of all points of the cloud.
    path : str or Path
        Ends in .las, .laz, .xyz, .txt or .csv.
    progress : Progress

    Raises
    ------
    InputError
        If an input is damaged, or `path` is an input, cannot be written or has an extension that is not
        known.
    """
    target = Path(path)
    check_target(cloud, target)
    with atomic_output(target) as temporary:
        if is_text(target):
            _write_text(cloud, name, values, temporary, progress)
        elif have_one_point_format(cloud):
            _write_records(cloud, name, values, temporary, progress)
        else:
            _write_las(cloud, name, values, temporary, progress)


def _write_records(cloud: Cloud, name: str, values: np.ndarray, path: Path, progress: Progress) -> None:
    first = cloud.sources[0]
    header, evlrs = copied_header(first.path)
    if name not in header.point_format.dimension_names:
        header.add_extra_dim(laspy.ExtraBytesParams(name, values.dtype))
    if first.crs is None and cloud.crs is not None:
        evlrs = replace_crs(header, evlrs, cloud.crs)
    header.scales = common_scales(cloud)
    done = 0
    with las_writer(path, header) as writer:
        for source, part in parts(cloud.sources, progress):
            for records in source.records(part, CHUNK_SIZE):
                points = np.empty(len(records), header.point_format.dtype())
                for field in records.dtype.names:
                    points[field] = records[field]
                points[name] = values[done : done + len(records)]
                done += len(records)
                rescale(points, source, header, path)
                writer.write_points(laspy.PackedPointRecord(points, header.point_format))
        if evlrs:
            writer.write_evlrs(VLRList(evlrs))


def _write_las(cloud: Cloud, name: str, values: np.ndarray, path: Path, progress: Progress) -> None:
    shared = _shared_attributes(cloud)
    has_rgb = any(source.has_rgb for source in cloud.sources)
    header = laspy.LasHeader(version="1.4", point_format=7 if has_rgb else 6)
    header.scales, header.offsets = common_scales(cloud), cloud.origin
    replace_crs(header, [], cloud.crs)
    taken = {"x", "y", "z", name, *header.point_format.dimension_names}
    shared = {attribute: kind for attribute, kind in shared.items() if attribute.lower() not in taken}
    for attribute, kind in (*shared.items(), (name, values.dtype)):
        header.add_extra_dim(laspy.ExtraBytesParams(attribute, kind))
    done = 0
    with las_writer(path, header) as writer:
        for chunk in cloud.chunks(progress, CHUNK_SIZE):
            points = las_points(chunk, header, path)
            for attribute in shared:
                points.array[attribute] = chunk.attributes[attribute]
            points.array[name] = values[done : done + len(chunk.xyz)]
            done += len(chunk.xyz)
            writer.write_points(points)


def _write_text(cloud: Cloud, name: str, values: np.ndarray, path: Path, progress: Progress) -> None:
    shared = _shared_attributes(cloud)
    done = 0
    with path.open("w", encoding="utf-8", newline="") as stream:
        for chunk in cloud.chunks(progress, CHUNK_SIZE):
            table = table_of(cloud, chunk)
            for attribute in shared:
                table[attribute] = chunk.attributes[attribute]
            table[name] = values[done : done + len(chunk.xyz)]
            done += len(chunk.xyz)
            append_rows(table, stream, path)


def _shared_attributes(cloud: Cloud) -> dict:
    """Return names and types of the attributes that all files have."""
    first, *others = (dict(source.attributes) for source in cloud.sources)
    return {name: kind for name, kind in first.items() if all(name in other for other in others)}
