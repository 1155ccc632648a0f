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
    # The wall ends raggedly, and so does what was scanned of it.
    at_end = bool(set(opening.open_sides) - {"bottom"})
    narrow = settings.narrow_m * (2 if outline.shape == FREE else 1)
    if (shallow or at_end) and min(right - left, top - bottom) < narrow:
        return False
    measured = _measured(outline)
    if outline.shape == FREE:
        return _is_hole(opening, border, outline, settings) and len(measured) >= settings.measured
    # Where a door stands on the ground, the wall cannot bound it.
    bounded = measured | ({"bottom"} & set(opening.open_sides))
    if math.isnan(opening.depth) and len(bounded) < len(vars(outline.edges)):
        # Nothing was seen behind the wall, so it may be a part of it that was not scanned.
        return False
    if not measured & {"top", "bottom"} and top - bottom < settings.lowest_gap_m:
        return False
    return len(measured) >= settings.measured and len(bounded) >= settings.bounded


def _is_hole(opening: Opening, border: Border, outline: Outline, settings: AcceptanceSettings) -> bool:
    """Whether a free shape is bounded by the wall, and something was seen behind it."""
    if math.isnan(opening.depth) or set(opening.open_sides) - {"bottom"} or not len(border.seen):
        return False
    whole = outline.polygon.area >= settings.solid * outline.polygon.convex_hull.area
    return bool(whole and border.seen.mean() >= settings.seen)


def is_regular(outline: Outline, settings: AcceptanceSettings = AcceptanceSettings()) -> bool:
    """Whether a region of another colour was made: stains, joints and lamplight have no straight sides."""
    return outline.shape != FREE and len(_measured(outline)) >= settings.bounded


def _measured(outline: Outline) -> set[str]:
    return {name for name, std in vars(outline.edges).items() if math.isfinite(std)}
