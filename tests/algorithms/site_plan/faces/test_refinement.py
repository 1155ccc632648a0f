"""Outlines lie on the faces that the points show, and walls are measured by them."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.errors import NothingFoundError
from ichnograph.tests.algorithms.site_plan.masonry import faces_of, masonry, offset, refined, scattered
from shapely.affinity import rotate, translate
from shapely.geometry import LineString, Point, box
from shapely.geometry.polygon import orient

NOISE = 0.003


def ring_wall(radius, thickness):
    return (
        Point(0, 0)
        .buffer(radius + thickness / 2, 128)
        .difference(Point(0, 0).buffer(radius - thickness / 2, 128))
    )


def turns_of(outline):
    """Return the changes of direction at the corners (degrees), sorted."""
    ring = np.asarray(orient(outline).exterior.coords)
    east, north = np.diff(np.vstack([ring, ring[1]]), axis=0).T
    headings = np.degrees(np.arctan2(north, east))
    return np.sort((np.diff(headings) + 180) % 360 - 180)


@pytest.mark.parametrize("thickness", [0.12, 0.2, 0.4])
def test_a_wall_seen_from_both_sides_lies_between_its_faces(thickness):
    truth = rotate(masonry([(0, 0), (5, 0)], thickness), 12)
    (pixels,), (wall,) = refined(scattered(faces_of(truth), NOISE))
    assert offset(wall.outline, truth) < 0.01 < offset(pixels.outline, truth)
    assert wall.outline.symmetric_difference(truth).area < 0.002 * truth.length
    assert wall.thickness == pytest.approx(thickness, abs=0.001)
    assert wall.thick_sd < 0.001
    assert wall.rms == pytest.approx(NOISE, rel=0.3)
    assert wall.coverage > 0.95
    assert wall.radius is None


@settings(max_examples=12, deadline=None)
@given(angle=st.floats(0, 360), east=st.floats(0, 0.1), north=st.floats(0, 0.1))
def test_a_turn_or_a_shift_of_the_site_changes_millimetres(angle, east, north):
    corner = masonry([(0, 0), (4, 0), (4, 3)], 0.24)
    points = scattered(faces_of(corner))
    turned = np.array(translate(rotate(LineString(points[:, :2]), angle, (0, 0)), east, north).coords)
    _, (wall,) = refined(np.column_stack([turned, points[:, 2]]))
    assert offset(wall.outline, translate(rotate(corner, angle, (0, 0)), east, north)) < 0.01
    assert wall.thickness == pytest.approx(0.24, abs=0.001)


@settings(max_examples=5, deadline=None)
@given(seed=st.integers(0, 1000))
def test_the_order_of_the_points_changes_nothing(seed):
    points = scattered(faces_of(rotate(masonry([(0, 0), (3, 0)], 0.3), 30)))
    shuffled = np.random.default_rng(seed).permutation(points)
    assert refined(shuffled) == refined(points)


@pytest.mark.parametrize("angle", [60.0, 88.5, 90.0, 120.0])
def test_a_corner_keeps_its_angle(angle):
    turn = np.radians(180 - angle)
    truth = masonry([(0, 0), (4, 0), (4 + 4 * np.cos(turn), 4 * np.sin(turn))], 0.24)
    _, (wall,) = refined(scattered(faces_of(truth)))
    assert offset(wall.outline, truth) < 0.01
    # At the end of a short jamb an angle is less sure than between long faces.
    np.testing.assert_allclose(turns_of(wall.outline), turns_of(truth), atol=0.5)
    assert np.abs(turns_of(wall.outline) - (180 - angle)).min() < 0.1


def test_a_junction_is_one_wall():
    truth = masonry([(0, 0), (6, 0)], 0.3).union(masonry([(3, 0), (3, 3)], 0.15))
    _, (wall,) = refined(scattered(faces_of(rotate(truth, 17, (0, 0)))))
    assert offset(wall.outline, rotate(truth, 17, (0, 0))) < 0.01


def test_a_door_stays_open_between_its_jambs():
    truth = [rotate(masonry([(start, 0), (start + 3, 0)], 0.24), 10, (0, 0)) for start in (0, 3.9)]
    _, walls = refined(np.concatenate([scattered(faces_of(wall)) for wall in truth]))
    assert len(walls) == 2
    assert walls[0].outline.distance(walls[1].outline) == pytest.approx(0.9, abs=0.005)


@pytest.mark.parametrize("gap", [None, box(-0.5, 0, 0.5, 4)])
def test_a_round_wall_has_a_radius_and_follows_its_arcs(gap):
    whole = ring_wall(2.5, 0.4)
    truth = whole if gap is None else whole.difference(gap)
    _, (wall,) = refined(scattered(faces_of(truth)))
    assert len(wall.outline.interiors) == (1 if gap is None else 0)
    assert offset(wall.outline, truth) < 0.01
    assert wall.radius == pytest.approx(2.5, abs=0.002)
    assert wall.thickness == pytest.approx(0.4, abs=0.002)


def test_the_walls_of_a_room_keep_its_hole():
    truth = rotate(box(0, 0, 5, 4).difference(box(0.3, 0.3, 4.7, 3.7)), 25)
    _, (wall,) = refined(scattered(faces_of(truth)))
    assert offset(wall.outline, truth) < 0.01
    assert len(wall.outline.interiors) == 1


def test_a_face_that_was_not_seen_is_not_invented():
    solid = masonry([(0, 0), (5, 0)], 0.4)
    faces = faces_of(solid)
    south = faces[faces[:, 4] < -0.5]
    _, (wall,) = refined(scattered(south), unseen=box(-1, -0.15, 6, 3))
    west, low, east, high = wall.outline.bounds
    assert low == pytest.approx(-0.2, abs=0.002)
    assert 0.005 < high - low < 0.02
    assert (west, east) == pytest.approx((0, 5), abs=0.03)
    assert wall.thickness is None and wall.thick_sd is None
    assert wall.coverage == pytest.approx(0.5, abs=0.03)


def test_the_front_of_a_face_is_where_the_ground_was_seen():
    faces = faces_of(masonry([(0, 0), (5, 0)], 0.4))
    south = scattered(faces[faces[:, 4] < -0.5])
    _, (from_south,) = refined(south, unseen=box(-1, -0.15, 6, 3))
    _, (from_north,) = refined(south, unseen=box(-1, -3, 6, -0.25))
    assert from_south.outline.centroid.y > -0.2 > from_north.outline.centroid.y


def test_rubble_is_outlined_by_its_mean_face_and_its_rms_is_its_relief():
    truth = masonry([(0, 0), (8, 0)], 0.6)
    faces = faces_of(truth)
    stone = np.floor(faces[:, :3] / (0.2, 0.7, 0.15)).astype(int) @ (1, 40, 80) % 997
    relief = np.random.default_rng(0).normal(0, 0.02, 997)[stone]
    points = scattered(faces)
    points[:, :2] += relief[:, None] * faces[:, 3:]
    _, (wall,) = refined(points)
    assert offset(wall.outline, truth) < 0.03
    assert wall.thickness == pytest.approx(0.6, abs=0.01)
    assert wall.rms == pytest.approx(0.02, rel=0.2)


def test_a_leaning_wall_is_outlined_at_the_middle_of_its_height():
    truth = masonry([(0, 0), (5, 0)], 0.3)
    points = scattered(faces_of(truth))
    points[:, 1] += np.tan(np.radians(1)) * (points[:, 2] - 1.0)
    _, (wall,) = refined(points)
    assert offset(wall.outline, truth) < 0.015
    assert wall.rms == pytest.approx(np.tan(np.radians(1)) * 2 / np.sqrt(12), rel=0.1)


def test_where_nothing_is_known_of_the_faces_the_outline_of_pixels_is_freed_of_its_bias():
    truth = masonry([(0, 0), (5, 0)], 0.4)
    (pixels,), (wall,) = refined(scattered(faces_of(truth)), faces=np.array([[9.0, 9.0, 1.0]]))
    assert wall.coverage == 0
    assert (wall.thickness, wall.rms, wall.radius) == (None, None, None)
    assert wall.outline.equals(pixels.outline.buffer(-0.05, join_style=2))


def test_a_cloud_without_heights_has_faces_too():
    truth = masonry([(0, 0), (5, 0)], 0.3)
    points = scattered(faces_of(truth))
    points[:, 2] = 0.0
    _, (wall,) = refined(points)
    assert offset(wall.outline, truth) < 0.01


def test_a_beam_beside_a_wall_is_no_face():
    truth = masonry([(0, 0), (5, 0)], 0.3)
    beam = scattered(faces_of(box(0, -0.25, 5, -0.2), height=0.08))
    _, (wall,) = refined(np.concatenate([scattered(faces_of(truth)), beam]))
    assert offset(wall.outline, truth) < 0.01


def test_clutter_before_a_face_does_not_move_it():
    truth = masonry([(0, 0), (5, 0)], 0.3)
    clutter = scattered(faces_of(box(2.0, -0.45, 2.6, -0.2), height=1.0))
    _, (wall,) = refined(np.concatenate([scattered(faces_of(truth)), clutter]))
    _, low, _, high = wall.outline.intersection(box(3, -1, 4, 1)).bounds
    assert (low, high) == pytest.approx((-0.15, 0.15), abs=0.002)


def bush(count=3000, seed=1):
    """Return points about a centre that is 4 m north of a wall: about 2 x 0.6 m, thinner outwards."""
    return np.random.default_rng(seed).normal((2, 4, 1), (0.4, 0.12, 0.4), (count, 3)).clip(0)


def test_what_has_points_enough_but_no_face_is_foliage_and_no_wall():
    truth = masonry([(0, 0), (5, 0)], 0.3)
    pixels, walls = refined(np.concatenate([scattered(faces_of(truth)), bush()]))
    assert len(pixels) == 2
    (wall,) = walls
    assert offset(wall.outline, truth) < 0.01


def test_foliage_alone_is_refused_in_one_sentence():
    with pytest.raises(NothingFoundError, match="switch REFINE off"):
        refined(bush())


@pytest.mark.parametrize("seed", range(3))
def test_a_room_seen_from_inside_only_keeps_all_its_walls(seed):
    inside = rotate(box(0, 0, 6, 4), 7)
    faces = faces_of(inside.buffer(0.3, join_style=2).difference(inside))
    seen = np.array([inside.distance(Point(place)) < 0.01 for place in faces[:, :2]])
    _, (wall,) = refined(
        scattered(faces[seen], 0.012, seed), unseen=inside.buffer(3).difference(inside.buffer(0.05))
    )
    assert inside.boundary.difference(wall.outline.buffer(0.02)).length < 0.3
    assert wall.outline.area < 0.1 * inside.length
