"""Figures of reports: drawn by matplotlib, written as SVG that stands in a page."""

import io
import re
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from matplotlib import style
from matplotlib.figure import Figure

WIDTH = 900.0
"""Of every figure, in pixels."""

COLOURS = ("#3b78a8", "#e0a030", "#3f9c78", "#8a6bb0", "#c2607f", "#7a8b2f", "#5aa9b5", "#a5714b")
"""Of series; as distinct for the colour-blind as eight colours can be."""

RED = "#b3261e"
GREY = "#90a4ae"
INK = "#22303a"
AXIS = "#607d8b"
GRID = "#e3e9ec"
TEXT = "#37474f"

LETTER = 6.8
"""Mean width of a letter of 11 pixels."""

LINE = 12.0
"""Height of a line of such letters."""

STYLE = Path(__file__).parent / "templates" / "figures.mplstyle"

WITHOUT_METADATA = dict.fromkeys(("Creator", "Date", "Format", "Type"))

FRAME = re.compile(
    r"^.*?<svg[^>]*>|</svg>\s*$|<style.*?</style>|<clipPath.*?</clipPath>|<g\b[^>]*>|</g>", re.DOTALL
)
"""What a page does not need of a file of matplotlib: prolog, style, clips and groups."""

ATTRIBUTES = re.compile(
    r' clip-path="[^"]*"| transform="rotate\(-?0 [^"]*"'
    r"|font(-size)?: 11px( 'DejaVu Sans')?; |font-family: 'DejaVu Sans'; |(?<=base64,)\s+"
)
"""What it does not need within a tag: clips, rotations by 0, and the usual font."""


@contextmanager
def canvas(height: float) -> Iterator[Figure]:
    """Give an empty figure of `WIDTH` by `height` pixels; to be drawn and written in the body.

    The settings of matplotlib that the user or another plugin has made do not matter in the body, and are
    as before after it.
    """
    with style.context(["default", str(STYLE)]), warnings.catch_warnings():
        # The page has the letters that DejaVu Sans lacks.
        warnings.filterwarnings("ignore", message="Glyph .* missing")
        yield Figure(figsize=(WIDTH / 72, height / 72))


def svg(figure: Figure) -> str:
    """Return a figure as an SVG element for a page."""
    file = io.StringIO()
    figure.savefig(file, format="svg", metadata=WITHOUT_METADATA)
    text = FRAME.sub("", file.getvalue())
    # Within tags only: a name may look like an attribute.
    text = re.sub(r"<[^>]+>", _for_a_page, text)
    text = re.sub(r">\s+<", "><", text).replace("<defs></defs>", "").strip()
    width, height = (f"{72 * inches:.0f}" for inches in figure.get_size_inches())
    return f'<svg width="{width}" height="{height}" viewBox="0 0 {width} {height}">{text}</svg>'


def _for_a_page(tag: "re.Match[str]") -> str:
    return " ".join(ATTRIBUTES.sub("", tag.group()).replace("xlink:href=", "href=").split())


def plain(text: str) -> str:
    """Return a text that matplotlib writes letter by letter: no formulas, one line, no half letters."""
    text = " ".join(text.encode("utf-8", errors="replace").decode("utf-8").split())
    return text.replace("$", r"\$")
