"""The lists of targets."""

import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.registration.lists.point_list import read_point_list
from ichnograph.algorithms.targets.output.lists import list_writers
from ichnograph.tests.algorithms.targets.made_targets import search, station, target


def test_a_list_holds_the_targets_without_doubt_in_the_coordinates_of_the_file(tmp_path):
    found = search(station("hall", target((1.0, 2.0, 3.0)), target(doubt="few points")))
    writers = list_writers(found)
    writers["hall.txt"](tmp_path / "hall.txt")

    assert (tmp_path / "hall.txt").read_text() == "101.00000 202.00000 13.00000\n"


def test_a_list_is_read_by_the_registration(tmp_path):
    found = search(station("hall", *(target((i, 0.0, i % 2)) for i in range(4))))
    list_writers(found)["hall.txt"](tmp_path / "hall.txt")
    points = read_point_list(tmp_path / "hall.txt")

    assert points.names == ("1", "2", "3", "4")
    assert points.xyz[3].tolist() == [103.0, 200.0, 11.0]


def test_a_scan_without_targets_has_no_list():
    assert list_writers(search(station("hall"), station("attic", target()))).keys() == {"attic.txt"}


def test_two_scans_of_one_name_are_refused():
    with pytest.raises(InputError, match="Two scans are called Hall"):
        list_writers(search(station("hall", target()), station("Hall", target())))
