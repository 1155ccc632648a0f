"""Lists of points from files of any kind: names, repeated points, missing files, published lists."""

from pathlib import Path

import numpy as np
import pytest
from ichnograph.algorithms.registration.lists.point_list import read_point_list
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


def test_coordinates_that_went_through_single_precision_are_said(tmp_path):
    exact = np.random.default_rng(0).uniform(0, 50, (12, 3)).round(3) + (412_300, 5_812_300, 70)
    for xyz, said in ((exact, False), (exact.astype(np.float32).astype(float), True)):
        np.savetxt(tmp_path / "a.txt", xyz, "%.4f")
        warnings = read_point_list(tmp_path / "a.txt").warnings
        assert any("have single precision" in sentence for sentence in warnings) == said
