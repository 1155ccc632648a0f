"""Parts of what is linked in pairs."""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree


def label_linked(first: np.ndarray, second: np.ndarray, count: int) -> np.ndarray:
    """Label things 0..count-1 so that those linked, `first` to `second` in pairs, have one label."""
    links = coo_matrix((np.ones(len(first), bool), (first, second)), shape=(count, count))
    return connected_components(links, directed=False)[1]


def label_near(cells: np.ndarray, reach: int) -> np.ndarray:
    """Label cells of a grid, shape (n, axes), so that those within `reach` on each axis have one label."""
    first, second = cKDTree(cells).query_pairs(float(reach), p=np.inf, output_type="ndarray").T
    return label_linked(first, second, len(cells))
