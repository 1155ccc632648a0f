"""From a density raster to wall pixels, and to what became of all others."""

from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.errors import NothingFoundError
from ichnograph.algorithms.site_plan.density.density_raster import DensityRaster
from ichnograph.algorithms.site_plan.walls.extraction import Verdict, WallParameters, extract_wall_pixels
from ichnograph.algorithms.site_plan.walls.thresholds import Rule
from ichnograph.tests.algorithms.site_plan.rasters import GRID, field, sheets, wall_tower_and_beam


def extracted(raster, **parameters):
    return extract_wall_pixels(
        raster.density, raster.heights, raster.transform.a, WallParameters(**parameters)
    )


def test_walls_are_found_and_a_beam_is_not():
    raster, wall, tower, beam = wall_tower_and_beam()
    image = extracted(raster)
    assert not image.walls[beam].any()
    # Closing rounds single pixels off the steps of the tower.
    assert np.count_nonzero(image.walls != (wall | tower)) < 10


def test_without_the_gate_the_beam_passes_as_in_the_paper():
    raster, _wall, _tower, beam = wall_tower_and_beam()
    image = extracted(raster, min_height=0)
    assert image.walls[beam].all()
    assert image.gate.warnings == ()


def test_density_alone_gives_the_plain_chain_and_says_so():
    raster, _wall, _tower, beam = wall_tower_and_beam()
    image = extracted(replace(raster, heights=None))
    assert image.walls[beam].all()
    assert "MIN_HEIGHT is not applied" in image.gate.warnings[0]


def test_no_wall_is_an_error_that_says_which_criterion_removed_what():
    raster, *_ = wall_tower_and_beam()
    with pytest.raises(NothingFoundError, match=r"MIN_AREA 999 m² removed \d+.*MAX_FILL.*removed 0"):
        extracted(raster, min_area=999.0)
    with pytest.raises(NothingFoundError, match=r"MIN_HEIGHT 1.9 m left 0 of 60000 pixels"):
        extracted(raster, min_height=1.9)


def test_a_threshold_above_all_density_is_named():
    raster, *_ = wall_tower_and_beam()
    with pytest.raises(NothingFoundError, match="THRESHOLD 50"):
        extracted(raster, threshold=50.0)


def test_a_horizontal_slice_is_taken_without_the_gate():
    density = np.full((100, 100), np.nan)
    density[20:22, 10:90] = 4.0
    flat = np.full(density.shape, 1.2)
    heights = sheets(np.zeros(density.shape), flat, flat)
    image = extracted(DensityRaster(density, heights, GRID, None))
    assert image.walls[20:22, 10:90].all()
    assert "horizontal slice" in image.gate.warnings[0]


def test_a_large_field_with_a_small_building_is_no_slice():
    raster, wall = field(800, 40)
    image = extracted(raster)
    assert image.gate.warnings == ()
    np.testing.assert_array_equal(image.walls, wall)


def test_a_bare_floor_has_no_walls():
    raster, _wall = field(300, 0)
    with pytest.raises(NothingFoundError):
        extracted(raster)


def wall_scrap_and_block():
    """Return a raster of densities alone: a wall, a scrap of 2 pixels, a block of 12 x 12, a faint wall."""
    density = np.full((60, 100), 1.0)
    shapes = {
        Verdict.KEPT: (slice(10, 12), slice(10, 90), 60.0),
        Verdict.SMALL: (slice(20, 21), slice(10, 12), 60.0),
        Verdict.MISSHAPEN: (slice(30, 42), slice(10, 22), 60.0),
        Verdict.FAINT: (slice(50, 52), slice(10, 90), 20.0),
    }
    for rows, columns, dense in shapes.values():
        density[rows, columns] = dense
    return DensityRaster(density, None, GRID, None), shapes


def test_each_threshold_has_a_verdict_on_each_pixel_and_counts_the_regions():
    raster, shapes = wall_scrap_and_block()
    image = extracted(raster, threshold=1.0, threshold_max=4.0, threshold_steps=2)
    low, high = image.steps
    assert (low.threshold, high.threshold) == (1.0, 4.0)
    assert (low.regions, low.too_small, low.wrong_shape) == (4, 1, 1)
    assert (high.regions, high.too_small, high.wrong_shape) == (3, 1, 1)
    for verdict, (rows, columns, _) in shapes.items():
        assert (image.verdicts(high)[rows, columns] == verdict).all(), verdict.name
    rows, columns, _ = shapes[Verdict.FAINT]
    assert (image.verdicts(low)[rows, columns] == Verdict.KEPT).all()
    assert image.verdicts(low)[0, 0] == Verdict.FAINT


def test_what_a_criterion_removed_at_any_threshold_is_known():
    raster, shapes = wall_scrap_and_block()
    image = extracted(raster, threshold=1.0, threshold_max=4.0, threshold_steps=2)
    for verdict in (Verdict.SMALL, Verdict.MISSHAPEN):
        expected = np.zeros(raster.density.shape, bool)
        expected[shapes[verdict][:2]] = True
        np.testing.assert_array_equal(image.removed(verdict), expected)


def test_votes_count_the_thresholds_that_kept_a_pixel():
    raster, *_ = wall_scrap_and_block()
    image = extracted(raster, threshold=1.0, threshold_max=4.0, threshold_steps=5)
    kept = sum((image.verdicts(step) == Verdict.KEPT).astype(int) for step in image.steps)
    np.testing.assert_array_equal(image.votes, kept)


def test_the_rule_of_the_lowest_threshold_is_noted_unless_it_was_given():
    raster, *_ = wall_tower_and_beam()
    assert extracted(raster).thresholds.rule is Rule.SURFACES
    assert extracted(raster, threshold=1.0).thresholds.rule is None
