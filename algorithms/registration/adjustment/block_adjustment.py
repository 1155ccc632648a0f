"""All scans and the points that they share, adjusted together; outliers are rejected one at a time."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Optional

import numpy as np

from ..results import GlobalTest
from ..sequential_registration import SequentialRegistration
from ..settings import Settings
from ..surfaces.tie import Tie
from .least_squares import Block, Sighting, adjust
from .statistical_tests import global_test, worst_target
from .target_layout import fixes_pose, line_width

Rejected = dict[int, np.ndarray]
Suspect = tuple[int, int, np.ndarray]


@dataclass(frozen=True)
class Adjusted:
    """The adjusted block, and the targets it was computed from.

    Attributes
    ----------
    block : Block
        Its points are those of the network; those that only one scan sees are left as they were.
    used : tuple of ndarray of int
        Rows of the targets of each scan that were used.
    rejected : tuple of dict of int to ndarray, shape (3,)
        Rows of the targets of each scan that were not, with Baarda's w that led to it.
    tests : tuple of GlobalTest
        Of each scan.
    """

    block: Block
    used: tuple[np.ndarray, ...]
    rejected: tuple[Rejected, ...]
    tests: tuple[GlobalTest, ...]


def adjust_block(sequence: SequentialRegistration, settings: Settings) -> Adjusted:
    """Adjust all registered scans in one block.

    Parameters
    ----------
    sequence : SequentialRegistration
        With at least one scan.
    settings : Settings
    """
    rejected = tuple(dict(scan.rejected) for scan in sequence.placed)
    adjusted = _adjusted(sequence, rejected, settings)
    spared: set[tuple[int, int]] = set()
    while True:
        suspect = _suspect(sequence, adjusted, spared, settings)
        if suspect is None:
            return adjusted
        number, row, normalized = suspect
        fewer = tuple(
            {**out, row: normalized} if scan == number else out for scan, out in enumerate(adjusted.rejected)
        )
        try:
            adjusted = _adjusted(sequence, fewer, settings)
        except np.linalg.LinAlgError:
            # Without this target the scans do not hang together.
            spared.add((number, row))


def adjust_tied(
    sequence: SequentialRegistration,
    rejected: tuple[Rejected, ...],
    settings: Settings,
    ties: Sequence[Tie],
) -> Adjusted:
    """Adjust all scans by the targets that were not rejected, and by the surfaces that they share.

    No more targets are rejected: where surfaces contradict targets, the targets are right.

    Parameters
    ----------
    sequence : SequentialRegistration
    rejected : tuple of dict of int to ndarray, shape (3,)
        As in `Adjusted`.
    settings : Settings
    ties : sequence of Tie
    """
    return _adjusted(sequence, rejected, settings, ties)


def _adjusted(
    sequence: SequentialRegistration,
    rejected: tuple[Rejected, ...],
    settings: Settings,
    ties: Sequence[Tie] = (),
) -> Adjusted:
    used = _used(sequence, rejected)
    sightings = []
    for scan, rows in zip(sequence.placed, used):
        by_targets = scan.match is not None
        width = line_width(scan.scan.xyz, settings)
        if by_targets and not fixes_pose(scan.scan.xyz[rows], settings.model, width):
            raise np.linalg.LinAlgError(f"{scan.scan.name} has too few points left")
        own = scan.scan.covariances_of(rows)
        sightings.append(Sighting(scan.scan.xyz[rows], scan.labels[rows], scan.pose, own, scan.held))
    block = adjust(
        sightings,
        sequence.network.points,
        sequence.network.surveyed,
        settings.model,
        settings.sigma,
        sequence.network.sigmas,
        settings.adjustment,
        ties,
    )
    tests = tuple(
        global_test(float(item.squares.sum()), float(item.redundancy.sum()), settings.adjustment.tests)
        for item in block.targets
    )
    return Adjusted(block, tuple(used), rejected, tests)


def _used(sequence: SequentialRegistration, rejected: tuple[Rejected, ...]) -> list[np.ndarray]:
    """Return the rows of each scan that contribute to it: surveyed points, and points seen by other scans."""
    rows = [
        np.array([row for row in range(len(scan.labels)) if row not in out], int)
        for scan, out in zip(sequence.placed, rejected)
    ]
    seen = np.bincount(
        np.concatenate([scan.labels[own] for scan, own in zip(sequence.placed, rows)]),
        minlength=len(sequence.network.names),
    )
    contributing = sequence.network.surveyed | (seen > 1)
    return [own[contributing[scan.labels[own]]] for scan, own in zip(sequence.placed, rows)]


def _suspect(
    sequence: SequentialRegistration,
    adjusted: Adjusted,
    spared: set[tuple[int, int]],
    settings: Settings,
) -> Optional[Suspect]:
    """Return scan, row and w of the most suspicious target that can be spared, or None."""
    suspects = []
    for number, (residuals, test) in enumerate(zip(adjusted.block.targets, adjusted.tests)):
        rows = adjusted.used[number]
        barred = np.array([(number, row) in spared for row in rows])
        normalized = np.where(barred[:, None], 0.0, residuals.normalized)
        worst = worst_target(normalized, test.sigma0, test.redundancy, settings.adjustment.tests)
        if worst is not None:
            size = float(np.nanmax(np.abs(normalized[worst])))
            suspects.append((size, number, int(rows[worst]), normalized[worst]))
    return max(suspects, key=lambda item: item[0])[1:] if suspects else None
