"""Beside each station of an outline there is a ridge where a face was seen."""

from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.faces.face_points import face_points
from ichnograph.algorithms.site_plan.faces.ridges import find_ridges, stations_along
from ichnograph.algorithms.site_plan.faces.settings import RidgeSettings
from ichnograph.tests.algorithms.site_plan.faces.voxels import PIXEL, WALL, pixel_ring, voxels_of
from shapely.geometry import box

STATIONS = stations_along(pixel_ring(WALL), PIXEL)


def test_stations_are_evenly_spaced_and_head_along_the_ring():
    assert len(STATIONS.xy) == pytest.approx(2 * (5.1 + 0.4) / 0.05, abs=1)
    south = STATIONS.xy[:, 1] < 2.0
    inner = south & (np.abs(STATIONS.xy[:, 0] - 4.5) < 2)
    np.testing.assert_allclose(STATIONS.tangent[inner], np.tile([1.0, 0.0], (inner.sum(), 1)), atol=1e-9)


def test_stations_are_no_closer_for_finer_pixels():
    assert len(stations_along(pixel_ring(WALL), 0.02).xy) == len(STATIONS.xy)
    finer = RidgeSettings(finest_m=0.02)
    assert len(stations_along(pixel_ring(WALL), 0.02, finer).xy) == pytest.approx(5 * len(STATIONS.xy), abs=5)


def test_the_ridge_lies_on_the_face_and_runs_along_it():
    ridges = find_ridges(STATIONS, voxels_of(WALL), PIXEL)
    assert ridges.found.mean() > 0.95
    inner = ridges.found & (np.abs(STATIONS.xy[:, 0] - 4.5) < 2)
    from_axis = np.abs(ridges.xy[inner, 1] - 2.15)
    assert np.median(np.abs(from_axis - 0.15)) < 0.002
    assert np.abs(ridges.direction[inner, 1]).max() < 0.1


def test_without_voxels_nearby_no_ridge_is_found():
    ridges = find_ridges(STATIONS, voxels_of(box(20, 20, 22, 20.3)), PIXEL)
    assert not ridges.found.any()


def test_sparse_points_of_a_slice_show_more_ridges_in_longer_windows():
    random = np.random.default_rng(0)
    slots = np.arange(2.0, 7.0, 0.06)
    along = np.concatenate([slots, slots]) + random.uniform(0, 0.06, 2 * len(slots))
    across = np.repeat([2.0, 2.3], len(slots)) + random.normal(0, 0.015, 2 * len(slots))
    one = np.ones(len(along), np.int64)
    voxels = face_points(np.column_stack([along, across]), one, one, flat=True)
    inner = np.abs(STATIONS.xy[:, 0] - 4.5) < 2

    ridges = find_ridges(STATIONS, voxels, PIXEL)
    short = find_ridges(STATIONS, voxels, PIXEL, RidgeSettings(longest_m=0.15))

    assert ridges.found[inner].mean() > 0.9 > 0.6 > short.found[inner].mean()
    np.testing.assert_array_equal(ridges.xy[short.found], short.xy[short.found])
    # Where heights were seen, so few points are foliage or the far end of a scan.
    np.testing.assert_array_equal(
        find_ridges(STATIONS, replace(voxels, flat=False), PIXEL).found, short.found
    )


def test_a_ridge_needs_voxels_on_several_levels_unless_the_cloud_is_flat():
    voxels = voxels_of(WALL)
    sill = replace(voxels, level=voxels.level % 2)
    assert not find_ridges(STATIONS, sill, PIXEL).found.any()
    flat = replace(sill, levels=2)
    assert find_ridges(STATIONS, flat, PIXEL).found.mean() > 0.95
