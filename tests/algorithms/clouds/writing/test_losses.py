"""What is lost where unlike files are written as one is said."""

import laspy
import numpy as np
import pytest
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.clouds.writing.labelling import write_labelled
from ichnograph.algorithms.clouds.writing.point_selection import write_cloud
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.progress import Progress
from ichnograph.tests.algorithms.clouds.sample_files import write_ply

COUNT = 20
LEFT_OUT = "Left out of {}: {}. Write LAS or LAZ"


def las(path, point_format=2, version="1.2", depth=255, **dimensions):
    """Write random points with colours up to `depth`, and dimensions that are constant."""
    random = np.random.default_rng(0)
    header = laspy.LasHeader(point_format=point_format, version=version)
    header.scales = np.full(3, 0.001)
    if "week_time" in dimensions:
        header.global_encoding.gps_time_type = laspy.header.GpsTimeType(dimensions.pop("week_time"))
    cloud = laspy.LasData(header)
    cloud.x, cloud.y, cloud.z = random.uniform(0, 5, (3, COUNT))
    if "red" in cloud.point_format.dimension_names:
        cloud.red, cloud.green, cloud.blue = np.tile(np.linspace(0, depth, COUNT).astype(int), (3, 1))
    for name, value in {"intensity": 7, **dimensions}.items():
        cloud[name] = np.full(COUNT, value)
    cloud.write(str(path))
    return path


def text(path, header, rows):
    path.write_text(header + "\n" + "".join(" ".join(map(str, row)) + "\n" for row in rows))
    return path


def written(paths, target):
    """Return what is said while all points are written to one file."""
    said = []
    cloud = open_cloud(paths)
    write_cloud(cloud, np.arange(COUNT * len(paths)), target, Progress(lambda _, text: said.append(text)))
    return [sentence for sentence in said if sentence and not sentence.startswith("Reading")]


def test_points_of_files_without_colour_or_intensity_are_said(tmp_path):
    plain = text(tmp_path / "a.xyz", "x y z", np.random.default_rng(1).random((COUNT, 3)))
    assert written([plain, las(tmp_path / "b.las")], tmp_path / "out.laz") == [
        "There is no colour in a.xyz, so the points from there are black in out.laz.",
        "There is no intensity in a.xyz, so it is 0 in out.laz for the points from there.",
    ]


@pytest.mark.parametrize("target", ["out.txt", "out.laz"])
def test_dimensions_that_hold_something_are_named(tmp_path, target):
    dimensions = {"classification": 6, "gps_time": 5.5, "user_data": 0}
    paths = [
        las(tmp_path / "a.las", 3, **dimensions),
        las(tmp_path / "b.las", 7, "1.4", **dimensions),
    ]
    assert written(paths, tmp_path / target)[0].startswith(
        LEFT_OUT.format(target, "classification, gps_time")
    )


def test_normals_of_a_ply_and_further_columns_of_a_text_are_named(tmp_path):
    points = np.rec.fromarrays(np.random.default_rng(0).random((6, COUNT)), names="x,y,z,nx,ny,nz")
    ply = write_ply(tmp_path / "a.ply", points)
    rows = text(tmp_path / "b.txt", "x y z class", np.random.default_rng(0).random((COUNT, 4)))

    assert written([ply, rows], tmp_path / "out.las")[0].startswith(
        LEFT_OUT.format("out.las", "nx, ny, nz, class")
    )


def test_nothing_is_said_where_nothing_is_lost(tmp_path):
    like = [las(tmp_path / name, 3, classification=6, gps_time=5.5) for name in ("a.las", "b.laz")]

    assert written(like, tmp_path / "out.laz") == []
    assert written([las(tmp_path / "c.las")], tmp_path / "out.txt") == []


@pytest.mark.parametrize("labelled", [True, False])
def test_colours_of_8_and_of_16_bits_become_16_bits(tmp_path, labelled):
    cloud = open_cloud([las(tmp_path / "a.las"), las(tmp_path / "b.las", depth=65535)])
    target, every = tmp_path / "out.las", np.arange(2 * COUNT)
    write_labelled(cloud, "n", every, target) if labelled else write_cloud(cloud, every, target)

    red = np.asarray(laspy.read(target).red, int)
    np.testing.assert_allclose(red[:COUNT], red[COUNT:], atol=257)


@pytest.mark.parametrize("labelled", [True, False])
def test_a_colour_beyond_the_range_of_its_file_is_refused_where_ranges_differ(tmp_path, labelled):
    dark = laspy.read(las(tmp_path / "a.las"))
    count = 200_000
    many = laspy.LasData(laspy.LasHeader(point_format=2))
    many.x = many.y = many.z = np.linspace(0, 5, count)
    many.red = many.green = many.blue = np.where(np.arange(count) == 7777, 300, dark.red.max())
    many.write(str(tmp_path / "a.las"))
    cloud = open_cloud([tmp_path / "a.las", las(tmp_path / "b.las", depth=65535)])
    every = np.arange(count + COUNT)

    with pytest.raises(InputError, match="colours above 255"):
        if labelled:
            write_labelled(cloud, "n", every, tmp_path / "out.las")
        else:
            write_cloud(cloud, every, tmp_path / "out.las")


def test_attributes_that_a_new_las_file_cannot_hold_by_their_names_are_named(tmp_path):
    points = np.rec.fromarrays(np.ones((5, COUNT)), names="x,y,z,user_data,n")
    cloud = open_cloud([write_ply(tmp_path / "a.ply", points)])
    said = []
    labels = np.arange(COUNT, dtype=np.uint16)
    write_labelled(
        cloud, "plane", labels, tmp_path / "out.laz", progress=Progress(lambda _, text: said.append(text))
    )

    assert any(sentence.startswith(LEFT_OUT.format("out.laz", "user_data")) for sentence in said)


def test_unlike_kinds_of_gps_time_are_said(tmp_path):
    paths = [las(tmp_path / f"{kind}.las", 3, week_time=kind, gps_time=1.5) for kind in (0, 1)]

    (sentence,) = written(paths, tmp_path / "out.laz")
    assert sentence.startswith("Some inputs have the seconds of a week as GPS times")


def test_labelled_points_keep_shared_attributes_without_a_word(tmp_path):
    points = np.rec.fromarrays(np.random.default_rng(0).random((4, COUNT)), names="x,y,z,deviation")
    cloud = open_cloud([write_ply(tmp_path / "a.ply", points)])
    said = []
    report = Progress(lambda _, text: said.append(text))
    write_labelled(cloud, "n", np.arange(COUNT), tmp_path / "out.laz", progress=report)

    assert not [sentence for sentence in said if "left out" in sentence]
