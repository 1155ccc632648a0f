"""Houses whose fronts have several planes."""

import numpy as np
from shapely.geometry import Polygon, box

from ..building import STONE, U, V, W
from ..caster import Panel
from ..scene import FacadeScene
from . import clutter
from .filling import fill_window
from .houses import any_colour, any_filling, begin, door, finish, street_life, window
from .masonry import Face, standing
from .openings import DOOR, WINDOW, circle, round_arch

ROOF = (120.0, 70.0, 55.0)


def setback(seed: int = 0) -> FacadeScene:
    """Build a house whose upper storey stands back, by a brick or by a terrace."""
    masonry = begin(seed, 4)
    about, width = masonry.about, masonry.about(7.6, 0.4)
    level, top = about(3.2, 0.1), about(6.2, 0.2)
    back = about(0.13, 0.02) if masonry.chance(0.5) else about(1.5, 0.3)
    below = masonry.wall(standing(0.0, width, level), colour=any_colour(masonry))
    above = masonry.wall(box(0.0, level, width, top), -back, any_colour(masonry))
    masonry.sides(below, box(0.0, level - 0.1, width, level), 0.0, -back, STONE, 0.6)
    masonry.room(below, box(0.1, 0.0, width - 0.1, level - 0.3), 5.0)
    masonry.room(above, box(0.1, level, width - 0.1, top - 0.2))
    for share in (0.2, 0.8):
        wide = about(1.2, 0.15)
        window(masonry, below, about(share * width, 0.15) - wide / 2, about(0.9), wide, about(1.4, 0.1))
    wide = about(1.0, 0.1)
    door(masonry, below, 0.5 * width - wide / 2, wide, about(2.2, 0.1))
    for share in (0.18, 0.5, 0.82):
        wide = about(1.05, 0.12)
        window(
            masonry, above, about(share * width, 0.1) - wide / 2, about(level + 0.9), wide, about(1.4, 0.1)
        )
    street_life(masonry, below, width)
    return finish(masonry, "setback", width)


def gable(seed: int = 0) -> FacadeScene:
    """Build a house whose gable stands back by 10 cm, with a round or an arched window."""
    masonry = begin(seed, 5)
    about, width = masonry.about, masonry.about(7.0, 0.4)
    eaves, ridge = about(4.2, 0.15), about(7.2, 0.2)
    below = masonry.wall(standing(0.0, width, eaves), colour=any_colour(masonry))
    shape = Polygon([(0.0, eaves), (width, eaves), (0.5 * width, ridge)])
    above = masonry.wall(shape, -about(0.1, 0.015), any_colour(masonry))
    masonry.sides(below, box(0.0, eaves - 0.05, width, eaves), 0.0, -0.12, STONE, 0.6)
    masonry.room(below, box(0.1, 0.0, width - 0.1, eaves - 0.3), 5.0)
    masonry.room(above, box(0.25 * width, eaves, 0.75 * width, eaves + 0.5 * (ridge - eaves)))
    if masonry.chance(0.5):
        outline, name = circle(0.5 * width, eaves + about(1.0), about(0.45, 0.06)), "circle"
    else:
        outline = round_arch(about(0.5 * width) - 0.4, about(eaves + 0.4), 0.8, about(1.3))
        name = "round arch"
    masonry.opening(above, outline, WINDOW, 0.18, name)
    fill_window(masonry, above, outline, 0.18, any_filling(masonry))
    for share in (0.2, 0.8):
        wide = about(1.2, 0.12)
        window(masonry, below, about(share * width, 0.1) - wide / 2, about(1.5), wide, about(1.5, 0.1))
    wide = about(1.1, 0.1)
    door(masonry, below, 0.5 * width - wide / 2, wide, about(2.3, 0.1))
    clutter.quoins(masonry, below, width, -1, eaves)
    street_life(masonry, below, width)
    return finish(masonry, "gable", width)


def bay(seed: int = 0) -> FacadeScene:
    """Build a house with a canted bay in the middle of its front."""
    masonry = begin(seed, 6)
    about, width, top = masonry.about, masonry.about(8.4, 0.4), masonry.about(6.2, 0.2)
    face = masonry.wall(standing(0.0, width, top), colour=any_colour(masonry))
    out, wide, high = about(0.75, 0.1), about(2.0, 0.15), top - about(0.5, 0.1)
    left = 0.5 * width - 0.5 * wide
    ahead = masonry.wall(standing(left, left + wide, high), out, face.colour)
    length, across = out * np.sqrt(2), np.sqrt(0.5)
    cant = standing(0.0, length, high)
    sides = [
        masonry.face(Face((left - out) * U, across * (U + W), cant, face.colour)),
        masonry.face(Face((left + wide) * U + out * W, across * (U - W), cant, face.colour)),
    ]
    roof = Polygon([(left - out, 0), (left, out), (left + wide, out), (left + wide + out, 0)])
    masonry.panels.append(Panel(high * V, np.array([U, W]), roof, ROOF, 0.4))
    # Behind the bay the wall is open.
    behind = box(left - out + 0.05, -1.0, left + wide + out - 0.05, high - 0.1)
    face.outline = face.outline.difference(behind)
    for low, up in ((0.0, 2.8), (3.1, high - 0.2)):
        masonry.room(face, box(0.1, low, width - 0.1, up))
        bottom = low + about(0.95)
        tall = about(1.5, 0.1)
        opening = box(left + 0.3, bottom, left + wide - 0.3, bottom + tall)
        masonry.opening(ahead, opening, WINDOW, 0.12)
        fill_window(masonry, ahead, opening, 0.12, any_filling(masonry))
        for side in sides:
            opening = box(0.25, bottom, length - 0.25, bottom + tall)
            masonry.opening(side, opening, WINDOW, 0.12)
            fill_window(masonry, side, opening, 0.12, any_filling(masonry))
        for middle in (about(1.2, 0.1), about(width - 1.2, 0.1)):
            if low > 0 or middle > 2:
                broad = about(1.0, 0.1)
                window(masonry, face, middle - broad / 2, bottom, broad, tall)
    broad = about(1.0, 0.08)
    door(masonry, face, 1.2 - broad / 2, broad, about(2.2, 0.1))
    street_life(masonry, face, width)
    return finish(masonry, "bay", width)


def balconies(seed: int = 0) -> FacadeScene:
    """Build a house with balconies in front of its upper doors."""
    masonry = begin(seed, 7)
    about, width, top = masonry.about, masonry.about(8.0, 0.4), masonry.about(6.2, 0.2)
    face = masonry.wall(standing(0.0, width, top), colour=any_colour(masonry))
    masonry.room(face, box(0.1, 0.0, width - 0.1, 2.8))
    masonry.room(face, box(0.1, 3.2, width - 0.1, top - 0.2))
    for share in (0.25, 0.75):
        middle, wide, level = about(share * width, 0.1), about(1.1, 0.1), about(3.2, 0.05)
        outline, depth = (
            box(middle - wide / 2, level, middle + wide / 2, level + about(2.25, 0.1)),
            about(0.15, 0.05),
        )
        masonry.opening(face, outline, DOOR, depth)
        fill_window(masonry, face, outline, depth, any_filling(masonry))
        clutter.balcony(masonry, face, middle - 1.1, middle + 1.1, level, about(0.9, 0.15))
    wide = about(0.9, 0.1)
    window(masonry, face, 0.5 * width - wide / 2, about(4.1), wide, about(1.3))
    for share in (0.18, 0.82):
        wide = about(1.3, 0.15)
        window(masonry, face, about(share * width, 0.1) - wide / 2, about(0.9), wide, about(1.4, 0.1))
    wide = about(1.1, 0.1)
    door(masonry, face, 0.5 * width - wide / 2, wide, about(2.2, 0.1))
    street_life(masonry, face, width)
    return finish(masonry, "balconies", width)
