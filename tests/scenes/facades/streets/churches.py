"""Churches, arcades and towers: pointed, round and blind openings, and walls that turn."""

import numpy as np
from shapely.geometry import Polygon, box

from ..building import STONE, U, V, W
from ..scene import FacadeScene
from . import clutter
from .filling import DARK, fill_door, fill_niche, fill_passage, fill_window
from .houses import any_filling, begin, finish, street_life
from .masonry import Face, Masonry, standing
from .openings import DOOR, NICHE, PASSAGE, WINDOW, circle, pointed, round_arch


def church(seed: int = 0) -> FacadeScene:
    """Build a west front: a portal, pointed windows, a round one, a niche, ashlar, and surrounds."""
    masonry = begin(seed, 8)
    about, width, top = masonry.about, masonry.about(8.4, 0.4), masonry.about(6.6, 0.2)
    outline = standing(0.0, width, top).union(Polygon([(0, top), (width, top), (width / 2, top + 1.8)]))
    face = masonry.wall(outline, colour=STONE)
    masonry.room(face, box(0.2, 0.0, width - 0.2, top - 0.2), 9.0)
    middle, wide = 0.5 * width, about(1.7, 0.1)
    portal = (round_arch if masonry.chance(0.5) else pointed)(middle - wide / 2, 0.0, wide, about(3.0, 0.1))
    depth = about(0.4, 0.08)
    masonry.opening(
        face, portal, DOOR, depth, "round arch" if len(portal.exterior.coords) < 30 else "pointed arch"
    )
    fill_door(masonry, face, portal, depth)
    for at in (about(1.5, 0.1), about(width - 1.5, 0.1)):
        wide = about(0.9, 0.08)
        light = pointed(at - wide / 2, about(2.3, 0.1), wide, about(2.6, 0.15))
        depth = about(0.22, 0.05)
        masonry.opening(face, light, WINDOW, depth, "pointed arch")
        fill_window(masonry, face, light, depth, DARK if masonry.chance(0.5) else any_filling(masonry))
        if masonry.chance(0.4):
            clutter.surround(masonry, face, light, about(0.025, 0.01))
    rose = circle(middle, about(4.9), about(0.75, 0.08))
    masonry.opening(face, rose, WINDOW, 0.25, "circle")
    fill_window(masonry, face, rose, 0.25, DARK)
    niche = round_arch(middle - 0.3, about(6.3), 0.6, about(1.1))
    masonry.opening(face, niche, NICHE, 0.3, "round arch")
    fill_niche(masonry, face, niche, 0.3)
    clutter.joints(masonry, face, 0.0, width, top)
    street_life(masonry, face, width)
    return finish(masonry, "church", width)


def arcade(seed: int = 0) -> FacadeScene:
    """Build arches through which a yard is seen, under round windows."""
    masonry = begin(seed, 9)
    about, top = masonry.about, masonry.about(5.6, 0.2)
    pitch, wide = about(2.4, 0.1), about(1.6, 0.1)
    width = 3 * pitch + 0.6
    face = masonry.wall(standing(0.0, width, top), colour=STONE)
    masonry.room(face, box(0.1, 3.3, width - 0.1, top - 0.2))
    for number in range(3):
        middle = 0.3 + (number + 0.5) * pitch
        arch = round_arch(middle - wide / 2, 0.0, wide, about(2.6, 0.05))
        masonry.opening(face, arch, PASSAGE, 7.0, "round arch")
        fill_passage(masonry, face, arch)
        light = circle(middle, about(4.2), about(0.5, 0.05))
        if number == 1:
            light = round_arch(middle - 0.45, about(3.6), 0.9, about(1.4))
        masonry.opening(face, light, WINDOW, 0.2, "round arch" if number == 1 else "circle")
        fill_window(masonry, face, light, 0.2, any_filling(masonry))
    clutter.course(masonry, face, 0.0, width, 3.1, about(0.06, 0.02))
    street_life(masonry, face, width)
    return finish(masonry, "arcade", width)


def polygonal_tower(seed: int = 0) -> FacadeScene:
    """Build three sides of an eight-sided tower, each with windows."""
    masonry = begin(seed, 10)
    about, side, top = masonry.about, masonry.about(3.2, 0.2), masonry.about(6.0, 0.2)
    turn = np.radians(45)
    start, across = np.array([0.0, 0.0, -side * np.sin(turn)]), side * np.cos(turn)
    directions = [np.cos(turn) * U + np.sin(turn) * W, U, np.cos(turn) * U - np.sin(turn) * W]
    for direction in directions:
        face = masonry.face(Face(start, direction, standing(0.0, side, top), STONE))
        masonry.room(face, box(0.4, 0.2, side - 0.4, top - 0.4), 1.5)
        for low in (about(1.0), about(3.6)):
            wide = about(0.9, 0.1)
            light = round_arch(0.5 * side - wide / 2, low, wide, about(1.6, 0.1))
            masonry.opening(face, light, WINDOW, 0.25, "round arch")
            fill_window(masonry, face, light, 0.25, any_filling(masonry))
        start = start + side * direction
    # The clutter stands on the ground in front of the middle side.
    masonry.faces.insert(0, masonry.faces.pop(1))
    width = side + 2 * across
    street_life(masonry, masonry.faces[0], side)
    return finish(masonry, "polygonal_tower", width, 3)


FACETS_DEG = 4.0
"""A facet of a round tower lies within 2 mm of the circle."""


def round_tower(seed: int = 0) -> FacadeScene:
    """Build the front of a round tower, with a door and windows."""
    masonry = begin(seed, 11)
    about, radius, top = masonry.about, masonry.about(3.2, 0.2), masonry.about(6.0, 0.2)
    lights = []
    for azimuth in (-45.0, 0.0, 45.0):
        for low, high in ((1.0, 2.5), (3.6, 5.0)):
            half = np.degrees(about(0.45, 0.05) / radius)
            lights.append((about(azimuth, 3.0), half, about(low), about(high)))
    lights[2] = (lights[2][0], lights[2][1], 0.0, about(2.2))
    for azimuth, half, low, high in lights:
        _curved_opening(masonry, radius, azimuth, half, low, high)
    turns = np.arange(-88.0, 88.0 + FACETS_DEG / 2, FACETS_DEG)
    edges = {*turns, *(azimuth + sign * half for azimuth, half, *_ in lights for sign in (-1, 1))}
    stops = np.array(sorted(edges))
    for left, right in zip(stops[:-1], stops[1:]):
        middle = 0.5 * (left + right)
        facet = _facet(radius, left, right, top)
        for azimuth, half, low, high in lights:
            if abs(middle - azimuth) < half:
                facet.outline = facet.outline.difference(box(-1, low if low > 0 else -1, 9, high))
        masonry.face(facet)
    masonry.ground(-8.0, 2 * radius + 8.0)
    stations = [(about(at, 0.5), 1.6, about(8.0)) for at in (radius - 5.0, radius, radius + 5.0)]
    return masonry.scene("round_tower", stations)


def _on_circle(radius: float, azimuth: float, v: float = 0.0) -> np.ndarray:
    """Return the point of a tower that touches w = 0 at u = radius."""
    turn = np.radians(azimuth)
    return (radius + radius * np.sin(turn)) * U + v * V + radius * (np.cos(turn) - 1) * W


def _facet(radius: float, left: float, right: float, top: float) -> Face:
    start, stop = _on_circle(radius, left), _on_circle(radius, right)
    length = float(np.linalg.norm(stop - start))
    return Face(start, (stop - start) / length, standing(0.0, length, top), STONE)


def _curved_opening(
    masonry: Masonry, radius: float, azimuth: float, half: float, low: float, high: float
) -> None:
    """Add an opening that spans an angle; `outline` is what the elevation shows."""
    chord = _facet(radius, azimuth - half, azimuth + half, high)
    length = chord.outline.bounds[2]
    outline = box(0.0, low, length, high)
    masonry.opening(chord, outline, DOOR if low == 0 else WINDOW, 0.25)
    if low == 0:
        fill_door(masonry, chord, outline, 0.25)
    else:
        fill_window(masonry, chord, outline, 0.25, any_filling(masonry))
