"""Scans registered one after the other, as far as the control points reach (paper, chapter 4)."""

from dataclasses import dataclass

import numpy as np

from ..progress import Progress
from .adjustment.control_network import ControlNetwork
from .adjustment.similarity import Pose
from .densification import PlacedScan, placed_scan
from .lists.point_list import PointList
from .matching.refusals import Refusal
from .matching.scan_matching import UNEXPLAINED, ScanMatch, match_scan
from .settings import Settings


@dataclass(frozen=True)
class SequentialRegistration:
    """The scans that could be registered, and the others.

    Attributes
    ----------
    network : ControlNetwork
    placed : tuple of PlacedScan
        In the order in which the scans were registered.
    refused : dict of str to Refusal
        By the name of the scan.
    """

    network: ControlNetwork
    placed: tuple[PlacedScan, ...]
    refused: dict[str, Refusal]


def register_in_sequence(
    scans: dict[str, PointList],
    network: ControlNetwork,
    settings: Settings,
    progress: Progress = Progress(),
) -> SequentialRegistration:
    """Register scans in the order that works, and append their unmatched targets.

    Parameters
    ----------
    scans : dict of str to PointList
        Near the origin.
    network : ControlNetwork
        The surveyed points.
    settings : Settings
    progress : Progress
    """
    placed: list[PlacedScan] = []
    waiting = dict(sorted(scans.items()))
    refused: dict[str, Refusal] = {}
    number = 0
    while waiting:
        number += 1
        matches: dict[str, ScanMatch] = {}
        refused = {}
        for name, scan in waiting.items():
            part = progress.part(len(placed) / len(scans), (len(placed) + 1) / len(scans))
            part.update(0.0, f"Matching {name}")
            result = match_scan(scan, network, settings, explain=False, progress=part)
            if isinstance(result, ScanMatch):
                matches[name] = result
            else:
                refused[name] = result
        if not matches:
            break
        for name in _surest(matches, settings.matches.accidents.certain):
            registered, network = placed_scan(waiting.pop(name), matches[name], network, settings, number)
            placed.append(registered)
    for name, scan in waiting.items():
        if refused[name] is not UNEXPLAINED:
            continue
        part = progress.part(len(placed) / len(scans), 1.0)
        part.update(0.0, f"Searching why {name} does not match")
        result = match_scan(scan, network, settings, progress=part)
        if isinstance(result, Refusal):
            refused[name] = result
    return SequentialRegistration(network, tuple(placed), refused)


def in_frame_of_first(scans: dict[str, PointList], network: ControlNetwork) -> SequentialRegistration:
    """Return the first scan placed where it is, and the others refused, because they have no targets.

    Parameters
    ----------
    scans : dict of str to PointList
        Empty lists, in the order in which they were given.
    network : ControlNetwork
        Without points.
    """
    first, *others = scans
    pose = Pose(np.eye(3), np.array(1.0), np.zeros(3), np.zeros(3))
    placed = PlacedScan(scans[first], None, None, pose, np.zeros(0, int), {})
    refused = {name: Refusal("too few", f"{name} has no targets.") for name in others}
    return SequentialRegistration(network, (placed,), refused)


def _surest(matches: dict[str, ScanMatch], certain: float) -> list[str]:
    """Return the scans to register now: all that are certain, or else the most certain one.

    An uncertain match may be accidental, and its points would mislead the other scans; with more points it
    may become certain.
    """
    order = sorted(matches, key=lambda name: (matches[name].chance or 0.0, -matches[name].solution.matched))
    return [name for name in order if (matches[name].chance or 0.0) <= certain] or order[:1]
