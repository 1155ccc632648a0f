"""Spheres: the fit and its tests."""

import numpy as np
import pytest
from ichnograph.algorithms.targets.results import Rejection, Target
from ichnograph.algorithms.targets.spheres.candidates import Candidate
from ichnograph.algorithms.targets.spheres.settings import SphereSettings
from ichnograph.algorithms.targets.spheres.sphere import sphere_at
from ichnograph.tests.algorithms.targets.made_targets import image_of_simulated, one_target
from ichnograph.tests.scenes.stations.caster import Ball, Panel, Scanner, Window, cast
from ichnograph.tests.scenes.stations.layout import Placed, Station

USUAL = SphereSettings().candidates.usual_m


def examined(scan, radius, diameters=USUAL):
    centre = scan.targets[0].centre
    surface = centre * (1 - radius / np.linalg.norm(centre))
    candidate = Candidate(surface + 0.003, radius, 0.1)
    return sphere_at(image_of_simulated(scan), candidate, diameters, SphereSettings())


def ball(radius, *others):
    centre = np.array([5.0, 0.0, 0.0])
    window = Window(0.0, 0.0, (0.08, 0.08), (Ball(centre, radius), *others))
    xyz, intensity = cast(Scanner(step=0.0006), window, np.random.default_rng(1))
    return Station(xyz, intensity, (Placed("sphere", centre, 2 * radius, 5.0, 0.0),))


@pytest.mark.parametrize(("size", "distance"), [(0.076, 3.0), (0.145, 8.0), (0.2, 12.0)])
def test_the_centre_is_found_with_the_usual_diameter(size, distance):
    scan = one_target("sphere", size, distance)
    target = examined(scan, size / 2)

    assert isinstance(target, Target)
    assert target.size == size
    assert np.linalg.norm(target.xyz - scan.targets[0].centre) < 0.001


def test_a_ball_of_another_diameter_is_rejected():
    rejection = examined(ball(0.11), 0.1)

    assert isinstance(rejection, Rejection)
    assert rejection.test == "difference from a usual diameter"


def test_the_chosen_diameter_is_accepted():
    target = examined(ball(0.11), 0.11, (0.22,))

    assert isinstance(target, Target)
    assert target.size == 0.22


def test_half_a_globe_on_a_wall_is_rejected():
    wall = Panel(np.array([5.0, 0.0, 0.0]), np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]), (2.0, 2.0))
    rejection = examined(ball(0.0725, wall), 0.0725)

    assert isinstance(rejection, Rejection)
    assert rejection.test == "part of the surroundings at its depth"


def test_two_diameters_that_cannot_be_distinguished_are_a_doubt():
    target = examined(one_target("sphere", 0.145, 8.0), 0.0725, (0.144, 0.146))

    assert isinstance(target, Target)
    assert target.possible == (0.144, 0.146)
    assert target.doubt == "its diameter may be 144 or 146 mm; set SIZE"
