"""The matching matrix M: which pairs of targets have the distance of which pairs of control points.

A node is a possible match, a target with a control point, numbered target * N + point. An edge joins two
nodes if the distance of their targets agrees with that of their points.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from scipy.spatial.distance import cdist

from ...progress import Progress
from ..settings import Model
from .control_points import ControlPoints
from .settings import SearchSettings

PAIRS = 500_000
"""Pairs of edges that are examined at once, a tenth of a second."""


@dataclass(frozen=True)
class MatchingMatrix:
    """The matching matrix as a graph; its edges lead from an earlier target to a later one.

    Attributes
    ----------
    count : int
        N, the number of control points.
    targets : int
        How many of the first targets it holds: all, or as many as have `most_edges` edges.
    starts, ends : ndarray of int64, shape (e,)
        Nodes; sorted by `starts`, then `ends`.
    """

    count: int
    targets: int
    starts: np.ndarray
    ends: np.ndarray


def matching_matrix(
    control: ControlPoints,
    targets: np.ndarray,
    allowed: np.ndarray,
    levelled: bool,
    settings: SearchSettings = SearchSettings(),
    progress: Progress = Progress(),
) -> MatchingMatrix:
    """Return the matching matrix of the targets, in their order.

    Parameters
    ----------
    control : ControlPoints
    targets : ndarray, shape (n, 3)
    allowed : ndarray of bool, shape (n, N)
        Points with which a target may match.
    levelled : bool
        Whether heights must agree as well.
    settings : SearchSettings
        In a regular layout there may be more than `most_edges` edges; the last targets are then left out.
    """
    count = len(control.points)
    low, high = np.triu_indices(count, 1)
    lengths, limits = control.distances[low, high], control.limits[low, high]
    limits = limits + control.scale_error * lengths
    order = np.argsort(lengths, kind="stable")
    low, high, lengths, limits = low[order], high[order], lengths[order], limits[order]
    first, second = np.triu_indices(len(targets), 1)
    asked = cdist(targets, targets)[first, second]
    widest = limits.max(initial=0.0)
    begin = np.searchsorted(lengths, asked - widest)
    counts = np.searchsorted(lengths, asked + widest, side="right") - begin
    # The pairs whose later target is `last`, and both directions of each.
    edges = np.cumsum(np.bincount(second, 2 * counts, minlength=len(targets)))
    held = max(int(np.searchsorted(edges, settings.most_edges, side="right")), min(3, len(targets)))
    if held < len(targets):
        early = second < held
        first, second, begin, counts, asked = (item[early] for item in (first, second, begin, counts, asked))
    progress.check()
    pair = np.repeat(np.arange(len(asked)), counts)
    found = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts) + np.repeat(begin, counts)
    agreeing = np.abs(lengths[found] - asked[pair]) <= limits[found]
    progress.check()
    pair, found = pair[agreeing], found[agreeing]
    i, j = first[pair], second[pair]
    starts, ends = [], []
    for a, c in ((low[found], high[found]), (high[found], low[found])):
        keep = allowed[i, a] & allowed[j, c]
        if levelled:
            rise = (targets[j, 2] - targets[i, 2]) - (control.points[c, 2] - control.points[a, 2])
            keep &= np.abs(rise) <= limits[found]
        starts.append(i[keep] * count + a[keep])
        ends.append(j[keep] * count + c[keep])
        progress.check()
    nodes = len(targets) * count
    keys = np.sort(np.concatenate(starts) * nodes + np.concatenate(ends))
    return MatchingMatrix(count, held, keys // nodes, keys % nodes)


def pruned(
    matrix: MatchingMatrix, targets: int, least: int, progress: Progress = Progress()
) -> MatchingMatrix:
    """Return the graph without nodes that cannot belong to a solution of `least` targets.

    A node of such a solution agrees with all others but one, because one distance may exceed its limit.
    """
    count, starts, ends = matrix.count, matrix.starts, matrix.ends
    enough = max(least - 2, 1)
    while len(starts):
        progress.check()
        # Once for each other target, however many of its points agree.
        agreeing = np.unique(
            np.concatenate([starts * targets + ends // count, ends * targets + starts // count])
        )
        degrees = np.bincount(agreeing // targets, minlength=targets * count)
        keep = (degrees[starts] >= enough) & (degrees[ends] >= enough)
        if keep.all():
            break
        starts, ends = starts[keep], ends[keep]
    return MatchingMatrix(count, matrix.targets, starts, ends)


def seeds(matrix: MatchingMatrix, last: int, model: Model) -> Iterator[np.ndarray]:
    """Yield the smallest sets of nodes that fix a pose, and whose last target is `last`, in parts.

    Yields
    ------
    ndarray of int64, shape (s, 2) if levelled, else (s, 3)
    """
    count = matrix.count
    of_last = matrix.ends // count == last
    starts, ends = matrix.starts[of_last], matrix.ends[of_last]
    if model.levelled:
        yield np.column_stack([starts, ends])
    else:
        yield from _triangles(matrix, starts, ends)


def _triangles(matrix: MatchingMatrix, starts: np.ndarray, ends: np.ndarray) -> Iterator[np.ndarray]:
    """Yield the triangles that close over two of the given edges with the same end."""
    order = np.lexsort([starts, ends])
    starts, ends = starts[order], ends[order]
    # Each edge meets those after it that have the same end.
    after = np.searchsorted(ends, ends, side="right") - np.arange(len(ends)) - 1
    nodes = int(max(matrix.ends.max(initial=0), matrix.starts.max(initial=0))) + 1
    edges = matrix.starts * nodes + matrix.ends
    met = np.cumsum(after)
    parts = np.searchsorted(met, np.arange(PAIRS, met[-1] if len(met) else 0, PAIRS))
    for rows in np.split(np.arange(len(ends)), np.unique(parts)):
        one = np.repeat(rows, after[rows])
        before = np.cumsum(after[rows]) - after[rows]
        other = np.arange(len(one)) - np.repeat(before, after[rows]) + one + 1
        u, v, w = starts[one], starts[other], ends[one]
        keys = u * nodes + v
        position = np.minimum(np.searchsorted(edges, keys), max(len(edges) - 1, 0))
        closed = edges[position] == keys if len(edges) else np.zeros(0, bool)
        yield np.column_stack([u, v, w])[closed]
