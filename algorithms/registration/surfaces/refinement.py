"""All scans adjusted by their targets and by the surfaces that they share, in one block.

Surfaces are paired at the poses at hand, adjusted together with the targets, and paired again. A scan that
they move farther than its targets allow, or against the targets that it shares with others, contradicts
them: its surfaces are left out.
"""

from collections.abc import Container, Mapping
from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import Optional

import numpy as np
from scipy import stats
from scipy.spatial.transform import Rotation

from ...progress import Progress
from ..adjustment.block_adjustment import Adjusted, adjust_tied
from ..adjustment.similarity import Pose, parameter_design
from ..adjustment.statistical_tests import global_test, spread_factor
from ..matching.refusals import Refusal
from ..results import SharedSurfaces, SurfaceChange
from ..sequential_registration import SequentialRegistration
from ..settings import Model, Settings
from .pairing import Placed, paired
from .patches import Surfaces
from .tie import Tie, free_directions, spoken

ScanPair = tuple[int, int]
"""The numbers of two scans among those placed."""


@dataclass(frozen=True)
class Refined:
    """The block with surfaces; without any, only `adjusted` is not empty.

    Attributes
    ----------
    sequence : SequentialRegistration
        Without scans that surfaces placed, but do not hold.
    adjusted : Adjusted
    changes : dict of str to SurfaceChange
        Of the scans that surfaces tie, by their names.
    shared : tuple of SharedSurfaces
        What was used.
    warnings : tuple of str
    """

    sequence: SequentialRegistration
    adjusted: Adjusted
    changes: dict[str, SurfaceChange] = field(default_factory=dict)
    shared: tuple[SharedSurfaces, ...] = ()
    warnings: tuple[str, ...] = ()


def refine(
    sequence: SequentialRegistration,
    by_targets: Optional[Adjusted],
    surfaces: Mapping[str, Surfaces],
    settings: Settings,
    progress: Progress = Progress(),
) -> Refined:
    """Tie scans by their surfaces.

    Parameters
    ----------
    sequence : SequentialRegistration
        Of the scans in `by_targets`, and then those that surfaces placed.
    by_targets : Adjusted or None
        The block without surfaces; None if targets placed no scan.
    surfaces : mapping of str to Surfaces
        By the names of the scans, near their origins.
    settings : Settings
    progress : Progress

    Raises
    ------
    CancelledError
        If the caller asked to stop.
    """
    block = _Block(sequence, by_targets, surfaces, settings)
    left_out: dict[str, SurfaceChange] = {}
    while True:
        part = progress.part(len(left_out) / len(sequence.placed), 1.0)
        try:
            adjusted, ties = block.tied(left_out, part)
        except np.linalg.LinAlgError:
            block = block.without_last()
            continue
        changes = block.changes(adjusted, ties)
        wrong = block.wrong_target(adjusted)
        if wrong is not None:
            block = block.without_target(*wrong)
            continue
        worst = block.worst(adjusted, changes)
        if worst is None:
            tied = {block.name(number) for tie in ties for number in tie.scans}
            shared = tuple(block.shared(tie, adjusted) for tie in ties)
            warnings = (*_contradictions(left_out), *_untied(surfaces, block.sequence, {*left_out, *tied}))
            return Refined(
                block.sequence, adjusted, {**left_out, **changes}, shared, (*warnings, *_sliding(shared))
            )
        left_out[worst] = replace(changes[worst], used=False)


@dataclass(frozen=True)
class _Block:
    sequence: SequentialRegistration
    by_targets: Optional[Adjusted]
    surfaces: Mapping[str, Surfaces]
    settings: Settings

    @property
    def start(self) -> tuple[Pose, ...]:
        """The poses before surfaces tie the scans."""
        known = () if self.by_targets is None else self.by_targets.block.poses
        return (*known, *(item.pose for item in self.sequence.placed[len(known) :]))

    def without_last(self) -> "_Block":
        """Return the block without the scan that surfaces placed last, because they do not hold all of them.

        Raises
        ------
        numpy.linalg.LinAlgError
            If targets placed all scans.
        """
        last = self.sequence.placed[-1]
        if last.placement is None:
            raise np.linalg.LinAlgError(f"{last.scan.name} is held by nothing")
        refused = {**self.sequence.refused, last.scan.name: not_held(last.scan.name)}
        fewer = replace(self.sequence, placed=self.sequence.placed[:-1], refused=refused)
        return replace(self, sequence=fewer)

    def wrong_target(self, adjusted: Adjusted) -> Optional[tuple[int, int, np.ndarray]]:
        """Return scan, row and w of the most wrong target among those that surfaces matched."""
        found = []
        limit = self.settings.adjustment.tests.critical_w
        for number, item in enumerate(self.sequence.placed):
            if item.placement is not None and len(adjusted.used[number]):
                normalized = adjusted.block.targets[number].normalized
                sizes = np.nan_to_num(np.abs(normalized)).max(axis=1)
                worst = int(sizes.argmax())
                found.append((sizes[worst], number, int(adjusted.used[number][worst]), normalized[worst]))
        size, *suspect = max(found, key=lambda item: item[0], default=(0.0, 0, 0, np.zeros(0)))
        return (suspect[0], suspect[1], suspect[2]) if size > limit else None

    def without_target(self, number: int, row: int, normalized: np.ndarray) -> "_Block":
        """Return the block in which a target of a scan is rejected."""
        placed = list(self.sequence.placed)
        item = placed[number]
        placed[number] = replace(item, rejected={**item.rejected, row: normalized})
        return replace(self, sequence=replace(self.sequence, placed=tuple(placed)))

    def tied(self, left_out: Container[str], progress: Progress) -> tuple[Adjusted, list[Tie]]:
        """Return the block and its ties when neither changes any more."""
        limits, poses = self.settings.surfaces, self.start
        pairs = self._pairs(left_out, poses)
        gates = dict.fromkeys(pairs, limits.pairs.gate_m)
        known = () if self.by_targets is None else self.by_targets.rejected
        rejected = (*known, *(item.rejected for item in self.sequence.placed[len(known) :]))
        for number in range(limits.refinement.most_rounds):
            progress.update(number / limits.refinement.most_rounds, "Tying scans by their surfaces")
            ties = self._ties(gates, poses, progress)
            adjusted = adjust_tied(self.sequence, rejected, self.settings, ties)
            moved = self._farthest(poses, adjusted.block.poses)
            poses = adjusted.block.poses
            narrower = {tie.scans: self._narrower(gates[tie.scans], tie, poses) for tie in ties}
            settled = all(narrower[pair] == gates[pair] for pair in narrower)
            gates.update(narrower)
            if moved < limits.refinement.smallest_move_m and settled:
                break
        return adjusted, ties

    def _narrower(self, gate: float, tie: Tie, poses: tuple[Pose, ...]) -> float:
        """Return how far partners may lie apart in the next round."""
        limits = self.settings.surfaces.pairs
        off = max(np.sqrt(np.median(tie.variances)), tie.rms(*(poses[number] for number in tie.scans)))
        return max(gate / 2, min(2 * limits.trim * float(off), gate), limits.least_gate_m)

    def _of(self, number: int) -> Optional[Surfaces]:
        found = self.surfaces.get(self.name(number))
        return found if found is not None and len(found) else None

    def name(self, number: int) -> str:
        """Return the name of a scan."""
        return self.sequence.placed[number].scan.name

    def _pairs(self, left_out: Container[str], poses: tuple[Pose, ...]) -> list[ScanPair]:
        """Return the scans whose boxes overlap, of those whose scanners are known."""
        boxes = {}
        for number, pose in enumerate(poses):
            own = self._of(number)
            if own is not None and own.facing and self.name(number) not in left_out:
                corners = pose.apply(own.corners())
                boxes[number] = corners.min(axis=0), corners.max(axis=0)
        gate = self.settings.surfaces.pairs.gate_m
        return [
            (one, other)
            for one, other in combinations(sorted(boxes, key=self.name), 2)
            if (boxes[one][0] < boxes[other][1] + gate).all()
            and (boxes[other][0] < boxes[one][1] + gate).all()
        ]

    def _ties(self, gates: dict[ScanPair, float], poses: tuple[Pose, ...], progress: Progress) -> list[Tie]:
        ties = []
        for pair, gate in gates.items():
            progress.check()
            tie = self._tie(pair, gate, poses, exact=True)
            placed = any(self.sequence.placed[number].placement is not None for number in pair)
            if placed and (tie is None or len(self._free(tie, poses))):
                # Nothing else holds the scan: a few millimetres are better than nothing.
                tie = self._tie(pair, gate, poses, exact=False)
            if tie is not None:
                ties.append(tie)
        return ties

    def _tie(self, pair: ScanPair, gate: float, poses: tuple[Pose, ...], exact: bool) -> Optional[Tie]:
        own = [self.surfaces[self.name(number)] for number in pair]
        one, other = (Placed(item.exact if exact else item, poses[number]) for item, number in zip(own, pair))
        if not len(one.surfaces) or not len(other.surfaces):
            return None
        return paired(one, other, pair, gate, self.settings.surfaces.pairs, self.settings.model)

    def _free(self, tie: Tie, poses: tuple[Pose, ...]) -> np.ndarray:
        """Return the directions along which the scans of a tie slide."""
        directions = tie.directions(*(poses[number] for number in tie.scans))
        return free_directions(directions, self.settings.surfaces.refinement.weak_share)

    def _farthest(self, before: tuple[Pose, ...], after: tuple[Pose, ...]) -> float:
        """Return how far any surface moved, metres."""
        moves = [0.0]
        for number, (old, new) in enumerate(zip(before, after)):
            own = self._of(number)
            if own is not None:
                corners = own.corners()
                moves.append(float(np.linalg.norm(new.apply(corners) - old.apply(corners), axis=1).max()))
        return max(moves)

    def changes(self, adjusted: Adjusted, ties: list[Tie]) -> dict[str, SurfaceChange]:
        """Return what surfaces change of the scans that they tie and targets placed, by their names."""
        if self.by_targets is None:
            return {}
        before = self.by_targets.block
        return {
            self.name(number): _change(
                self.sequence.placed[number].scan.xyz,
                before.poses[number],
                adjusted.block.poses[number],
                self._spread**2 * before.pose_cofactors[number],
                self.settings,
            )
            for number in sorted({number for tie in ties for number in tie.scans})
            if number < len(before.poses)
        }

    @property
    def _spread(self) -> float:
        """The standard deviation of unit weight by the targets alone."""
        if self.by_targets is None:
            return 1.0
        before, limits = self.by_targets.block, self.settings.adjustment.tests
        test = global_test(before.sum_of_squares, before.redundancy, limits)
        # A small sigma0 of few redundant observations does not make targets more exact.
        return max(spread_factor(test, limits), 1.0)

    def worst(self, adjusted: Adjusted, changes: Mapping[str, SurfaceChange]) -> Optional[str]:
        """Return the scan whose surfaces contradict the targets most, or None if none do.

        At the end of a chain, a pose may change much, yet not against its neighbour: two scans that surfaces
        tear apart show only in the residuals of the targets that they share.
        """
        wrong = [name for name, change in changes.items() if not change.used]
        if wrong:
            return max(wrong, key=lambda name: changes[name].sigmas)
        if self.by_targets is None or len(changes) < 2:
            return None
        before, after = self.by_targets.block, adjusted.block
        of_placed = sum(item.squares.sum() for item in after.targets[len(before.targets) :])
        growth = (after.sum_of_squares - of_placed - before.sum_of_squares) / self._spread**2
        count = self.settings.model.unknowns * (len(changes) - 1)
        if growth <= stats.chi2.isf(self.settings.surfaces.refinement.significance, count):
            return None
        grown = {
            self.name(number): float(new.squares.mean() - old.squares.mean())
            for number, (old, new) in enumerate(zip(before.targets, after.targets))
        }
        return max(changes, key=lambda name: grown[name])

    def shared(self, tie: Tie, adjusted: Adjusted) -> SharedSurfaces:
        """Return what a tie shows after the adjustment."""
        poses = [adjusted.block.poses[number] for number in tie.scans]
        one, other = (self.name(number) for number in tie.scans)
        free = self._free(tie, adjusted.block.poses)
        return SharedSurfaces((one, other), tie.overlap, len(tie), tie.rms(*poses), free)


def not_held(name: str) -> Refusal:
    """Return the refusal of a scan that surfaces placed, but do not hold."""
    return Refusal(
        "no overlap",
        f"{name} shares too few plane surfaces with other scans to be tied to them; scan with more overlap, "
        "or pick targets.",
    )


def _change(
    targets: np.ndarray, old: Pose, new: Pose, covariance: np.ndarray, settings: Settings
) -> SurfaceChange:
    difference = _parameters(old, new, settings.model)
    square = float(difference @ np.linalg.solve(covariance, difference))
    count = settings.model.unknowns
    design = parameter_design(old.rotated(targets), settings.model)
    stds = np.linalg.eigvalsh(design @ covariance @ np.swapaxes(design, 1, 2))[:, -1]
    limit = stats.chi2.isf(settings.surfaces.refinement.significance, count)
    return SurfaceChange(
        shift=float(np.linalg.norm(new.apply(targets) - old.apply(targets), axis=1).max()),
        sigmas=float(np.sqrt(square / count)),
        std=float(np.sqrt(stds.max())),
        used=bool(square <= limit),
    )


def _parameters(old: Pose, new: Pose, model: Model) -> np.ndarray:
    """Return the step from one pose to another, as `parameter_design` orders it, shape (u,)."""
    turn = Rotation.from_matrix(new.rotation @ old.rotation.T).as_rotvec()
    scale = [float(new.scale / old.scale) - 1.0] if model.scaled else []
    return np.r_[new.position - old.position, turn[2:] if model.levelled else turn, scale]


def _contradictions(left_out: Mapping[str, SurfaceChange]) -> list[str]:
    return [
        f"The surfaces that {name} shares with other scans would move it by {1000 * change.shift:.1f} mm, "
        f"{change.sigmas:.1f} standard deviations, which the targets, also those that scans share, rule out; "
        "they are not used. Look, also in the scans beside it, for things that were moved between the scans, "
        "or for a cloud that is not the one of the targets."
        for name, change in left_out.items()
    ]


def _untied(
    surfaces: Mapping[str, Surfaces], sequence: SequentialRegistration, judged: Container[str]
) -> list[str]:
    names = [scan.scan.name for scan in sequence.placed if scan.scan.name in surfaces]
    return [_reason(name, surfaces[name]) for name in names if name not in judged]


def _reason(name: str, surfaces: Surfaces) -> str:
    if len(surfaces) and not surfaces.facing:
        return (
            f"{name} is not tied by surfaces, because its cloud does not show where the scanner stood, and "
            "both sides of a wall would be taken for one; give the cloud in the frame of the scanner, or an "
            "E57 or PTX file of one scan with its pose."
        )
    return (
        f"{name} shares too few plane surfaces with another scan to be tied by them; its targets alone "
        "hold it."
    )


def _sliding(shared: tuple[SharedSurfaces, ...]) -> list[str]:
    """Say along which direction scans slide, as in a corridor, or that they do so along a plane."""
    sentences = []
    for item in shared:
        one, other = item.scans
        if len(item.free) == 1:
            sentences.append(
                f"{one} and {other} slide along the surfaces that they share, {spoken(item.free[0])}; in "
                "that direction, only targets or other scans hold them."
            )
        elif len(item.free):
            sentences.append(
                f"{one} and {other} share only surfaces that face one way, and slide in all directions along "
                "them; there, only targets or other scans hold them."
            )
    return sentences
