"""Things that hang together."""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components


def label_linked(first: np.ndarray, second: np.ndarray, count: int) -> np.ndarray:
    """Label things 0..count-1 so that those linked, `first` to `second` in pairs, have one label."""
    links = coo_matrix((np.ones(len(first), bool), (first, second)), shape=(count, count))
    return connected_components(links, directed=False)[1]
