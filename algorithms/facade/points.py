"""The points of a facade, read from its scans."""

from collections.abc import Iterator
from typing import Optional

import numpy as np

from ..clouds.cloud import Cloud, parts
from ..clouds.source import Chunk
from ..clouds.thinning.thinning import thin_cloud
from ..progress import Progress
from .elevation import Points
from .settings import ThinningSettings

CHUNK_SIZE = 1_000_000


def read_points(
    cloud: Cloud, progress: Progress = Progress(), thinning: Optional[ThinningSettings] = None
) -> Points:
    """Return the points of a cloud, with colour and intensity where all its files have them.

    Parameters
    ----------
    cloud : Cloud
    progress : Progress
    thinning : ThinningSettings, optional
        How larger clouds are thinned; all points are kept if not given.

    Raises
    ------
    InputError
        If a file is damaged.
    """
    has_rgb = _all_have(cloud, "has_rgb", "colour", progress)
    has_intensity = _all_have(cloud, "has_intensity", "intensity", progress)
    xyz: list[np.ndarray] = []
    rgb: list[np.ndarray] = []
    intensity: list[np.ndarray] = []
    scans: list[np.ndarray] = []
    for number, chunk in _chunks(cloud, progress):
        xyz.append(chunk.xyz)
        if has_rgb and chunk.rgb is not None:
            rgb.append((chunk.rgb / np.float32(257)).astype(np.float32))
        if has_intensity and chunk.intensity is not None:
            intensity.append(chunk.intensity.astype(np.float32))
        within = np.zeros(len(chunk.xyz)) if chunk.scan is None else chunk.scan
        # The stations of LAS are 16-bit numbers, which cannot hold the sum.
        scans.append(number * (1 << 32) + within.astype(np.int64))
    _, scan = np.unique(np.concatenate(scans), return_inverse=True)
    points = Points(
        np.concatenate(xyz),
        cloud.origin,
        np.concatenate(rgb) if has_rgb else None,
        np.concatenate(intensity) if has_intensity else None,
        scan.astype(np.int32),
    )
    if thinning is None or len(points.xyz) <= thinning.most_points:
        return points
    return _thinned(cloud, points, thinning, progress)


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
    )


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
