"""Reports: one HTML page each that needs no other file, no network and no script."""

import html
import math
from collections.abc import Container, Iterable, Sequence
from pathlib import Path
from typing import Optional

from ..files import atomic_output

MISSING = "\N{EN DASH}"
"""Stands where a value cannot be known."""

STYLESHEET = """
html { font: 15px/1.5 "Segoe UI", "Helvetica Neue", "DejaVu Sans", Arial, sans-serif; color: #22303a; }
body { max-width: 940px; margin: 2rem auto 4rem; padding: 0 1.2rem; }
h1 { font-size: 1.75rem; font-weight: 600; line-height: 1.25; margin: 0 0 .2rem; }
h2 { font-size: 1.25rem; font-weight: 600; margin: 2.6rem 0 .6rem; padding-bottom: .2rem;
     border-bottom: 1px solid #cfd8dc; }
h3 { font-size: 1rem; font-weight: 600; margin: 1.5rem 0 .4rem; }
p, ul, dl { margin: .4rem 0 .8rem; max-width: 76ch; }
ul { padding-left: 1.3rem; }
dt { font-weight: 600; margin-top: .4rem; }
dd { margin: 0 0 0 1.3rem; }
a { color: #0b5a8c; }
.note { border-left: 3px solid #d08a00; background: #fff8e8; padding: .5rem .9rem; }
.wide { overflow-x: auto; margin: .5rem 0 1rem; }
table { border-collapse: collapse; font-size: .84rem; line-height: 1.35; }
caption { text-align: left; color: #5b6b75; padding-bottom: .3rem; }
th, td { padding: .22rem .5rem; text-align: right; white-space: nowrap; vertical-align: top;
         font-variant-numeric: tabular-nums; border-bottom: 1px solid #e6ebee; }
th { font-weight: 600; white-space: normal; border-bottom: 1px solid #90a4ae; vertical-align: bottom; }
.w { text-align: left; white-space: normal; overflow-wrap: anywhere; min-width: 3.5em; }
.marked td, .red { color: #b3261e; }
figure { margin: .8rem 0 1.4rem; break-inside: avoid; page-break-inside: avoid; }
figcaption { color: #5b6b75; font-size: .84rem; max-width: 92ch; margin-top: .3rem; }
svg { display: block; max-width: 100%; height: auto; }
svg text { font-size: 11px; fill: #37474f; font-family: inherit; }
svg .strong { font-weight: 600; fill: #22303a; }
svg .red { fill: #b3261e; }
svg .end { text-anchor: end; }
svg .middle { text-anchor: middle; }
svg .axis { stroke: #607d8b; fill: none; }
svg .grid { stroke: #e3e9ec; fill: none; }
svg .limit { stroke: #b3261e; stroke-dasharray: 5 3; fill: none; }
@page { margin: 16mm 14mm; }
@media print {
  html { font-size: 11px; }
  body { max-width: none; margin: 0; padding: 0; }
  .wide { overflow: visible; }
  tr { break-inside: avoid; page-break-inside: avoid; }
  h2, h3 { break-after: avoid; page-break-after: avoid; }
  a { color: inherit; text-decoration: none; }
}
"""


class Markup(str):
    """Text that is HTML; any other text is escaped when it gets into a page."""

    __slots__ = ()


def escaped(value: object) -> Markup:
    """Return a value as HTML."""
    return value if isinstance(value, Markup) else Markup(html.escape(str(value)))


def join(parts: Iterable) -> Markup:
    """Return parts, one after the other, as HTML."""
    return Markup("".join(map(escaped, parts)))


def element(tag: str, *children: object, **attributes: object) -> Markup:
    """Return an element; write `class_` for class and `stroke_width` for stroke-width."""
    written = "".join(
        f' {name.rstrip("_").replace("_", "-")}="{html.escape(str(value))}"'
        for name, value in attributes.items()
        if value is not None
    )
    return Markup(f"<{tag}{written}>{join(children)}</{tag}>")


def section(heading: str, *parts: Markup, anchor: Optional[str] = None, level: int = 2) -> Markup:
    """Return a heading, to which links of the page can point, and what stands under it."""
    return join((element(f"h{level}", heading, id=anchor), *parts))


def paragraph(*parts: object) -> Markup:
    """Return a paragraph of texts and markup."""
    return element("p", *parts)


def bullets(items: Iterable) -> Markup:
    """Return a list of texts or markup; nothing if there are none."""
    return _unless_empty("ul", [element("li", item) for item in items])


def notes(sentences: Iterable) -> Markup:
    """Return sentences that the reader must not miss; nothing if there are none."""
    return join(element("p", sentence, class_="note") for sentence in sentences)


def definitions(items: dict) -> Markup:
    """Return terms and what they mean."""
    return _unless_empty(
        "dl", [join((element("dt", term), element("dd", text))) for term, text in items.items()]
    )


def link(text: str, anchor: str) -> Markup:
    """Return a link to a section of the page."""
    return element("a", text, href=f"#{anchor}")


def number(value: Optional[float], decimals: int) -> str:
    """Return a number, or `MISSING` where it is None or nan."""
    if value is None or math.isnan(value):
        return MISSING
    text = f"{value:.{decimals}f}"
    # Minus nothing is nothing.
    return text.lstrip("-") if float(text) == 0 else text


def table(
    header: Sequence,
    rows: Iterable[Sequence],
    words: Container[int] = (0,),
    marked: Container[int] = (),
    caption: Optional[str] = None,
) -> Markup:
    """Return a table.

    Parameters
    ----------
    header : sequence of str
    rows : iterable of sequences
        Texts, or markup.
    words : container of int
        Columns of words, which stand on the left and may be broken; all others hold numbers.
    marked : container of int
        Rows that stand out.
    caption : str, optional
    """
    classes = ["w" if column in words else None for column in range(len(header))]
    head = element("tr", *(element("th", cell, class_=kind) for cell, kind in zip(header, classes)))
    body = (
        element(
            "tr",
            *(element("td", cell, class_=kind) for cell, kind in zip(row, classes)),
            class_="marked" if place in marked else None,
        )
        for place, row in enumerate(rows)
    )
    title = element("caption", caption) if caption else Markup()
    return element(
        "div", element("table", title, element("thead", head), element("tbody", *body)), class_="wide"
    )


def figure(chart: Markup, caption: str) -> Markup:
    """Return a chart with its caption."""
    return element("figure", chart, element("figcaption", caption))


def page(title: str, *parts: Markup) -> str:
    """Return a whole page."""
    head = f'<meta charset="utf-8"><title>{html.escape(title)}</title><style>{STYLESHEET}</style>'
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head>{head}</head>\n'
        f"<body>{element('h1', title)}{join(parts)}</body></html>\n"
    )


def write_page(path: Path, title: str, *parts: Markup) -> None:
    """Write a whole page as UTF-8.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    text = page(title, *parts)
    with atomic_output(path) as temporary:
        # The name of a file can hold bytes that are no text.
        temporary.write_bytes(text.encode("utf-8", errors="replace"))


def _unless_empty(tag: str, items: Sequence[Markup]) -> Markup:
    return element(tag, *items) if items else Markup()
