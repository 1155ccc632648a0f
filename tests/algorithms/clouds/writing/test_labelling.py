"""All points arrive with all they have and one attribute more."""

import laspy
import numpy as np
import pandas as pd
import pytest
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.clouds.writing.labelling import write_labelled
from ichnograph.algorithms.errors import InputError
from ichnograph.tests.algorithms.clouds.sample_files import leave_usable, write_ply


def las(path, count, point_format=7, seed=0, extra=True):
    generator = np.random.default_rng(seed)
    header = laspy.LasHeader(version="1.4", point_format=point_format)
    header.scales, header.offsets = np.full(3, 0.001), np.array([400000.0, 5000000, 0])
    if extra:
        header.add_extra_dim(laspy.ExtraBytesParams("deviation", np.uint16))
    points = laspy.ScaleAwarePointRecord.zeros(count, header=header)
    for name in points.array.dtype.names:
        points.array[name] = generator.integers(1, 200, count)
    leave_usable(points.array)
    with laspy.open(path, "w", header=header) as writer:
        writer.write_points(points)
    return path


@pytest.mark.parametrize("name", ["out.las", "out.laz"])
def test_las_keeps_every_attribute_and_gets_the_numbers(tmp_path, name):
    path, numbers = las(tmp_path / "in.laz", 50), np.arange(50, dtype=np.uint16)
    write_labelled(open_cloud([path]), "plane", numbers, tmp_path / name)
    before, after = laspy.read(path), laspy.read(tmp_path / name)

    np.testing.assert_array_equal(after["plane"], numbers)
    for dimension in before.point_format.dimension_names:
        np.testing.assert_array_equal(after[dimension], before[dimension])


def test_files_become_one_in_the_sequence_of_their_points(tmp_path):
    paths = [las(tmp_path / f"{name}.laz", 20, seed=seed) for seed, name in enumerate("ab")]
    write_labelled(open_cloud(paths), "plane", np.arange(40, dtype=np.uint16), tmp_path / "out.laz")
    after = laspy.read(tmp_path / "out.laz")

    np.testing.assert_array_equal(after["plane"], np.arange(40))
    np.testing.assert_allclose(after.x, np.concatenate([laspy.read(path).x for path in paths]))


@pytest.mark.parametrize("suffix", ["laz", "ply"])
def test_points_without_a_value_are_written_with_0(tmp_path, suffix):
    path = tmp_path / f"in.{suffix}"
    xyz = np.random.default_rng(0).random((12, 3)).round(3)
    write_ply(path, xyz) if suffix == "ply" else las(path, 12)
    labels, labelled = np.array([1, 2, 2, 1], np.uint16), np.array([0, 3, 4, 11])
    write_labelled(open_cloud([path]), "plane", labels, tmp_path / "out.laz", labelled)

    assert list(laspy.read(tmp_path / "out.laz")["plane"]) == [1, 0, 0, 2, 2, 0, 0, 0, 0, 0, 0, 1]


def test_numbers_of_an_earlier_run_are_replaced(tmp_path):
    path = las(tmp_path / "in.laz", 10)
    write_labelled(open_cloud([path]), "plane", np.ones(10, np.uint16), tmp_path / "first.laz")
    write_labelled(
        open_cloud([tmp_path / "first.laz"]), "plane", np.full(10, 7, np.uint16), tmp_path / "second.laz"
    )
    after = laspy.read(tmp_path / "second.laz")

    assert list(after.point_format.extra_dimension_names).count("plane") == 1
    assert (after["plane"] == 7).all()


@pytest.mark.parametrize("name", ["out.laz", "out.txt"])
def test_other_formats_become_las_or_text(tmp_path, name):
    points = np.random.default_rng(0).uniform(0, 5, (30, 3)).round(3)
    cloud = open_cloud([write_ply(tmp_path / "in.ply", points)])
    write_labelled(cloud, "plane", np.arange(30, dtype=np.uint16), tmp_path / name)

    if name.endswith("laz"):
        after = laspy.read(tmp_path / name)
        found, numbers = np.column_stack([after.x, after.y, after.z]), after["plane"]
    else:
        table = pd.read_csv(tmp_path / name, sep=" ")
        found, numbers = table[["x", "y", "z"]].to_numpy(), table["plane"]
    np.testing.assert_allclose(found, points, atol=1e-4)
    np.testing.assert_array_equal(numbers, np.arange(30))


def test_an_input_is_never_overwritten(tmp_path):
    path = las(tmp_path / "in.laz", 10)
    with pytest.raises(InputError, match=r"in\.laz"):
        write_labelled(open_cloud([path]), "plane", np.ones(10, np.uint16), path)
