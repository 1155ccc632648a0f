"""What is known of each wall."""

import pytest
from ichnograph.algorithms.site_plan.storeys.walls.walls import describe_walls
from ichnograph.tests.algorithms.site_plan.storeys.drawn import STOREY, Face, along, sides
from shapely.geometry import Polygon, box

WALL = box(0, 0, 8, 0.2)
SOUTH, NORTH = Face((0, 0), (8, 0)), Face((0, 0.2), (8, 0.2))


def described(faces, *bodies, parapets=()):
    return describe_walls(list(bodies), list(parapets), along(*faces), STOREY)


def test_the_thickness_is_the_distance_of_two_faces():
    (wall,) = described([SOUTH, NORTH], WALL)
    assert (wall.kind, wall.thickness) == ("wall", pytest.approx(0.2))


def test_where_one_face_was_seen_the_thickness_is_not_known():
    (wall,) = described([SOUTH], WALL)
    assert wall.thickness is None
    (strip,) = described([SOUTH, Face((0, 0.02), (8, 0.02))], box(0, 0, 8, 0.02))
    assert strip.thickness is None


def test_the_thickness_is_weighted_by_how_far_faces_are_opposite():
    # A body that is thicker over a quarter of its length; it is not a junction, because nothing juts in.
    tapered = Polygon([(0, 0), (8, 0), (8, 0.2), (6, 0.2), (5.5, 0.3), (4, 0.3), (3.5, 0.2), (0, 0.2)])
    faces = [SOUTH, Face((0, 0.2), (3.5, 0.2)), Face((4, 0.3), (5.5, 0.3)), Face((6, 0.2), (8, 0.2))]
    (wall,) = described(faces, tapered)
    assert wall.thickness == pytest.approx((5.5 * 0.2 + 1.5 * 0.3) / 7)


def test_base_and_top_are_those_of_the_surface_seen():
    (wall,) = described([Face((0, 0), (8, 0), 1, 22), Face((0, 0.2), (8, 0.2), 3, 25)], WALL)
    assert (wall.z_base, wall.z_top) == pytest.approx((0.1, 2.5))


def test_coverage_is_the_share_of_the_outline_with_surface():
    (wall,) = described([SOUTH, NORTH], WALL)
    assert wall.coverage == pytest.approx(16 / 16.4, abs=0.03)
    (half,) = described([SOUTH], WALL)
    assert half.coverage == pytest.approx(8 / 16.4, abs=0.03)


def test_where_no_surface_was_seen_nothing_is_known():
    (wall,) = described([], WALL)
    assert (wall.thickness, wall.z_base, wall.z_top, wall.coverage) == (None, None, None, 0.0)


def test_a_free_column_is_a_column():
    column = box(1, 1, 1.4, 1.4)
    (found,) = described(sides(1, 1, 1.4, 1.4), column)
    assert (found.kind, found.outline) == ("column", column)


@pytest.mark.parametrize(
    "faces, body",
    [
        ([], box(1, 1, 1.4, 1.4)),
        (sides(1, 1, 4, 1.6), box(1, 1, 4, 1.6)),
        (sides(1, 1, 2, 1.02), box(1, 1, 2, 1.02)),
    ],
    ids=["what hardly was seen", "what is large", "a thin screen"],
)
def test_other_free_bodies_are_walls(faces, body):
    assert {wall.kind for wall in described(faces, body)} == {"wall"}


def test_a_column_with_a_notch_is_not_cut():
    notched = box(1, 1, 1.5, 1.5).difference(box(1.4, 1.4, 1.5, 1.5))
    faces = [*sides(1, 1, 1.5, 1.5)[:2], Face((1.4, 1.5), (1, 1.5)), Face((1, 1.5), (1, 1))]
    assert [wall.kind for wall in described(faces, notched)] == ["column"]


def test_a_short_wall_that_stands_free_is_a_wall():
    stub = box(1, 1, 2.2, 1.12)
    assert [wall.kind for wall in described(sides(*stub.bounds), stub)] == ["wall"]


def test_walls_that_meet_in_a_corner_are_no_column():
    corner = box(1, 1, 2, 2).difference(box(1.15, 1.15, 2, 2))
    faces = [*sides(1, 1, 2, 1.15), *sides(1, 1, 1.15, 2)]
    assert [wall.kind for wall in described(faces, corner)] == ["wall", "wall"]


def test_pieces_of_one_body_share_its_number_and_their_edges():
    ring = box(-0.2, -0.2, 4.2, 3.2).difference(box(0, 0, 4, 3))
    walls = described(sides(0, 0, 4, 3), ring, box(6, 0, 9, 0.2))
    assert sorted(wall.body for wall in walls) == [1, 1, 1, 1, 2]
    assert sum(wall.outline.area for wall in walls) == pytest.approx(ring.area + 0.6)
    assert all(
        one.outline.intersection(other.outline).area == pytest.approx(0, abs=1e-9)
        for number, one in enumerate(walls)
        for other in walls[:number]
    )


def test_parapets_follow_the_walls_and_are_pieces_of_no_body():
    wall, parapet = described(
        [SOUTH, NORTH, *sides(5, 2, 6, 2.25, 0, 9)], WALL, parapets=[box(5, 2, 6, 2.25)]
    )
    assert (wall.kind, parapet.kind) == ("wall", "parapet")
    assert parapet.body == 0
    assert parapet.thickness == pytest.approx(0.25)
    assert parapet.z_top == pytest.approx(0.9)


def test_no_bodies_give_no_walls():
    assert described([SOUTH]) == []
