"""Points come with what all files have of colour, intensity and scan."""

import laspy
import numpy as np
import pytest
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.facade.points import read_points
from ichnograph.algorithms.facade.settings import ThinningSettings
from ichnograph.tests.algorithms.clouds.sample_files import write_e57, write_ply, write_ptx

COUNT = 40


def las(path, colour=True, factor=257, intensity=True, station=1, count=COUNT):
    generator = np.random.default_rng(station)
    header = laspy.LasHeader(point_format=2 if colour else 0, version="1.2")
    header.scales = np.full(3, 0.001)
    cloud = laspy.LasData(header)
    cloud.x, cloud.y, cloud.z = generator.uniform(0, 5, (3, count))
    if colour:
        cloud.red, cloud.green, cloud.blue = generator.integers(0, 256, (3, count)) * factor
    if intensity:
        cloud.intensity = generator.integers(1, 5000, count)
    cloud.point_source_id = np.full(count, station, np.uint16)
    cloud.write(str(path))
    return path


@pytest.mark.parametrize("factor", [1, 257], ids=["8 bits in 16", "16 bits"])
def test_colour_is_0_to_255_whatever_the_file_has(tmp_path, factor):
    path = las(tmp_path / "a.laz", factor=factor)
    points = read_points(open_cloud([path]))

    raw = laspy.read(path)
    np.testing.assert_allclose(
        points.rgb, np.column_stack([raw.red, raw.green, raw.blue]) / factor, atol=0.01
    )


def test_points_that_reach_farther_than_any_facade_are_refused_before_rasters_are_made(tmp_path):
    path = tmp_path / "a.xyz"
    path.write_text("".join(f"{x} 0.5 {z}.5\n" for x in ("0.5", "10000.5") for z in range(10)))
    with pytest.raises(InputError, match="reach over 10000 m, more than the 2000 m of any facade"):
        read_points(open_cloud([path]))


@pytest.mark.parametrize("far", [(1e6, 0, 0), (0, 0, -5e4), (1e300, 0, 0), (30, 0, 0)])
def test_a_single_point_far_away_is_left_out_and_said(tmp_path, far):
    wall = [(x / 50, 0.5, z / 50) for x in range(60) for z in range(20)]
    path = tmp_path / "a.xyz"
    np.savetxt(path, [*wall[:7], far, *wall[7:]], "%.3f")
    points = read_points(open_cloud([path]))

    np.testing.assert_allclose(points.xyz + points.origin, wall)
    assert len(points.scan) == len(wall)
    assert points.warnings == ("a.xyz: 1 of 1201 points lie far away from the site and are left out.",)


def test_a_file_without_colour_or_intensity_has_none(tmp_path):
    points = read_points(open_cloud([las(tmp_path / "a.laz", colour=False, intensity=False)]))
    assert points.rgb is None and points.intensity is None


def test_colour_that_only_some_files_have_is_not_used(tmp_path):
    paths = [las(tmp_path / "a.laz"), las(tmp_path / "b.laz", colour=False, station=2)]
    points = read_points(open_cloud(paths))

    assert points.rgb is None
    assert points.intensity is not None and len(points.xyz) == 2 * COUNT
    assert points.warnings == ("b.laz has no colour, so the colour of the other files is ignored.",)


def test_scans_are_distinguished_by_point_source_file_and_block(tmp_path):
    paths = [las(tmp_path / "a.laz", station=5), las(tmp_path / "b.laz", station=5)]
    cells = np.random.default_rng(0).uniform(1, 2, (10, 4))
    paths.append(write_ptx(tmp_path / "c.ptx", cells, cells))
    points = read_points(open_cloud(paths))

    assert [np.sum(points.scan == number) for number in range(4)] == [COUNT, COUNT, 10, 10]


def test_the_scans_of_an_e57_are_distinguished(tmp_path):
    cells = np.random.default_rng(0).uniform(1, 2, (10, 3))
    points = read_points(open_cloud([write_e57(tmp_path / "a.e57", cells, cells[:4])]))
    assert np.bincount(points.scan).tolist() == [10, 4]


def test_scanners_stand_where_the_poses_of_their_scans_say(tmp_path):
    cells = np.random.default_rng(0).uniform(1, 2, (10, 4))
    moved = np.array([[0, -1, 0, 7.0], [1, 0, 0, 8.0], [0, 0, 1, 9.0], [0, 0, 0, 1]])
    points = read_points(open_cloud([write_ptx(tmp_path / "a.ptx", (cells, moved), cells)]))

    np.testing.assert_allclose(points.stations[0] + points.origin, (7, 8, 9))
    assert np.isnan(points.stations[1]).all()


def test_without_poses_no_scanner_is_known(tmp_path):
    assert read_points(open_cloud([las(tmp_path / "a.laz")])).stations is None


def test_more_points_than_asked_for_are_thinned_the_same_in_any_order(tmp_path):
    xyz = np.random.default_rng(0).uniform(0, 1, (4000, 3)) * (1, 0.002, 1)
    write_ply(tmp_path / "a.ply", xyz)
    write_ply(tmp_path / "b.ply", xyz[::-1])
    thinning = ThinningSettings(most_points=1000)
    first, second = (
        read_points(open_cloud([tmp_path / name]), thinning=thinning) for name in ("a.ply", "b.ply")
    )

    assert 500 < len(first.xyz) <= 1000
    assert sorted(map(tuple, (first.xyz + first.origin).round(6))) == sorted(
        map(tuple, (second.xyz + second.origin).round(6))
    )
