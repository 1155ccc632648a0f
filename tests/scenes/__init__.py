"""Simulated terrestrial laser scans of scenes whose true walls are known."""

from .columns import columns
from .interior import interior
from .rooms import rooms
from .ruins import ruins
from .scene import Scan, Scene
from .terraces import terraces
from .yard import yard

SCENES = {scene.__name__: scene for scene in (interior, yard, ruins, rooms, columns, terraces)}

__all__ = ["SCENES", "Scan", "Scene"]
