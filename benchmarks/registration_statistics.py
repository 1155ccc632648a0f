"""Whether the statistics of an adjustment keep what they promise: Monte Carlo over random layouts of targets.

make registration-statistics, or: python3 -m ichnograph.benchmarks.registration_statistics [--trials 5000]

For each model and trial, eight targets on a building are seen in a random pose with normal noise:

region
    Share of 95 % confidence regions of the parameters that hold the true ones, by the a priori and by the a
    posteriori standard deviation.
false alarms
    Share of coordinates without a gross error whose |w| is beyond Baarda's critical value, 0.001 expected.
power
    Share of biases of exactly the minimal detectable size, one a trial, whose own |w| is beyond it, 0.80
    expected.
"""

import argparse
from dataclasses import replace

import numpy as np
from ichnograph.algorithms.registration.adjustment.least_squares import Block, Sighting, adjust
from ichnograph.algorithms.registration.adjustment.settings import OutlierTestSettings
from ichnograph.algorithms.registration.adjustment.similarity import fit_pose
from ichnograph.algorithms.registration.settings import Model
from ichnograph.tests.scenes.targets import CORNER, TargetScene, target_scene
from scipy import stats
from scipy.spatial.transform import Rotation

TESTS = OutlierTestSettings()
TARGETS = 8
NOISE = 0.003
CONFIDENCE = 0.95
MODELS = (Model.RIGID, Model.SIMILARITY, Model.LEVELLED, Model.LEVELLED_SCALE)
SCALES = (0.999, 1.001)


def measure(model: Model, trials: int) -> str:
    """Return a row of the table."""
    found = [trial(model, seed) for seed in range(trials)]
    a_priori, a_posteriori, alarms, detected = (np.array(values) for values in zip(*found))
    return (
        f"| {model.name.lower()} | {_share(a_priori, CONFIDENCE)} | {_share(a_posteriori, CONFIDENCE)} "
        f"| {_share(alarms.ravel(), TESTS.significance)} | {_share(detected, TESTS.power)} |"
    )


def trial(model: Model, seed: int) -> tuple[bool, bool, np.ndarray, bool]:
    """Return whether both regions hold the truth, where an alarm was false, and whether a bias was found."""
    random = np.random.default_rng([seed, model.value])
    scale = random.uniform(*SCALES) if model.scaled else 1.0
    tilt = 0.0 if model.levelled else None
    scene = target_scene(TARGETS, TARGETS, TARGETS, NOISE, int(random.integers(2**32)), tilt, scale)
    block = adjust_scene(scene, model)
    error = parameter_error(block, scene, model)
    squares = error @ np.linalg.solve(block.pose_cofactors[0], error)
    by_sigma0 = squares / model.unknowns / (block.sum_of_squares / block.redundancy)
    coordinate = (random.integers(TARGETS), random.integers(3))
    bias = random.choice([-1, 1]) * block.targets[0].detectable[coordinate]
    biased = adjust_scene(with_bias(scene, coordinate, bias), model)
    return (
        squares < stats.chi2.ppf(CONFIDENCE, model.unknowns),
        by_sigma0 < stats.f.ppf(CONFIDENCE, model.unknowns, block.redundancy),
        np.abs(block.targets[0].normalized) > TESTS.critical_w,
        np.abs(biased.targets[0].normalized[coordinate]) > TESTS.critical_w,
    )


def adjust_scene(scene: TargetScene, model: Model) -> Block:
    """Adjust the scan to the control points that its targets truly are, near the origin."""
    rows = np.array([scene.control.names.index(name) for name in scene.truth.values()])
    points, targets = scene.control.xyz - CORNER, scene.targets.xyz
    sighting = Sighting(targets, rows, fit_pose(points[rows], targets, model))
    return adjust([sighting], points, np.ones(len(points), bool), model, NOISE)


def parameter_error(block: Block, scene: TargetScene, model: Model) -> np.ndarray:
    """Return estimate minus truth of the parameters, in the order of the adjustment."""
    pose, true = block.poses[0], scene.matrix
    scale = np.cbrt(np.linalg.det(true[:3, :3]))
    position = true[:3, :3] @ pose.centre + true[:3, 3] - CORNER
    rotation = Rotation.from_matrix(pose.rotation @ true[:3, :3].T / scale).as_rotvec()
    scale_error = [pose.scale / scale - 1.0] if model.scaled else []
    return np.concatenate(
        [pose.position - position, rotation[2:] if model.levelled else rotation, scale_error]
    )


def with_bias(scene: TargetScene, coordinate: tuple[int, int], bias: float) -> TargetScene:
    """Return the scene with a target shifted along an axis of the control frame by `bias`."""
    target, axis = coordinate
    moved = scene.targets.xyz.copy()
    moved[target] += np.linalg.solve(scene.matrix[:3, :3], bias * np.eye(3)[axis])
    return replace(scene, targets=replace(scene.targets, xyz=moved))


def _share(hits: np.ndarray, expected: float) -> str:
    """Return the share of hits, with the standard deviation that the expected share would have."""
    deviation = np.sqrt(expected * (1 - expected) / hits.size)
    return f"{hits.mean():.4f} (expected {expected:g} ± {deviation:.4f})"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--trials", type=int, default=5000, help="of each model")
    trials = parser.parse_args().trials
    print("| model | region, a priori | region, a posteriori | false alarms | power |")
    print("|---|---|---|---|---|")
    for model in MODELS:
        print(measure(model, trials), flush=True)


if __name__ == "__main__":
    main()
