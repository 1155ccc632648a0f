"""Town houses and shops in one plane, with all that streets put in front of them."""

import numpy as np
from shapely.geometry import box

from ..scene import FacadeScene
from . import clutter
from .filling import FILLINGS, OPEN, fill_door, fill_niche, fill_passage, fill_shop, fill_window
from .masonry import STONES, Face, Masonry, standing
from .openings import DOOR, NICHE, PASSAGE, WINDOW, segmental


def begin(seed: int, kind: int) -> Masonry:
    """Return the masonry of a street, with its own random numbers."""
    return Masonry(np.random.default_rng([kind, seed]))


def any_colour(masonry: Masonry) -> tuple[float, float, float]:
    return STONES[int(masonry.generator.integers(len(STONES)))]


def any_filling(masonry: Masonry) -> str:
    return FILLINGS[int(masonry.generator.integers(len(FILLINGS)))]


def stations(masonry: Masonry, width: float, count: int) -> list[tuple[float, float, float]]:
    """Return stations spread along a street."""
    shares = (np.arange(count) + 0.5) / count
    return [
        (masonry.about(share * width, 0.8), masonry.about(1.6, 0.1), masonry.about(8.5, 1.5))
        for share in shares
    ]


def bulge(masonry: Masonry) -> tuple[float, float]:
    """Return how an old wall stands: a centimetre out in its middle, and out of plumb."""
    return masonry.about(0.0, 0.012), masonry.about(0.0, 0.01)


def finish(masonry: Masonry, name: str, width: float, count: int = 2) -> FacadeScene:
    """Add the ground and return the scene."""
    masonry.ground(-8.0, width + 8.0)
    return masonry.scene(name, stations(masonry, width, count), bulge=bulge(masonry))


def window(
    masonry: Masonry,
    face: Face,
    left: float,
    bottom: float,
    width: float,
    height: float,
    with_sill: bool = True,
) -> None:
    """Add a window with a random filling, and perhaps its sill."""
    rise = masonry.about(0.12, 0.03)
    flat = masonry.chance(0.7)
    outline = box(left, bottom, left + width, bottom + height)
    if not flat:
        outline = segmental(left, bottom, width, height, rise)
    depth = masonry.about(0.17, 0.06)
    masonry.opening(face, outline, WINDOW, depth, "rectangle" if flat else "segmental arch")
    fill_window(masonry, face, outline, depth, any_filling(masonry))
    if with_sill and masonry.chance(0.6):
        clutter.sill(masonry, face, outline, masonry.about(0.1, 0.04))


def door(masonry: Masonry, face: Face, left: float, width: float, height: float) -> None:
    """Add a door, mostly closed."""
    outline, depth = box(left, 0.0, left + width, height), masonry.about(0.2, 0.08)
    masonry.opening(face, outline, DOOR, depth)
    if masonry.chance(0.85):
        fill_door(masonry, face, outline, depth)


def street_life(masonry: Masonry, face: Face, width: float) -> None:
    """Put people, a car or a tree in front of a house."""
    clutter.person(masonry, masonry.about(0.3 * width, 1.0), masonry.about(2.2, 1.2))
    clutter.person(masonry, masonry.about(0.8 * width, 1.0), masonry.about(1.6, 0.8))
    if masonry.chance(0.6):
        clutter.car(masonry, masonry.about(0.1 * width, 1.0), masonry.about(2.5, 0.2))
    if masonry.chance(0.5):
        clutter.tree(masonry, masonry.about(0.5 * width, 0.4 * width), 2.6, 3.0, 0.6)
    for _ in range(3):
        clutter.stain(masonry, face, masonry.about(0.5 * width, 0.45 * width), masonry.about(2.8, 1.5), 0.5)


def terrace(seed: int = 0) -> FacadeScene:
    """Build a rendered house of two storeys: windows, a door, quoins, a downpipe, a sign, shutters."""
    masonry = begin(seed, 1)
    about, width, top = masonry.about, masonry.about(7.4, 0.5), masonry.about(6.2, 0.3)
    face = masonry.wall(standing(0.0, width, top), colour=any_colour(masonry))
    masonry.room(face, box(0.1, 0.0, width - 0.1, 2.8))
    masonry.room(face, box(0.1, 3.05, width - 0.1, top - 0.2))
    middles = about(1.3, 0.15), about(3.6, 0.2), about(width - 1.3, 0.15)
    for middle in middles:
        wide = about(1.0, 0.12)
        window(masonry, face, middle - wide / 2, about(3.9, 0.1), wide, about(1.5, 0.15))
    wide = about(1.05, 0.1)
    door(masonry, face, middles[1] - wide / 2, wide, about(2.2, 0.12))
    for middle in middles[::2]:
        wide = about(1.1, 0.15)
        window(masonry, face, middle - wide / 2, about(0.95, 0.1), wide, about(1.45, 0.12))
    if masonry.chance(0.5):
        clutter.shutters(masonry, face, face.openings[1])
    clutter.quoins(masonry, face, 0.0, 1, top)
    clutter.downpipe(masonry, face, width - 0.2, top)
    clutter.course(masonry, face, 0.55, width, 2.95, about(0.07, 0.02))
    clutter.sign(masonry, face, box(middles[1] + 0.8, 2.35, middles[1] + 1.7, 2.7))
    clutter.hanging_sign(masonry, about(2.5, 0.1), 2.3)
    street_life(masonry, face, width)
    return finish(masonry, "terrace", width)


def shops(seed: int = 0) -> FacadeScene:
    """Build a shop front: large panes with goods behind, a sign above them, a passage, windows above."""
    masonry = begin(seed, 2)
    about, width, top = masonry.about, masonry.about(8.0, 0.5), masonry.about(6.4, 0.3)
    face = masonry.wall(standing(0.0, width, top), colour=any_colour(masonry))
    masonry.room(face, box(2.3, 0.0, width - 0.1, 2.9), 6.0)
    masonry.room(face, box(0.1, 3.2, width - 0.1, top - 0.2))
    outline = box(about(0.5), 0.0, about(1.9), about(2.6))
    masonry.opening(face, outline, PASSAGE, 7.0)
    fill_passage(masonry, face, outline)
    left, depth = about(2.7, 0.1), about(0.1, 0.05)
    outline = box(left, about(0.5), left + about(2.2, 0.2), about(2.5))
    masonry.opening(face, outline, WINDOW, depth)
    fill_shop(masonry, face, outline, depth)
    door(masonry, face, left + 2.75, about(1.0), about(2.4))
    outline = box(left + 4.1, about(0.6), width - 0.35, about(2.4))
    depth = about(0.08, 0.03)
    masonry.opening(face, outline, WINDOW, depth)
    fill_shop(masonry, face, outline, depth)
    clutter.sign(masonry, face, box(left, 2.65, about(width - 0.6, 0.2), 3.05), about(0.15, 0.05))
    for middle in (about(1.2, 0.15), about(4.0, 0.2), about(width - 1.3, 0.15)):
        wide = about(1.1, 0.15)
        window(masonry, face, middle - wide / 2, about(3.85, 0.1), wide, about(1.6, 0.15))
    clutter.hanging_sign(masonry, about(2.3, 0.05), 2.9)
    clutter.downpipe(masonry, face, 0.15, top)
    street_life(masonry, face, width)
    return finish(masonry, "shops", width)


def warehouse(seed: int = 0) -> FacadeScene:
    """Build a brick front with segmental and blind openings, joints, a gate, and open windows."""
    masonry = begin(seed, 3)
    about, width, top = masonry.about, masonry.about(8.0, 0.4), masonry.about(5.8, 0.3)
    face = masonry.wall(standing(0.0, width, top), colour=STONES[3])
    masonry.room(face, box(0.1, 0.0, width - 0.1, 2.9), 6.0)
    masonry.room(face, box(0.1, 3.2, width - 0.1, top - 0.2), 6.0)
    wide = about(2.2, 0.2)
    gate = segmental(about(2.9, 0.2), 0.0, wide, about(2.7, 0.1), about(0.35, 0.08))
    depth = about(0.25, 0.06)
    masonry.opening(face, gate, DOOR, depth, "segmental arch")
    fill_door(masonry, face, gate, depth)
    for middle in (about(1.3, 0.1), about(6.7, 0.1)):
        wide = about(1.0, 0.1)
        outline = segmental(middle - wide / 2, about(1.0), wide, about(1.5, 0.1), about(0.15, 0.04))
        masonry.opening(face, outline, WINDOW, 0.2, "segmental arch")
        fill_window(masonry, face, outline, 0.2, any_filling(masonry))
    for number, middle in enumerate((about(1.3, 0.1), about(3.1, 0.1), about(4.9, 0.1), about(6.7, 0.1))):
        wide, high = about(0.95, 0.08), about(1.4, 0.1)
        outline = segmental(middle - wide / 2, about(3.6, 0.05), wide, high, about(0.14, 0.03))
        blind = number == 1 or masonry.chance(0.15)
        depth = about(0.13, 0.03) if blind else about(0.2, 0.04)
        masonry.opening(face, outline, NICHE if blind else WINDOW, depth, "segmental arch")
        if blind:
            fill_niche(masonry, face, outline, depth)
        else:
            fill_window(masonry, face, outline, depth, OPEN if number == 2 else any_filling(masonry))
        clutter.sill(masonry, face, outline, about(0.07, 0.02))
    clutter.joints(masonry, face, 0.0, width, top)
    clutter.course(masonry, face, 0.0, width, 3.2, about(0.06, 0.02))
    street_life(masonry, face, width)
    return finish(masonry, "warehouse", width)
