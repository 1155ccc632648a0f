"""Numbers as people read them."""

import math
from typing import Optional

MISSING = "\N{EN DASH}"
"""Replaces a value that cannot be known."""


def number(value: Optional[float], decimals: int) -> str:
    """Return a number with so many decimals, or `MISSING` where it is None or nan."""
    if value is None or math.isnan(value):
        return MISSING
    text = f"{value:.{decimals}f}"
    # A zero has no sign.
    return text.lstrip("-") if float(text) == 0 else text


def round_step(value: float) -> float:
    """Return the largest of 1, 2 or 5 times a power of ten that is not above `value`."""
    power = 10.0 ** math.floor(math.log10(value) + 1e-9)
    return max(step * power for step in (1, 2, 5) if step * power <= value * (1 + 1e-9))
