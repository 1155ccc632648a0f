"""Move a cloud by a similarity transformation, with all that its points carry."""

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import chain, count
from pathlib import Path
from typing import Optional, Union

import laspy
import numpy as np
from laspy.vlrs.vlrlist import VLRList
from rasterio.crs import CRS

from ...errors import InputError
from ...files import atomic_output
from ...geometry.motion import Motion
from ...progress import Progress
from ...reference_systems import require_metres
from ...tables.dialect import Dialect
from ..formats.las import LasSource, coordinates
from ..formats.normals import find_normals
from ..formats.text import TextSource
from ..formats.text_layout import Layout
from ..settings import WritingSettings
from ..source import Source
from .las_files import copied_header, las_points, las_writer, new_header, replace_crs, stored

DIMENSION_NAME = 32
"""Bytes for the name of an extra dimension in LAS."""

WITHOUT_WAVEFORM = {4: 1, 5: 3, 9: 6, 10: 8}
"""The point formats with waveforms, and what they are without."""


def transformed_names(sources: Sequence[Source]) -> tuple[str, ...]:
    """Return the names of the files that clouds are written to, in the same format where it can be written.

    Raises
    ------
    InputError
        If two clouds would become one file.
    """
    names = tuple(_transformed_name(source) for source in sources)
    # Not every file system distinguishes capitals.
    keys = [name.lower() for name in names]
    for number, source in enumerate(sources):
        first = keys.index(keys[number])
        if first < number:
            raise InputError(
                f"{sources[first].path} and {source.path} would both become {names[number]}; "
                "transform one of them later, into another folder."
            )
    return names


def _transformed_name(source: Source) -> str:
    stem = source.path.stem
    if isinstance(source, LasSource) and stem.lower().endswith(".copc"):
        return stem[: -len(".copc")] + ".laz"
    return source.path.name if isinstance(source, (LasSource, TextSource)) else f"{stem}.laz"


def refuse_other_units(sources: Sequence[Source]) -> None:
    """Refuse clouds whose own reference system is not in metres, as transformations are.

    Raises
    ------
    InputError
        Naming the first of them.
    """
    for source in sources:
        if source.crs:
            require_metres(source.crs, f"{source.path}, which transformations in metres cannot move,")


def rounding_warnings(
    source: Source, matrix: np.ndarray, settings: WritingSettings = WritingSettings()
) -> tuple[str, ...]:
    """Return a sentence if the rounded numbers of a matrix move the points by more than scanners measure."""
    linear = matrix[:3, :3] / np.cbrt(np.linalg.det(matrix[:3, :3]))
    error = np.abs(linear.T @ linear - np.eye(3)).max() / 2 * np.linalg.norm(source.middle)
    if error < settings.least_rounding_m:
        return ()
    return (
        f"The matrix for {source.path} is rounded, which moves its points by up to {error:.2g} m, because "
        "they lie far from 0; write the matrix with more decimals.",
    )


def transform_cloud(
    source: Source,
    matrix: np.ndarray,
    path: Union[str, Path],
    crs: Optional[CRS] = None,
    progress: Progress = Progress(),
    settings: WritingSettings = WritingSettings(),
) -> int:
    """Write the points of `source`, moved by `matrix`, to `path` and return their number.

    Attributes are unchanged, except normals, which are rotated. LAS and LAZ keep their point format;
    waveforms, which are stored apart from the points, are left out. Text keeps its separator, its header
    and the other columns. All other formats become LAS with extra dimensions.

    Parameters
    ----------
    source : Source
    matrix : ndarray of float64, shape (4, 4)
        A similarity transformation.
    path : str or Path
        Named as `transformed_names` says.
    crs : CRS, optional
        Of the result; the system that the file itself states does not apply any more.
    progress : Progress
    settings : WritingSettings

    Raises
    ------
    InputError
        If the input is damaged, or `path` is the input or cannot be written.
    """
    target = Path(path)
    if target.resolve() == source.path.resolve():
        raise InputError(f"{target} is an input as well; choose another name for the output.")
    motion = Motion.about(np.asarray(matrix, np.float64), source.middle)
    with atomic_output(target) as temporary:
        if isinstance(source, LasSource):
            return _write_records(source, motion, temporary, crs, progress, settings)
        if isinstance(source, TextSource):
            return _write_text(source, motion, temporary, progress, settings)
        return _write_points(source, motion, temporary, crs, progress, settings)


def _write_records(
    source: LasSource,
    motion: Motion,
    path: Path,
    crs: Optional[CRS],
    progress: Progress,
    settings: WritingSettings,
) -> int:
    """Write the records of a LAS file, unchanged except for positions and directions."""
    header, evlrs = copied_header(source.path)
    if header.point_format.has_waveform_packet:
        progress.update(0.0, f"{source.path.name} holds waveforms, which are left out.")
        _drop_waveform(header)
    evlrs = replace_crs(header, evlrs, crs)
    header.scales = np.clip(source.scales, settings.finest_step_m, settings.coarsest_step_m)
    header.offsets = motion.offset
    with las_writer(path, header) as writer:
        for records in source.records(progress, settings.chunk_points, with_unusable=True):
            points = np.empty(len(records), header.point_format.dtype())
            for name in points.dtype.names:
                points[name] = records[name]
            positions = motion.positions(coordinates(records, source.scales, source.offsets - motion.origin))
            for axis, name in enumerate("XYZ"):
                points[name] = stored(positions[:, axis], header.scales[axis], path)
            _rotate_normals(points, header.point_format, motion)
            writer.write_points(laspy.PackedPointRecord(points, header.point_format))
        if evlrs:
            writer.write_evlrs(VLRList(evlrs))
    return source.point_count


def _drop_waveform(header: laspy.LasHeader) -> None:
    remaining = laspy.PointFormat(WITHOUT_WAVEFORM[header.point_format.id])
    remaining.dimensions.extend(header.point_format.extra_dimensions)
    header.point_format = remaining
    header.global_encoding.waveform_data_packets_external = False
    header.global_encoding.waveform_data_packets_internal = False


def _rotate_normals(points: np.ndarray, point_format: laspy.PointFormat, motion: Motion) -> None:
    """Rotate the normals among the extra dimensions of `points`, which are changed."""
    extra = list(point_format.extra_dimensions)
    found = find_normals([dimension.name for dimension in extra])
    if found is None:
        return
    dimensions = [extra[index] for index in found]
    scales = [np.ravel(1.0 if item.scales is None else item.scales)[0] for item in dimensions]
    offsets = [np.ravel(0.0 if item.offsets is None else item.offsets)[0] for item in dimensions]
    normals = np.stack([points[item.name] for item in dimensions], axis=1) * scales + offsets
    rotated = (motion.directions(normals) - offsets) / scales
    for item, column in zip(dimensions, rotated.T):
        kind = points.dtype[item.name]
        if kind.kind != "f":
            limits = np.iinfo(kind)
            column = np.clip(np.rint(column), limits.min, limits.max)
        points[item.name] = column


def _write_points(
    source: Source,
    motion: Motion,
    path: Path,
    crs: Optional[CRS],
    progress: Progress,
    settings: WritingSettings,
) -> int:
    """Write the points of any format as LAS, their attributes as extra dimensions."""
    header = new_header(motion.offset, np.full(3, settings.coarsest_step_m), source.has_rgb, crs)
    names = _dimension_names([name for name, _ in source.attributes], header.point_format)
    for name, kind in source.attributes:
        header.add_extra_dim(laspy.ExtraBytesParams(names[name], kind))
    written = 0
    with las_writer(path, header) as writer:
        for chunk in source.chunks(motion.origin, progress, settings.chunk_points):
            points = las_points(replace(chunk, xyz=motion.positions(chunk.xyz)), header, path)
            for name, values in chunk.attributes.items():
                points.array[names[name]] = values
            _rotate_normals(points.array, header.point_format, motion)
            writer.write_points(points)
            written += len(points)
    return written


def _dimension_names(names: list[str], point_format: laspy.PointFormat) -> dict[str, str]:
    """Return a name for each attribute that fits into LAS and that LAS does not use itself."""
    given = {"x", "y", "z", *(name.lower() for name in point_format.dimension_names)}
    chosen = {}
    for name in names:
        short = name.encode("ascii", errors="replace").decode()[:DIMENSION_NAME]
        others = (f"{short[: DIMENSION_NAME - 4]}_{number}" for number in count(2))
        chosen[name] = next(free for free in chain([short], others) if free.lower() not in given)
        given.add(chosen[name].lower())
    return chosen


def _write_text(
    source: TextSource, motion: Motion, path: Path, progress: Progress, settings: WritingSettings
) -> int:
    """Write the lines, unchanged except for positions and directions; text cannot hold a CRS."""
    layout, rows = source.layout, source.rows
    written = 0
    with path.open("w", encoding=layout.encoding, errors="surrogateescape", newline="") as stream:
        stream.writelines(source.head())
        for lines, values in source.records(progress, settings.text_lines):
            points = iter(
                _moved_lines(
                    [line for line in lines if rows.is_point(line)], values, layout, motion, settings
                )
            )
            stream.writelines(next(points) if rows.is_point(line) else line for line in lines)
            written += len(values)
    return written


def _moved_lines(
    lines: list[str], values: np.ndarray, layout: Layout, motion: Motion, settings: WritingSettings
) -> list[str]:
    dialect, columns = layout.dialect, layout.columns
    rows = [dialect.fields(line) for line in lines]
    positions = (motion.positions(values[:, :3] - motion.origin) + motion.offset) / layout.metres
    _replace(rows, columns.xyz, positions, settings.text_decimals, dialect)
    if columns.normals:
        normals = [[dialect.number(row[column].strip(' "')) for column in columns.normals] for row in rows]
        rotated = motion.directions(np.array(normals).reshape(-1, 3))
        _replace(rows, columns.normals, rotated, settings.normal_decimals, dialect)
    return [dialect.delimiter.join(row) + "\n" for row in rows]


def _replace(
    rows: list[list[str]], columns: tuple[int, ...], values: np.ndarray, decimals: int, dialect: Dialect
) -> None:
    """Write `values`, shape (n, columns), into fields of `rows`; fields without a number are unchanged.

    Raises
    ------
    ValueError
        If the rows are not as many as the values, so that values would be those of other points.
    """
    if len(rows) != len(values):
        raise ValueError(f"{len(rows)} rows and {len(values)} points")
    for column, numbers in zip(columns, values.T.tolist()):
        for row, number in zip(rows, numbers):
            if math.isfinite(number):
                blanks = " " if row[column].startswith(" ") else ""
                text = f"{number:.{decimals}f}".replace(".", dialect.decimal)
                quote = '"' if dialect.delimiter in text else ""
                row[column] = f"{blanks}{quote}{text}{quote}"
