"""Which control points the targets of one scan are, or why that cannot be said."""

from dataclasses import dataclass
from typing import Optional, Union

import numpy as np
from scipy.spatial.distance import cdist

from ..adjustment.control_network import Network
from ..adjustment.scan_adjustment import fit_scan
from ..adjustment.similarity import Pose
from ..adjustment.target_layout import fixes_pose, has_free_scale, line_width, spread
from ..lists.point_list import PointList
from ..settings import Matching, Model, Settings
from .accidental_matches import Chance
from .control_points import DRIFT, Site, factor_of
from .diagnosis import explain_failure, mirrored_solution
from .similar_triangles import MOST_POINTS
from .solution_search import MOST_SOLUTIONS, Solution, find_solutions

POOR = 2.5
"""With a larger sigma0 a fit is poor."""

LARGEST_TURN = 1.0
"""Standard deviation of a turn, degrees, beyond which a transformation is of no use."""

DOUBT, MOST_DOUBT = 1.5, 3.0
"""How many times as far as its reach a target may lie from a point to speak for another solution.

The first is multiplied by sigma0."""

EQUAL = 30.0
"""Solutions are equally good unless their weighted sums of squares differ by more.

One is then exp(15) times as likely as the other, and still e^4 times if the noise is twice what was said."""


@dataclass(frozen=True)
class Refusal:
    """Why a scan has no transformation; the attributes are those of `ScanRegistration`."""

    status: str
    reason: str
    rivals: tuple[dict, ...] = ()


UNEXPLAINED = Refusal("no overlap", "")


@dataclass(frozen=True)
class Found:
    """Which point each target is.

    Attributes
    ----------
    solution : Solution
    chance : float or None
        Expected number of accidental matches; None when matched by names.
    warnings : tuple of str
    """

    solution: Solution
    chance: Optional[float]
    warnings: tuple[str, ...]


@dataclass(frozen=True)
class Question:
    """A scan, the control points, and what may be which.

    Attributes
    ----------
    scan : PointList
    network : Network
    site : Site
    settings : Settings
    allowed : ndarray of bool, shape (n, N)
    free_scale : bool
    """

    scan: PointList
    network: Network
    site: Site
    settings: Settings
    allowed: np.ndarray
    free_scale: bool

    @property
    def named(self) -> bool:
        """Whether names say which target is which point."""
        return self.settings.matching is Matching.NAMES

    def solutions(self, targets: np.ndarray, model: Model, least: int, site: Optional[Site] = None) -> list:
        """Return the best solutions for the targets, or for what was made of them."""
        return find_solutions(
            site or self.site, targets, model, least, self.allowed, self.named, self.free_scale
        )


def find_scan(
    scan: PointList, network: Network, settings: Settings, explain: bool = True
) -> Union[Found, Refusal]:
    """Match the targets of a scan with control points.

    Parameters
    ----------
    scan : PointList
        Near the origin.
    network : Network
    settings : Settings
    explain : bool
        Whether to find out why nothing matches, which takes several searches.
    """
    question = _question(scan, network, settings)
    refusal = _refuse_list(question)
    if refusal:
        return refusal
    model, targets = settings.model, scan.xyz
    chance = Chance(question.site, targets, model, question.free_scale)
    least = model.least_targets
    if not question.named:
        least = max(least, chance.least(least))
        if least > min(len(targets), len(network.points)):
            return _too_few_to_tell(question, chance)
    solutions = question.solutions(targets, model, least)
    if not solutions:
        return Refusal(*explain_failure(question, least)) if explain else UNEXPLAINED
    best = solutions[0]
    # A few in one plane fit though the list is mirrored.
    mirrored = _in_one_plane(question, best) and mirrored_solution(question, best.matched + 1)
    if mirrored:
        return Refusal(*mirrored)
    rivals = _rivals(best, solutions[1:], model)
    if rivals:
        return _ambiguous(question, [best, *rivals])
    kept = _kept(question, best)
    turning = _turning(question, best.pose, kept)
    if turning > LARGEST_TURN:
        return _nearly_on_a_line(question, turning)
    if question.named:
        return Found(best, None, _warnings(question, best))
    # A true target may be an outlier; where the fit is poor, outliers rather do not belong to it.
    poor = _variance_factor(best, model) > POOR**2
    evidence = len(kept) if poor else best.matched, best.misfit, chance.repetition(best.labels[kept])
    expected = chance.expected(*evidence)
    if chance.explains(*evidence):
        return _accidental(question, best, expected)
    return Found(best, expected, _warnings(question, best))


def _rivals(best: Solution, others: list[Solution], model: Model) -> list[Solution]:
    """Return the solutions that are as good as the best."""
    factor = _variance_factor(best, model)
    limit = best.misfit + EQUAL * factor
    # Where SIGMA is too small, true targets fall out, and a wrong solution may match more.
    width = min(DOUBT * factor**0.5, MOST_DOUBT)
    return [
        item
        for item in others
        if item.contradicts(best, model.least_targets)
        and (item.misfit <= limit if item.matched == best.matched else item.support(width) >= best.matched)
    ]


def _kept(question: Question, solution: Solution) -> np.ndarray:
    """Return the rows of the matched targets that are no outliers."""
    rows = np.flatnonzero(solution.labels >= 0)
    settings, points = question.settings, question.site.points[solution.labels[rows]]
    targets, nothing = question.scan.xyz[rows], np.zeros((3 * len(rows), 3 * len(rows)))
    width = line_width(question.scan.xyz, settings)
    return rows[fit_scan(targets, points, nothing, settings.model, settings.sigma, width).used]


def _turning(question: Question, pose: Pose, rows: np.ndarray) -> float:
    """Return the standard deviation of the least certain turn of the scan, degrees."""
    arms = pose.turned(question.scan.xyz[rows])
    arms = arms - arms.mean(axis=0)
    if question.settings.model.levelled:
        inertia = float((arms[:, :2] ** 2).sum())
    else:
        inertia = float(np.linalg.eigvalsh((arms**2).sum() * np.eye(3) - arms.T @ arms)[0])
    return float(np.degrees(question.site.sigma / np.sqrt(max(inertia, np.finfo(float).tiny))))


def _nearly_on_a_line(question: Question, turning: float) -> Refusal:
    line = "nearly above each other" if question.settings.model.levelled else "nearly on a line"
    return Refusal(
        "collinear",
        f"The targets of {question.scan.name} that match lie {line}, so the scan may turn about it by "
        f"{turning:.0f} degrees; pick a target beside it.",
    )


def _question(scan: PointList, network: Network, settings: Settings) -> Question:
    named = settings.matching is Matching.NAMES
    free = has_free_scale(settings)
    drift = DRIFT if settings.model.scaled and not free else 0.0
    factor = factor_of(settings.tolerance, settings.sigma, settings.control_sigma)
    site = network.site(settings.sigma, factor, drift)
    if named:
        allowed = np.array([[name == label for label in network.labels] for name in scan.names])
    else:
        allowed = np.broadcast_to(~doubles(site), (len(scan.names), len(network.points)))
    return Question(scan, network, site, settings, allowed, free)


def doubles(site: Site) -> np.ndarray:
    """Tell which control points cannot be told from an earlier one; bool, shape (N,)."""
    return np.triu(site.distances <= site.limits, 1).any(axis=0)


def _refuse_list(question: Question) -> Optional[Refusal]:
    scan, model = question.scan, question.settings.model
    count = len(scan.names)
    if count < model.least_targets:
        return Refusal(
            "too few",
            f"{scan.name} has {count} target{'s' * (count != 1)}, but {_kind(model)} needs at least "
            f"{model.least_targets}; pick more targets.",
        )
    width = line_width(scan.xyz, question.settings)
    if not question.free_scale:
        close = np.argwhere(np.triu(cdist(scan.xyz, scan.xyz) <= width, 1))
        if len(close):
            one, other = sorted(
                (scan.names[number] for number in close[0]), key=lambda name: (len(name), name)
            )
            return Refusal(
                "coincident",
                f"The targets {one} and {other} of {scan.name} are at the same place; remove one of them.",
            )
    if not fixes_pose(scan.xyz, model, width):
        line = "above each other" if model.levelled else "on a line"
        return Refusal(
            "collinear",
            f"The targets of {scan.name} lie {line}, so the scan can still turn about it; "
            "pick a target beside it.",
        )
    known = int(question.allowed.any(axis=1).sum())
    if question.named and known < model.least_targets:
        return Refusal(
            "no overlap",
            f"Of the targets of {scan.name}, {known} have the name of a control point, but {_kind(model)} "
            "needs "
            f"at least {model.least_targets}; correct the names, or match by distances.",
        )
    if question.free_scale and not question.named and len(question.network.points) > MOST_POINTS:
        return Refusal(
            "too many",
            f"With an unknown scale at most {MOST_POINTS} control points can be searched, and there are "
            f"{len(question.network.points)}; shorten the list to the surroundings of {scan.name}, or match "
            "by names.",
        )
    return None


def _kind(model: Model) -> str:
    return "a levelled scan" if model.levelled else "a scan"


def _variance_factor(solution: Solution, model: Model) -> float:
    return max(1.0, solution.misfit / max(3 * solution.matched - model.unknowns, 1))


def _too_few_to_tell(question: Question, chance: Chance) -> Refusal:
    count, points = len(question.scan.names), len(question.network.points)
    most = min(count, points)
    redundancy = 3 * most - question.settings.model.unknowns
    if redundancy <= 0:
        return Refusal(
            "too few",
            f"{most} matches of {question.scan.name} leave nothing to check them by; pick more targets, or "
            "match "
            "by names.",
        )
    return Refusal(
        "chance",
        f"{count} targets of {question.scan.name} can be matched with {points} control points by accident "
        "(expected "
        f"{chance.expected(most, redundancy):.2g} times); pick more targets, shorten the control list to the "
        "surroundings, or match by names.",
    )


def _accidental(question: Question, best: Solution, expected: float) -> Refusal:
    status, reason = explain_failure(question, best.matched)
    if status in ("mirrored", "units", "tilted", "scale"):
        return Refusal(status, reason)
    return Refusal(
        "chance",
        f"{best.matched} of {len(question.scan.names)} targets of {question.scan.name} match, but that "
        "happens "
        f"by accident too (expected {expected:.2g} times); pick more targets, or match by names.",
    )


def _ambiguous(question: Question, rivals: list[Solution]) -> Refusal:
    names, points = question.scan.names, question.network.names
    described = tuple(
        {names[row]: points[label] for row, label in enumerate(item.labels) if label >= 0} for item in rivals
    )
    number = f"at least {len(rivals)}" if len(rivals) >= MOST_SOLUTIONS else str(len(rivals))
    listed = "; ".join(
        ", ".join(f"{target} = {point}" for target, point in rival.items()) for rival in described[:4]
    )
    more = f"; and {len(rivals) - 4} more" if len(rivals) > 4 else ""
    return Refusal(
        "ambiguous",
        f"The targets of {question.scan.name} fit the control points in {number} ways that are equally good "
        f"({listed}{more}); add a target that breaks the symmetry, or match by names.",
        described,
    )


def _in_one_plane(question: Question, solution: Solution) -> bool:
    if question.settings.model.levelled or question.free_scale:
        return False
    matched = question.scan.xyz[solution.labels >= 0]
    return bool(spread(matched)[0] <= 2 * question.site.factor * question.site.sigma)


def _warnings(question: Question, best: Solution) -> tuple[str, ...]:
    scan, network = question.scan, question.network
    warnings = []
    if _in_one_plane(question, best):
        warnings.append(
            f"The matched targets of {scan.name} lie in one plane, so a mirrored list (x and y swapped) "
            "would fit "
            "as well; check the position of the scanner in the report."
        )
    tilt = float(np.degrees(np.arccos(np.clip(best.pose.rotation[2, 2], -1.0, 1.0))))
    if tilt > 30 and not question.free_scale:
        warnings.append(
            f"{scan.name} is tilted by {tilt:.0f} degrees; if the scanner stood upright, the axes of a "
            "list are "
            "in another order (z is up)."
        )
    if question.named:
        warnings += _wrong_names(question, best)
    else:
        warnings += _contradicted_names(scan, network, best)
    return tuple(warnings)


def _wrong_names(question: Question, best: Solution) -> list[str]:
    """Say what the targets are whose names do not fit."""
    scan, network = question.scan, question.network
    placed = best.pose.apply(scan.xyz)
    warnings = []
    for row in np.flatnonzero((best.labels < 0) & question.allowed.any(axis=1)):
        own = np.linalg.norm(network.points[question.allowed[row]] - placed[row], axis=1).min()
        away = np.linalg.norm(network.points - placed[row], axis=1)
        sentence = (
            f"Target {scan.names[row]} of {scan.name} lies {own:.3f} m from the control point of its name"
        )
        nearest = int(away.argmin())
        if away[nearest] <= 3 * question.site.factor * question.site.sigma:
            sentence += f", but {away[nearest]:.3f} m from {network.names[nearest]}: its name is wrong"
        warnings.append(sentence + "; it was left out.")
    return warnings


def _contradicted_names(scan: PointList, network: Network, best: Solution) -> list[str]:
    if not scan.named:
        return []
    known = set(network.labels)
    wrong = [
        f"{name} is {network.names[label]}"
        for name, label in zip(scan.names, best.labels)
        if label >= 0 and name in known and network.labels[label] != name
    ]
    # Numbers that merely count the rows of both lists contradict each other everywhere.
    agreeing = sum(
        name == network.labels[label] for name, label in zip(scan.names, best.labels) if label >= 0
    )
    if not wrong or agreeing < len(wrong):
        return []
    return [f"By its distances, the names in {scan.name} are wrong: {', '.join(wrong)}."]
