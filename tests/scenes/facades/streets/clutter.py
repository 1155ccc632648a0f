"""What stands in front of walls and hangs on them."""

import numpy as np
from shapely.geometry import Point, Polygon, box

from ..building import STONE, TRUNK
from .masonry import Face, Masonry

GREY, CLOTH = (120.0, 125.0, 130.0), (60.0, 70.0, 110.0)


def sill(masonry: Masonry, face: Face, opening: Polygon, out: float = 0.1) -> None:
    """Add a sill that stands out under an opening; from the street it hides the lower edge."""
    left, bottom, right, _ = opening.bounds
    masonry.block(face, box(left - 0.06, bottom - 0.06, right + 0.06, bottom), 0.0, out, STONE, 0.6)


def surround(masonry: Masonry, face: Face, opening: Polygon, out: float, width: float = 0.14) -> None:
    """Add a stone frame that stands out around an opening."""
    band = opening.buffer(width, join_style=2).difference(opening)
    masonry.front(face, band, out, STONE, 0.6)
    masonry.sides(face, opening, 0.0, out, STONE, 0.6)
    masonry.sides(face, opening.buffer(width, join_style=2), 0.0, out, STONE, 0.6)


def quoins(masonry: Masonry, face: Face, a: float, inward: int, top: float, out: float = 0.025) -> None:
    """Add blocks at a corner, long and short in turn."""
    for number, low in enumerate(np.arange(0.0, top - 0.3, 0.33)):
        stop = a + inward * (0.5 if number % 2 else 0.3)
        masonry.block(face, box(min(a, stop), low, max(a, stop), low + 0.31), 0.0, out, STONE, 0.6)


def course(masonry: Masonry, face: Face, left: float, right: float, v: float, out: float) -> None:
    """Add a string course or a cornice."""
    masonry.block(face, box(left, v, right, v + masonry.about(0.16, 0.03)), 0.0, out, STONE, 0.6)


def downpipe(masonry: Masonry, face: Face, a: float, top: float) -> None:
    """Add a pipe from the eaves to the pavement."""
    masonry.block(face, box(a - 0.05, 0.0, a + 0.05, top), 0.04, 0.14, GREY, 0.5)


def sign(masonry: Masonry, face: Face, outline: Polygon, out: float = 0.12) -> None:
    """Hang a board on the wall."""
    masonry.block(face, outline, 0.02, out, (40.0, 60.0, 120.0), 0.5)


def hanging_sign(masonry: Masonry, u: float, v: float, w: float = 0.0) -> None:
    """Hang a board across the pavement."""
    masonry.block(
        masonry.faces[0], box(u - 0.03, v, u + 0.03, v + 0.6), w + 0.2, w + 0.9, (160.0, 30.0, 40.0), 0.5
    )


def stain(masonry: Masonry, face: Face, a: float, v: float, size: float) -> None:
    """Darken the plaster where water ran down."""
    turns = np.linspace(0, 2 * np.pi, 14, endpoint=False)
    radii = size * masonry.generator.uniform(0.5, 1.0, len(turns))
    corners = [
        (a + 0.5 * radius * np.sin(turn), v + radius * np.cos(turn)) for radius, turn in zip(radii, turns)
    ]
    shape = Polygon(corners).buffer(0).intersection(face.outline)
    for opening in face.openings:
        shape = shape.difference(opening.buffer(0.01))
    for part in getattr(shape, "geoms", [shape]):
        if not part.is_empty:
            masonry.front(face, part, 0.0005, tuple(0.6 * value for value in face.colour), 0.6)


def joints(masonry: Masonry, face: Face, left: float, right: float, top: float) -> None:
    """Draw the joints of ashlar, 8 mm wide, up to a height."""
    for v in np.arange(0.45, top, 0.45):
        line = box(left, v, right, v + 0.008)
        for opening in face.openings:
            line = line.difference(opening.buffer(0.01))
        for part in getattr(line, "geoms", [line]):
            masonry.front(face, part, 0.0003, tuple(0.55 * value for value in face.colour), 0.5)


def person(masonry: Masonry, u: float, w: float) -> None:
    """Let somebody stand on the pavement."""
    ground, tall = masonry.faces[0], masonry.about(1.7, 0.12)
    low = w - float(ground.origin[2])
    masonry.block(ground, box(u - 0.22, 0.0, u + 0.22, tall - 0.25), low - 0.13, low + 0.13, CLOTH, 0.4)
    masonry.block(
        ground, Point(u, tall - 0.12).buffer(0.11, 3), low - 0.1, low + 0.1, (200.0, 160.0, 140.0), 0.5
    )


def car(masonry: Masonry, u: float, w: float = 2.4) -> None:
    """Park a car along the pavement."""
    ground, length = masonry.faces[0], masonry.about(4.1, 0.3)
    low = w - float(ground.origin[2])
    paint = tuple(masonry.generator.uniform(20, 220, 3))
    body = box(u, 0.1, u + length, 0.75)
    cabin = Polygon([(u + 0.9, 0.75), (u + length - 0.4, 0.75), (u + length - 0.9, 1.4), (u + 1.5, 1.4)])
    masonry.block(ground, body, low, low + 1.7, paint, 0.5)
    masonry.block(ground, cabin, low + 0.1, low + 1.6, (50.0, 55.0, 60.0), 0.2)


def tree(masonry: Masonry, u: float, w: float, crown: float, radius: float) -> None:
    """Plant a tree whose crown is around v = crown."""
    ground = masonry.faces[0]
    low = w - float(ground.origin[2])
    masonry.block(ground, box(u - 0.12, -0.3, u + 0.12, crown), low - 0.12, low + 0.12, TRUNK, 0.4)
    for du, dv, share in ((0, 0, 1.0), (0.5, 0.3, 0.7), (-0.45, 0.35, 0.7)):
        masonry.foliage(u + du * radius, crown + dv * radius, w, share * radius)


def balcony(masonry: Masonry, face: Face, left: float, right: float, level: float, out: float) -> None:
    """Add a slab with a railing of bars."""
    masonry.block(face, box(left, level - 0.14, right, level), 0.0, out, STONE, 0.6)
    rail = box(left, level + 0.95, right, level + 1.0)
    masonry.block(face, rail, out - 0.05, out, GREY, 0.5)
    for a in np.arange(left, right, 0.13):
        masonry.front(face, box(a, level, a + 0.018, level + 0.95), out - 0.02, GREY, 0.5)
    for end in (left, right):
        masonry.sides(face, box(end, level + 0.95, end + 1e-3, level + 1.0), 0.0, out, GREY, 0.5)


def shutters(masonry: Masonry, face: Face, opening: Polygon) -> None:
    """Open two leaves of shutters against the wall."""
    left, bottom, right, top = opening.bounds
    leaf = 0.5 * (right - left)
    for start in (left - leaf - 0.02, right + 0.02):
        masonry.block(
            face, box(start, bottom - 0.01, start + leaf, top), 0.01, 0.045, (70.0, 105.0, 85.0), 0.35
        )
