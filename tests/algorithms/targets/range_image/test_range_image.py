"""The range image of a station."""

import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.targets.range_image.range_image import image_of, jump_share
from ichnograph.algorithms.targets.range_image.station import Station

STEP = 0.005


def panorama(start=-np.pi, stop=np.pi, distance=5.0):
    """Return the points of a cylinder around the scanner."""
    azimuth, elevation = np.meshgrid(np.arange(start, stop, STEP), np.arange(-0.3, 0.3, STEP))
    azimuth, elevation = azimuth.ravel(), elevation.ravel()
    level = np.column_stack([np.cos(azimuth), np.sin(azimuth), np.tan(elevation)])
    return (distance * level).astype(np.float32)


def made(xyz):
    intensity = np.arange(len(xyz)).astype(np.uint16)
    return image_of(Station(np.zeros(3), xyz, intensity), "hall")


def test_a_full_circle_has_all_columns():
    image = made(panorama())

    assert image.ranges.shape[1] == image.period
    assert np.mean(image.ranges > 0) > 0.9


def test_a_part_of_a_circle_across_180_degrees_is_one_piece():
    image = made(panorama(np.pi - 0.4, np.pi + 0.4))

    assert image.ranges.shape[1] == pytest.approx(0.8 / STEP, rel=0.05)
    assert np.mean(image.ranges > 0) > 0.9


def test_a_pixel_and_its_direction_belong_together():
    image = made(panorama())
    for row, column in ((3, 10), (50, 700), (100, 1200)):
        assert image.pixel(7.0 * image.direction(row, column)) == pytest.approx((row, column))


@pytest.mark.parametrize("azimuth", [-np.pi, 0.0, 1.0])
def test_the_points_around_a_direction_are_those_in_the_cone(azimuth):
    xyz = panorama()
    image = made(xyz)
    centre = np.array([5.0 * np.cos(azimuth), 5.0 * np.sin(azimuth), 0.5])
    rays = xyz / np.linalg.norm(xyz, axis=1)[:, None]
    distance = np.linalg.norm(centre)
    inside = np.count_nonzero(rays @ (centre / distance) > np.sqrt(1 - (0.2 / distance) ** 2))

    assert len(image.around(centre, 0.2)) == inside


def test_every_point_keeps_its_intensity():
    xyz = panorama(0.0, 0.5)
    image = made(xyz)

    np.testing.assert_array_equal(xyz[image.intensity], image.xyz)


def test_the_order_of_the_points_does_not_change_what_is_around():
    xyz = panorama(0.0, 0.5)
    mixed = xyz[np.random.default_rng(1).permutation(len(xyz))]
    centre = np.array([5.0, 1.0, 0.2])
    found = [image.xyz[image.around(centre, 0.1)] for image in (made(xyz), made(mixed))]

    np.testing.assert_array_equal(np.unique(found[0], axis=0), np.unique(found[1], axis=0))


def test_a_cloud_of_several_stations_is_refused_with_the_remedy():
    rng = np.random.default_rng(1)
    xyz = panorama() * rng.choice([0.5, 1.0, 2.0], (len(panorama()), 1))

    with pytest.raises(InputError, match=r"hall is not the scan of one station.*STATION"):
        made(xyz.astype(np.float32))


def test_a_handful_of_points_is_refused():
    with pytest.raises(InputError, match="hall has too few points"):
        made(panorama()[:5])


def test_jumps_are_counted_between_neighbours_with_points():
    ranges = np.array([[1.0, 1.0, 2.0, 0.0, 2.0]])

    assert jump_share(ranges, 0.1) == 0.5
