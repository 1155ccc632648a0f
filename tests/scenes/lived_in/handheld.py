"""The flat, scanned by hand in two passes that do not quite agree."""

from dataclasses import replace

import numpy as np

from ..scene import Scene
from .flat import flat

PASSES = 2
DRIFT = 0.03
"""Of one pass against the other, metres."""

RANGE_NOISE = 0.012


def handheld(seed: int = 0) -> Scene:
    """Build the flat with stations along the way of a person, in two passes 3 cm apart."""
    random = np.random.default_rng(seed + 1000)
    scene = flat(seed)
    stations, drifts = [], []
    for number in range(PASSES):
        angle = random.uniform(0, 2 * np.pi)
        drift = number * DRIFT * np.array([np.cos(angle), np.sin(angle), 0.0])
        for room in scene.local_rooms:
            west, south, east, north = room.bounds
            for share in np.linspace(0.3, 0.7, 4):
                x = west + (east - west) * (share if number else 1 - share)
                y = south + (north - south) * (0.5 + random.uniform(-0.15, 0.15))
                stations.append((x, y, random.uniform(1.2, 1.5)))
                drifts.append(drift)
    return replace(
        scene, name="handheld", scanners=np.array(stations), drifts=np.array(drifts), range_noise=RANGE_NOISE
    )
