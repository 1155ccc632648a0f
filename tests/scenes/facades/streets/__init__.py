"""Simulated scans of facades as they stand in the street, with rooms, people, cars and trees.

Public names: `STREETS`, the streets by name, each a function of a seed; `openings.TrueOpening`;
`cuts.CUTS`, the parts of a scan that users keep; `judging.judge_street`.
"""

from .churches import arcade, church, polygonal_tower, round_tower
from .houses import shops, terrace, warehouse
from .layered import balconies, bay, gable, setback

STREETS = {
    street.__name__: street
    for street in (
        terrace, shops, warehouse, setback, gable, bay, balconies, church, arcade, polygonal_tower,
        round_tower,
    )
}  # fmt: skip

__all__ = ["STREETS"]
