"""Pictures of targets."""

import numpy as np
from ichnograph.algorithms.targets.results import Kind
from ichnograph.algorithms.targets.settings import TargetSettings
from ichnograph.algorithms.targets.view import view_of
from ichnograph.tests.algorithms.targets.made_targets import image_of_simulated, one_target, target


def test_a_picture_shows_the_pattern_around_its_centre():
    scan = one_target("black and white", 0.3, 5.0, 0.0)
    made = target(scan.targets[0].centre)
    view = view_of(image_of_simulated(scan), made, TargetSettings())

    middle = len(view.picture) // 2
    inside = view.picture[middle - 8 : middle + 8, middle - 8 : middle + 8]
    assert np.mean(inside < 80) > 0.3
    assert np.mean(inside > 180) > 0.3
    assert view.height == 1.6 * made.size


def test_a_sphere_is_brighter_than_what_is_behind_it():
    scan = one_target("sphere", 0.145, 5.0)
    view = view_of(image_of_simulated(scan), target(scan.targets[0].centre, Kind.SPHERE), TargetSettings())

    middle = len(view.picture) // 2
    assert view.picture[middle, middle] > 200
    assert view.picture[middle, 0] < 60
