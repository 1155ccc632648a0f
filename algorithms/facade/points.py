"""Read all points of a scan."""

from collections.abc import Iterator

import numpy as np

from ..clouds.cloud import Cloud, parts
from ..progress import Progress
from .model import Points

CHUNK_SIZE = 1_000_000


def read_points(cloud: Cloud, progress: Progress = Progress()) -> Points:
    """Return the points of a cloud, with colour and intensity where all its files have them.

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
    return Points(
        np.concatenate(xyz),
        cloud.origin,
        np.concatenate(rgb) if has_rgb else None,
        np.concatenate(intensity) if has_intensity else None,
        scan.astype(np.int32),
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
