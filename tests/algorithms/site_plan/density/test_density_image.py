"""The density image: weights, pixel edges, heights, extent."""

from types import SimpleNamespace

import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.site_plan.density.density_image import density_image

GRID_ORIGIN = np.array([412_300.0, 5_812_700.0, 0.0])


def cloud_of(points, origin=GRID_ORIGIN):
    xyz = np.asarray(points, float).reshape(-1, 3)
    source = SimpleNamespace(path=SimpleNamespace(name="scan.laz"))
    return SimpleNamespace(
        positions=lambda progress: iter([xyz]),
        expected_points=len(xyz),
        origin=origin,
        warnings=(),
        sources=(source,),
        crs=None,
    )


def value_at(image, band, x, y):
    transform = image.transform
    column, row = (x - transform.c) / transform.a, (y - transform.f) / transform.e
    return getattr(image, band)[int(row), int(column)]


def floor(width=4.0, depth=4.0, step=0.02, z=0.0):
    x, y = np.meshgrid(np.arange(0, width, step), np.arange(0, depth, step))
    return np.column_stack([x.ravel(), y.ravel(), np.full(x.size, z)])


def wall(x, length=4.0, low=0.0, high=2.5, step=0.02):
    y, z = np.meshgrid(np.arange(0, length, step), np.arange(low, high, step))
    return np.column_stack([np.full(y.size, x), y.ravel(), z.ravel()])


def test_a_point_on_a_pixel_centre_gives_all_its_weight_to_that_pixel():
    image = density_image(cloud_of([[0.05, 0.05, 0.0], [2.05, 0.05, 0.0]]))
    x, y = GRID_ORIGIN[:2]
    assert value_at(image, "density", x + 0.05, y + 0.05) == pytest.approx(1.0)
    assert np.nansum(image.density) == pytest.approx(2.0)


def test_a_point_beside_the_centre_spreads_by_inverse_distance_with_sum_one():
    image = density_image(cloud_of([[0.08, 0.05, 0.0], [2.05, 0.05, 0.0]]))
    x, y = GRID_ORIGIN[:2]
    own = value_at(image, "density", x + 0.05, y + 0.05)
    right = value_at(image, "density", x + 0.15, y + 0.05)
    left = value_at(image, "density", x - 0.05, y + 0.05)
    assert own / right == pytest.approx(0.07 / 0.03)
    assert own / left == pytest.approx(0.13 / 0.03)
    assert np.nansum(image.density) == pytest.approx(2.0)


def test_neighbourhood_0_is_the_plain_histogram():
    points = np.random.default_rng(0).uniform(0, 3, (500, 3)).round(3) + 0.0004
    image = density_image(cloud_of(points), spacing=0.001, neighbourhood=0)
    counts = np.histogram2d(points[:, 1], points[:, 0], bins=30, range=[[0, 3], [0, 3]])[0]
    rows, columns = image.density.shape
    assert np.nansum(image.density) == 500
    np.testing.assert_array_equal(np.nan_to_num(image.density)[1:-1, 1:-1], counts[::-1])
    assert (rows, columns) == (32, 32)


@pytest.mark.parametrize("origin", [np.zeros(3), GRID_ORIGIN, np.array([-300.0, 7_000_000.0, 0.0])])
def test_pixel_edges_are_multiples_of_the_pixel_size_at_any_origin(origin):
    image = density_image(cloud_of(floor(), origin), pixel_size=0.1)
    assert image.transform.a == 0.1
    assert image.transform.c * 10 == pytest.approx(round(image.transform.c * 10), abs=1e-6)
    assert image.transform.f * 10 == pytest.approx(round(image.transform.f * 10), abs=1e-6)


@pytest.mark.parametrize("origin", [np.zeros(3), GRID_ORIGIN, np.array([-300.0, 7_000_000.0, 0.0])])
def test_a_wall_lies_in_its_own_column_of_pixels_at_any_origin(origin):
    image = density_image(cloud_of(np.concatenate([floor(), wall(1.23)]), origin))
    full = np.nan_to_num(image.occupied).mean(axis=0) > 1
    column = int((origin[0] + 1.23 - image.transform.c) / 0.1)
    assert np.flatnonzero(full).tolist() == [column]


def test_the_occupied_height_counts_bins_between_the_window_above_ground():
    image = density_image(cloud_of(np.concatenate([floor(z=71.0), wall(2.05, high=1.3) + [0, 0, 71.0]])))
    x, y = GRID_ORIGIN[:2] + [2.05, 2.05]
    assert value_at(image, "occupied", x, y) == pytest.approx(1.0, abs=0.101)
    assert value_at(image, "ground", x, y) == pytest.approx(71.0, abs=0.02)
    assert value_at(image, "top", x, y) == pytest.approx(72.28, abs=0.01)


def test_a_beam_is_dense_but_occupies_no_height():
    beam = wall(2.05, low=2.5, high=3.0)
    image = density_image(cloud_of(np.concatenate([floor(), beam])))
    x, y = GRID_ORIGIN[:2] + [2.05, 2.05]
    assert value_at(image, "density", x, y) > 5
    assert value_at(image, "occupied", x, y) == 0


def test_heights_count_from_the_ground_of_a_slope():
    ground = floor(20.0, 4.0, 0.05)
    ground[:, 2] = 0.1 * ground[:, 0]
    foot = wall(15.05, high=1.0) + [0, 0, 1.505]
    image = density_image(cloud_of(np.concatenate([ground, foot])))
    x, y = GRID_ORIGIN[:2] + [15.05, 2.05]
    assert value_at(image, "occupied", x, y) == pytest.approx(0.7, abs=0.101)
    assert np.nanmax(image.occupied[:, :140]) == 0


def test_points_below_the_ground_do_not_pull_it_down():
    ghosts = np.random.default_rng(0).uniform([0, 0, -6], [8, 8, -1], (30, 3))
    image = density_image(cloud_of(np.concatenate([floor(8.0, 8.0), ghosts])))
    assert np.abs(image.ground).max() < 0.1


def test_reflections_far_away_do_not_enlarge_the_raster():
    far = [[900.0, 40.0, 2.0], [-700.0, 1e6, 3.0]]
    image = density_image(cloud_of(np.concatenate([floor(), far])))
    assert max(image.density.shape) < 60
    assert "2 of 40002 points lie far away" in image.warnings[0]


def test_a_raster_beyond_all_memory_is_refused_with_its_size():
    corners = np.concatenate([floor(step=0.2) + [x, 0, 0] for x in (0, 3e6)])
    with pytest.raises(InputError, match=r"PIXEL_SIZE"):
        density_image(cloud_of(corners))


def test_points_all_in_one_place_are_refused():
    with pytest.raises(InputError, match=r"scan\.laz.*same position"):
        density_image(cloud_of(np.ones((50, 3))))


def test_shuffled_points_give_the_same_image():
    points = np.concatenate([floor(), wall(2.0)]).round(3)
    shuffled = np.random.default_rng(1).permutation(points)
    one, other = density_image(cloud_of(points)), density_image(cloud_of(shuffled))
    for band in ("density", "occupied", "base", "top", "ground"):
        np.testing.assert_array_equal(getattr(one, band), getattr(other, band))


def test_points_scattered_over_a_country_are_refused():
    points = np.random.default_rng(0).uniform(0, 1e6, (3000, 3)) * [1, 1, 1e-4]
    with pytest.raises(InputError, match=r"scan\.laz: 2999 of 3000 points lie far from each other"):
        density_image(cloud_of(points))
