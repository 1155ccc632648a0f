"""A facade is seen from the street: what is behind a wall is seen in its holes only."""

import numpy as np
import pytest
from ichnograph.algorithms.facade.planes.front import find_side
from ichnograph.tests.algorithms.facade.samples import at, lattice, without

WINDOWS = ((1.0, 1.0, 2.0, 2.5), (3.0, 1.0, 4.0, 2.5))
STEP = 0.04


def wall():
    points = lattice(0, 0, 5, 4, STEP)
    for window in WINDOWS:
        points = without(points, *window)
    return at(points)


def panes(depth=-0.2):
    return np.concatenate([at(lattice(*window, STEP), depth) for window in WINDOWS])


def car():
    """Something in front, behind which the wall is seen as well."""
    return at(lattice(0.2, 0, 2.2, 1.2, STEP), 1.2)


def street(sign=1):
    u, w = np.meshgrid(np.arange(0, 5, 0.1), np.arange(0.2, 8, 0.1))
    return np.column_stack([u.ravel(), np.full(u.size, 0.02), sign * w.ravel()])


def side_of(*parts, scanners=np.nan):
    uvw = np.concatenate(parts)
    on_wall = np.arange(len(uvw)) < len(parts[0])
    return find_side(uvw, on_wall, np.full(len(uvw), scanners))


def mirrored(points):
    return points * (1, 1, -1)


@pytest.mark.parametrize("others", [(), (car(),), (street(),), (car(), street())], ids=len)
def test_panes_in_its_holes_are_behind_a_wall(others):
    parts = (wall(), panes(), *others)

    assert side_of(*parts).sign == 1
    assert side_of(*map(mirrored, parts)).sign == -1
    assert side_of(*parts).sure > 0.3


def test_a_bay_does_not_outvote_the_windows_beside_it():
    bay = (2.2, 0.2, 2.8, 3.8)
    left = at(without(wall()[:, :2], *bay))
    front = at(lattice(*bay, STEP), 0.6)
    assert side_of(left, panes(), front, car()).sign == 1


def test_rooms_with_more_points_than_the_street_do_not_decide():
    rooms = np.concatenate([street(-1) for _ in range(5)])
    inner = at(without(without(lattice(0, 0, 5, 3, STEP), *WINDOWS[0]), *WINDOWS[1]), -0.35)
    found = side_of(wall(), panes(), rooms, inner)

    assert found.sign == 1
    assert found.inner.offset == pytest.approx(0.35, abs=0.01)
    assert "inner face" in found.reason


@pytest.mark.parametrize("scanner", [6.0, -6.0])
def test_the_position_of_the_scanner_comes_first(scanner):
    found = side_of(wall(), panes(), scanners=scanner)

    assert found.sign == np.sign(scanner)
    assert found.sure == 1
    assert "scanner" in found.reason


def test_a_wall_without_holes_faces_the_street_and_that_is_uncertain():
    found = side_of(at(lattice(0, 0, 5, 4, STEP)), street())

    assert found.sign == 1 and found.sure == 0
