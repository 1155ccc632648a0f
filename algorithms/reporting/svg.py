"""What the drawings of reports have in common; the styles of their texts and lines are those of `html`."""

import math
from typing import Optional

from .html import Markup, element

WIDTH = 900.0
"""Of every drawing, in pixels."""

COLOURS = ("#3b78a8", "#e0a030", "#3f9c78", "#8a6bb0", "#c2607f", "#7a8b2f", "#5aa9b5", "#a5714b")
"""Of series; told apart by the colour-blind as far as eight colours can be."""

RED = "#b3261e"
GREY = "#90a4ae"

LETTER = 6.8
"""Mean width of a letter of 11 pixels."""

LINE = 12.0
"""Height of a line of such letters."""


def drawing(height: float, *parts: Markup) -> Markup:
    """Return parts as an SVG of `WIDTH` by `height` pixels."""
    size = {"width": f"{WIDTH:.0f}", "height": f"{height:.0f}", "viewBox": f"0 0 {WIDTH:.0f} {height:.0f}"}
    return element("svg", *parts, **size)


def stroke(path: str, colour: str, width: float, **attributes: object) -> Markup:
    """Return a path that is drawn with a pen."""
    return element("path", d=path, fill="none", stroke=colour, stroke_width=width, **attributes)


def text(x: float, y: float, words: str, kind: Optional[str] = "middle") -> Markup:
    """Return words on a base line; `kind` is a class of the stylesheet."""
    return element("text", words, x=f"{x:.1f}", y=f"{y:.1f}", class_=kind)


def round_step(value: float) -> float:
    """Return the largest of 1, 2 or 5 times a power of ten that is not above `value`."""
    power = 10.0 ** math.floor(math.log10(value) + 1e-9)
    return max(step * power for step in (1, 2, 5) if step * power <= value * (1 + 1e-9))
