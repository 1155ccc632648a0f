"""The t-test whether the scale of a scan differs from 1, and what to do about it."""

import numpy as np
from scipy import stats

from ..results import GlobalTest, ScaleTest
from ..settings import Model, Settings
from .block_adjustment import Adjusted
from .least_squares import Sighting, adjust
from .similarity import Pose
from .statistical_tests import global_test, spread_factor
from .target_layout import is_of_projection

WITH_SCALE = {Model.RIGID: Model.SIMILARITY, Model.LEVELLED: Model.LEVELLED_SCALE}


def scale_test(sighting: Sighting, number: int, adjusted: Adjusted, settings: Settings) -> ScaleTest:
    """Test the scale of a scan, if its model has none by an adjustment of the scan alone with a scale.

    Parameters
    ----------
    sighting : Sighting
        The targets that were used, with the adjusted pose.
    number : int
        Of the scan in the block.
    adjusted : Adjusted
    settings : Settings
    """
    model, block = settings.model, adjusted.block
    scaled = WITH_SCALE.get(model, model)
    if model is scaled:
        of_scan = adjusted.tests[number]
        return _tested(block.poses[number], block.pose_cofactors[number], of_scan, sighting.targets, settings)
    fixed = np.ones(len(block.points), bool)
    alone = adjust([sighting], block.points, fixed, scaled, settings.sigma, settings=settings.adjustment)
    test = global_test(alone.sum_of_squares, alone.redundancy, settings.adjustment.tests)
    return _tested(alone.poses[0], alone.pose_cofactors[0], test, sighting.targets, settings)


def _tested(
    pose: Pose, cofactors: np.ndarray, test: GlobalTest, targets: np.ndarray, settings: Settings
) -> ScaleTest:
    deviation = float(pose.scale) - 1.0
    spread = spread_factor(test, settings.adjustment.tests)
    std = float(pose.scale) * float(np.sqrt(cofactors[-1, -1])) * spread
    limits = settings.adjustment.scale_test
    limit = stats.t.isf(limits.significance / 2, max(test.redundancy, 1.0))
    significant = bool(abs(deviation) > limit * std)
    advice = _advice(1e6 * deviation, significant, targets, settings)
    return ScaleTest(1e6 * deviation, 1e6 * std, significant, advice)


def _advice(ppm: float, significant: bool, targets: np.ndarray, settings: Settings) -> str:
    model = settings.model
    if model is Model.UNKNOWN_SCALE:
        return f"One unit of the scan is {1 + ppm / 1e6:.6g} m."
    if not significant:
        return (
            "The scale does not differ significantly from 1; a model without scale suffices."
            if model.scaled
            else "The scale does not differ significantly from 1."
        )
    extent = float(np.linalg.norm(np.ptp(targets, axis=0)))
    differs = (
        f"The scale differs from 1 by {ppm:+.0f} ppm, {abs(ppm) * extent / 1000:.1f} mm over the "
        f"{extent:.0f} m of the targets, which suggests"
    )
    if not is_of_projection(ppm, targets, settings):
        return (
            f"{differs} a wrong target, a SIGMA that is too small, or a scanner that needs calibration; if "
            "other scans have the same scale, "
            f"{'keep the model with scale' if model.scaled else 'choose a model with scale'}."
        )
    remedy = (
        "keep the model with scale" if model.scaled else "choose a model with scale, or reduce the distances"
    )
    return f"{differs} grid coordinates that are not reduced for the projection; {remedy}."
