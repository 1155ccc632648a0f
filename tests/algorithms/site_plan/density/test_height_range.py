"""A storey is planned on its own, between two heights."""

from pathlib import Path

import laspy
import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.site_plan.density.density_image import density_image
from ichnograph.algorithms.site_plan.density.density_raster import DensityRaster
from ichnograph.algorithms.site_plan.density.height_range import HeightRange
from ichnograph.algorithms.site_plan.site_plan import extract_walls
from ichnograph.algorithms.site_plan.walls.extraction import WallParameters
from ichnograph.tests.algorithms.site_plan.surfaces import band_at, cloud_of, gate_of, level, upright

INDOOR = Path(__file__).parents[5] / "shared" / "data" / "indoor_two_storey_loadersgl" / "indoor.laz"

UPPER = 3.3
"""Height of the upper floor; the ceiling of the lower storey is 0.3 m below."""


def storeys():
    """Return two storeys, and the partition of each, which do not stand above each other."""
    parts = []
    for floor, ceiling in ((0.0, UPPER - 0.3), (UPPER, UPPER + 2.7)):
        corners = [(0, 0), (8, 0), (8, 5), (0, 5), (0, 0)]
        parts += [upright(a, b, floor, ceiling) for a, b in zip(corners[:-1], corners[1:])]
        parts += [level((0, 8), (0, 5), z) for z in (floor, ceiling)]
    lower = upright((3, 0), (3, 5), 0, UPPER - 0.3)
    upper = upright((5.5, 0), (5.5, 5), UPPER, UPPER + 2.7)
    # Asked are places off the outer walls.
    asked = (wall[np.abs(wall[:, 1] - 2.5) < 2] for wall in (lower, upper))
    return np.concatenate([*parts, lower, upper]), *asked


def tall_at(points, heights, *asked):
    """Return the share of each of the places asked for that may be wall within the heights."""
    image = density_image(cloud_of(points), heights=heights)
    tall = gate_of(image).tall
    return [band_at(image, tall, places).mean() for places in asked]


def test_each_storey_shows_its_own_walls():
    points, lower, upper = storeys()
    assert tall_at(points, HeightRange(high=UPPER - 0.1), lower, upper) == [1, 0]
    assert tall_at(points, HeightRange(low=UPPER - 0.1), lower, upper) == [0, 1]


def test_the_floor_of_a_storey_is_its_ground():
    points, *_ = storeys()
    image = density_image(cloud_of(points), heights=HeightRange(low=UPPER - 0.1))
    np.testing.assert_allclose(image.ground, UPPER, atol=0.05)


def test_a_storey_that_is_cut_above_its_floor_shows_its_walls_from_the_cut_up():
    points, lower, upper = storeys()
    assert tall_at(points, HeightRange(low=UPPER + 1), lower, upper) == [0, 1]


def on_slope(points):
    return points + 0.1 * points[:, :1] * [0, 0, 1]


def test_heights_above_the_ground_follow_a_slope():
    wall, beam = upright((4, 3), (26, 3), 0, 1.0), upright((4, 4.5), (26, 4.5), 1.6, 2.6)
    points = on_slope(np.concatenate([level((0, 30), (0, 6), 0.0, 0.05), wall, beam]))
    image = density_image(cloud_of(points), heights=HeightRange(0.2, 1.5, above_ground=True))
    assert np.isnan(band_at(image, "base", beam)).all()
    lowest = band_at(image, "base", wall) - band_at(image, "ground", wall)
    np.testing.assert_allclose(lowest, 0.0, atol=0.03)


def test_a_slice_far_above_the_ground_shows_the_walls_that_it_cuts():
    points, lower, upper = storeys()
    assert tall_at(points, HeightRange(2.4, 2.9, above_ground=True), lower, upper) == [1, 0]


@pytest.mark.parametrize("above_ground", [False, True])
def test_a_range_without_points_names_the_heights_that_there_are(above_ground):
    points = np.concatenate([level((0, 4), (0, 4), 0.0), upright((1, 1), (3, 1), 0, 2.0)]) + [0, 0, 70]
    reach = r"-?0\.0\d to 1\.9\d m above" if above_ground else r"70\.00 to 71\.9\d m\."
    with pytest.raises(InputError, match=rf"scan\.laz.*ZMIN 100 to ZMAX 110.*reach from {reach}"):
        density_image(cloud_of(points), heights=HeightRange(100.0, 110.0, above_ground))


def test_limits_in_the_wrong_order_are_refused():
    with pytest.raises(InputError, match="ZMIN 3 m is not below ZMAX 3 m"):
        HeightRange(3.0, 3.0)


@pytest.mark.skipif(not INDOOR.exists(), reason="the shared test data are not here")
def test_a_real_house_on_two_storeys_gives_a_plan_of_each():
    points = laspy.read(INDOOR)
    # Its heights are in the second column.
    cloud = cloud_of(np.column_stack([points.x, -np.asarray(points.z), points.y]))
    for heights, low, high in ((HeightRange(high=3.7), -2, 0), (HeightRange(low=3.9), 3.9, 6)):
        image = density_image(cloud, heights=heights)
        plan = extract_walls(DensityRaster.of(image), WallParameters())
        assert plan.length > 40
        assert all(low <= wall.z_base <= high for wall in plan.walls if wall.length > 3)


def test_the_points_of_the_whole_cloud_are_counted():
    points, *_ = storeys()
    assert density_image(cloud_of(points), heights=HeightRange(high=1.0)).points_in == len(points)
