"""The points of a facade, read from its scans."""

from collections.abc import Iterator
from typing import Optional

import numpy as np

from ..clouds.cloud import Cloud, names_of, parts
from ..clouds.source import Chunk
from ..clouds.thinning.thinning import thin_cloud
from ..errors import InputError
from ..progress import Progress
from .elevation import Points
from .settings import ExtentSettings, ThinningSettings

CHUNK_SIZE = 1_000_000

SCANS = 1 << 32
"""A scan is numbered by its file times this, and its number within the file."""


def read_points(
    cloud: Cloud,
    progress: Progress = Progress(),
    thinning: Optional[ThinningSettings] = None,
    limits: ExtentSettings = ExtentSettings(),
) -> Points:
    """Return the points of a cloud, with colour and intensity where all its files have them.

    Parameters
    ----------
    cloud : Cloud
    progress : Progress
    thinning : ThinningSettings, optional
        How larger clouds are thinned; all points are kept if not given.
    limits : ExtentSettings

    Raises
    ------
    InputError
        If a file is damaged, or the points lie too far apart.
    """
    has_rgb = _all_have(cloud, "has_rgb", "colour", progress)
    has_intensity = _all_have(cloud, "has_intensity", "intensity", progress)
    xyz: list[np.ndarray] = []
    rgb: list[np.ndarray] = []
    intensity: list[np.ndarray] = []
    scans: list[np.ndarray] = []
    stations: dict[int, np.ndarray] = {}
    for number, chunk in _chunks(cloud, progress):
        xyz.append(chunk.xyz)
        if has_rgb and chunk.rgb is not None:
            rgb.append((chunk.rgb / np.float32(257)).astype(np.float32))
        if has_intensity and chunk.intensity is not None:
            intensity.append(chunk.intensity.astype(np.float32))
        within = np.zeros(len(chunk.xyz)) if chunk.scan is None else chunk.scan
        # The stations of LAS are 16-bit numbers, which cannot hold the sum.
        scans.append(number * SCANS + within.astype(np.int64))
        if chunk.station is not None and len(within):
            stations[int(scans[-1][0])] = chunk.station
    _check_extent(cloud, xyz, limits)
    keys, scan = np.unique(np.concatenate(scans), return_inverse=True)
    points = Points(
        np.concatenate(xyz),
        cloud.origin,
        np.concatenate(rgb) if has_rgb else None,
        np.concatenate(intensity) if has_intensity else None,
        scan.reshape(-1).astype(np.int32),
        _positions(keys, stations),
    )
    if thinning is None or len(points.xyz) <= thinning.most_points:
        return points
    return _thinned(cloud, points, thinning, progress)


def _check_extent(cloud: Cloud, xyz: list[np.ndarray], limits: ExtentSettings) -> None:
    """Refuse points that lie so far apart that rasters over them would not fit into memory."""
    low = np.min([part.min(axis=0) for part in xyz if len(part)], axis=0)
    high = np.max([part.max(axis=0) for part in xyz if len(part)], axis=0)
    extent = float(np.max(high - low))
    if extent > limits.largest_m:
        raise InputError(
            f"The points of {names_of(cloud.sources)} reach over {extent:.7g} m, more than the "
            f"{limits.largest_m:.0f} m of any facade; cut the cloud to the facade, or check that its "
            "coordinates are metres."
        )


def _thinned(cloud: Cloud, points: Points, settings: ThinningSettings, progress: Progress) -> Points:
    spacing, kept = settings.finest_m, np.arange(len(points.xyz))
    while len(kept) > settings.most_points:
        kept = thin_cloud(cloud, spacing).kept
        # Points lie on surfaces, so their number falls with the square of their distance.
        used, spacing = spacing, spacing * max(settings.coarser, np.sqrt(len(kept) / settings.most_points))
    progress.update(
        1.0,
        f"The {len(points.xyz)} points were thinned to {len(kept)}, {1000 * used:.1f} mm apart; clip the "
        "cloud to the facade to keep more.",
    )
    return Points(
        points.xyz[kept],
        points.origin,
        None if points.rgb is None else points.rgb[kept],
        None if points.intensity is None else points.intensity[kept],
        points.scan[kept],
        points.stations,
    )


def _positions(keys: np.ndarray, known: dict[int, np.ndarray]) -> Optional[np.ndarray]:
    """Return the positions of the scanners of scans, nan where a file does not say; None if none does."""
    if not known:
        return None
    return np.array([known.get(int(key), np.full(3, np.nan)) for key in keys])


def _chunks(cloud: Cloud, progress: Progress) -> Iterator[tuple[int, Chunk]]:
    for number, (source, part) in enumerate(parts(cloud.sources, progress)):
        for chunk in source.chunks(cloud.origin, part, CHUNK_SIZE):
            yield number, chunk


def _all_have(cloud: Cloud, attribute: str, name: str, progress: Progress) -> bool:
    lacking = [source.path.name for source in cloud.sources if not getattr(source, attribute)]
    if lacking and len(lacking) < len(cloud.sources):
        progress.update(
            0.0, f"{', '.join(lacking)} has no {name}, so the {name} of the other files is ignored."
        )
    return not lacking
