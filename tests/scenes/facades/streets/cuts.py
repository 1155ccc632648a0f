"""The parts of a scan that users keep when they clip a cloud to a facade."""

from dataclasses import replace

import numpy as np

from ..scene import FacadeScan, FacadeScene

WHOLE, STREET, ROOMS, WALL = "whole", "street", "rooms", "wall"
CUTS = (WHOLE, STREET, ROOMS, WALL)
"""All points; those of the wall and the street, without the rooms; of the wall and the rooms, without the
street; of the wall alone."""

IN_FRONT, BEHIND = 0.3, 0.6
"""What is kept in front of the foremost and behind the rearmost plane of wall (m)."""


def cut(scan: FacadeScan, scene: FacadeScene, name: str) -> FacadeScan:
    """Return the part of a scan with a name of `CUTS`."""
    w = scene.frame.local(scan.points, np.zeros(3))[:, 2]
    layers = [opening.layer for opening in scene.details if not opening.turned] or [0.0]
    kept = np.ones(len(w), bool)
    if name in (ROOMS, WALL):
        kept &= w < max(layers) + IN_FRONT
    if name in (STREET, WALL):
        kept &= w > min(layers) - BEHIND
    return replace(
        scan,
        points=scan.points[kept],
        rgb=scan.rgb[kept],
        intensity=scan.intensity[kept],
        station=scan.station[kept],
    )
