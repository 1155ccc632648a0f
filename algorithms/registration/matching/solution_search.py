"""The search for every way to lay the targets of a scan on control points that is as good as the best.

The seeds are not drawn at random but enumerated in a fixed order until no further solution is possible: a
solution with k of n targets misses n - k, so that three of the first n - k + 3 targets belong to it. Targets
on a line do not fix a pose, so that as many more are taken as the longest line holds.
"""

from collections.abc import Iterator
from typing import Optional

import numpy as np

from ...progress import Progress
from ..adjustment.similarity import fit_pose
from .matching_matrix import MatchingMatrix
from .refinement import refined
from .search_space import SearchSpace
from .seeds import are_wide, matched_at_most, seed_sets
from .solution import Solution, Solutions, enough, with_solution

REFINED = 50
"""Comparisons of a target with a point take so many times less time than placing a target."""


def find_solutions(space: SearchSpace, least: int, progress: Progress = Progress()) -> Solutions:
    """Return all solutions with the largest number of matched targets, or nearly so many.

    Parameters
    ----------
    space : SearchSpace
        As `search_space` makes it.
    least : int
        Solutions with fewer targets are not searched for.
    progress : Progress

    Returns
    -------
    Solutions
        By the number of targets, then by how well they fit; empty if nothing fits. At most `most_solutions`
        of the largest number, and as many others. Incomplete if the search was ended because it placed
        `most_placed` targets.

    Raises
    ------
    CancelledError
        If the caller asked to stop.
    """
    if len(space.targets) < least or len(space.control.points) < least:
        return Solutions()
    search = space.settings.matches.search
    solutions: list[Solution] = []
    placed, count, points = 0, len(space.targets), len(space.control.points)
    in_line = space.longest_line(progress)
    matrix = None if space.settings.free_scale else space.matrix(least, progress)
    complete = matrix is None or matrix.targets == count
    if matrix is not None and complete:
        space = space.reordered(matrix)
        matrix = space.matrix(least, progress)
    for last, nodes in _batches(space, matrix, progress):
        wanted = enough(solutions, least, search)
        if last > count - wanted + in_line or wanted > min(count, points):
            complete = True
            break
        if placed > search.most_placed:
            complete = False
            break
        share = max(last / count, placed / search.most_placed)
        solutions, refinements = _extended(
            space, nodes, least, solutions, progress.part(min(share, 1.0), 1.0)
        )
        # To refine a seed, all targets are compared with all points, nearly once for each target.
        placed += len(nodes) * count + refinements * _placed_by_refining(space)
    order = sorted(solutions, key=lambda item: (-item.matched, round(item.misfit, 6), item.labels.tolist()))
    return Solutions(tuple(order), complete)


def _batches(
    space: SearchSpace, matrix: Optional[MatchingMatrix], progress: Progress
) -> Iterator[tuple[int, np.ndarray]]:
    """Yield the seeds target by target, in parts that are tried at once."""
    size = max(space.settings.matches.search.batch_size // len(space.targets), 1)
    for last, nodes in seed_sets(space, matrix, progress):
        progress.check()
        for start in range(0, len(nodes), size):
            yield last, nodes[start : start + size]


def _extended(
    space: SearchSpace, nodes: np.ndarray, least: int, solutions: list[Solution], progress: Progress
) -> tuple[list[Solution], int]:
    """Lay seeds on the control points, and keep the solutions that match enough targets.

    Returns
    -------
    list of Solution
    int
        How many seeds were refined.
    """
    search = space.settings.matches.search
    progress.update(0.0)
    count = len(space.control.points)
    mine, theirs = nodes // count, nodes % count
    wide = are_wide(space, space.targets[mine])
    mine, theirs = mine[wide], theirs[wide]
    poses = fit_pose(space.control.points[theirs], space.targets[mine], space.seed_model)
    scores = matched_at_most(space, poses, mine, theirs)
    for solution in solutions:
        scores[_within(space, solution, mine, theirs)] = 0
    refinements, step = 0, _placed_by_refining(space) / search.most_placed
    while len(scores):
        progress.check()
        top = int(scores.argmax())
        if scores[top] < enough(solutions, least, search):
            break
        done = min(refinements * step, 1.0)
        part = progress.part(done, min(done + step, 1.0))
        refinements += 1
        solution = refined(space, mine[top], theirs[top], part)
        scores[top] = 0
        # Other seeds within this solution lead to it again.
        scores[_within(space, solution, mine, theirs)] = 0
        solutions = with_solution(solution, solutions, least, space.size, search)
    return solutions, refinements


def _placed_by_refining(space: SearchSpace) -> int:
    """Return how many targets could be placed in the time that it takes to refine a seed."""
    count = len(space.targets)
    return len(space.control.points) * count * max(count // REFINED, 1)


def _within(space: SearchSpace, solution: Solution, mine: np.ndarray, theirs: np.ndarray) -> np.ndarray:
    """Return which seeds belong to a solution."""
    return (solution.labels[space.order][mine] == theirs).all(axis=1)
