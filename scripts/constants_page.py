"""Write docs/constants.md: every constant of the settings with its value, kind and reason.

make constants, or: python3 -m ichnograph.scripts.constants_page
"""

import inspect
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from importlib import import_module
from typing import Any, Optional

from ichnograph.algorithms.settings import Constant, constants

from .house import CHAPTERS, ROOT, SHARED, modules

PAGE = ROOT / "docs" / "constants.md"

INTRODUCTION = """\
# Constants

Generated from the settings in the code by `make constants`; change it there. Parameters that a user sets are
described on the pages of the [algorithms](index.md). The kinds say where a value comes from:

* *physical*: from the size or the nature of things;
* *statistical*: from a distribution and a probability;
* *judged*: chosen by looking at results.
"""

UNITS = {
    "m": "m",
    "m2": "m²",
    "px": "pixels",
    "deg": "degrees",
    "ppm": "ppm",
    "mm": "mm",
    "bytes": "bytes",
    "points": "points",
    "share": "share",
    "sd": "standard deviations",
}
"""Units by the ends of names."""


def page() -> str:
    """Return the text of the page."""
    parts = [INTRODUCTION, _summary()]
    for package in (*SHARED, *CHAPTERS):
        found = list(settings_of(package))
        if found:
            parts.append(f"## {_heading(package)}\n")
        parts += [part for settings in found for part in _stages(settings)]
    return "\n".join(parts)


def settings_of(package: str) -> Iterator[Any]:
    """Yield the default settings of a package of `algorithms` that are not part of others."""
    found = [settings for settings in _declared_in(package) if any(constants(settings))]
    inner = {type(part) for settings in found for part in _parts(settings)}
    for settings in found:
        if type(settings) not in inner:
            yield settings


def _declared_in(package: str) -> Iterator[Any]:
    for module in modules(f"algorithms/{package}"):
        if module.path.name == "settings.py":
            loaded = import_module(f"ichnograph.{module.name}")
            for _, value in inspect.getmembers(loaded, inspect.isclass):
                if is_dataclass(value) and value.__module__ == loaded.__name__:
                    yield value()


def _parts(settings: Any) -> Iterator[Any]:
    """Yield the settings within settings, at any depth."""
    for item in fields(settings):
        value = getattr(settings, item.name)
        if is_dataclass(value):
            yield value
            yield from _parts(value)


def _stages(settings: Any) -> Iterator[str]:
    """Yield a heading, the docstring and a table for each stage."""
    by_stage: dict[tuple[str, ...], list[Constant]] = {}
    for constant in constants(settings):
        by_stage.setdefault(constant.path[:-1], []).append(constant)
    for path, declared in by_stage.items():
        stage = settings
        for name in path:
            stage = getattr(stage, name)
        summary = (inspect.getdoc(type(stage)) or "").split("\n\n")[0].replace("\n", " ")
        yield f"### {' / '.join(path) or type(stage).__name__}\n\n{summary}\n"
        yield "| constant | value | unit | kind | reason |\n|---|---|---|---|---|"
        yield "\n".join(map(_row, declared)) + "\n"


def _row(constant: Constant) -> str:
    name = constant.path[-1]
    value = _value(constant.value)
    return f"| {name} | {value} | {_unit(name) or ''} | {constant.kind} | {constant.reason} |"


def _unit(name: str) -> Optional[str]:
    return UNITS.get(name.rpartition("_")[2]) if "_" in name else None


def _value(value: Any) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, (tuple, list)):
        return ", ".join(map(_value, value))
    if isinstance(value, (int, float)):
        return f"{value:,.10g}".replace(",", " ") if abs(value) >= 10_000 else f"{value:g}"
    return "derived" if value is None else str(value)


def _summary() -> str:
    kinds = ("physical", "statistical", "judged")
    lines = [f"| chapter | {' | '.join(kinds)} |", "|---|---|---|---|"]
    for package in (*SHARED, *CHAPTERS):
        declared = [constant.kind for settings in settings_of(package) for constant in constants(settings)]
        if declared:
            counts = " | ".join(str(declared.count(kind)) for kind in kinds)
            lines.append(f"| [{_heading(package)}](#{package.replace('_', '-')}) | {counts} |")
    return "\n".join(lines) + "\n"


def _heading(package: str) -> str:
    return package.replace("_", " ").capitalize()


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
    print(f"{PAGE.relative_to(ROOT)} is written.")
