"""All scans and the points that they share, adjusted together; outliers leave one at a time."""

from dataclasses import dataclass

import numpy as np

from .adjustment import Block, Sighting, adjust
from .geometry import fixes_pose, line_width
from .growth import Growth, Placed
from .model import Settings
from .results import GlobalTest
from .single import worst_target
from .statistics import global_test


@dataclass(frozen=True)
class Adjusted:
    """The adjusted block, and what it stands on.

    Attributes
    ----------
    block : Block
        Its points are those of the network; those that only one scan sees are left as they were.
    used : tuple of ndarray of int
        Rows of the targets that each scan contributes.
    rejected : tuple of dict of int to ndarray, shape (3,)
        Rows that each scan does not, with Baarda's w that led to it.
    tests : tuple of GlobalTest
        Of each scan.
    """

    block: Block
    used: tuple[np.ndarray, ...]
    rejected: tuple[dict, ...]
    tests: tuple[GlobalTest, ...]


def adjust_block(growth: Growth, settings: Settings) -> Adjusted:
    """Adjust all placed scans in one block.

    Parameters
    ----------
    growth : Growth
        With at least one scan placed.
    settings : Settings
    """
    rejected = [dict(scan.rejected) for scan in growth.placed]
    while True:
        used = _used(growth, rejected)
        sightings = [
            Sighting(scan.scan.xyz[rows], scan.labels[rows], scan.pose)
            for scan, rows in zip(growth.placed, used)
        ]
        network = growth.network
        block = adjust(
            sightings,
            network.points,
            network.surveyed,
            settings.model,
            settings.sigma,
            settings.control_sigma,
        )
        tests = tuple(_test_of(item, settings.sigma) for item in block.targets)
        worst = _worst(growth.placed, used, block, tests, settings)
        if worst is None:
            return Adjusted(block, tuple(used), tuple(rejected), tests)
        number, row, normalized = worst
        rejected[number][row] = normalized


def _used(growth: Growth, rejected: list) -> list[np.ndarray]:
    """Return the rows of each scan that say something about it: surveyed points, and those seen again."""
    rows = [
        np.array([row for row in range(len(scan.labels)) if row not in out], int)
        for scan, out in zip(growth.placed, rejected)
    ]
    seen = np.bincount(
        np.concatenate([scan.labels[own] for scan, own in zip(growth.placed, rows)]),
        minlength=len(growth.network.names),
    )
    telling = growth.network.surveyed | (seen > 1)
    return [own[telling[scan.labels[own]]] for scan, own in zip(growth.placed, rows)]


def _test_of(residuals, sigma: float) -> GlobalTest:
    squares = float(np.sum(residuals.residuals**2)) / sigma**2
    return global_test(squares, float(residuals.redundancy.sum()))


def _worst(placed: tuple[Placed, ...], used: list, block: Block, tests: tuple, settings: Settings):
    """Return scan, row and w of the most suspicious target that can be spared, or None."""
    suspects = []
    for number, (residuals, test) in enumerate(zip(block.targets, tests)):
        worst = worst_target(residuals.normalized, test.sigma0, test.redundancy)
        if worst is None:
            continue
        targets = placed[number].scan.xyz
        rest = np.delete(used[number], worst)
        if fixes_pose(targets[rest], settings.model, line_width(targets, settings)):
            normalized = residuals.normalized[worst]
            suspects.append(
                (float(np.nanmax(np.abs(normalized))), number, int(used[number][worst]), normalized)
            )
    if not suspects:
        return None
    _, number, row, normalized = max(suspects, key=lambda item: item[0])
    return number, row, normalized
