"""The lines before the first point name the columns, or announce how many points there are."""

from pathlib import Path

import pytest
from ichnograph.algorithms.clouds.formats.text_header import read_preamble
from ichnograph.algorithms.errors import InputError

SCAN = Path("scan.csv")


@pytest.mark.parametrize(
    "line",
    [
        "x;y;z;Intensity",
        "Easting [m];Northing [m];Elevation;reflectance",
        "#Rechtswert;Hochwert;Höhe;i",
        "//X;Y;Z;I",
    ],
)
def test_columns_are_recognised_by_their_usual_names(line):
    names, announced = read_preamble(SCAN, [line], ";", 4)
    assert names == {"x": 0, "y": 1, "z": 2, "intensity": 3}
    assert announced is None


def test_the_order_is_that_of_the_header_and_unknown_names_are_left_out():
    names, _ = read_preamble(SCAN, ["Z;time;Y;X;Nx;Ny;Nz"], ";", 7)
    assert names == {"x": 3, "y": 2, "z": 0, "nx": 4, "ny": 5, "nz": 6}


def test_counts_of_points_add_up():
    assert read_preamble(SCAN, ["1200\n", "# second scan\n", "34\n"], " ", 7) == ({}, 1234)


def test_remarks_and_prose_of_another_width_are_passed_over():
    assert read_preamble(SCAN, ["# the long wall of x", "", "site plan of 2026 x"], " ", 4) == ({}, None)


@pytest.mark.parametrize(
    ("line", "problem"),
    [
        ("lat;lon;height;i", "has geographic coordinates in degrees"),
        ("a;b;c;d", "header in line 1 of scan.csv does not name the 4 columns"),
        ("x;y;z", "header in line 1 of scan.csv does not name the 4 columns"),
        ("1;2", "has 2 columns in line 1 where most lines have 4"),
    ],
)
def test_a_header_that_does_not_fit_is_refused(line, problem):
    with pytest.raises(InputError, match=problem):
        read_preamble(SCAN, [line], ";", 4)
