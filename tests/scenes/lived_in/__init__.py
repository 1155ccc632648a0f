"""Simulated scans of buildings in use: furnished, glazed, partly unscanned, hand-held, vaulted, sparse."""

from .depot import depot
from .flat import flat
from .handheld import handheld
from .loft import loft
from .office import office
from .terraced_house import terraced_house
from .vaulted import vaulted
from .workshop import workshop

LIVED_IN = {
    scene.__name__: scene
    for scene in (flat, handheld, loft, vaulted, workshop, office, depot, terraced_house)
}

__all__ = ["LIVED_IN"]
