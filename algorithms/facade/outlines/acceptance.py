"""Which holes and colours of a wall are details: those with enough straight sides that were seen."""

import math

from ..elevation import FREE
from ..openings.content import Opening
from .border import Border
from .regular_outlines import Outline
from .settings import AcceptanceSettings


def is_opening(
    opening: Opening,
    border: Border,
    outline: Outline,
    settings: AcceptanceSettings = AcceptanceSettings(),
) -> bool:
    """Whether a hole is an opening, and not damage of the stone or the shadow of something in front.

    Parameters
    ----------
    opening : Opening
    border : Border
    outline : Outline
    settings : AcceptanceSettings
    """
    left, bottom, right, top = outline.polygon.bounds
    shallow = opening.depth > -settings.damage_m
    if shallow and min(right - left, top - bottom) < settings.narrow_m:
        return False
    if outline.shape == FREE:
        whole = outline.polygon.area >= settings.solid * outline.polygon.convex_hull.area
        return bool(whole and len(border.seen) and border.seen.mean() >= settings.seen)
    measured = _measured(outline)
    # Where a door stands on the ground, the wall cannot bound it.
    bounded = measured | ({"bottom"} & set(opening.open_sides))
    return len(measured) >= settings.measured and len(bounded) >= settings.bounded


def is_regular(outline: Outline, settings: AcceptanceSettings = AcceptanceSettings()) -> bool:
    """Whether a region of another colour was made: stains, joints and lamplight have no straight sides."""
    return outline.shape != FREE and len(_measured(outline)) >= settings.bounded


def _measured(outline: Outline) -> set[str]:
    return {name for name, std in vars(outline.edges).items() if math.isfinite(std)}
