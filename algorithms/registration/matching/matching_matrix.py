"""The matching matrix M: which pairs of targets have the distance of which pairs of control points.

A node is a target with a control point that it may be, numbered target * N + point. Two nodes are joined
where the distance of their targets agrees with that of their points.
"""

from dataclasses import dataclass

import numpy as np
from scipy.spatial.distance import cdist

from ..settings import Model
from .control_points import Site


@dataclass(frozen=True)
class Candidates:
    """The matching matrix as a graph; its edges lead from an earlier target to a later one.

    Attributes
    ----------
    count : int
        N, the number of control points.
    starts, ends : ndarray of int64, shape (e,)
        Nodes; sorted by `starts`, then `ends`.
    """

    count: int
    starts: np.ndarray
    ends: np.ndarray


def find_candidates(site: Site, targets: np.ndarray, allowed: np.ndarray, levelled: bool) -> Candidates:
    """Return the matching matrix of the targets, in their order.

    Parameters
    ----------
    site : Site
    targets : ndarray, shape (n, 3)
    allowed : ndarray of bool, shape (n, N)
        Which points a target may be.
    levelled : bool
        Whether heights must agree as well.
    """
    count = len(site.points)
    low, high = np.triu_indices(count, 1)
    lengths, limits = site.distances[low, high], site.limits[low, high]
    limits = limits + site.drift * lengths
    order = np.argsort(lengths, kind="stable")
    low, high, lengths, limits = low[order], high[order], lengths[order], limits[order]
    first, second = np.triu_indices(len(targets), 1)
    asked = cdist(targets, targets)[first, second]
    widest = limits.max(initial=0.0)
    begin = np.searchsorted(lengths, asked - widest)
    counts = np.searchsorted(lengths, asked + widest, side="right") - begin
    pair = np.repeat(np.arange(len(asked)), counts)
    found = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts) + np.repeat(begin, counts)
    agreeing = np.abs(lengths[found] - asked[pair]) <= limits[found]
    pair, found = pair[agreeing], found[agreeing]
    i, j = first[pair], second[pair]
    starts, ends = [], []
    for a, c in ((low[found], high[found]), (high[found], low[found])):
        keep = allowed[i, a] & allowed[j, c]
        if levelled:
            rise = (targets[j, 2] - targets[i, 2]) - (site.points[c, 2] - site.points[a, 2])
            keep &= np.abs(rise) <= limits[found]
        starts.append(i[keep] * count + a[keep])
        ends.append(j[keep] * count + c[keep])
    starts, ends = np.concatenate(starts), np.concatenate(ends)
    order = np.lexsort([ends, starts])
    return Candidates(count, starts[order], ends[order])


def pruned(candidates: Candidates, targets: int, least: int) -> Candidates:
    """Return the graph without nodes that cannot belong to a solution of `least` targets.

    Such a node agrees with all others but one, for one distance may be off by more than its limit.
    """
    count, starts, ends = candidates.count, candidates.starts, candidates.ends
    enough = max(least - 2, 1)
    while len(starts):
        # Once for each other target, however many of its points agree.
        agreeing = np.unique(
            np.concatenate([starts * targets + ends // count, ends * targets + starts // count])
        )
        degrees = np.bincount(agreeing // targets, minlength=targets * count)
        keep = (degrees[starts] >= enough) & (degrees[ends] >= enough)
        if keep.all():
            break
        starts, ends = starts[keep], ends[keep]
    return Candidates(count, starts, ends)


def seeds(candidates: Candidates, last: int, model: Model) -> np.ndarray:
    """Return the smallest sets of nodes that fix a pose and whose last target is `last`.

    Returns
    -------
    ndarray of int64, shape (s, 2) if levelled, else (s, 3)
    """
    count = candidates.count
    of_last = candidates.ends // count == last
    starts, ends = candidates.starts[of_last], candidates.ends[of_last]
    if model.levelled:
        return np.column_stack([starts, ends])
    return _triangles(candidates, starts, ends)


def _triangles(candidates: Candidates, starts: np.ndarray, ends: np.ndarray) -> np.ndarray:
    """Return the triangles that close over two of the given edges with the same end."""
    order = np.lexsort([starts, ends])
    starts, ends = starts[order], ends[order]
    # Each edge meets those after it that have the same end.
    after = np.searchsorted(ends, ends, side="right") - np.arange(len(ends)) - 1
    one = np.repeat(np.arange(len(ends)), after)
    other = np.arange(len(one)) - np.repeat(np.cumsum(after) - after, after) + one + 1
    u, v, w = starts[one], starts[other], ends[one]
    nodes = int(max(candidates.ends.max(initial=0), candidates.starts.max(initial=0))) + 1
    edges = candidates.starts * nodes + candidates.ends
    keys = u * nodes + v
    place = np.minimum(np.searchsorted(edges, keys), max(len(edges) - 1, 0))
    closed = edges[place] == keys if len(edges) else np.zeros(0, bool)
    return np.column_stack([u, v, w])[closed]
