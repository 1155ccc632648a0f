"""The centrelines of walls."""

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.site_plan.axes.axes import find_axes
from shapely.affinity import rotate, translate
from shapely.geometry import LineString, Point, Polygon, box
from shapely.ops import unary_union


def wall(*corners, thickness=0.3):
    return LineString(corners).buffer(thickness / 2, cap_style=2, join_style=2)


def axes_of(*outlines):
    return find_axes(enumerate(outlines, start=1))


def ends(axes):
    return {
        tuple(np.round(end, 2) + 0.0) for axis in axes for end in (axis.line.coords[0], axis.line.coords[-1])
    }


def test_the_axis_of_a_wall_runs_from_end_to_end():
    (axis,) = axes_of(wall((0, 0), (5, 0)))
    assert ends([axis]) == {(0, 0), (5, 0)}
    assert len(axis.line.coords) == 2
    assert (axis.wall_id, axis.axis_id) == (1, 1)
    assert (axis.length, axis.thickness, axis.azimuth) == pytest.approx((5.0, 0.3, 90.0), abs=1e-3)
    assert axis.thick_sd < 1e-3
    assert axis.radius is None


def test_the_thickness_of_a_wall_seen_from_one_side_is_not_known():
    strip = wall((0, 0), (5, 0), (5, 4), thickness=0.01)
    axes = axes_of(strip)
    assert ends(axes) == {(0, 0), (5, 0), (5, 4)}
    assert {(axis.thickness, axis.thick_sd) for axis in axes} == {(None, None)}


def test_pieces_meet_in_a_corner_each_with_its_own_thickness():
    outline = unary_union([box(0, 0, 6, 0.6), box(0, 0, 0.2, 5)])
    axes = axes_of(outline)
    assert ends(axes) == {(0.1, 0.3), (6.0, 0.3), (0.1, 5.0)}
    assert sorted(axis.thickness for axis in axes) == pytest.approx([0.2, 0.6], abs=1e-3)
    assert sorted(axis.azimuth % 179.999 for axis in axes) == pytest.approx([0.0, 90.0], abs=0.1)


def test_three_axes_end_in_the_node_of_a_tee():
    axes = axes_of(unary_union([wall((0, 0), (8, 0), thickness=0.5), wall((3, 0), (3, 4), thickness=0.1)]))
    assert ends(axes) == {(0, 0), (3, 0), (8, 0), (3, 4)}
    assert sorted(axis.thickness for axis in axes) == pytest.approx([0.1, 0.5, 0.5], abs=1e-3)


def test_four_axes_end_in_the_node_of_a_crossing():
    axes = axes_of(unary_union([wall((0, 0), (8, 0)), wall((3, -4), (3, 4))]))
    assert ends(axes) == {(0, 0), (3, 0), (8, 0), (3, 4), (3, -4)}
    assert len(axes) == 4


def test_the_axes_of_a_house_close_around_it():
    axes = axes_of(unary_union([wall((0, 0), (6, 0), (6, 4), (0, 4), (0, 0)), box(-0.15, -0.15, 0.15, 0.15)]))
    assert ends(axes) == {(0, 0), (6, 0), (6, 4), (0, 4)}
    assert len(axes) == 4


def test_a_wall_that_changes_its_thickness_has_two_axes_and_a_step_between():
    axes = axes_of(unary_union([box(0, 0, 5, 0.3), box(5, 0, 9, 0.6)]))
    thin, thick = sorted(axes, key=lambda axis: axis.thickness)
    assert (thin.thickness, thick.thickness) == pytest.approx((0.3, 0.6), abs=1e-3)
    assert (thin.line.bounds[0], thick.line.bounds[2]) == pytest.approx((0, 9), abs=1e-3)
    shared = {tuple(end) for end in thin.line.coords} & {tuple(end) for end in thick.line.coords}
    assert len(shared) == 1
    assert np.linalg.norm(np.subtract(next(iter(shared)), (5, 0.225))) < 0.4


def test_a_round_wall_has_a_radius():
    ring = Point(0, 0).buffer(4.2, 64).difference(Point(0, 0).buffer(3.8, 64))
    (half,) = axes_of(ring.intersection(box(-5, 0, 5, 5)))
    assert (half.radius, half.thickness) == pytest.approx((4.0, 0.4), abs=0.01)
    assert half.length == pytest.approx(4 * np.pi, rel=0.01)
    assert half.azimuth is None
    (tower,) = axes_of(ring)
    assert tower.length == pytest.approx(8 * np.pi, rel=0.002)
    assert tower.line.is_closed


@pytest.mark.parametrize("column", [box(0, 0, 0.5, 0.5), Point(0, 0).buffer(0.4), box(0, 0, 0.4, 0.55)])
def test_a_column_has_no_axis(column):
    assert axes_of(column) == ()


@pytest.mark.parametrize("thickness", [2e-5, 4e-5, 2e-4])
def test_a_sliver_of_a_wall_has_an_axis_or_none(thickness):
    axes = axes_of(wall((0, 0), (3, 0), thickness=thickness))
    assert len(axes) <= 1
    assert all(axis.line.is_valid and axis.line.length > 0 for axis in axes)


def test_a_buttress_no_longer_than_wide_makes_no_spur():
    (axis,) = axes_of(unary_union([wall((0, 0), (8, 0)), box(3, 0, 3.4, 0.5)]))
    assert len(axis.line.coords) == 2


def test_rubble_faces_do_not_bend_the_axis():
    random = np.random.default_rng(0)
    along = np.arange(0, 8.01, 0.15)
    north = np.column_stack([along, 0.3 + random.normal(0, 0.02, len(along))])
    south = np.column_stack([along, -0.3 + random.normal(0, 0.02, len(along))])
    (axis,) = axes_of(Polygon([*south, *north[::-1]]))
    assert len(axis.line.coords) == 2
    assert np.abs(np.asarray(axis.line.coords)[:, 1]).max() < 0.02
    assert axis.thickness == pytest.approx(0.6, abs=0.02)
    assert 0.01 < axis.thick_sd < 0.05


@settings(max_examples=20, deadline=None)
@given(
    angle=st.integers(0, 359),
    east=st.floats(0, 1e6),
    north=st.floats(0, 6e6),
    stem_cm=st.integers(100, 700),
    thickness_cm=st.integers(10, 80),
)
def test_axes_turn_and_move_with_the_wall(angle, east, north, stem_cm, thickness_cm):
    stem, thickness = stem_cm / 100, thickness_cm / 100
    outline = unary_union([wall((0, 0), (8, 0), (8, 5)), wall((stem, 0), (stem, -4), thickness=thickness)])
    moved = translate(rotate(outline, angle, origin=(0, 0)), east, north)
    back = [
        np.asarray(rotate(translate(axis.line, -east, -north), -angle, origin=(0, 0)).coords)
        for axis in axes_of(moved)
    ]
    found = np.array([corner for corners in back for corner in (corners[0], corners[-1])])
    for corner in [(0, 0), (stem, 0), (8, 0), (8, 5), (stem, -4)]:
        assert np.linalg.norm(found - corner, axis=1).min() < 0.01
    assert len(back) == 4


def area_outside(axes, outline):
    """Return the area between the axes and their wall, of strips of 2 mm along the axes."""
    strips = unary_union([axis.line.buffer(0.001, cap_style=2) for axis in axes])
    return strips.difference(outline.buffer(0.003)).area


@settings(max_examples=20, deadline=None)
@given(start=st.floats(1, 2), width=st.floats(0.2, 1.0), depth=st.floats(0.1, 0.5))
@example(start=1.935, width=0.918, depth=0.1011)
def test_axes_never_leave_their_walls(start, width, depth):
    # One face was seen, with a pier before it: where the lines of the pieces meet is outside.
    outline = unary_union([box(0, 0, 4, 0.025), box(start, 0, start + width, depth)])
    axes = axes_of(outline)
    assert axes
    assert area_outside(axes, outline) == 0.0


def test_nearly_parallel_axes_meet_where_the_wall_bends():
    outline = wall((0, 0), (4, 0), (8, 0.3), thickness=0.3)
    for x, y in ends(axes_of(outline)):
        assert min(np.hypot(x - a, y - b) for a, b in [(0, 0), (4, 0), (8, 0.3)]) < 0.35
