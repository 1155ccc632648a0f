"""Pages: one HTML file each that needs no other file, no network and no script."""

from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from ..files import atomic_output
from .numbers import MISSING, number

TEMPLATES = Path(__file__).parent / "templates"
"""Holds the frame of all pages, their style, and the macros for tables, notes and figures."""


def render(template: Path, **content: object) -> str:
    """Return a page.

    Parameters
    ----------
    template : Path
        Extends page.html, sets `title` and fills the block `content`; may import macros.html.
    **content : object
        What the template shows. Text is escaped; the drawings that `figure` gets are markup.
    """
    environment = Environment(
        loader=FileSystemLoader([str(TEMPLATES), str(template.parent)]),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["number"] = number
    environment.globals["MISSING"] = MISSING
    return environment.get_template(template.name).render(content)


def write_page(path: Path, template: Path, **content: object) -> None:
    """Write a page as UTF-8; see `render`.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    text = render(template, **content)
    with atomic_output(path) as temporary:
        # The name of a file can hold bytes that are not text.
        temporary.write_bytes(text.encode("utf-8", errors="replace"))
