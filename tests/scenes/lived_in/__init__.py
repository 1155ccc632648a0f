"""Simulated scans of buildings in use: furnished, glazed, partly unscanned, hand-held, vaulted."""

from .flat import flat
from .handheld import handheld
from .loft import loft
from .vaulted import vaulted
from .workshop import workshop

LIVED_IN = {scene.__name__: scene for scene in (flat, handheld, loft, vaulted, workshop)}

__all__ = ["LIVED_IN"]
