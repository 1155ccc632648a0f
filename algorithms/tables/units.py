"""Units of lengths in the names of columns."""

import re
from typing import Optional

METRES = {
    **dict.fromkeys(
        ("um", "micrometer", "micrometre", "micrometers", "micrometres", "micron", "microns"), 1e-6
    ),
    **dict.fromkeys(("mm", "millimeter", "millimetre", "millimeters", "millimetres", "millimetri"), 1e-3),
    **dict.fromkeys(("cm", "centimeter", "centimetre", "centimeters", "centimetres", "zentimeter"), 1e-2),
    **dict.fromkeys(("dm", "decimeter", "decimetre", "dezimeter"), 1e-1),
    **dict.fromkeys(("m", "meter", "metre", "meters", "metres", "metri", "metro", "metros"), 1.0),
    **dict.fromkeys(("km", "kilometer", "kilometre", "kilometers", "kilometres"), 1e3),
}
"""How long the units are that are converted."""

GEODETIC = frozenset(("gon", "grad", "rad"))
"""Units of angles in which no coordinates are given, as they are in degrees."""

REFUSED = frozenset(
    (
        *("ift", "intft", "ftint", "ftintl", "intlft", "internationalfeet", "internationalfoot", "lf"),
        *(
            "ussft",
            "usfeet",
            "usfoot",
            "ussurveyft",
            "ussurveyfeet",
            "ussurveyfoot",
            "surveyfeet",
            "surveyfoot",
        ),
        *("ft", "feet", "foot", "usft", "ftus", "sft", "in", "inch", "inches", "yd", "yard", "yards"),
        *("mi", "mile", "miles", "chain", "chains", "rod", "rods", "fathom", "fathoms"),
        *("fuss", "zoll", "pied", "pieds", "pouce", "pouces", "toise", "toises"),
        *("piede", "piedi", "pollice", "pollici", "pie", "pies", "pulgada", "pulgadas", "vara", "varas"),
        *("deg", "degree", "degrees", *GEODETIC),
    )
)
"""Units that are refused: there are several of their names, or they are angles."""

MARKS = {'"': "in", "''": "in", "'": "ft", "\u2032": "ft", "\u2033": "in", "\u00b0": "deg"}
"""Units that are written as marks."""

_BRACKETS = re.compile(r"[\[({<]\s*(?:in\s+)?([^\])}>]*?)\s*[\])}>]")
_SUFFIX = re.compile(
    r"(?<=[^\W_])(?:[\s_/]|\s+(?:in|en)\s+)(µm|um|mm|cm|dm|km|m|ft|us-?ft|feet|foot|inch|inches|metres?|meters?)\s*$"
)
_MULTIPLE = re.compile(r"[\d.,/*x\u00d7\s]*\d[\d.,/*x\u00d7\s]*([^\W\d]+)|([^\W\d]+)\s*/\s*\d+")
"""A unit that is multiplied or divided, as in '0.1 mm'."""

_UNIT = r"\b(?:units?|einheit(?:en)?|unit[ée]s?|unit[àa]|unidad(?:es)?)\b"
_WHAT = (
    r"(?:coordinates?|coords?|koordinaten|coordonn[ée]es|coordenadas|x\W*y\W*z|points?|punkte|values?|werte"
    r"|lengths?|dimensions?|l[äa]ngen|ma(?:ß|ss)e|mesures|misure|medidas|data|daten)"
)
_WRITTEN = r"(?:exports?|export(?:ed|iert|[ée]e?s?)|esportat[oaie]|exportad[oa]s?|files?|clouds?|scans?)"
_ARE = r"(?:\s+(?:are|is|sind|sont|sono|son|given|angegeben))*"
_OF_ALL = rf"(?:{_WHAT}|linear|distances?|measurements?|files?|exports?|models?|clouds?|scans?|global)"
_REMARKS = (
    re.compile(
        # Not of angles, of voxels or of an instrument: their unit follows other words.
        rf"(?:^|[.,;:|(])\W*(?:(?:the|all)\s+)?(?:{_OF_ALL}\s+)?{_UNIT}"
        r"\s*(?:[:=,;|\t]|(?:in|are|is|sind|ist|sont|est|son|es)\b)"
        r"\s*(?:in\s+)?(?:(?:us|survey|international|intl)[\s-]+)*([^\s,;]+)"
    ),
    re.compile(rf"\W*(?:the\s+)?{_UNIT}\s+(\S+?)\W*"),
    re.compile(
        # A file or a scan may be called M, but is not written in it.
        rf"\W*(?:(?:all|alle|toutes?|tutte|todas)\s+)?(?:(?:the|les|le|las)\s+)?"
        rf"(?:(?:{_WHAT})?{_ARE}\s*(?:\b(?:in|en)\s|[:=(\[])|{_WRITTEN}{_ARE}\s+(?:in|en)\s)\s*(\w+)\W*"
    ),
    re.compile(
        r"\W*(?:(?:us|u\.s\.?|survey|international|intl)[\s-]+)*"
        r"((?:milli|centi|deci|kilo)?met(?:er|re)s?|mm|cm|dm|m|km|ft|us-?ft|feet|foot|inch|inches)\W*"
    ),
)
"""How a remark states the unit: after a word for it that begins a phrase, as all that it says of the
coordinates, or alone."""


def unit_of(name: str) -> Optional[str]:
    """Return the unit in the name of a column, as in 'X [mm]', 'x_mm' or 'Width (in cm)'; None without one.

    >>> unit_of("Easting [US-ft]"), unit_of("z_mm"), unit_of("height")
    ('usft', 'mm', None)
    """
    for match in (_BRACKETS.search(name.lower()), _SUFFIX.search(name.lower().strip(' "'))):
        unit = match and _plain(match.group(1))
        if unit and _is_known(unit):
            return unit
    return None


def unit_of_remark(line: str) -> Optional[str]:
    """Return the unit that a line such as '# units: mm' or '# all in mm' states; None without one."""
    text = line.lower().strip()
    for match in (_REMARKS[0].search(text), *(pattern.fullmatch(text) for pattern in _REMARKS[1:])):
        unit = _plain(match.group(1)) if match else ""
        # 'Unit in ...' is seldom about inches.
        if unit != "in" and unit not in GEODETIC and _is_known(unit):
            return unit
    return None


def is_unit(field: str) -> bool:
    """Whether a field holds nothing but a unit, as in a second line of a header."""
    plain = _plain(field.strip().strip("[](){}"))
    return plain in METRES or plain in REFUSED


def as_unit(field: str) -> Optional[str]:
    """Return the unit that a field of nothing but a unit holds; None if it holds something else."""
    return _plain(field.strip().strip("[](){}")) if is_unit(field) else None


def without_unit(name: str) -> str:
    """Return the name of a column without its unit and without other remarks in brackets."""
    return _SUFFIX.sub("", re.sub(r"[\[({<].*?[\])}>]", "", name).strip(' "').lower())


def factor_of(unit: Optional[str]) -> Optional[float]:
    """Return how many metres a unit is, 1 for none; None if it is not metric."""
    return METRES.get(unit) if unit else 1.0


def _is_known(unit: str) -> bool:
    return unit in METRES or unit in REFUSED or bool(_MULTIPLE.fullmatch(unit))


def _plain(unit: str) -> str:
    """Return a unit in plain small letters; a multiple as it is written, so that it is refused."""
    text = unit.lower().strip().replace("µ", "u").replace("\u03bc", "u").replace("ß", "ss")
    multiple = _MULTIPLE.fullmatch(text)
    if multiple and (multiple.group(1) or multiple.group(2)) in (*METRES, *REFUSED):
        return text
    return MARKS.get(text) or re.sub(r"[^a-z]", "", text)
