"""The lists of targets."""

from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.registration.lists.point_list import read_point_list
from ichnograph.algorithms.targets.output.lists import list_writers
from ichnograph.tests.algorithms.targets.made_targets import search, station, target


def test_a_list_holds_the_targets_without_doubt_in_the_coordinates_of_the_file(tmp_path):
    found = search(station("hall", target((1.0, 2.0, 3.0)), target(doubt="few points")))
    writers = list_writers(found)
    writers["hall.txt"](tmp_path / "hall.txt")

    assert (tmp_path / "hall.txt").read_text().splitlines() == [
        "x y z sx sy sz rxy rxz ryz",
        "101.00000 202.00000 13.00000 0.0010000 0.0020000 0.0030000 0.000000 0.000000 0.000000",
    ]


def test_a_list_is_read_by_the_registration(tmp_path):
    found = search(station("hall", *(target((i, 0.0, i % 2)) for i in range(4))))
    list_writers(found)["hall.txt"](tmp_path / "hall.txt")
    points = read_point_list(tmp_path / "hall.txt")

    assert points.names == ("1", "2", "3", "4")
    assert points.xyz[3].tolist() == [103.0, 200.0, 11.0]
    assert points.warnings == ()


def test_the_registration_reads_the_covariances_of_the_centres(tmp_path):
    ray = np.array([0.6, 0.64, 0.48])
    needle = 1e-8 * np.eye(3) + 4e-6 * np.outer(ray, ray)
    found = search(station("hall", replace(target(), covariance=needle)))
    list_writers(found)["hall.txt"](tmp_path / "hall.txt")
    points = read_point_list(tmp_path / "hall.txt")

    assert points.covariances[0] == pytest.approx(needle, rel=1e-3)
    assert np.linalg.eigvalsh(points.covariances[0])[0] == pytest.approx(1e-8, rel=0.05)


def test_a_scan_without_targets_has_no_list():
    assert list_writers(search(station("hall"), station("attic", target()))).keys() == {"attic.txt"}


def test_two_scans_of_one_name_are_refused():
    with pytest.raises(InputError, match="Two scans are called Hall"):
        list_writers(search(station("hall", target()), station("Hall", target())))
