"""Simulated coloured scans of facades whose details are known."""

from .medina import medina
from .scene import FacadeScan, FacadeScene, TrueDetail
from .storehouse import storehouse
from .townhouse import townhouse

FACADES = {scene.__name__: scene for scene in (medina, townhouse, storehouse)}

__all__ = ["FACADES", "FacadeScan", "FacadeScene", "TrueDetail"]
