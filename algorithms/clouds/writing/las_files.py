"""LAS and LAZ files: their headers, their records, and how finely these hold coordinates."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Optional

import laspy
import lazrs
import numpy as np
from laspy.vlrs.known import WktCoordinateSystemVlr
from rasterio.crs import CRS

from ...errors import InputError
from ..cloud import Cloud
from ..formats.las import LasSource
from ..formats.las_reader import open_reader
from ..formats.value_ranges import scaled_colour
from ..settings import WritingSettings
from ..source import Chunk, Source


def las_sources(sources: Sequence[Source]) -> tuple[LasSource, ...]:
    """Return the files that are LAS or LAZ."""
    return tuple(source for source in sources if isinstance(source, LasSource))


def of_one_point_format(cloud: Cloud) -> tuple[LasSource, ...]:
    """Return the files of a cloud if the raw records of all fit into one output, otherwise none."""
    files = las_sources(cloud.sources)
    if len(files) < len(cloud.sources):
        return ()
    formats = [source.point_format for source in files]
    # Waveforms are stored apart from the records, which would not find them in a new file.
    same = not formats[0].has_waveform_packet and all(
        other.id == formats[0].id and _extra(other) == _extra(formats[0]) for other in formats
    )
    return files if same else ()


def _extra(point_format: laspy.PointFormat) -> list[tuple[object, ...]]:
    return [
        (extra.name, extra.dtype, *np.ravel([extra.scales, extra.offsets]).tolist())
        for extra in point_format.extra_dimensions
    ]


def copied_header(path: Path) -> tuple[laspy.LasHeader, list[laspy.VLR]]:
    """Return the header of a LAS file for a new one, and the records that follow its points."""
    with open_reader(path) as reader:
        header = reader.header
    header.vlrs[:] = [record for record in header.vlrs if record.user_id != "copc"]
    # Some programs state a version in which there is no such point format.
    oldest = laspy.point.dims.preferred_file_version_for_point_format(header.point_format.id)
    version = max(header.version, laspy.header.Version(1, 2), laspy.header.Version.from_str(oldest))
    header.version = min(version, laspy.header.Version(1, 4))
    return header, [record for record in header.evlrs or [] if record.user_id != "copc"]


def replace_crs(header: laspy.LasHeader, evlrs: list[laspy.VLR], crs: Optional[CRS]) -> list[laspy.VLR]:
    """Make `crs` the reference system of `header`; return `evlrs` without those that state another."""
    header.vlrs[:] = [record for record in header.vlrs if record.user_id != "LASF_Projection"]
    if crs is not None:
        if header.version < laspy.header.Version(1, 4):
            header.version = laspy.header.Version(1, 4)
        header.vlrs.append(WktCoordinateSystemVlr(crs.to_wkt()))
    # The newer point formats allow WKT only.
    header.global_encoding.wkt = crs is not None or header.point_format.id >= 6
    return [record for record in evlrs if record.user_id != "LASF_Projection"]


def new_header(origin: np.ndarray, scales: np.ndarray, has_rgb: bool, crs: Optional[CRS]) -> laspy.LasHeader:
    """Return the header of a LAS 1.4 with coordinates, intensity and, if there is, colour."""
    header = laspy.LasHeader(version="1.4", point_format=7 if has_rgb else 6)
    header.scales, header.offsets = scales, origin
    replace_crs(header, [], crs)
    return header


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
            laspy.LasWriter(
                stream, header, do_compress=compress, closefd=False, encoding_errors="replace"
            ) as writer,
        ):
            yield writer
    except lazrs.LazrsError as error:
        raise OSError(str(error)) from error


def common_scales(cloud: Cloud, settings: WritingSettings = WritingSettings()) -> np.ndarray:
    """Return the scales (m) at which the coordinates of all files can be stored."""
    files = las_sources(cloud.sources)
    if len(files) == len(cloud.sources):
        scales = files[0].scales
        steps = [(file.offsets - files[0].offsets) / scales for file in files]
        same = all(np.array_equal(file.scales, scales) for file in files)
        if same and np.allclose(steps, np.rint(steps), rtol=0, atol=1e-6):
            return scales
    finest = np.min([np.full(3, settings.coarsest_step_m), *(file.scales for file in files)], axis=0)
    return np.maximum(finest, settings.finest_step_m)


def rescale(points: np.ndarray, source: LasSource, header: laspy.LasHeader, path: Path) -> None:
    """Bring the coordinates from the scale and offset of `source` to those of `header`."""
    for axis, name in enumerate("XYZ"):
        scale, shift = source.scales[axis], source.offsets[axis] - header.offsets[axis]
        if scale != header.scales[axis] or shift:
            points[name] = stored(points[name] * scale + shift, header.scales[axis], path)


def widen_colour(points: np.ndarray, source: LasSource) -> None:
    """Bring the colours of raw records of `source`, which are changed, to 16 bits."""
    for name in ("red", "green", "blue"):
        points[name] = scaled_colour(source.path, points[name], source.colour_factor)


def stored(values: np.ndarray, scale: float, path: Path) -> np.ndarray:
    """Return the integers by which a LAS file stores `values`.

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
