"""The search for every way to lay the targets of a scan on control points that is as good as the best.

The seeds are not drawn at random but enumerated in a fixed order until no further solution is possible: a
solution with k of n targets misses n - k, so that three of the first n - k + 3 targets belong to it. Targets
on a line do not fix a pose, so that as many more are taken as the longest line holds.
"""

import numpy as np

from ..adjustment.similarity import fit_pose
from .refinement import refined
from .search_space import SearchSpace
from .seeds import are_wide, matched_at_most, seed_sets
from .solution import Solution, enough, with_solution


def find_solutions(space: SearchSpace, least: int) -> list[Solution]:
    """Return all solutions with the largest number of matched targets, or nearly so many.

    Parameters
    ----------
    space : SearchSpace
        As `search_space` makes it.
    least : int
        Solutions with fewer targets are not searched for.

    Returns
    -------
    list of Solution
        By the number of targets, then by how well they fit; empty if nothing fits. At most `most_solutions`
        of the largest number, and as many others.
    """
    if len(space.targets) < least or len(space.control.points) < least:
        return []
    search = space.settings.matches.search
    solutions: list[Solution] = []
    in_line = space.longest_line
    if not space.settings.free_scale:
        space = space.reordered(least)
    for last, nodes in seed_sets(space, least):
        if last > len(space.targets) - enough(solutions, least, search) + in_line:
            break
        for start in range(0, len(nodes), search.batch_size):
            solutions = _extended(space, nodes[start : start + search.batch_size], least, solutions)
    return sorted(solutions, key=lambda item: (-item.matched, round(item.misfit, 6), item.labels.tolist()))


def _extended(space: SearchSpace, nodes: np.ndarray, least: int, solutions: list[Solution]) -> list[Solution]:
    """Lay seeds on the control points, and keep the solutions that match enough targets."""
    search = space.settings.matches.search
    count = len(space.control.points)
    mine, theirs = nodes // count, nodes % count
    wide = are_wide(space, space.targets[mine])
    mine, theirs = mine[wide], theirs[wide]
    poses = fit_pose(space.control.points[theirs], space.targets[mine], space.seed_model)
    scores = matched_at_most(space, poses, mine, theirs)
    for solution in solutions:
        scores[_within(space, solution, mine, theirs)] = 0
    while len(scores):
        top = int(scores.argmax())
        if scores[top] < enough(solutions, least, search):
            break
        solution = refined(space, mine[top], theirs[top])
        scores[top] = 0
        # Other seeds within this solution lead to it again.
        scores[_within(space, solution, mine, theirs)] = 0
        solutions = with_solution(solution, solutions, least, space.size, search)
    return solutions


def _within(space: SearchSpace, solution: Solution, mine: np.ndarray, theirs: np.ndarray) -> np.ndarray:
    """Return which seeds belong to a solution."""
    return (solution.labels[space.order][mine] == theirs).all(axis=1)
