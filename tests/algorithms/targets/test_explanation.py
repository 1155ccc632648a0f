"""Why a scan has no targets."""

import numpy as np
from ichnograph.algorithms.targets.explanation import explanation, reach_of_step
from ichnograph.algorithms.targets.results import Kind, Rejection
from ichnograph.algorithms.targets.settings import TargetSettings, Wanted
from ichnograph.tests.algorithms.targets.made_targets import station

PLACE = np.array([1.0, 0.0, 0.5])


def test_the_nearest_miss_is_named_with_its_place_value_and_limit():
    hall = station(
        "hall",
        rejections=[
            Rejection(Kind.SPHERE, PLACE, "points around the centre", 0, 15, 16),
            Rejection(Kind.SPHERE, PLACE, "scatter of the ranges", 3, 0.009, 0.005, "m"),
            Rejection(Kind.SPHERE, PLACE, "scatter of the ranges", 3, 0.006, 0.005, "m"),
        ],
    )
    sentence, _ = explanation(hall, TargetSettings(wanted=Wanted.SPHERES))

    assert "3 places in hall look like a sphere" in sentence
    assert "2 by the scatter of the ranges" in sentence
    assert "at 101.00 200.00 10.50" in sentence
    assert "6.0 mm, where 5.0 mm is the limit" in sentence


def test_a_scan_without_candidates_says_so_for_each_kind():
    sentences = explanation(station("hall"), TargetSettings())

    assert "Nothing in hall looks like a black and white target." in sentences
    assert "Nothing in hall looks like a sphere." in sentences


def test_the_step_says_how_far_it_reaches_and_which_one_reaches_farther():
    sentence = reach_of_step(station("hall"), TargetSettings(size=0.1))

    assert "6.0 mm at 10 m" in sentence
    assert "up to 42 m" in sentence
    assert "3.0 mm to find it up to 83 m" in sentence
