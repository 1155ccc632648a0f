"""From a density image to walls with their attributes."""

import numpy as np
import pytest
from affine import Affine
from ichnograph.algorithms.errors import NothingFoundError
from ichnograph.algorithms.site_plan.site_plan import extract_walls
from ichnograph.algorithms.site_plan.walls.extraction import WallParameters
from ichnograph.algorithms.site_plan.walls.height_gate import Heights

GRID = Affine(0.1, 0, 1000.0, 0, -0.1, 2000.0)


def scene():
    """Build a floor of 3 points per pixel, a straight wall, a beam as dense as the wall, a round tower."""
    density = np.random.default_rng(0).normal(3.0, 0.3, (200, 300))
    occupied = np.zeros(density.shape)
    top = np.full(density.shape, 70.0)
    y, x = np.mgrid[:200, :300]
    wall = (np.abs(y - 30) < 2) & (x > 20) & (x < 280)
    tower = np.abs(np.hypot(x - 150, y - 120) - 40) < 3
    beam = (np.abs(y - 60) < 2) & (x > 20) & (x < 280)
    density[wall | tower | beam] = 60.0
    occupied[wall | tower] = 1.5
    top[wall], top[tower], top[beam] = 72.5, 71.9, 74.0
    ground = np.full(density.shape, 70.0)
    return density, Heights(occupied, ground.copy(), top, ground), wall, tower, beam


def test_walls_are_found_and_a_beam_is_not():
    density, heights, wall, tower, beam = scene()
    image = extract_walls(density, heights, GRID, WallParameters()).image
    assert not image.walls[beam].any()
    # Closing rounds single pixels off the steps of the tower.
    assert np.count_nonzero(image.walls != (wall | tower)) < 10


def test_without_the_gate_the_beam_passes_as_in_the_paper():
    density, heights, _wall, _tower, beam = scene()
    image = extract_walls(density, heights, GRID, WallParameters(min_height=0)).image
    assert image.walls[beam].all()
    assert image.warnings == ()


def test_density_alone_gives_the_plain_chain_and_says_so():
    density, _heights, _wall, _tower, beam = scene()
    image = extract_walls(density, None, GRID, WallParameters()).image
    assert image.walls[beam].all()
    assert "MIN_HEIGHT is not applied" in image.warnings[0]


def test_each_wall_has_its_attributes():
    density, heights, wall, tower, _beam = scene()
    straight, round_tower = extract_walls(density, heights, GRID, WallParameters()).walls
    assert (straight.kind, round_tower.kind) == ("straight", "curved")
    assert straight.length == pytest.approx(25.9, abs=0.2)
    assert straight.azimuth == pytest.approx(90.0, abs=0.1)
    assert round_tower.azimuth is None
    assert round_tower.length == pytest.approx(2 * np.pi * 4.0, rel=0.02)
    assert (straight.z_base, straight.z_top, straight.height) == pytest.approx((70.0, 72.5, 2.5))
    assert round_tower.z_top == pytest.approx(71.9)
    assert straight.density == pytest.approx(60.0)
    assert straight.outline.area == pytest.approx(0.01 * wall.sum(), rel=1e-6)
    assert round_tower.outline.area == pytest.approx(0.01 * tower.sum(), rel=0.02)


def test_the_sums_of_a_plan_are_those_of_its_walls():
    density, heights, *_ = scene()
    plan = extract_walls(density, heights, GRID, WallParameters())
    assert plan.area == pytest.approx(sum(w.outline.area for w in plan.walls))
    assert plan.length == pytest.approx(sum(w.length for w in plan.walls))


@pytest.mark.parametrize("angle", [0, 20, 45, 70, 90, 110, 135, 160])
def test_the_azimuth_turns_clockwise_from_north(angle):
    y, x = np.mgrid[:200, :200]
    east, north = np.sin(np.radians(angle)), np.cos(np.radians(angle))
    along = (x - 100) * east - (y - 100) * north
    across = (x - 100) * north + (y - 100) * east
    density = np.where((np.abs(along) < 80) & (np.abs(across) < 2.2), 50.0, 2.0)
    (wall,) = extract_walls(density, None, GRID, WallParameters()).walls
    assert wall.azimuth == pytest.approx(angle, abs=0.5)
    assert wall.length == pytest.approx(16.0, rel=0.02)


def test_no_wall_is_an_error_that_says_which_criterion_removed_what():
    density, heights, *_ = scene()
    with pytest.raises(NothingFoundError, match=r"MIN_AREA 999 m2 removed \d+.*MAX_FILL.*removed 0"):
        extract_walls(density, heights, GRID, WallParameters(min_area=999.0))
    with pytest.raises(NothingFoundError, match=r"MIN_HEIGHT 1.9 m left 0 of 60000 pixels"):
        extract_walls(density, heights, GRID, WallParameters(min_height=1.9))


def test_a_horizontal_slice_is_taken_without_the_gate():
    density = np.full((100, 100), np.nan)
    density[20:22, 10:90] = 4.0
    flat = np.full(density.shape, 1.2)
    heights = Heights(np.zeros(density.shape), flat, flat, flat)
    image = extract_walls(density, heights, GRID, WallParameters()).image
    assert image.walls[20:22, 10:90].all()
    assert "horizontal slice" in image.warnings[0]


def field(width, building):
    """Return a flat field of pixels with a small building of `building` pixels square, or none."""
    density = np.random.default_rng(0).normal(3.0, 0.3, (width, width))
    ground = np.zeros(density.shape)
    occupied, top = ground.copy(), ground.copy()
    wall = np.zeros(density.shape, bool)
    wall[100 : 100 + building, 100 : 100 + building] = True
    wall[101 : 99 + building, 101 : 99 + building] = False
    density[wall], occupied[wall], top[wall] = 60.0, 2.0, 2.5
    nothing = np.zeros(density.shape), np.full(density.shape, np.nan)
    return density, Heights(occupied, ground.copy(), top, ground, *nothing), wall


def test_a_large_field_with_a_small_building_is_no_slice():
    density, heights, wall = field(800, 40)
    image = extract_walls(density, heights, GRID, WallParameters()).image
    assert image.warnings == ()
    np.testing.assert_array_equal(image.walls, wall)


def test_a_bare_floor_has_no_walls():
    density, heights, _wall = field(300, 0)
    with pytest.raises(NothingFoundError):
        extract_walls(density, heights, GRID, WallParameters())


def test_a_threshold_above_all_density_is_named():
    density, heights, *_ = scene()
    with pytest.raises(NothingFoundError, match="THRESHOLD 50"):
        extract_walls(density, heights, GRID, WallParameters(threshold=50.0))
