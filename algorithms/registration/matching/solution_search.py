"""The search for every way to lay the targets of a scan on control points that is as good as the best.

In place of random samples, the seeds are gone through in a fixed order until none can be missing: a solution
with k of n targets misses n - k, so among the first n - k + 3 targets it has three. Targets in one line do
not fix a pose, so as many more are taken as the longest line holds.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Optional

import numpy as np
from scipy.spatial.distance import cdist

from ..adjustment.similarity import Pose, fit_pose
from ..adjustment.target_layout import FLAT, fixes_pose, spread
from ..settings import Model
from .control_points import Site
from .matching_matrix import Candidates, find_candidates, pruned, seeds
from .similar_triangles import SimilarTriangles, named_seeds

MOST_SOLUTIONS = 48
"""More equally good ones are not told apart any more."""

SPOILT = 0.85
"""A fit is spoilt if its sigma0 is beyond this share of the limit of distances: three, by default."""

SLACK = 2
"""Solutions that match so many targets less than the best are looked for too, for noise may hide a target."""

WIDE = 25.0
"""How many times as far from a line as a target may err the corner of a seed must be.

The pose of a narrower one leaves so much open that wrong points join."""

NARROWEST = 0.3
"""Of the width of all targets, if that is less."""

BATCH = 20_000


@dataclass(frozen=True)
class Solution:
    """A way to lay targets on control points.

    Attributes
    ----------
    labels : ndarray of int, shape (n,)
        The point of each target, -1 for none.
    pose : Pose
    misfit : float
        Sum of the squared residuals over the variance of a coordinate.
    gaps : ndarray, shape (n,)
        How far each target without a point lies from the nearest free one, over its reach.
    """

    labels: np.ndarray
    pose: Pose
    misfit: float
    gaps: np.ndarray

    @property
    def matched(self) -> int:
        """The number k of targets with a point."""
        return int((self.labels >= 0).sum())

    def support(self, width: float) -> int:
        """Return the number of targets that lie on points if these reach `width` times as far."""
        return self.matched + int((self.gaps <= width).sum())

    def contradicts(self, other: "Solution", least: int) -> bool:
        """Tell whether another solution is not the same one with more or fewer targets.

        Parameters
        ----------
        other : Solution
        least : int
            So many common targets make the pose the same.
        """
        both = (self.labels >= 0) & (other.labels >= 0)
        equal = self.labels[both] == other.labels[both]
        return not equal.all() or int(equal.sum()) < least


def find_solutions(
    site: Site,
    targets: np.ndarray,
    model: Model,
    least: int,
    allowed: np.ndarray,
    named: bool = False,
    free_scale: bool = False,
) -> list[Solution]:
    """Return all solutions with the largest number of matched targets, or nearly so many.

    Parameters
    ----------
    site : Site
    targets : ndarray, shape (n, 3)
        Near the origin.
    model : Model
    least : int
        Solutions with fewer targets are not looked for.
    allowed : ndarray of bool, shape (n, N)
        Which points a target may be.
    named : bool
        Whether that is at most one point for each target.
    free_scale : bool
        Whether the scale may be any, not only near 1.

    Returns
    -------
    list of Solution
        By the number of targets, then by how well they fit; empty if there is none. No more than
        `MOST_SOLUTIONS` of the largest number, and as many others.
    """
    search = _Search(site, targets, model, allowed, named, free_scale)
    if len(targets) < least or len(site.points) < least:
        return []
    solutions: list[Solution] = []
    in_line = search.longest_line()
    for last, nodes in search.seeds(least):
        if last > len(targets) - _enough(solutions, least) + in_line:
            break
        for start in range(0, len(nodes), BATCH):
            solutions = search.extended(nodes[start : start + BATCH], least, solutions)
    return sorted(solutions, key=lambda item: (-item.matched, round(item.misfit, 6), item.labels.tolist()))


def _enough(solutions: list, least: int) -> int:
    """Return how many targets a solution must match to be worth keeping beside those that were found."""
    best = max((item.matched for item in solutions), default=least)
    equal = sum(item.matched == best for item in solutions)
    if equal >= MOST_SOLUTIONS:
        return best + 1
    return best if len(solutions) - equal >= MOST_SOLUTIONS else max(best - SLACK, least)


def _with(solution: Solution, solutions: list, least: int, size: int) -> list:
    """Return the solutions with one more if it is new and matches enough, without what it outdoes."""
    if solution.matched < _enough(solutions, least):
        return solutions
    same = [item for item in solutions if not solution.contradicts(item, size)]
    if any(item.matched >= solution.matched for item in same):
        return solutions
    kept = [item for item in solutions if not any(item is other for other in same)] + [solution]
    best = max(item.matched for item in kept)
    return [item for item in kept if item.matched >= best - SLACK]


class _Search:
    def __init__(self, site, targets, model, allowed, named, free_scale) -> None:
        self.site, self.tree, self.targets, self.model = site, site.tree, targets, model
        self.allowed, self.named, self.free_scale = allowed, named, free_scale
        # A seed is laid at the scale 1 if the scale is near it: three targets say little about it.
        self.seed_model = model if free_scale else (Model.LEVELLED if model.levelled else Model.RIGID)
        self.size = model.least_targets
        self.order = np.arange(len(targets))
        self.width = self._width()

    def longest_line(self) -> int:
        """Return the largest number of targets on a line, vertical if levelled; they fix no pose."""
        near = 2 * self.width
        if self.model.levelled:
            return int((cdist(self.targets[:, :2], self.targets[:, :2]) <= near).sum(axis=1).max())
        first, second = np.triu_indices(len(self.targets), 1)
        along = self.targets[second] - self.targets[first]
        along /= np.maximum(np.linalg.norm(along, axis=1), np.finfo(float).tiny)[:, None]
        arms = self.targets[None, :, :] - self.targets[first][:, None, :]
        square = (arms**2).sum(axis=2) - np.einsum("pnk,pk->pn", arms, along) ** 2
        return int((square <= near**2).sum(axis=1).max(initial=1))

    def _width(self) -> float:
        """Return how far from a line, in the scan, the corner of a triangle must be to be a seed."""
        if self.free_scale:
            return WIDE * FLAT * float(np.ptp(self.targets, axis=0).max(initial=0.0))
        level = self.targets[:, :2] - self.targets[:, :2].mean(axis=0)
        widest = np.linalg.norm(level, axis=1).max() if self.model.levelled else spread(self.targets)[1]
        return min(WIDE * self.site.factor * self.site.sigma, NARROWEST * float(widest))

    def seeds(self, least: int) -> Iterator[tuple[int, np.ndarray]]:
        """Yield, target by target, the sets of nodes that fix a pose and end with it."""
        count = len(self.site.points)
        if self.free_scale:
            yield from self._seeds_of_any_scale()
            return
        # First those with few candidates: they are soon through, and what they fix ends the search.
        found = self._candidates(least)
        work = np.bincount(np.r_[found.starts, found.ends] // count, minlength=len(self.targets))
        self._reorder(np.argsort(work, kind="stable"))
        found = self._candidates(least)
        for last in range(self.size - 1, len(self.targets)):
            yield last, seeds(found, last, self.model)

    def _seeds_of_any_scale(self) -> Iterator[tuple[int, np.ndarray]]:
        triangles = None if self.named else SimilarTriangles(self.site)
        for last in range(self.size - 1, len(self.targets)):
            if triangles is None:
                yield last, named_seeds(self.site, self.targets, last, self.allowed, self.size)
            else:
                yield last, triangles.seeds(self.targets, last, len(self.site.points))

    def _candidates(self, least: int) -> Candidates:
        found = find_candidates(self.site, self.targets, self.allowed, self.model.levelled)
        return pruned(found, len(self.targets), least)

    def _reorder(self, order: np.ndarray) -> None:
        self.order, self.targets, self.allowed = order, self.targets[order], self.allowed[order]

    def extended(self, nodes: np.ndarray, least: int, solutions: list[Solution]) -> list[Solution]:
        """Lay seeds, and keep the solutions that match enough targets."""
        count = len(self.site.points)
        mine, theirs = nodes // count, nodes % count
        fixing = self._fixes(self.targets[mine])
        mine, theirs = mine[fixing], theirs[fixing]
        pose = fit_pose(self.site.points[theirs], self.targets[mine], self.seed_model)
        scores = self._scores(pose, mine, theirs)
        for solution in solutions:
            scores[self._within(solution, mine, theirs)] = 0
        while len(scores):
            top = int(scores.argmax())
            if scores[top] < _enough(solutions, least):
                break
            solution = self._refined(mine[top], theirs[top])
            scores[top] = 0
            # Other seeds within this solution lead to it again.
            scores[self._within(solution, mine, theirs)] = 0
            solutions = _with(solution, solutions, least, self.size)
        return solutions

    def _within(self, solution: Solution, mine: np.ndarray, theirs: np.ndarray) -> np.ndarray:
        return (solution.labels[self.order][mine] == theirs).all(axis=1)

    def _fixes(self, corners: np.ndarray) -> np.ndarray:
        """Tell which seeds are wide enough to fix a pose."""
        if self.size == 2:
            return np.linalg.norm(np.diff(corners[..., :2], axis=1)[:, 0], axis=1) > self.width
        sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
        doubled = np.linalg.norm(
            np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
        )
        return doubled > self.width * sides.max(axis=1, initial=0.0)

    def _scores(self, pose: Pose, mine: np.ndarray, theirs: np.ndarray) -> np.ndarray:
        """Return how many targets come to lie on points, at most."""
        if not len(mine):
            return np.zeros(0, int)
        reach = self.site.reach(self._leverage(pose, mine), theirs) + self._drift(pose, len(mine))
        placed = pose.apply(np.broadcast_to(self.targets, (len(mine), *self.targets.shape)))
        distances, _ = self.tree.query(placed, distance_upper_bound=float(reach.max()))
        return (distances <= reach).sum(axis=1)

    def _drift(self, pose: Pose, count: int) -> np.ndarray:
        """Return how far a scale error may move each target by the poses of seeds, which have none."""
        arms = pose.turned(np.broadcast_to(self.targets, (count, *self.targets.shape)))
        return self.site.drift * np.linalg.norm(arms, axis=-1)

    def _leverage(self, pose: Pose, mine: np.ndarray) -> np.ndarray:
        """Return the variance that the pose of seeds adds to each target, over that of a coordinate."""
        arms = pose.turned(self.targets[mine])
        squares = (arms**2).sum(axis=(-2, -1))
        all_arms = pose.turned(np.broadcast_to(self.targets, (len(mine), *self.targets.shape)))
        if self.model.levelled:
            inertia = (arms[..., :2] ** 2).sum(axis=(-2, -1))
            far = (all_arms[..., :2] ** 2).sum(axis=-1)
        else:
            moments = squares[:, None, None] * np.eye(3) - np.swapaxes(arms, -1, -2) @ arms
            inertia = np.linalg.eigvalsh(moments)[:, 0]
            far = (all_arms**2).sum(axis=-1)
        tiny = np.finfo(float).tiny
        leverage = 1.0 / mine.shape[1] + far / np.maximum(inertia, tiny)[:, None]
        if self.model.scaled:
            leverage = leverage + (all_arms**2).sum(axis=-1) / np.maximum(squares, tiny)[:, None]
        return leverage

    def _refined(self, mine: np.ndarray, theirs: np.ndarray) -> Solution:
        """Let targets join, the surest first, and leave, until nothing changes."""
        labels = np.full(len(self.targets), -1)
        labels[mine] = theirs
        barred = np.zeros(labels.shape, bool)
        for _ in range(4 * len(labels)):
            joining = self._joining(labels, barred)
            leaving = None if joining else self._leaving(labels)
            if joining:
                labels[joining[0]] = joining[1]
            elif leaving is not None:
                labels[leaving], barred[leaving] = -1, True
            else:
                break
        used = np.flatnonzero(labels >= 0)
        in_order, gaps = np.full(len(labels), -1), np.full(len(labels), np.inf)
        in_order[self.order] = labels
        gaps[self.order] = self._free_gaps(labels).min(axis=1)
        return Solution(in_order, self._fitted(labels, used), self._misfit(labels, used), gaps)

    def _fitted(self, labels: np.ndarray, used: np.ndarray) -> Pose:
        model = self.model if len(used) > self.size else self.seed_model
        return fit_pose(self.site.points[labels[used]], self.targets[used], model)

    def _gaps(self, labels: np.ndarray, used: np.ndarray) -> np.ndarray:
        """Return how far all targets lie from all points, over their reach, by the pose of those `used`."""
        pose = self._fitted(labels, used)
        reach = self.site.reach(self._leverage(pose[None], used[None]), labels[used][None])[0]
        if len(used) <= self.size:
            reach = reach + self._drift(pose[None], 1)[0]
        gaps = cdist(pose.apply(self.targets), self.site.points) / reach[:, None]
        return np.where(self.allowed, gaps, np.inf)

    def _joining(self, labels: np.ndarray, barred: np.ndarray) -> Optional[tuple[int, int]]:
        """Return the free target that lies closest to a free point, and the point, if within reach."""
        gaps = self._free_gaps(labels)
        gaps[barred] = np.inf
        row, point = np.unravel_index(gaps.argmin(), gaps.shape)
        return (int(row), int(point)) if gaps[row, point] <= 1.0 else None

    def _free_gaps(self, labels: np.ndarray) -> np.ndarray:
        """Return the gaps between targets without a point and points without a target, infinite elsewhere."""
        gaps = self._gaps(labels, np.flatnonzero(labels >= 0))
        gaps[labels >= 0] = np.inf
        gaps[:, labels[labels >= 0]] = np.inf
        return gaps

    def _leaving(self, labels: np.ndarray) -> Optional[int]:
        """Return the target that is out of reach by the pose of the others, or spoils the fit, if any."""
        used = np.flatnonzero(labels >= 0)
        gaps, misfits = np.zeros(len(used)), np.full(len(used), np.inf)
        for place, row in enumerate(used):
            others = np.delete(used, place)
            if fixes_pose(self.targets[others], self.model, self.width / 2):
                gaps[place] = self._gaps(labels, others)[row, labels[row]]
                misfits[place] = self._misfit(labels, others)
        if gaps.max() > 1.0:
            return int(used[gaps.argmax()])
        limit = (SPOILT * self.site.factor) ** 2 * (3 * len(used) - self.model.unknowns)
        spoilt = self._misfit(labels, used) > limit and np.isfinite(misfits).any()
        return int(used[misfits.argmin()]) if spoilt else None

    def _misfit(self, labels: np.ndarray, used: np.ndarray) -> float:
        """Return the squared residuals of the targets `used`, over the variance of a coordinate."""
        residuals = self._fitted(labels, used).apply(self.targets[used]) - self.site.points[labels[used]]
        return float((residuals**2).sum()) / self.site.sigma**2
