"""Remarks on what no reader applies: shifts, rotations, scales, another upward axis, a reference system."""

import re
from collections.abc import Iterable
from pathlib import Path
from typing import Optional

LONGEST = 100
"""Letters of a remark that a message quotes."""

_MOTION = re.compile(
    r"(?<![^\W_])(?:(?P<alone>shift|offset|translation|verschiebung|d[ée]calage|traslazione|desplazamiento"
    r"|scale|scaling|scale[ _]?factor|ma(?:ß|ss)stab(?:sfaktor)?|[ée]chelle|rotation)"
    r"|origin|ursprung|origine|matrix|transform(?:ation)?)s?(?![^\W_]{2})(?P<rest>.*)",
    re.IGNORECASE,
)
"""What moves points; those after 'alone' do so by a single number, too."""

_OTHERS = re.compile(
    r"(?<!cen)time|zeit|heure|gps|clock|intensit|reflectan|amplitude|colou?r|farb|scan\W?lines?|bytes?",
    re.IGNORECASE,
)
"""What else has an offset or a scale."""

_LABELS = re.compile(
    r"(?<![^\W_])(?:[dt]?[xyzenh]|[cm]?m|met(?:er|re)s?|deg|gon)(?![^\W_])\s*[:=]?", re.IGNORECASE
)
"""Names of axes before numbers, and units behind them."""

_THOUSANDS = re.compile(r"(?<=\d)(?:['\u2019](?=\d{3})|\.(?=\d{3}(?:\.\d{3})*,\d+(?![\d.,])))")
"""What divides long numbers, as in 5'812'345.7 or 5.812.345,7."""

_UPWARD = re.compile(
    r"(?<![^\W_])(?:up[ _-]?axis|axis[ _-]?up)\W*[+]?(?P<axis>[xy])(?![^\W_])", re.IGNORECASE
)
_SHORT_UPWARD = re.compile(r"(?<![^\W_])(?P<axis>[xy])[ _-]?(?:axis[ _-]?)?up(?![^\W_])", re.IGNORECASE)
_SYSTEM = re.compile(r"(?<![^\W_])EPSG\W{0,3}(?P<code>\d{4,6})(?!\d)", re.IGNORECASE)
_AUTHORITY = re.compile(r"(?:AUTHORITY|\bID)\s*\[", re.IGNORECASE)
_SYSTEM_WKT = re.compile(
    r"(?:COMPD_?CS|COMPOUNDCRS|PROJ(?:ECTED)?CR?S|GEOG(?:RAPHIC)?CR?S|GEOD(?:ETIC)?CRS|GEOCCS|LOCAL_CS|ENGCRS"
    r"|BOUNDCRS)\s*\[.*",
    re.IGNORECASE,
)
_BRACKETS = re.compile(r"[\[\](){}<>|;_°]")
_DIGITS = re.compile(r"[-+.,\d][-+.,\de]*", re.IGNORECASE)
_NUMBER = re.compile(r"[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:e[-+]?\d+)?", re.IGNORECASE)

_IDENTITIES = (
    [0, 0, 0],
    [1],
    [1, 1, 1],
    [1, 1, 1, 1],
    [1, 0, 0, 0],
    [0, 0, 0, 1],
    [1, 0, 0, 0, 1, 0, 0, 0, 1],
    [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0],
    [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
)
"""Numbers of a shift, a scale, a quaternion, a rotation and a matrix that move nothing."""

PROJECTED = 1e-3
"""By this part a scale may differ from 1 that is one of a projection, as 0.9996 of UTM, and was applied."""


def unapplied_remarks(path: Path, remarks: Iterable[str], of_list: bool = False) -> tuple[str, ...]:
    """Return a sentence on each remark that moves the points or names their reference system.

    Whether a shift is to be added or was added already is not the same in all programs, so none is applied.

    Parameters
    ----------
    path : Path
    remarks : iterable of str
        Lines of a header, with or without the sign of a remark.
    of_list : bool
        Whether the points are those of a list, which transformcloud does not move.
    """
    said = []
    for line in remarks:
        remark = " ".join(line.strip().lstrip("#/;").split())
        upward = _UPWARD.search(remark) or _SHORT_UPWARD.search(remark)
        code = _code(remark)
        if _moves(remark):
            quoted = remark[:LONGEST]
            said.append(
                f"The header of {path} says '{quoted}', which is not applied; apply it to the coordinates of "
                "the list where they need it."
                if of_list
                else f"The header of {path} says '{quoted}', which is not applied; move the points by it "
                "with transformcloud where they need it."
            )
        elif upward:
            said.append(
                f"The header of {path} says that {upward['axis'].lower()} is up, which is not applied; "
                "rotate the points so that z is."
            )
        elif code:
            said.append(system_remark(path, code))
    return tuple(dict.fromkeys(said))


def system_remark(path: Path, code: str) -> str:
    """Return the sentence on a reference system in a remark, to be left out if it was chosen anyway."""
    return (
        f"A remark in {path} names EPSG:{code}, which is not read; choose that reference system if it is "
        "right."
    )


def _moves(remark: str) -> bool:
    """Whether a remark ends with the numbers of a motion that is not the identity."""
    motion = _MOTION.search(remark)
    if not motion or _OTHERS.search(remark):
        return False
    numbers = _last_numbers(motion["rest"])
    if len(numbers) == 1 and (not motion["alone"] or abs(numbers[0] - 1) < PROJECTED):
        return False
    return any(numbers) and numbers not in _IDENTITIES


def _last_numbers(text: str) -> list[float]:
    """Return the last numbers of a text; none if they are fewer than three amid words."""
    text = _LABELS.sub(" ", _THOUSANDS.sub("", text))
    if text.count(" / ") > 1:  # A single one is that of a scale.
        text = text.replace(" / ", " ")
    words = _BRACKETS.sub(" ", re.sub(r"[:=]", " : ", text)).split()
    ends = words and re.search(r"\d", words[-1])
    while words and not re.search(r"\d", words[-1]):
        words.pop()
    last: list[str] = []
    while words and _DIGITS.fullmatch(words[-1]):
        last.insert(0, words.pop())
    follow = not words or (words[-1] == ":" and not re.search(r"\d", " ".join(words)))
    if len(last) < 3 and not (follow and ends):
        return []
    # A comma is a decimal sign, unless there are points or it separates all.
    separates = any("." in word for word in last) or (len(last) == 1 and last[0].count(",") > 1)
    fields = " ".join(last).replace(",", " ").split() if separates else _with_points(last)
    return [float(field) for field in fields] if all(map(_NUMBER.fullmatch, fields)) else []


def _with_points(words: list[str]) -> list[str]:
    """Return numbers with points for decimal commas, without the commas between them."""
    return [word.rstrip(",").replace(",", ".") for word in words if word != ","]


def _code(remark: str) -> Optional[str]:
    """Return the code of the reference system that a remark names; None without one.

    In WKT, those of units, ellipsoids and datums are within further brackets.
    """
    if not _AUTHORITY.search(remark):
        system = _SYSTEM.search(remark)
        return system["code"] if system else None
    found = _SYSTEM_WKT.search(remark)
    wkt = found[0] if found else ""
    codes = [
        system["code"]
        for system in _SYSTEM.finditer(wkt)
        if wkt.count("[", 0, system.start()) - wkt.count("]", 0, system.start()) == 2
    ]
    return codes[-1] if codes else None
