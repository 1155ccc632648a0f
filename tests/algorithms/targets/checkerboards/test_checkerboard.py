"""Black and white targets: the fit and its tests."""

import numpy as np
import pytest
from ichnograph.algorithms.targets.checkerboards.candidates import Candidate
from ichnograph.algorithms.targets.checkerboards.checkerboard import checkerboard_at
from ichnograph.algorithms.targets.checkerboards.settings import CheckerboardSettings
from ichnograph.algorithms.targets.results import Rejection, Target
from ichnograph.tests.algorithms.targets.made_targets import SCANNER, image_of_simulated, one_target
from ichnograph.tests.scenes.stations.caster import Scanner
from ichnograph.tests.scenes.stations.layout import cluttered_station, target_station


def examined(scan, size=None, radius=0.03, shift=0.005):
    centre = scan.targets[0].centre
    aside = np.cross(centre, [0, 0, 1.0])
    place = centre + shift * aside / np.linalg.norm(aside)
    return checkerboard_at(
        image_of_simulated(scan), Candidate(place, radius, 0.8), size, CheckerboardSettings()
    )


@pytest.mark.parametrize("incidence", [0.0, 30.0, 60.0])
def test_the_centre_is_found_from_beside_it(incidence):
    scan = one_target("black and white", 0.15, 5.0, incidence)
    target = examined(scan)

    assert isinstance(target, Target)
    assert np.linalg.norm(target.xyz - scan.targets[0].centre) < 0.0005
    assert target.incidence_deg == pytest.approx(incidence, abs=4)
    assert target.size == pytest.approx(0.15, rel=0.1)


def test_a_target_behind_a_post_is_still_exact():
    scan = one_target("black and white", 0.3, 6.0, 10.0, covered=0.2)
    target = examined(scan)

    assert isinstance(target, Target)
    assert np.linalg.norm(target.xyz - scan.targets[0].centre) < 0.0005


def test_another_size_than_the_chosen_one_is_rejected():
    rejection = examined(one_target("black and white", 0.15, 5.0), size=0.3)

    assert isinstance(rejection, Rejection)
    assert rejection.test == "width of the pattern"


def test_too_coarse_a_scan_is_rejected_by_its_points():
    rejection = examined(one_target("black and white", 0.075, 30.0), radius=0.016)

    assert isinstance(rejection, Rejection)
    assert rejection.test == "points around the centre"


def test_fields_that_do_not_end_are_rejected():
    scan = cluttered_station(SCANNER, (3.0,), seed=4)
    image = image_of_simulated(scan)
    # The last window shows fields of paint that meet in its middle.
    last = scan.xyz[-1]
    row, column = image.pixel(last)
    results = [
        checkerboard_at(
            image,
            Candidate(image.direction(row - d, column - d) * 3.0, 0.03, 0.5),
            None,
            CheckerboardSettings(),
        )
        for d in range(20, 200, 20)
    ]

    assert all(isinstance(result, Rejection) for result in results)


@pytest.mark.parametrize(("incidence", "seed"), [(60.0, 4), (66.0, 4), (66.0, 7)])
def test_what_is_behind_a_slanting_target_does_not_hide_it(incidence, seed):
    scanner = Scanner(step=0.0006, noise=0.0015, crosstalk=-0.0014)
    scan = target_station(scanner, [("black and white", 0.3, 6.0, incidence)], seed)
    target = examined(scan, radius=0.016, shift=0.002)

    assert isinstance(target, Target)
    assert np.linalg.norm(target.xyz - scan.targets[0].centre) < 0.002
