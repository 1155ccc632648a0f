"""The help beside a dialog: in sections with bold names on the desktop, plain text headless."""

from collections.abc import Iterable, Mapping, Sequence

from .desktop import on_desktop
from .labels import with_labels
from .language import translated
from .parameters.parameter import Parameter

Entry = tuple[str, str]
"""The label of a parameter, and what it does."""


def help_of(
    about: str, inputs: Sequence[Parameter], outputs: Sequence[Parameter], labels: Mapping[str, str]
) -> str:
    """Return the help of an algorithm; QGIS makes a paragraph of each line.

    Parameters
    ----------
    about : str
        What the algorithm does.
    inputs, outputs : sequence of Parameter
    labels : dict of str to str
        What a person reads in place of each id in the texts.
    """
    advanced = [item for item in inputs if getattr(item, "advanced", False)]
    basic = [item for item in inputs if item not in advanced]
    sections = {"Parameters": basic, "Advanced parameters": advanced, "Outputs": outputs}
    page = help_page(translated(about), {title: map(_entry, items) for title, items in sections.items()})
    # Who writes commands knows the ids; in a dialog, only the labels are seen.
    return with_labels(page, labels) if on_desktop() else page


def help_page(about: str, sections: Mapping[str, Iterable[Entry]]) -> str:
    """Return a help of texts that are in the language of QGIS already, besides the titles of the sections.

    Parameters
    ----------
    about : str
    sections : dict of str to iterable of Entry
        By their titles; empty ones are left out.
    """
    lines = [about]
    for title, entries in sections.items():
        texts = [*map(_rich if on_desktop() else _plain, entries)]
        if texts and on_desktop():
            lines.append(f"<h3>{translated(title)}</h3>")
        lines += texts
    return "\n".join(lines)


def _entry(item: Parameter) -> Entry:
    return translated(item.description), translated(item.explanation)


def _plain(entry: Entry) -> str:
    return ": ".join(entry)


def _rich(entry: Entry) -> str:
    label, text = entry
    return f"<b>{label}</b><br>{text}"
