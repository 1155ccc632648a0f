"""A cloud that does not stand upright is found out, and one that does is left in peace."""

import numpy as np
import pytest
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.clouds.uprightness import (
    Faces,
    axis_that_is_up,
    faces_of,
    hangs,
    tilt,
    upright_warnings,
)
from ichnograph.tests.algorithms.clouds.sample_files import write_ply
from scipy.spatial.transform import Rotation

Z_FROM_Y = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])
"""Turns z, which is up, into y."""


def rectangle(corner, along, across, rng, noise=0.002):
    """Return points 4 cm apart on average on a rectangle from a corner along two vectors."""
    corner, along, across = (np.array(vector, float) for vector in (corner, along, across))
    count = int(np.linalg.norm(np.cross(along, across)) / 0.04**2)
    points = corner + rng.random((count, 1)) * along + rng.random((count, 1)) * across
    return points + rng.normal(0, noise, points.shape)


def house(ceiling=True, slope=0.0, seed=0):
    """Return points of two rooms of 6 x 5 x 2.8 m; without a ceiling, of their walls on the ground."""
    rng = np.random.default_rng(seed)
    parts = [rectangle((x, 0, 0), (0, 5, 0), (0, 0, 2.8), rng) for x in (0, 6, 12)]
    parts += [rectangle((0, y, 0), (12, 0, 0), (0, 0, 2.8), rng) for y in (0, 5)]
    parts.append(rectangle((-4, -4, -4 * slope), (20, 0, 20 * slope), (0, 13, 0), rng))
    if ceiling:
        parts[-1] = rectangle((0, 0, 0), (12, 0, 0), (0, 5, 0), rng)
        parts.append(rectangle((0, 0, 2.8), (12, 0, 0), (0, 5, 0), rng))
    return np.concatenate(parts) @ Rotation.from_euler("z", 25, degrees=True).as_matrix().T


def leaning(degrees):
    return Rotation.from_euler("xyz", [0.8 * degrees, 0.6 * degrees, 0], degrees=True).as_matrix()


@pytest.mark.parametrize("ceiling", [True, False])
@pytest.mark.parametrize("degrees", [1.5, 5, 12])
def test_a_tilt_is_measured(ceiling, degrees):
    faces = faces_of(house(ceiling) @ leaning(degrees).T)
    assert tilt(faces)[0] == pytest.approx(degrees, abs=0.2)


def test_the_azimuth_is_that_to_which_the_cloud_leans():
    east = Rotation.from_euler("y", 5, degrees=True).as_matrix()
    assert tilt(faces_of(house() @ east.T))[1] == pytest.approx(90, abs=2)


@pytest.mark.parametrize("ceiling", [True, False])
def test_an_upright_house_is_left_in_peace(ceiling):
    faces = faces_of(house(ceiling))
    assert tilt(faces)[0] < 0.5
    assert axis_that_is_up(faces) == ""
    assert not hangs(faces)


def test_plumb_walls_on_a_slope_are_upright():
    faces = faces_of(house(ceiling=False, slope=0.09))
    assert tilt(faces) == (0.0, 0.0)


def test_a_wood_has_no_vertical():
    rng = np.random.default_rng(0)
    faces = Faces(rng.random((2000, 3)), Rotation.random(2000, random_state=0).apply([0, 0, 1]))
    assert tilt(faces) == (0.0, 0.0)
    assert axis_that_is_up(faces) == ""


def test_the_axis_across_floors_and_ceilings_is_up():
    assert axis_that_is_up(faces_of(house() @ Z_FROM_Y.T)) == "y"
    assert axis_that_is_up(faces_of(house() @ Z_FROM_Y.T[:, [1, 0, 2]])) == "x"


def test_a_facade_is_not_taken_for_a_floor():
    rng = np.random.default_rng(0)
    wall = rectangle((0, 8, 0), (20, 0, 0), (0, 0, 12), rng)
    street = rectangle((0, 0, 0), (20, 0, 0), (0, 8, 0), rng)
    assert axis_that_is_up(faces_of(np.concatenate([wall, street]))) == ""


def test_walls_that_hang_from_the_ground_stand_on_their_head():
    assert hangs(faces_of(house(ceiling=False) * [1, -1, -1]))
    assert not hangs(faces_of(house() * [1, -1, -1]))


@pytest.mark.parametrize(
    ("turn", "words"),
    [
        (np.eye(3), ""),
        (leaning(5), "tilted by 5.0 degrees towards the azimuth"),
        (Z_FROM_Y, "y seems to be up"),
    ],
)
def test_the_sentence_names_the_file_the_angle_and_the_remedy(tmp_path, turn, words):
    points = np.rec.fromarrays((house() @ turn.T).T, names="x,y,z")
    cloud = open_cloud([write_ply(tmp_path / "scan.ply", points, "binary_little_endian")])
    warnings = upright_warnings(cloud)
    assert len(warnings) == bool(words)
    if words:
        assert warnings[0].startswith("scan.ply: ")
        assert words in warnings[0]
        assert ";" in warnings[0]


def test_a_few_points_have_no_vertical(tmp_path):
    points = np.rec.fromarrays(np.random.default_rng(0).random((3, 50)), names="x,y,z")
    assert upright_warnings(open_cloud([write_ply(tmp_path / "scan.ply", points)])) == ()
