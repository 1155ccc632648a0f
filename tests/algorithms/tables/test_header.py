"""The lines before the first point name the columns, or announce how many points there are."""

from pathlib import Path

import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.tables.header import Header, read_preamble

SCAN = Path("scan.csv")


@pytest.mark.parametrize(
    "line",
    [
        "x;y;z;Intensity",
        "Easting [m];Northing [m];Elevation;reflectance",
        "#Rechtswert;Hochwert;Höhe;i",
        "//X;Y;Z;I",
        "Est;Nord;Quota;Intensità",
        "Este;Norte;Cota;Intensidad",
        "Coordonnée X;Coordonnée Y;Altitude;Intensité",
        "Ost-Wert;Nord-Wert;Höhe [m];Intensität",
    ],
)
def test_columns_are_recognised_by_their_usual_names(line):
    header = read_preamble(SCAN, [line], ";", 4)
    assert header.columns == {"x": 0, "y": 1, "z": 2, "intensity": 3}
    assert header.announced is None


def test_the_order_is_that_of_the_header_and_unknown_names_are_left_out():
    header = read_preamble(SCAN, ["Z;time;Y;X;Nx;Ny;Nz"], ";", 7)
    assert header.columns == {"x": 3, "y": 2, "z": 0, "nx": 4, "ny": 5, "nz": 6}


def test_counts_of_points_add_up():
    assert read_preamble(SCAN, ["1200\n", "# second scan\n", "34\n"], " ", 7) == Header(announced=1234)


def test_remarks_and_prose_of_another_width_are_passed_over():
    assert read_preamble(SCAN, ["# the long wall of x", "", "site plan of 2026 x"], " ", 4) == Header()


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


@pytest.mark.parametrize(
    ("lines", "delimiter", "metres"),
    [
        (["X [mm];Y [mm];Z [mm]"], ";", (1e-3, 1e-3, 1e-3)),
        (["x_mm;y_mm;z_mm"], ";", (1e-3, 1e-3, 1e-3)),
        (["X (m);Y (m);Z (cm)"], ";", (1, 1, 1e-2)),
        (["x;y;z", "[cm];[cm];[mm]"], ";", (1e-2, 1e-2, 1e-3)),
        (["# units: mm", "x;y;z"], ";", (1e-3, 1e-3, 1e-3)),
        (["X [mm] Y [mm] Z [mm]"], " ", (1e-3, 1e-3, 1e-3)),
        (["x;y;z"], ";", (1, 1, 1)),
    ],
)
def test_units_of_the_coordinates_are_read_from_the_header(lines, delimiter, metres):
    assert read_preamble(SCAN, lines, delimiter, 3).factors(SCAN) == metres


@pytest.mark.parametrize("line", ["X [ft];Y [ft];Z [ft]", "x (US-ft);y (US-ft);z (m)", "E/ft;N/ft;H/ft"])
def test_feet_are_refused_because_there_are_several(line):
    with pytest.raises(InputError, match=r"scan\.csv gives lengths in (us)?ft; convert them to metres"):
        read_preamble(SCAN, [line], ";", 3).factors(SCAN)


@pytest.mark.parametrize(
    ("lines", "problem"),
    [
        (["X [mm];Y;Z"], "states the unit of some columns only"),
        (["x [ft];y;z"], "states the unit of some columns only"),
        (["x;y;z", "1.5;2.5;n/a"], "Line 2 of scan.csv, below the names of the columns, is not a row"),
        (["x;y;z", "1.5d3;2.5d3;1.5d3"], "Line 2 of scan.csv, below the names of the columns, is not a row"),
        (["X;Y;Z;x;y;z"], "has several columns called X"),
        (["X (local);X (grid);Y;Z"], "has several columns called X"),
    ],
)
def test_what_a_header_leaves_open_is_refused(lines, problem):
    with pytest.raises(InputError, match=problem):
        read_preamble(SCAN, lines, ";", len(lines[0].split(";")))


@pytest.mark.parametrize("lines", [["X Y Z (mm)"], ["x y z", "# all in mm"], ["coordinates in mm", "x y z"]])
def test_a_unit_that_is_stated_once_is_that_of_all_coordinates(lines):
    assert read_preamble(SCAN, lines, " ", 3).factors(SCAN) == (1e-3, 1e-3, 1e-3)


@pytest.mark.parametrize(
    ("lines", "metres"),
    [
        (["# units: m", "x[mm] y[mm] z"], (1e-3, 1e-3, 1)),
        (["x y z[mm]", "# all in millimetres"], (1e-3, 1e-3, 1e-3)),
    ],
)
def test_a_remark_states_the_unit_of_those_columns_that_state_none(lines, metres):
    assert read_preamble(SCAN, lines, " ", 3).factors(SCAN) == metres


@pytest.mark.parametrize("lines", [["# all in mm", "x y z[m]"], ["# units: mm", "# unit: m", "x y z"]])
def test_remarks_with_several_units_are_refused(lines):
    with pytest.raises(InputError, match=r"remarks in scan\.csv state several units, mm and m"):
        read_preamble(SCAN, lines, " ", 3)


def test_the_names_may_end_with_a_separator_although_the_rows_do_not():
    assert read_preamble(SCAN, ["X,Y,Z,i,"], ",", 4).columns == {"x": 0, "y": 1, "z": 2, "intensity": 3}


def test_two_pairs_of_horizontal_coordinates_are_asked_for():
    names = "X;Y;Z;Easting;Northing;Height\n"
    with pytest.raises(InputError, match="has X and Easting for one coordinate; rename"):
        read_preamble(Path("list.csv"), [names], ";", 6)
    accuracies = "#Label,X/East,Y/North,Z/Altitude,Accuracy_X,Y,Z\n"
    with pytest.raises(InputError, match="has Y/North and Y for one coordinate; rename"):
        read_preamble(Path("list.csv"), [accuracies], ",", 7)
    assert read_preamble(Path("list.csv"), ["X;Y;Z;Height\n"], ";", 4).columns["z"] == 2


@pytest.mark.parametrize("names", ["E;N;H;X;Y;Z", "X;Y;Z;N;E;H"])
def test_letters_that_name_all_three_coordinates_are_a_second_system(names):
    with pytest.raises(InputError, match="for one coordinate; rename"):
        read_preamble(Path("list.csv"), [names], ";", 6)


@pytest.mark.parametrize(
    ("names", "columns"),
    [
        ("N;X;Y;Z", (1, 2, 3)),
        ("X;Y;Z;N", (0, 1, 2)),
        ("x;y;z;n;e", (0, 1, 2)),
        ("X;Y;Z;Points:0;Points:1;Points:2", (0, 1, 2)),
        ("Point ID;Easting;Northing;Height;Cartesian X;Cartesian Y;Cartesian Z", (1, 2, 3)),
        ("E;N;H", (0, 1, 2)),
        ("Points:0;Points:1;Points:2", (0, 1, 2)),
    ],
)
def test_numbers_errors_and_accompanying_positions_are_no_second_system(names, columns):
    found = read_preamble(Path("list.csv"), [names], ";", names.count(";") + 1).columns
    assert (found["x"], found["y"], found["z"]) == columns
