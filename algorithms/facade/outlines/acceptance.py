"""Which holes and colours of a wall are details: those with enough straight sides that were seen."""

import math
from typing import Optional

from ..elevation import FREE
from ..openings.content import Opening
from .border import Border
from .regular_outlines import Outline
from .settings import AcceptanceSettings

FEW_SIDES = "fewer than three straight sides were seen, as of damage or a shadow"
SHALLOW = "shallow and small, as of damage of the stone"
UNSEEN = "nothing was seen behind it, so that the wall may not have been scanned there"
LOW = "low, and without head and sill, as of a gap between things on the ground"
OPEN = "not bounded by the wall all around"
AT_END = "narrow, at the end of the wall or of what was scanned of it"
BENT = "a part of the wall that bends or is a little set back, without an edge around it"
RAGGED = "ragged, as of damage or a shadow"


def reason_against_opening(
    opening: Opening,
    border: Border,
    outline: Outline,
    settings: AcceptanceSettings = AcceptanceSettings(),
) -> Optional[str]:
    """Return why a hole is not an opening, but damage or the shadow of something in front; None if it is one.

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
    if min(right - left, top - bottom) < narrow:
        if shallow:
            return SHALLOW
        if at_end:
            return AT_END
        if len(border.seen) and border.shown.mean() < settings.shown:
            return RAGGED
    measured = _measured(outline)
    if shallow and len(vars(outline.edges)) - opening.bent < settings.bounded:
        return BENT
    if outline.shape == FREE:
        few = len(measured) < settings.measured
        return _reason_against_free(opening, border, outline, settings) or (FEW_SIDES if few else None)
    # Where a door stands on the ground, the wall cannot bound it.
    bounded = measured | ({"bottom"} & set(opening.open_sides))
    if math.isnan(opening.depth) and len(bounded) < len(vars(outline.edges)):
        return UNSEEN
    if not measured & {"top", "bottom"} and top - bottom < settings.lowest_gap_m:
        return LOW
    enough = len(measured) >= settings.measured and len(bounded) >= settings.bounded
    return None if enough else FEW_SIDES


def _reason_against_free(
    opening: Opening, border: Border, outline: Outline, settings: AcceptanceSettings
) -> Optional[str]:
    """Return why a free shape is not a hole of the wall behind which something was seen."""
    if math.isnan(opening.depth):
        return UNSEEN
    if (
        opening.depth > -settings.damage_m
        or outline.polygon.area < settings.solid * outline.polygon.convex_hull.area
    ):
        return RAGGED
    bounded = len(border.seen) and border.seen.mean() >= settings.seen
    return OPEN if set(opening.open_sides) - {"bottom"} or not bounded else None


def is_regular(outline: Outline, settings: AcceptanceSettings = AcceptanceSettings()) -> bool:
    """Whether a region of another colour was made: stains, joints and lamplight have no straight sides."""
    return outline.shape != FREE and len(_measured(outline)) >= settings.bounded


def _measured(outline: Outline) -> set[str]:
    return {name for name, std in vars(outline.edges).items() if math.isfinite(std)}
