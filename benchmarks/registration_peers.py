"""Other tools that find a rigid transformation among many wrong matches, each with its documented settings.

All of them get every target matched with every control point, about the centroids of both lists, because none
of them matches bare points itself. `make peers` installs them into .peers.

scikit-image
    `ransac` with a 3D `EuclideanTransform`, three matches a sample, at most 20,000 samples. Its hook
    `is_data_valid` drops a sample whose three distances differ before a model is fitted to it.
open3d
    `registration_ransac_based_on_correspondence` with the checkers of its tutorial on distance and on edge
    length (0.99 instead of 0.9, because targets are precise), 4,000,000 iterations, confidence 0.999.
kiss-matcher
    `prune_and_solve` without voxel sampling, the noise bound of pruning and solver as for the others.
cliquematch
    The largest clique of the graph of matches with equal distances (`AlignGraph`), by its heuristic and its
    depth-first search, at most 20 s; then the least squares pose.
"""

from importlib import import_module
from typing import Callable, Optional

import numpy as np
from scipy.spatial.distance import pdist
from scipy.spatial.transform import Rotation

DISTANCES = 4.5
"""Largest difference of two distances that match, and largest residual, in standard deviations of the noise:
three of those of a distance."""

KISS_VOXEL = 0.01


def with_scikit_image(control: np.ndarray, targets: np.ndarray, noise: float) -> Optional[np.ndarray]:
    """Return the pose by RANSAC over all matches."""
    from skimage import measure, transform

    class Pose(transform.EuclideanTransform):
        def __init__(self, matrix: Optional[np.ndarray] = None) -> None:
            super().__init__(matrix=matrix, dimensionality=3)

    def is_congruent(source: np.ndarray, destination: np.ndarray) -> bool:
        return bool((np.abs(pdist(source) - pdist(destination)) < DISTANCES * noise).all())

    model, _ = measure.ransac(
        _all_matches(control, targets),
        Pose,
        min_samples=3,
        residual_threshold=DISTANCES * noise,
        max_trials=20_000,
        is_data_valid=is_congruent,
    )
    return None if model is None else model.params


def with_open3d(control: np.ndarray, targets: np.ndarray, noise: float) -> np.ndarray:
    """Return the pose by RANSAC over all matches."""
    open3d = import_module("open3d")
    registration, utility = open3d.pipelines.registration, open3d.utility
    source, destination = (
        open3d.geometry.PointCloud(utility.Vector3dVector(points)) for points in (targets, control)
    )
    pairs = np.indices((len(targets), len(control))).reshape(2, -1).T.astype(np.int32)
    result = registration.registration_ransac_based_on_correspondence(
        source,
        destination,
        utility.Vector2iVector(pairs),
        DISTANCES * noise,
        registration.TransformationEstimationPointToPoint(False),
        3,
        [
            registration.CorrespondenceCheckerBasedOnEdgeLength(0.99),
            registration.CorrespondenceCheckerBasedOnDistance(DISTANCES * noise),
        ],
        registration.RANSACConvergenceCriteria(4_000_000, 0.999),
    )
    return np.asarray(result.transformation)


def with_kiss_matcher(control: np.ndarray, targets: np.ndarray, noise: float) -> Optional[np.ndarray]:
    """Return the pose of the graph-theoretic pruning and its solver."""
    kiss_matcher = import_module("kiss_matcher")
    # The noise bound is a share of the voxel size, which must be 5 mm at least. It bounds one point of two.
    share = DISTANCES * noise / 2 / KISS_VOXEL
    settings = kiss_matcher.KISSMatcherConfig(
        voxel_size=KISS_VOXEL,
        use_voxel_sampling=False,
        robin_noise_bound_gain=share,
        solver_noise_bound_gain=share,
    )
    source, destination = (points.astype(np.float32) for points in _all_matches(control, targets))
    solution = kiss_matcher.KISSMatcher(settings).prune_and_solve(list(source), list(destination))
    if not solution.valid:
        return None
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = solution.rotation, np.ravel(solution.translation)
    return pose


def with_cliquematch(control: np.ndarray, targets: np.ndarray, noise: float) -> Optional[np.ndarray]:
    """Return the pose of the largest set of matches with equal distances."""
    cliquematch = import_module("cliquematch")
    graph = cliquematch.AlignGraph(*map(np.ascontiguousarray, (targets, control)))
    graph.epsilon = DISTANCES * noise
    graph.build_edges()
    of_targets, of_control = graph.get_correspondence(time_limit=20.0, use_heuristic=True, use_dfs=True)
    if len(of_targets) < 3:
        return None
    return _least_squares(targets[list(of_targets)], control[list(of_control)])


Peer = Callable[[np.ndarray, np.ndarray, float], Optional[np.ndarray]]

PEERS: dict[str, Peer] = {
    "scikit-image": with_scikit_image,
    "open3d": with_open3d,
    "kiss-matcher": with_kiss_matcher,
    "cliquematch": with_cliquematch,
}
"""Each takes the control points (n, 3), the targets (m, 3) and the noise (m), and returns a pose (4, 4) from
the targets to the control points, or None."""


def _all_matches(control: np.ndarray, targets: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return targets and control points, row by row every target with every control point."""
    return np.repeat(targets, len(control), axis=0), np.tile(control, (len(targets), 1))


def _least_squares(source: np.ndarray, destination: np.ndarray) -> np.ndarray:
    rotation, _ = Rotation.align_vectors(destination - destination.mean(axis=0), source - source.mean(axis=0))
    pose = np.eye(4)
    pose[:3, :3] = rotation.as_matrix()
    pose[:3, 3] = destination.mean(axis=0) - pose[:3, :3] @ source.mean(axis=0)
    return pose
