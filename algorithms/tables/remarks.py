"""Remarks on what no reader applies: shifts, rotations, scales, another upward axis, a reference system."""

import re
from collections.abc import Iterable
from pathlib import Path

LONGEST = 100
"""Letters of a remark that a message quotes."""

_MOTION = re.compile(
    r"(?<![^\W_])(?:shift|offset|origin|translation|verschiebung|ursprung|d[ée]calage|origine|traslazione"
    r"|desplazamiento|scale|scaling|scale[ _]?factor|ma(?:ß|ss)stab|[ée]chelle|matrix|rotation"
    r"|transform(?:ation)?)(?![^\W_]{2})(?P<rest>.*)",
    re.IGNORECASE,
)
_OTHERS = re.compile(r"time|zeit|heure|gps|clock|intensit|colou?r|farb|scan\W?lines?|bytes?", re.IGNORECASE)
"""What else has an offset or a scale."""

_UPWARD = re.compile(
    r"(?<![^\W_])(?:up[ _-]?axis|axis[ _-]?up)\W*[+]?(?P<axis>[xy])(?![^\W_])", re.IGNORECASE
)
_SHORT_UPWARD = re.compile(r"(?<![^\W_])(?P<axis>[xy])[ _-]?(?:axis[ _-]?)?up(?![^\W_])", re.IGNORECASE)
_SYSTEM = re.compile(r"(?<![^\W_])EPSG\W{0,3}(?P<code>\d{4,6})(?!\d)", re.IGNORECASE)
_NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:e[-+]?\d+)?(?![\w.])", re.IGNORECASE)

_IDENTITIES = (
    [0, 0, 0],
    [1],
    [1, 1, 1],
    [1, 0, 0, 0, 1, 0, 0, 0, 1],
    [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
)
"""Numbers of a shift, a scale, a rotation and a matrix that move nothing."""


def unapplied_remarks(path: Path, remarks: Iterable[str]) -> tuple[str, ...]:
    """Return a sentence on each remark that moves the points or names their reference system.

    Whether a shift is to be added or was added already is not the same in all programs, so none is applied.

    Parameters
    ----------
    path : Path
    remarks : iterable of str
        Lines of a header, with or without the sign of a remark.
    """
    said = []
    for line in remarks:
        remark = " ".join(line.strip().lstrip("#/;").split())[:LONGEST]
        upward = _UPWARD.search(remark) or _SHORT_UPWARD.search(remark)
        system = _SYSTEM.search(remark)
        if _moves(remark):
            said.append(
                f"The header of {path} says '{remark}', which is not applied; move the points by it with "
                "transformcloud where they need it."
            )
        elif upward:
            said.append(
                f"The header of {path} says that {upward['axis'].lower()} is up, which is not applied; "
                "rotate the points so that z is."
            )
        elif system:
            said.append(
                f"A remark in {path} names EPSG:{system['code']}, which is not read; choose that reference "
                "system if it is right."
            )
    return tuple(dict.fromkeys(said))


def _moves(remark: str) -> bool:
    """Whether a remark has numbers of a motion that is not the identity."""
    motion = _MOTION.search(remark)
    if not motion or _OTHERS.search(remark):
        return False
    numbers = [float(number.replace(",", ".")) for number in _NUMBER.findall(motion["rest"])]
    return any(numbers) and numbers not in _IDENTITIES
