"""What is seen in an opening: glass, frames, curtains, shutters, leaves of doors, masonry, rooms."""

import numpy as np
from shapely.geometry import Polygon, box
from shapely.ops import unary_union

from ..building import GLASS, STONE, WOOD
from .masonry import Face, Masonry

FRAME, BAR = 0.06, 0.04
MIRROR = 0.0
"""A reflectance that sends nothing back."""

PLAIN, CURTAIN, DARK, SHUTTERED, OPEN = "plain", "curtain", "dark", "shuttered", "open"
FILLINGS = (PLAIN, CURTAIN, DARK, SHUTTERED, OPEN)
"""Of windows: glass and the room behind it; curtains behind glass; glass that mirrors the laser away; closed
shutters; and an open casement."""

CURTAINS = (235.0, 232.0, 225.0)


def fill_window(masonry: Masonry, face: Face, outline: Polygon, depth: float, filling: str) -> None:
    """Put a frame and what belongs to a filling into a window, `depth` behind the wall."""
    if filling == OPEN:
        return
    if filling == SHUTTERED:
        masonry.front(face, outline, -0.4 * depth, (70.0, 105.0, 85.0), 0.4)
        return
    left, bottom, right, top = outline.bounds
    pane = outline.buffer(-FRAME, join_style=2)
    middle, transom = 0.5 * (left + right), bottom + 0.65 * (top - bottom)
    bars = unary_union(
        [
            box(middle - BAR / 2, bottom, middle + BAR / 2, top),
            box(left, transom - BAR / 2, right, transom + BAR / 2),
        ]
    )
    masonry.front(face, outline.difference(pane.difference(bars)), -depth, WOOD, 0.35)
    if filling == DARK:
        masonry.front(face, pane, -depth - 0.02, GLASS, MIRROR, 0.9)
        return
    masonry.front(face, pane, -depth - 0.02, GLASS, 0.12, masonry.about(0.15, 0.1))
    if filling == CURTAIN:
        _draw_curtains(masonry, face, outline, depth + 0.12)


def _draw_curtains(masonry: Masonry, face: Face, outline: Polygon, depth: float) -> None:
    left, bottom, right, top = outline.bounds
    if masonry.chance(0.3):
        cloth = [box(left, bottom, right, top)]
    elif masonry.chance(0.5):
        cloth = [box(left, bottom, right, bottom + 0.5 * (top - bottom))]
    else:
        share = masonry.about(0.25, 0.1) * (right - left)
        cloth = [box(left, bottom, left + share, top), box(right - share, bottom, right, top)]
    for part in cloth:
        masonry.front(face, part, -depth, CURTAINS, 0.6, 0.85)


def fill_door(masonry: Masonry, face: Face, outline: Polygon, depth: float) -> None:
    """Close a door with a leaf of wood with two panels sunk into it."""
    left, bottom, right, top = outline.bounds
    width, height = right - left, top - bottom
    masonry.front(face, outline, -depth, (96.0, 60.0, 40.0), 0.3)
    for low, high in ((0.1, 0.4), (0.5, 0.75)):
        panel = box(left + 0.2 * width, bottom + low * height, right - 0.2 * width, bottom + high * height)
        masonry.front(face, panel, -depth + 0.012, WOOD, 0.3)


def fill_niche(masonry: Masonry, face: Face, outline: Polygon, depth: float) -> None:
    """Close an opening with masonry."""
    masonry.front(face, outline, -depth, STONE, 0.6)


def fill_passage(masonry: Masonry, face: Face, outline: Polygon, deep: float = 7.0) -> None:
    """Lead a passage through the house, with a yard at its end."""
    masonry.sides(face, outline, 0.0, -deep, STONE, 0.55)
    yard = outline.buffer(2.0, join_style=2)
    masonry.front(face, yard, -deep - 4.0, STONE, 0.5)


def fill_shop(masonry: Masonry, face: Face, outline: Polygon, depth: float) -> None:
    """Glaze a shop window, with goods close behind the pane."""
    left, bottom, right, top = outline.bounds
    panes = 1 + int((right - left) / 1.3)
    edges = np.linspace(left, right, panes + 1)
    glass = unary_union(
        [
            box(start + FRAME / 2, bottom + FRAME, stop - FRAME / 2, top - FRAME)
            for start, stop in zip(edges[:-1], edges[1:])
        ]
    )
    masonry.front(face, outline.difference(glass), -depth, (60.0, 60.0, 65.0), 0.3)
    for pane in getattr(glass, "geoms", [glass]):
        masonry.front(face, pane, -depth - 0.01, GLASS, 0.12, 0.08)
        low, _, high, _ = pane.bounds
        goods = box(low, bottom, masonry.about(high - 0.3, 0.2), bottom + masonry.about(0.8, 0.3))
        back = depth + masonry.about(0.5, 0.3)
        masonry.block(face, goods, -back - 0.3, -back, (150.0, 60.0, 90.0), 0.5)
