"""All scans and the points that they share, adjusted together; outliers leave one at a time."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from ..results import GlobalTest
from ..sequential_registration import Growth
from ..settings import Settings
from .least_squares import Block, Sighting, adjust
from .scan_adjustment import worst_target
from .statistical_tests import global_test
from .target_layout import fixes_pose, line_width


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
    rejected = tuple(dict(scan.rejected) for scan in growth.placed)
    adjusted = _adjusted(growth, rejected, settings)
    spared: set = set()
    while True:
        suspect = _suspect(growth, adjusted, spared, settings)
        if suspect is None:
            return adjusted
        number, row, normalized = suspect
        fewer = tuple(
            {**out, row: normalized} if scan == number else out for scan, out in enumerate(adjusted.rejected)
        )
        try:
            adjusted = _adjusted(growth, fewer, settings)
        except np.linalg.LinAlgError:
            # Nothing else holds the scans together.
            spared.add((number, row))


def _adjusted(growth: Growth, rejected: tuple[dict, ...], settings: Settings) -> Adjusted:
    used = _used(growth, rejected)
    sightings = []
    for scan, rows in zip(growth.placed, used):
        if not fixes_pose(scan.scan.xyz[rows], settings.model, line_width(scan.scan.xyz, settings)):
            raise np.linalg.LinAlgError(f"{scan.scan.name} has too few points left")
        sightings.append(Sighting(scan.scan.xyz[rows], scan.labels[rows], scan.pose))
    block = adjust(
        sightings,
        growth.network.points,
        growth.network.surveyed,
        settings.model,
        settings.sigma,
        settings.control_sigma,
    )
    tests = tuple(_test_of(item, settings.sigma) for item in block.targets)
    return Adjusted(block, tuple(used), rejected, tests)


def _used(growth: Growth, rejected: tuple) -> list[np.ndarray]:
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


def _suspect(growth: Growth, adjusted: Adjusted, spared: set, settings: Settings) -> Optional[tuple]:
    """Return scan, row and w of the most suspicious target that can be spared, or None."""
    suspects = []
    for number, (residuals, test) in enumerate(zip(adjusted.block.targets, adjusted.tests)):
        rows = adjusted.used[number]
        barred = np.array([(number, row) in spared for row in rows])
        normalized = np.where(barred[:, None], 0.0, residuals.normalized)
        worst = worst_target(normalized, test.sigma0, test.redundancy)
        if worst is not None:
            size = float(np.nanmax(np.abs(normalized[worst])))
            suspects.append((size, number, int(rows[worst]), normalized[worst]))
    return max(suspects, key=lambda item: item[0])[1:] if suspects else None
