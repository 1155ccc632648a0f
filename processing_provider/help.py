"""The help beside a dialog: in sections with bold names on the desktop, plain text headless."""

from collections.abc import Iterable

from .desktop import on_desktop
from .language import translated
from .parameters.parameter import Parameter


def help_of(about: str, inputs: Iterable[Parameter], outputs: Iterable[Parameter]) -> str:
    """Return the help of an algorithm; QGIS makes a paragraph of each line.

    Parameters
    ----------
    about : str
        What the algorithm does.
    inputs, outputs : iterable of Parameter
    """
    if not on_desktop():
        return "\n".join([translated(about), *map(_plain, inputs), *map(_plain, outputs)])
    advanced = [item for item in inputs if getattr(item, "advanced", False)]
    basic = [item for item in inputs if item not in advanced]
    sections = {"Parameters": basic, "Advanced parameters": advanced, "Outputs": list(outputs)}
    lines = [translated(about)]
    for title, items in sections.items():
        if items:
            lines += [f"<h3>{translated(title)}</h3>", *map(_rich, items)]
    return "\n".join(lines)


def _plain(item: Parameter) -> str:
    return f"{translated(item.description)}: {translated(item.explanation)}"


def _rich(item: Parameter) -> str:
    return f"<b>{translated(item.description)}</b><br>{translated(item.explanation)}"
