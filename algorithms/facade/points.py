"""Read all points of a scan."""

from collections.abc import Iterator
from typing import Optional

import numpy as np

from ..clouds.cloud import Cloud, parts
from ..clouds.thinning.thinning import thin_cloud
from ..progress import Progress
from .elevation import Points

CHUNK_SIZE = 1_000_000

FINEST, COARSER = 0.002, 1.05
"""The first distance that points are thinned to (m), and by how much the next is larger at least."""


def read_points(cloud: Cloud, progress: Progress = Progress(), most: Optional[int] = None) -> Points:
    """Return the points of a cloud, with colour and intensity where all its files have them.

    Parameters
    ----------
    cloud : Cloud
    progress : Progress
    most : int, optional
        A cloud of more points is thinned to a distance at which there are no more.

    Raises
    ------
    InputError
        If a file turns out to be damaged.
    """
    has_rgb = _all_have(cloud, "has_rgb", "colour", progress)
    has_intensity = _all_have(cloud, "has_intensity", "intensity", progress)
    xyz, rgb, intensity, scans = [], [], [], []
    for number, chunk in _chunks(cloud, progress):
        xyz.append(chunk.xyz)
        rgb.append((chunk.rgb / np.float32(257)).astype(np.float32) if has_rgb else None)
        intensity.append(chunk.intensity.astype(np.float32) if has_intensity else None)
        within = np.zeros(len(chunk.xyz), np.int64) if chunk.scan is None else chunk.scan
        scans.append(number * (1 << 32) + within)
    _, scan = np.unique(np.concatenate(scans), return_inverse=True)
    points = Points(
        np.concatenate(xyz),
        cloud.origin,
        np.concatenate(rgb) if has_rgb else None,
        np.concatenate(intensity) if has_intensity else None,
        scan.astype(np.int32),
    )
    if most is None or len(points.xyz) <= most:
        return points
    return _thinned(cloud, points, most, progress)


def _thinned(cloud: Cloud, points: Points, most: int, progress: Progress) -> Points:
    spacing, kept = FINEST, np.arange(len(points.xyz))
    while len(kept) > most:
        kept = thin_cloud(cloud, spacing).kept
        # Points lie on surfaces, so their number falls with the square of their distance.
        used, spacing = spacing, spacing * max(COARSER, np.sqrt(len(kept) / most))
    progress.update(
        1.0,
        f"The {len(points.xyz)} points were thinned to {len(kept)}, {1000 * used:.1f} mm apart; cut the "
        "cloud to the facade for more.",
    )
    return Points(
        points.xyz[kept],
        points.origin,
        None if points.rgb is None else points.rgb[kept],
        None if points.intensity is None else points.intensity[kept],
        points.scan[kept],
    )


def _chunks(cloud: Cloud, progress: Progress) -> Iterator:
    for number, (source, part) in enumerate(parts(cloud.sources, progress)):
        for chunk in source.chunks(cloud.origin, part, CHUNK_SIZE):
            yield number, chunk


def _all_have(cloud: Cloud, attribute: str, name: str, progress: Progress) -> bool:
    lacking = [source.path.name for source in cloud.sources if not getattr(source, attribute)]
    if lacking and len(lacking) < len(cloud.sources):
        progress.update(0.0, f"{', '.join(lacking)} has no {name}, so that of the other files is not used.")
    return not lacking
