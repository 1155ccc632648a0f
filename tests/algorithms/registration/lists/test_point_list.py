"""Lists of points from files of any kind: names, repeated points, missing files, published lists."""

from pathlib import Path

import numpy as np
import pytest
from ichnograph.algorithms.registration.lists.point_list import is_cloud, read_point_list
from ichnograph.algorithms.registration.lists.settings import ListSettings
from ichnograph.tests.algorithms.registration.lists.written_lists import refuse, write

DATA = Path(__file__).resolve().parents[5] / "shared" / "data"


@pytest.mark.parametrize("name", ["missing.txt", "missing.gpkg", "folder/missing.shp"])
def test_a_missing_file_is_named(tmp_path, name):
    refuse(tmp_path / name, "cannot be read .*; check that it exists")


def test_a_point_that_is_listed_twice_counts_once(tmp_path):
    points = read_point_list(write(tmp_path, "T1 1.5 2.5 3.5\nT2 4.5 5.5 6.5\nT1 1.5 2.5 3.50\n"))
    assert points.names == ("T1", "T2")
    assert len(points.xyz) == 2
    assert points.warnings[0].endswith("count once: T1.")


def test_places_without_names_may_repeat(tmp_path):
    points = read_point_list(write(tmp_path, "1.5 2.5 3.5\n1.5 2.5 3.5\n"))
    assert points.names == ("1", "2")


needs_data = pytest.mark.skipif(not DATA.exists(), reason="the shared test data are not here")


@needs_data
@pytest.mark.parametrize(
    ("file", "count", "names", "first"),
    [
        (
            "registration/grafarend_source.txt",
            7,
            ("Solitude", "BuochZeil"),
            [4157222.543, 664789.307, 4774952.099],
        ),
        ("registration/jag3d_third_target.txt", 4, ("1", "2"), [929.580, 422.800, -0.210]),
        ("control_points_eov_cc0/coo_list.csv", 161, ("base_1", "1"), [667568.278, 271801.865, 252.176]),
        ("control_points_eov_cc0/gcp.txt", 10, ("1", "2"), [133.101, 140.589, 83.295]),
        ("control_points_eov_cc0/totalstation.txt", 1389, ("1", "2"), [-97.4704, -175.0972, 5.3846]),
    ],
)
def test_published_lists(file, count, names, first):
    points = read_point_list(DATA / file)
    assert len(points.names) == len(points.xyz) == count
    assert points.names[:2] == names
    np.testing.assert_array_equal(points.xyz[0], first)
    assert len(points.warnings) == ("totalstation" in file)


@needs_data
def test_published_lists_without_heights_are_refused():
    refuse(DATA / "registration" / "levelled_source.txt", "x and y but no z")


def test_a_text_file_with_more_points_than_anybody_picks_is_a_cloud(tmp_path):
    row = "1.5 2.5 3.5 800\n"
    (tmp_path / "list.xyz").write_text(20_000 * row)
    (tmp_path / "cloud.xyz").write_text(20_001 * row)

    assert is_cloud(tmp_path / "cloud.xyz") and not is_cloud(tmp_path / "list.xyz")


@pytest.mark.parametrize(
    ("name", "cloud"),
    [("a.e57", True), ("a.LAZ", True), ("a.gpkg", False), ("a.list", False), ("a.txt", False)],
)
def test_other_files_are_clouds_by_their_extension(tmp_path, name, cloud):
    assert is_cloud(tmp_path / name) == cloud


def test_standard_deviations_and_correlations_are_read_by_their_names(tmp_path):
    rows = [
        "name sx x y sz z sy rxz rxy ryz",
        "A 0.001 1 2 0.003 3 0.002 0.5 0 0",
        "B nan 4 5 0.003 6 0.002 0 0 0",
    ]
    points = read_point_list(write(tmp_path, "\n".join(rows)))

    assert points.names == ("A", "B")
    (warning,) = points.warnings
    assert "1 of the 2 points in" in warning and "count like points without standard deviations" in warning
    assert points.covariances[0] == pytest.approx(
        np.array([[1e-6, 0, 1.5e-6], [0, 4e-6, 0], [1.5e-6, 0, 9e-6]])
    )
    assert np.isnan(points.covariances[1]).all()


def test_standard_deviations_are_in_the_units_of_the_coordinates(tmp_path):
    text = "x[mm] y[mm] z[mm] sx sy sz\n1000 2000 3000 1 2 3\n4 5 6 1 2 3\n"
    points = read_point_list(write(tmp_path, text))

    assert points.covariances[0] == pytest.approx(np.diag([1e-6, 4e-6, 9e-6]))


@pytest.mark.parametrize(
    "header",
    [
        "name x[m] y[m] z[m] sx[mm] sy[mm] sz[mm]",
        "name x y z sx[mm] sy[mm] sz[mm]",
        "name x y z sx sy sz\n- m m m mm mm mm",
        "# units: m\nname x y z sx[mm] sy[mm] sz[mm]",
    ],
)
def test_standard_deviations_may_have_another_unit_than_the_coordinates(tmp_path, header):
    points = read_point_list(write(tmp_path, f"{header}\nT1 1 2 3 1.5 2 3\nT2 4 5 6 1.5 2 3\n"))

    np.testing.assert_array_equal(points.xyz, [[1, 2, 3], [4, 5, 6]])
    assert points.covariances[0] == pytest.approx(np.diag([2.25e-6, 4e-6, 9e-6]))
    assert [warning.partition(".txt")[2] for warning in points.warnings] == [
        " gives standard deviations in mm; they were converted to metres."
    ]


def test_standard_deviations_that_are_probably_in_another_unit_are_warned_of(tmp_path):
    points = read_point_list(write(tmp_path, "name x y z sx sy sz\nT1 1 2 3 1.5 2 3\nT2 4 5 6 1.5 2 3\n"))

    assert any("are 2 m in the median; check their unit" in warning for warning in points.warnings)


def test_a_list_without_all_three_standard_deviations_has_no_covariances(tmp_path):
    points = read_point_list(write(tmp_path, "x y z sx sy\n1 2 3 0.1 0.1\n4 5 6 0.1 0.1\n"))

    assert points.covariances is None
    assert "further columns were left out" in points.warnings[0]


def test_coordinates_that_went_through_single_precision_are_said(tmp_path):
    exact = np.random.default_rng(0).uniform(0, 50, (12, 3)).round(3) + (412_300, 5_812_300, 70)
    for xyz, said in ((exact, False), (exact.astype(np.float32).astype(float), True)):
        np.savetxt(tmp_path / "a.txt", xyz, "%.4f")
        warnings = read_point_list(tmp_path / "a.txt").warnings
        assert any("have single precision" in sentence for sentence in warnings) == said


def test_heights_that_stand_for_unknown_ones_are_said(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text("name,x,y,z\nA,1.5,2.5,3.5\nB,2.5,3.5,-9999\nC,7.5,8.5,9.5\n")

    assert f"The height of B in {path} is below -1000 m" in read_point_list(path).warnings[0]


@pytest.mark.parametrize(
    ("rows", "said"),
    [
        ("A 4.12E+05 5.81E+06 70.1\nB 4.12E+05 5.82E+06 71.1\nC 4.13E+05 5.81E+06 72.1\n", True),
        ("A 412345 5812345 70.1\nB 412350 5812340 71.1\n", True),
        ("A 412345.6 5812345 70.1\nB 412350.0 5812340.3 71.1\n", False),
        ("A 10 20 1.5\nB 15 40 2.5\n", False),
        ("A 412345.678 5812345.123 70\nB 412350.214 5812340.871 72\n", False),
        ("A 412345 5812345.123 70\nB 412350 5812340.871 72\n", False),
    ],
)
def test_national_coordinates_without_decimals_are_said(tmp_path, rows, said):
    (tmp_path / "a.txt").write_text("name x y z\n" + rows)
    warnings = read_point_list(tmp_path / "a.txt").warnings
    assert any("are multiples of" in sentence for sentence in warnings) == said


@pytest.mark.parametrize(
    "settings",
    [
        ListSettings(largest_local_m=1e9),
        ListSettings(coarsest_step_m=1000.0),
        ListSettings(fewest_rounded=3),
    ],
)
def test_the_settings_decide_which_coordinates_were_rounded(tmp_path, settings):
    path = write(tmp_path, "name x y z\nA 412345 5812345 70.1\nB 412350 5812340 71.1\n")
    assert "multiples of 1 m in x, 1 m in y;" in read_point_list(path).warnings[0]
    assert read_point_list(path, settings=settings).warnings == ()
