"""Units of lengths in the names of columns."""

import re
from typing import Optional

METRES = {
    **dict.fromkeys(("mm", "millimeter", "millimetre", "millimeters", "millimetres", "millimetri"), 1e-3),
    **dict.fromkeys(("cm", "centimeter", "centimetre", "centimeters", "centimetres", "zentimeter"), 1e-2),
    **dict.fromkeys(("dm", "decimeter", "decimetre", "dezimeter"), 1e-1),
    **dict.fromkeys(("m", "meter", "metre", "meters", "metres", "metri", "metro", "metros"), 1.0),
    **dict.fromkeys(("km", "kilometer", "kilometre", "kilometers", "kilometres"), 1e3),
}
"""How long the units are that are converted."""

FEET = (
    "ft",
    "feet",
    "foot",
    "usft",
    "ftus",
    "sft",
    "in",
    "inch",
    "inches",
    "yd",
    "yard",
    "yards",
    "piedi",
    "pied",
)
"""Units that are refused, because there are several of their names."""

_BRACKETS = re.compile(r"[\[({<]\s*(?:in\s+)?([^\])}>]*?)\s*[\])}>]")
_SUFFIX = re.compile(
    r"(?<=[^\W_])(?:[\s_/]|\s+in\s+)(mm|cm|dm|km|m|ft|us-?ft|feet|foot|inch|inches|metres?|meters?)\s*$"
)
_REMARK = re.compile(
    r"\b(?:units?|einheit(?:en)?|unit[ée]s?|unit[àa]|unidad(?:es)?)\b\s*(?:[:=]|(?:in|are|is|sind|ist|sont|est|son|es)\b)"
    r"\s*(?:in\s+)?(?:(?:us|survey|international|intl)[\s-]+)*([^\s,;]+)"
)


def unit_of(name: str) -> Optional[str]:
    """Return the unit in the name of a column, as in 'X [mm]', 'x_mm' or 'Width (in cm)'; None without one.

    >>> unit_of("Easting [US-ft]"), unit_of("z_mm"), unit_of("height")
    ('usft', 'mm', None)
    """
    for match in (_BRACKETS.search(name.lower()), _SUFFIX.search(name.lower().strip(' "'))):
        unit = match and _plain(match.group(1))
        if unit and (unit in METRES or unit in FEET):
            return unit
    return None


def unit_of_remark(line: str) -> Optional[str]:
    """Return the unit that a line such as '# units: mm' states; None without one."""
    match = _REMARK.search(line.lower())
    unit = _plain(match.group(1)) if match else ""
    # 'Unit in ...' is seldom about inches.
    return unit if unit != "in" and (unit in METRES or unit in FEET) else None


def is_unit(field: str) -> bool:
    """Whether a field holds nothing but a unit, as in a second line of a header."""
    plain = _plain(field.strip().strip("[](){}"))
    return plain in METRES or plain in FEET


def as_unit(field: str) -> Optional[str]:
    """Return the unit that a field of nothing but a unit holds; None if it holds something else."""
    return _plain(field.strip().strip("[](){}")) if is_unit(field) else None


def without_unit(name: str) -> str:
    """Return the name of a column without its unit and without other remarks in brackets."""
    return _SUFFIX.sub("", re.sub(r"[\[({<].*?[\])}>]", "", name).strip(' "').lower())


def factor_of(unit: Optional[str]) -> Optional[float]:
    """Return how many metres a unit is, 1 for none; None if it is not metric."""
    return METRES.get(unit) if unit else 1.0


def _plain(unit: str) -> str:
    return re.sub(r"[^a-z]", "", unit.lower())
