"""How large a space is."""

from shapely.geometry import Polygon

from ..settings import RoomSettings


def is_room(outline: Polygon, settings: RoomSettings = RoomSettings()) -> bool:
    """Return whether a space is a room, and not a niche or an opening."""
    wide = not outline.buffer(-settings.narrowest_m / 2).is_empty
    return bool(wide and outline.area >= settings.smallest_m2)


def inner_width(outline: Polygon) -> float:
    """Return about the width of the largest circle inside an outline, metres; 2 m where it is larger."""
    low, high = 0.0, 1.0
    if not outline.buffer(-high).is_empty:
        return 2 * high
    while high - low > 0.02:
        middle = (low + high) / 2
        if outline.buffer(-middle).is_empty:
            high = middle
        else:
            low = middle
    return 2 * low
