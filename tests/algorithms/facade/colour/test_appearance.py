"""The appearance of points, with and without intensity."""

import numpy as np
from ichnograph.algorithms.facade.colour.appearance import Appearance

RGB = np.full((5, 3), 100, np.float32)


def test_points_are_compared_within_a_multiple_of_f():
    values, reach = Appearance(RGB, np.linspace(0, 1, 5, dtype=np.float32), 0.1).gated(2.5)

    np.testing.assert_allclose(values, np.linspace(0, 1, 5))
    assert reach == 0.25


def test_without_intensity_every_point_passes():
    values, reach = Appearance(RGB).gated(2.5)

    assert np.ptp(values) == 0 and len(values) == 5
    assert np.isinf(reach)
