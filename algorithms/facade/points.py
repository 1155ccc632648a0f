"""The points of a facade, read from its scans."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Optional

import numpy as np

from ..clouds.cloud import Cloud, names_of, parts
from ..clouds.source import Chunk
from ..clouds.strays import stray_cells
from ..clouds.thinning.thinning import thin_cloud
from ..clouds.tiles.tile_store import stray_warning
from ..errors import InputError
from ..progress import Progress
from .elevation import Points
from .settings import ExtentSettings, ThinningSettings

CHUNK_SIZE = 1_000_000

FARTHEST_CELL = 1_000_000
"""Numbers of three such axes fit into 64 bits."""

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
    has_rgb, without_rgb = _all_have(cloud, "has_rgb", "colour")
    has_intensity, without_intensity = _all_have(cloud, "has_intensity", "intensity")
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
    keys, scan = np.unique(np.concatenate(scans), return_inverse=True)
    points = Points(
        np.concatenate(xyz),
        cloud.origin,
        np.concatenate(rgb) if has_rgb else None,
        np.concatenate(intensity) if has_intensity else None,
        scan.reshape(-1).astype(np.int32),
        _positions(keys, stations),
    )
    site = _site(cloud, points.xyz, limits)
    strays = stray_warning(cloud, int((~site).sum()), len(site))
    points = replace(points, warnings=(*without_rgb, *without_intensity, *strays))
    if thinning is not None and site.sum() > thinning.most_points:
        return _thinned(cloud, points, site, thinning, progress)
    return points if site.all() else points.subset(np.flatnonzero(site))


def _site(cloud: Cloud, xyz: np.ndarray, limits: ExtentSettings) -> np.ndarray:
    """Return which points are no strays.

    Raises
    ------
    InputError
        If they lie so far apart that rasters over them would not fit into memory.
    """
    site = np.ones(len(xyz), bool)
    if np.ptp(xyz, axis=0).max() > limits.strays.part_gap_m:
        numbers = _cell_numbers(xyz, limits.cell_m)
        found, counts = np.unique(numbers, return_counts=True)
        cells = np.column_stack(np.unravel_index(found, (2 * FARTHEST_CELL + 1,) * 3))
        stray = stray_cells(cells, counts, limits.cell_m, limits.strays)
        if stray.any():
            site = ~stray[np.searchsorted(found, numbers)]
    extent = float(np.ptp(xyz[site], axis=0).max())
    if extent > limits.largest_m:
        raise InputError(
            f"The points of {names_of(cloud.sources)} reach over {extent:.7g} m, more than the "
            f"{limits.largest_m:.0f} m of any facade; cut the cloud to the facade, or check that its "
            "coordinates are metres."
        )
    return site


def _cell_numbers(xyz: np.ndarray, edge_m: float) -> np.ndarray:
    """Return the number of the cell of each point; what is too far away is in the outermost cells."""
    numbers = np.zeros(len(xyz), np.int64)
    for column in xyz.T:
        cells = np.clip(np.floor(column / edge_m), -FARTHEST_CELL, FARTHEST_CELL).astype(np.int64)
        numbers = numbers * (2 * FARTHEST_CELL + 1) + cells + FARTHEST_CELL
    return numbers


def _thinned(
    cloud: Cloud, points: Points, site: np.ndarray, settings: ThinningSettings, progress: Progress
) -> Points:
    spacing, kept = settings.finest_m, np.arange(len(points.xyz))
    while len(kept) > settings.most_points:
        kept = thin_cloud(cloud, spacing).kept
        kept = kept[site[kept]]
        # Points lie on surfaces, so their number falls with the square of their distance.
        used, spacing = spacing, spacing * max(settings.coarser, np.sqrt(len(kept) / settings.most_points))
    progress.update(
        1.0,
        f"The {len(points.xyz)} points were thinned to {len(kept)}, {1000 * used:.1f} mm apart; clip the "
        "cloud to the facade to keep more.",
    )
    return points.subset(kept)


def _positions(keys: np.ndarray, known: dict[int, np.ndarray]) -> Optional[np.ndarray]:
    """Return the positions of the scanners of scans, nan where a file does not say; None if none does."""
    if not known:
        return None
    return np.array([known.get(int(key), np.full(3, np.nan)) for key in keys])


def _chunks(cloud: Cloud, progress: Progress) -> Iterator[tuple[int, Chunk]]:
    for number, (source, part) in enumerate(parts(cloud.sources, progress)):
        for chunk in source.chunks(cloud.origin, part, CHUNK_SIZE):
            yield number, chunk


def _all_have(cloud: Cloud, attribute: str, name: str) -> tuple[bool, tuple[str, ...]]:
    """Return whether all files have an attribute, and a sentence if only some have it."""
    lacking = [source.path.name for source in cloud.sources if not getattr(source, attribute)]
    if not lacking or len(lacking) == len(cloud.sources):
        return not lacking, ()
    return False, (f"{', '.join(lacking)} has no {name}, so the {name} of the other files is ignored.",)
