"""Blind windows and niches: openings whose whole content is a surface like that of the wall, set back."""

from dataclasses import replace

import numpy as np
from scipy.ndimage import binary_dilation, binary_erosion

from ...geometry.robust import sigma_about_median
from ..elevation import RECESS, Points
from .content import Opening
from .settings import NicheSettings
from .states import States

NICHE = "niche"
"""The use of a blind window, a blind arch or a niche."""


def with_niches(
    states: States, openings: list[Opening], points: Points, settings: NicheSettings = NicheSettings()
) -> list[Opening]:
    """Return the openings, those with nothing but wall in them marked as niches.

    One even surface fills a niche from edge to edge. Intensity, or colour without it, shows that it is of
    what the wall is; a shutter or a leaf of a door differs. Without both, a closed shutter cannot be
    distinguished, and what stands on the ground is taken for a door.

    Parameters
    ----------
    states : States
    openings : list of Opening
    points : Points
        Those of the states.
    settings : NicheSettings
    """
    return [
        replace(opening, use=NICHE) if _is_niche(states, opening, points, settings) else opening
        for opening in openings
    ]


def _is_niche(states: States, opening: Opening, points: Points, settings: NicheSettings) -> bool:
    looks = points.rgb if points.intensity is None else points.intensity[:, None]
    if opening.kind != RECESS or (looks is None and "bottom" in opening.open_sides):
        return False
    above = states.above[opening.inside] - opening.depth
    reach = max(states.layers[opening.layer].surface.tolerance, settings.even_m)
    even = opening.inside[np.abs(above) <= reach]
    # Jambs are nearer to the wall; panes and rooms would be farther.
    if np.mean(above < -reach) > settings.behind:
        return False
    core = binary_erosion(np.pad(opening.region.image, 1), np.ones((3, 3)))[1:-1, 1:-1]
    covered = states.grid.holds(states.cells[even])[opening.region.box]
    if not core.any() or covered[core].mean() < settings.covered:
        return False
    return looks is None or _is_alike(states, opening, even, looks, points.scan, settings)


def _is_alike(
    states: States,
    opening: Opening,
    even: np.ndarray,
    looks: np.ndarray,
    scan: np.ndarray,
    settings: NicheSettings,
) -> bool:
    """Whether the surface in an opening looks as the wall around it does, to the scan that saw most of it.

    Each scan has its own distance, angle of incidence and gain.
    """
    best = int(np.bincount(scan[even]).argmax())
    even = even[scan[even] == best]
    image = np.zeros(states.grid.shape, bool)
    image[opening.region.box] = opening.region.image
    rounds = max(int(settings.around_m / states.grid.size), 2)
    around = binary_dilation(image, iterations=rounds).ravel()
    wall = np.flatnonzero(states.on_wall & (states.cells >= 0) & (scan == best))
    wall = wall[around[states.cells[wall]]]
    if not len(wall):
        return False
    own, other = looks[even].astype(float), looks[wall].astype(float)
    middle = np.median(other, axis=0)
    away = float(np.linalg.norm(np.median(own, axis=0) - middle))
    scatter = float(np.linalg.norm(sigma_about_median(other, axis=0)))
    if looks.shape[1] > 1:
        # Weathered walls have so many colours that a door would be one of them.
        return away <= settings.colour
    return away <= max(settings.sigmas * scatter, settings.alike * float(middle[0]))
