"""The cheapest division of cells into two kinds."""

import numpy as np
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import breadth_first_order, maximum_flow

SCALE = 1e6
"""Capacities are whole numbers of mm2."""

MOST = 1_000_000_000


def minimum_cut(first: np.ndarray, second: np.ndarray, pairs: np.ndarray, between: np.ndarray) -> np.ndarray:
    """Divide cells into two kinds at the least cost.

    Parameters
    ----------
    first, second : ndarray of float, shape (cells,)
        What it costs to call a cell the first kind, and the second.
    pairs : ndarray of int, shape (n, 2)
        Neighbouring cells.
    between : ndarray of float, shape (n,)
        What it costs if the two are of different kinds.

    Returns
    -------
    ndarray of bool, shape (cells,)
        Whether a cell is of the first kind.
    """
    count = len(first)
    source, sink = count, count + 1
    cells = np.arange(count)
    start = np.concatenate([pairs[:, 0], pairs[:, 1], np.full(count, source), cells])
    stop = np.concatenate([pairs[:, 1], pairs[:, 0], cells, np.full(count, sink)])
    cost = np.concatenate([between, between, second, first])
    capacity = np.minimum(np.rint(cost * SCALE), MOST).astype(np.int32)
    # Entries of the same row and column are added up.
    network = csr_matrix((capacity, (start, stop)), shape=(count + 2, count + 2))
    network.data = np.minimum(network.data, MOST)
    flow = maximum_flow(network, source, sink)
    # scipy renamed it.
    left = network - (flow.flow if hasattr(flow, "flow") else flow.residual)
    left.data = np.maximum(left.data, 0)
    left.eliminate_zeros()
    reached = breadth_first_order(left, source, return_predecessors=False)
    is_first = np.zeros(count + 2, bool)
    is_first[reached] = True
    return is_first[:count]
