"""Scans that their targets do not place, placed by the surfaces that they share with others.

A scan is placed only if its surfaces show one pose beyond doubt: enough of them agree with what others saw,
in all directions, and no other pose explains nearly as much. Targets, where the scan has some, decide between
poses first.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Optional, Union

import numpy as np
from scipy import stats
from scipy.spatial.distance import cdist
from scipy.spatial.transform import Rotation

from ...progress import Progress
from ..adjustment.control_network import ControlNetwork
from ..adjustment.similarity import Pose
from ..densification import PlacedScan
from ..lists.point_list import PointList
from ..matching.refusals import Refusal
from ..results import Placement
from ..sequential_registration import SequentialRegistration
from ..settings import Settings
from .evidence import Evidence, Stood, evidence_for, into
from .motions import Anchors, Searched, likely_motions, searched, settled
from .patches import Surfaces
from .settings import PlacementSettings
from .tie import spoken

MAY_BE_PLACED = ("too few", "collinear", "coincident", "chance", "no overlap", "ambiguous")
"""Refusals by targets that surfaces may overrule; others say that something is wrong with the scan."""


LEAST_OF_PAIR = 3.0
"""Patches must agree for each that contradicts, so that a motion between two scans is looked at further."""

UNMOVED = Pose(np.eye(3), np.array(1.0), np.zeros(3), np.zeros(3))


@dataclass(frozen=True)
class Candidate:
    """A pose that a scan may have.

    Attributes
    ----------
    pose : Pose
    met : dict of int to int
        Rows of targets that meet a point, and the rows of the points.
    evidence : Evidence
    rival : Candidate or None
        The best other pose, if the pose is right beyond doubt.
    """

    pose: Pose
    met: dict[int, int]
    evidence: Evidence
    rival: Optional["Candidate"] = None

    def weight(self, against: float) -> float:
        """Return the evidence in patches."""
        return self.evidence.weight(against)

    def placement(self, scan: Searched, against: float) -> Placement:
        """Return how surfaces placed the scan."""
        own, rival = self.evidence, self.rival
        shift, turn = _difference(self.pose, rival.pose, scan) if rival else (None, None)
        return Placement(
            scans=own.scans,
            agreeing=own.agreeing,
            contradicting=own.contradicting,
            targets=len(self.met),
            next_agreeing=rival.evidence.agreeing if rival else None,
            next_contradicting=rival.evidence.contradicting if rival else None,
            next_share=max(rival.weight(against) / self.weight(against), 0.0) if rival else None,
            next_shift=shift,
            next_turn_deg=turn,
            station=scan.surfaces.station,
        )


def placed_by_surfaces(
    sequence: SequentialRegistration,
    poses: Sequence[Pose],
    scans: Mapping[str, PointList],
    surfaces: Mapping[str, Surfaces],
    settings: Settings,
    progress: Progress = Progress(),
) -> SequentialRegistration:
    """Place the scans that were refused, one after the other, beside those that are placed.

    Parameters
    ----------
    sequence : SequentialRegistration
    poses : sequence of Pose
        Of the scans in `sequence.placed`.
    scans : mapping of str to PointList
        Near their origins.
    surfaces : mapping of str to Surfaces
        Near the same origins.
    settings : Settings
    progress : Progress

    Raises
    ------
    CancelledError
        If the caller asked to stop.
    """
    waiting = sorted(
        name for name, refusal in sequence.refused.items() if name in surfaces and _may_be_placed(refusal)
    )
    if not waiting or not any(_usable(surfaces, item.scan.name) for item in sequence.placed):
        return sequence
    known = {item.scan.name: pose for item, pose in zip(sequence.placed, poses)}
    search = _Search(surfaces, settings)
    refused, placed, network = dict(sequence.refused), list(sequence.placed), sequence.network
    count = len(waiting)
    while waiting:
        found: dict[str, Candidate] = {}
        done = progress.part((count - len(waiting)) / count, (count - len(waiting) + 1) / count)
        for number, name in enumerate(waiting):
            part = done.part(number / len(waiting), (number + 1) / len(waiting))
            result = search.result(scans[name], known, network, part)
            if isinstance(result, Refusal):
                refused[name] = _joined(sequence.refused[name], result, scans[name])
            else:
                found[name] = result
        if not found:
            break
        # The surest one only: beside it, the others may be surer, or be contradicted.
        name = max(found, key=lambda each: found[each].weight(settings.surfaces.placement.against))
        item, network = _placed(scans[name], found[name], search.scan(name), network, settings)
        placed.append(item)
        known[name] = found[name].pose
        waiting.remove(name)
        del refused[name]
    return SequentialRegistration(network, tuple(placed), refused)


def _may_be_placed(refusal: Refusal) -> bool:
    return refusal.status in MAY_BE_PLACED


def _usable(surfaces: Mapping[str, Surfaces], name: str) -> bool:
    """Return whether a scan has surfaces, and shows where the scanner stood."""
    own = surfaces.get(name)
    return own is not None and len(own) > 0 and own.facing


def _joined(by_targets: Refusal, by_surfaces: Refusal, scan: PointList) -> Refusal:
    """Return why neither the targets, if there are any, nor the surfaces place a scan."""
    if not scan.names:
        return by_surfaces
    return replace(by_targets, reason=f"{by_targets.reason} {by_surfaces.reason}")


class _Search:
    """The scans that were prepared, and the motions that were found between them."""

    def __init__(self, surfaces: Mapping[str, Surfaces], settings: Settings) -> None:
        self.surfaces, self.settings = surfaces, settings
        self.scans: dict[tuple[str, bool], Searched] = {}
        self.motions: dict[tuple[str, str, int], list[Pose]] = {}

    def scan(self, name: str, mirrored: bool = False) -> Searched:
        """Return a scan or its mirror image, prepared once."""
        key = name, mirrored
        if key not in self.scans:
            limits, own = self.settings.surfaces, self.surfaces[name]
            self.scans[key] = searched(own.mirrored() if mirrored else own, limits.placement, limits.pairs)
        return self.scans[key]

    def result(
        self, scan: PointList, known: Mapping[str, Pose], network: ControlNetwork, progress: Progress
    ) -> Union[Candidate, Refusal]:
        """Return the pose of a scan, or why its surfaces do not show it."""
        if not _usable(self.surfaces, scan.name):
            return _unknown_scanner(scan.name)
        others = [
            Stood(name, self.scan(name), known[name])
            for name in sorted(known)
            if _usable(self.surfaces, name)
        ]
        candidates = []
        for number, other in enumerate(others):
            part = progress.part(number / len(others), (number + 1) / len(others))
            for motion in self._motions(other, scan, network, part):
                pose = _after(motion, other.pose)
                evidence = evidence_for(pose, self.scan(scan.name), others)
                candidates.append(Candidate(pose, self._met(scan, pose, network), evidence))
        result = self._decided(scan.name, candidates)
        if (
            isinstance(result, Candidate)
            and not result.met
            and self._fits_mirrored(scan.name, result, others)
        ):
            return _mirrored(scan.name)
        return result

    def _fits_mirrored(self, name: str, best: Candidate, others: Sequence[Stood]) -> bool:
        """Return whether the mirror image of a scan fits better, as of left-handed coordinates."""
        limits, own = self.settings.surfaces, self.scan(name, mirrored=True)
        for other in others:
            if other.name not in best.evidence.scans:
                continue
            key = other.name, name, -1
            if key not in self.motions:
                self.motions[key] = self._settled(other.scan, own, Anchors(), Progress())
            for pose in self.motions[key]:
                evidence = evidence_for(_after(pose, other.pose), own, others)
                weight = evidence.weight(limits.placement.against)
                if limits.placement.as_mirrored * weight > best.weight(limits.placement.against):
                    return True
        return False

    def _motions(
        self, other: Stood, scan: PointList, network: ControlNetwork, progress: Progress
    ) -> list[Pose]:
        """Return the motions of a scan into another one, settled."""
        few = 0 < len(scan.xyz) < self.settings.model.least_targets
        key = (other.name, scan.name, len(network.points) if few else 0)
        if key not in self.motions:
            one, own = other.scan, self.scan(scan.name)
            anchors = Anchors(scan.xyz, into(network.points, other.pose)) if few else Anchors()
            poses = self._settled(one, own, anchors, progress)
            alone = [Stood(other.name, one, UNMOVED)]
            # Others than the right one and its rivals need not be compared with all scans, again and again.
            kept = [evidence_for(pose, own, alone).weight(LEAST_OF_PAIR) > 0 for pose in poses]
            self.motions[key] = [pose for pose, keep in zip(poses, kept) if keep]
        return self.motions[key]

    def _settled(self, one: Searched, own: Searched, anchors: Anchors, progress: Progress) -> list[Pose]:
        """Return the likely motions of a scan into another one, where their surfaces lie on each other."""
        model, limits = self.settings.model, self.settings.surfaces
        search = limits.placement.search
        found = likely_motions(one, own, model, anchors, search, progress)
        return [settled(motion, one, own, model, search, limits.pairs) for motion in found]

    def _met(self, scan: PointList, pose: Pose, network: ControlNetwork) -> dict[int, int]:
        """Return the points that targets come to lie on, by the rows of the targets."""
        away = cdist(pose.apply(scan.xyz), network.points)
        if self.settings.named:
            named = [[label == name for label in network.labels] for name in scan.names]
            away = np.where(np.array(named, bool).reshape(away.shape), away, np.inf)
        met: dict[int, int] = {}
        limit = self.settings.surfaces.placement.met_m
        for row, point in sorted(np.argwhere(away < limit).tolist(), key=lambda pair: away[tuple(pair)]):
            if row not in met and point not in met.values():
                met[row] = point
        return met

    def _decided(self, name: str, candidates: list[Candidate]) -> Union[Candidate, Refusal]:
        """Return the candidate that is right beyond doubt, or why none is."""
        limits = self.settings.surfaces.placement
        allowed = sorted(
            (item for item in candidates if _explains(item, limits)),
            key=lambda item: -item.weight(limits.against),
        )
        if not allowed:
            best = max(candidates, key=lambda item: item.weight(limits.against), default=None)
            return _too_little(name, best, limits)
        # Targets decide between poses that surfaces show about as well.
        best = max((item for item in allowed if _rivals(item, allowed[0], limits)), key=_targets_met)
        fewest, direction = best.evidence.across()
        if not best.met and fewest < limits.least_across:
            return _slides(name, direction)
        scan = self.scan(name)
        ranked = sorted(candidates, key=lambda item: -item.weight(limits.against))
        others = [item for item in ranked if _apart(item.pose, best.pose, scan) > limits.same_pose_m]
        for rival in others:
            as_likely = len(rival.met) == len(best.met) and _rivals(rival, best, limits)
            better_met = _explains(rival, limits) and len(rival.met) > len(best.met)
            if as_likely or better_met:
                return _ambiguous(name, best, rival, scan)
        return replace(best, rival=others[0] if others else None)


def _explains(item: Candidate, limits: PlacementSettings) -> bool:
    """Return whether enough agrees at a pose, and not too much contradicts it."""
    own = item.evidence
    chance = _as_many(own, limits.contradicted)
    return item.weight(limits.against) >= limits.least_evidence and chance > limits.unlikely


def _as_many(evidence: Evidence, share: float) -> float:
    """Return the probability that as many patches or more contradict if a share of all does."""
    count = evidence.agreeing + evidence.contradicting
    return float(stats.binom.sf(evidence.contradicting - 1, count, share))


def _rivals(item: Candidate, best: Candidate, limits: PlacementSettings) -> bool:
    """Return whether a pose explains what was seen about as well as the best one."""
    share = item.weight(limits.against) / best.weight(limits.against)
    if share <= limits.most_consistent:
        return False
    other = best.evidence
    usual = (other.contradicting + 1) / (other.agreeing + other.contradicting + 2)
    return share > limits.most_rival or _as_many(item.evidence, usual) > limits.significance


def _targets_met(candidate: Candidate) -> int:
    return len(candidate.met)


def _after(motion: Pose, pose: Pose) -> Pose:
    """Return the pose of a scan that a motion takes into another scan."""
    position = pose.apply(motion.position[None])[0]
    return Pose(pose.rotation @ motion.rotation, pose.scale, motion.centre, position)


def _apart(one: Pose, other: Pose, scan: Searched) -> float:
    """Return how far the patches of a scan lie apart at two poses (root mean square), metres."""
    places = scan.surfaces.centres[scan.patches]
    return float(np.sqrt(((one.apply(places) - other.apply(places)) ** 2).sum(axis=1).mean()))


def _placed(
    scan: PointList, candidate: Candidate, own: Searched, network: ControlNetwork, settings: Settings
) -> tuple[PlacedScan, ControlNetwork]:
    """Return a scan at its pose, and the network with those of its targets that meet no point."""
    labels = np.full(len(scan.xyz), -1)
    labels[list(candidate.met)] = list(candidate.met.values())
    fresh = np.flatnonzero(labels < 0)
    if len(fresh):
        variance = settings.sigma**2 + settings.surfaces.placement.placed_m**2
        names = tuple(scan.names[row] for row in fresh)
        covariance = variance * np.eye(3 * len(fresh))
        with_loose = np.zeros((3 * len(fresh), len(network.covariance)))
        labels[fresh] = len(network.names) + np.arange(len(fresh))
        places = candidate.pose.apply(scan.xyz[fresh])
        network = network.appended(scan.name, names, places, covariance, with_loose)
    return PlacedScan(
        scan=scan,
        match=None,
        round=None,
        pose=about(candidate.pose, own.surfaces.centres.mean(axis=0)),
        labels=labels,
        rejected={},
        placement=candidate.placement(own, settings.surfaces.placement.against),
    ), network


def about(pose: Pose, centre: np.ndarray) -> Pose:
    """Return the same pose about another centre."""
    return replace(pose, centre=centre, position=pose.apply(centre[None])[0])


def _unknown_scanner(name: str) -> Refusal:
    return Refusal(
        "no overlap",
        f"{name} cannot be placed by surfaces, because its cloud does not show where the scanner stood; give "
        "it in the frame of the scanner, or as an E57 or PTX file with its pose, or pick targets.",
    )


def _mirrored(name: str) -> Refusal:
    return Refusal(
        "mirrored",
        f"The surfaces of {name} fit better as in a mirror; correct its cloud if two columns are swapped or "
        "an axis points the other way, or else pick targets.",
    )


def _too_little(name: str, best: Optional[Candidate], limits: PlacementSettings) -> Refusal:
    agreeing, contradicting = (best.evidence.agreeing, best.evidence.contradicting) if best else (0, 0)
    return Refusal(
        "no overlap",
        f"The surfaces of {name} do not place it: at best, {agreeing} patches agree with other scans and "
        f"{contradicting} contradict them; at least {limits.least_evidence:g} must agree, and hardly any "
        "contradict; scan with more overlap, or pick targets.",
    )


def _slides(name: str, direction: np.ndarray) -> Refusal:
    return Refusal(
        "sliding",
        f"{name} slides along the surfaces that it shares with other scans, {spoken(direction)}; scan it "
        "from where a wall across is seen too, or pick a target.",
    )


def _ambiguous(name: str, best: Candidate, rival: Candidate, scan: Searched) -> Refusal:
    one, other = best.evidence, rival.evidence
    shift, turn = _difference(best.pose, rival.pose, scan)
    return Refusal(
        "ambiguous",
        f"The surfaces of {name} agree with other scans at two poses about as well: {one.agreeing} patches "
        f"agree and {one.contradicting} do not, or {other.agreeing} and {other.contradicting} with the "
        f"scanner {shift:.1f} m away and turned by {turn:.0f} degrees; pick a target, or choose a levelled "
        "model if the scanner was levelled.",
    )


def _difference(one: Pose, other: Pose, scan: Searched) -> tuple[float, float]:
    """Return how far apart the scanner stands at two poses, metres, and the turn between them, degrees."""
    station = np.atleast_2d(scan.surfaces.station)
    shift = np.linalg.norm(one.apply(station) - other.apply(station))
    turn = Rotation.from_matrix(one.rotation.T @ other.rotation).magnitude()
    return float(shift), float(np.degrees(turn))
