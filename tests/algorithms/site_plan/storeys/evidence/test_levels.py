"""Floor, ceiling and upright surfaces of a storey."""

import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.site_plan.storeys.evidence.levels import (
    Frame,
    Storey,
    count_levels,
    find_storey,
    find_uprights,
    frame_around,
    with_measured_ceiling,
)
from ichnograph.algorithms.site_plan.storeys.evidence.voxels import Voxels
from ichnograph.tests.algorithms.site_plan.storeys.scans import flat, upright

UP, EAST = (0, 0, 1), (1, 0, 0)
WALL = upright((0, 0), (2, 0)), EAST


def voxels_of(*surfaces):
    """Return voxels of surfaces, each with its normal."""
    xyz = np.concatenate([points for points, _ in surfaces])
    normal = np.concatenate([np.tile(np.float32(way), (len(points), 1)) for points, way in surfaces])
    return Voxels(xyz, normal, 0.02, 0.025, 0.002)


def test_the_floor_is_the_lowest_large_layer_and_the_ceiling_the_next():
    levels = [(flat(0, 0, 2, 2, z), UP) for z in (3.12, 5.72, 5.9)]
    storey = find_storey(voxels_of(*levels))
    assert storey.floor == pytest.approx(3.12, abs=1e-6)
    # The ceiling is known to two of the layers that it is looked for in.
    assert storey.ceiling == pytest.approx(5.72, abs=0.1)


def test_the_ceiling_is_measured_in_its_layers():
    voxels = voxels_of(*((flat(0, 0, 2, 2, z), UP) for z in (3.12, 5.72, 5.9)))
    storey = with_measured_ceiling(find_storey(voxels), voxels)
    assert storey.ceiling == pytest.approx(5.72, abs=1e-6)
    assert with_measured_ceiling(Storey(3.12, None), voxels).ceiling is None


def test_a_small_pit_and_a_table_are_not_the_floor():
    floor, pit, table = flat(0, 0, 3, 3, 0.01), flat(0, 0, 0.5, 0.5, -0.6), flat(1, 1, 2, 2, 0.75)
    storey = find_storey(voxels_of((floor, UP), (pit, UP), (table, UP), WALL))
    assert storey.floor == pytest.approx(0.01, abs=1e-6)


def test_what_is_too_low_to_stand_under_is_no_ceiling():
    storey = find_storey(voxels_of((flat(0, 0, 2, 2, 0.0), UP), (flat(0, 0, 2, 2, 1.5), UP), WALL))
    assert storey.ceiling is None


def test_a_slice_that_nobody_could_stand_in_is_no_storey():
    assert find_storey(voxels_of((flat(0, 0, 2, 2, 0.0), UP), (flat(0, 0, 2, 2, 1.5), UP))) is None


def test_where_nothing_is_flat_there_is_no_storey():
    assert find_storey(voxels_of((upright((0, 0), (2, 0)), EAST))) is None
    assert find_storey(voxels_of((np.zeros((0, 3)), UP))) is None


def test_a_pixel_notes_the_levels_that_surface_fills():
    frame = Frame(0.0, 0.0, 0.02, (100, 100))
    points = np.array([[1.01, 1.01, z] for z in (0.05, 0.15, 1.25)])
    found = find_uprights(voxels_of((points, EAST)), 0.0, frame)
    assert found.levels.tolist() == [0b11 | 1 << 12]
    assert (found.row.tolist(), found.column.tolist()) == ([50], [50])


def test_heights_count_from_the_floor_and_those_out_of_reach_do_not():
    frame = Frame(0.0, 0.0, 0.02, (100, 100))
    points = np.array([[1.01, 1.01, z] for z in (9.95, 10.05, 16.35, 16.45)])
    found = find_uprights(voxels_of((points, EAST)), 10.0, frame)
    assert found.levels.tolist() == [1 | 1 << 63]


def test_floors_and_what_has_no_normal_are_not_upright():
    frame = Frame(0.0, 0.0, 0.02, (100, 100))
    points = np.array([[1.0, 1.0, 1.0]])
    for way in (UP, (0, 0, 0), (0.6, 0, 0.8)):
        assert len(find_uprights(voxels_of((points, way)), 0.0, frame).xy) == 0


def test_both_signs_of_a_normal_are_one_direction():
    frame = Frame(0.0, 0.0, 0.02, (100, 100))
    one, other = np.array([[1.01, 1.01, 0.05]]), np.array([[1.01, 1.01, 0.15]])
    found = find_uprights(voxels_of((one, (0.6, 0.8, 0)), (other, (-0.6, -0.8, 0))), 0.0, frame)
    assert found.angle == pytest.approx([np.arctan2(0.8, 0.6)], abs=1e-6)


def test_levels_are_counted():
    assert count_levels(np.array([0, 1, 0b1011, 2**64 - 1], np.uint64)).tolist() == [0, 1, 3, 64]


def test_the_frame_holds_all_voxels_and_a_margin():
    frame = frame_around(voxels_of((flat(-3, 2, 4, 5, 0.0), UP)), 0.04, 1.0)
    row, column = frame.places(np.array([[-4.0, 1.0], [4.95, 5.95]]))
    assert (row >= 0).all() and (column >= 0).all()
    assert (row < frame.shape[0]).all() and (column < frame.shape[1]).all()


def test_the_centre_of_a_pixel_lies_in_it():
    frame = Frame(-1.3, 2.6, 0.04, (50, 70))
    row, column = np.array([0, 49, 7]), np.array([0, 69, 33])
    found = frame.places(frame.centres(row, column))
    assert (found[0].tolist(), found[1].tolist()) == (row.tolist(), column.tolist())


def test_a_cloud_too_large_for_a_plan_of_rooms_is_an_error():
    corners = np.array([[0.0, 0.0, 0.0], [900.0, 900.0, 0.0]])
    with pytest.raises(InputError, match="902 x 902 m, too large"):
        frame_around(voxels_of((corners, UP)), 0.02, 1.0)
