"""Where floor or ceiling was seen."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.storeys.evidence.footprint import find_footprint
from ichnograph.algorithms.site_plan.storeys.evidence.voxels import Voxels
from ichnograph.tests.algorithms.site_plan.storeys.drawn import COARSE, STOREY, Face, uprights_of
from ichnograph.tests.algorithms.site_plan.storeys.scans import flat

UP = np.array([0, 0, 1], np.float32)


def footprint_of(*surfaces, faces=(), spacing=0.025, normal=UP):
    xyz = np.concatenate(surfaces)
    voxels = Voxels(xyz, np.tile(normal, (len(xyz), 1)), 0.02, spacing, 0.002)
    return find_footprint(voxels, STOREY, uprights_of(*faces), [face.sheet for face in faces], COARSE)


def weight_at(footprint, x, y):
    row, column = COARSE.places(np.array([[x, y]]))
    return footprint.weight[row[0], column[0]]


def test_ceiling_weighs_more_than_floor_and_nothing_nothing():
    found = footprint_of(flat(0, 0, 2, 2, 0.0), flat(2, 0, 4, 2, 2.6))
    assert weight_at(found, 1, 1) == pytest.approx(0.8)
    assert weight_at(found, 3, 1) == 1
    assert weight_at(found, 6, 1) == 0


def test_a_beam_below_the_ceiling_is_uncertain_and_a_wide_step_is_ceiling():
    beam = footprint_of(flat(0, 0, 2, 4, 2.6), flat(2, 0, 2.3, 4, 2.2), flat(2.3, 0, 4, 4, 2.6))
    assert weight_at(beam, 2.15, 2) == pytest.approx(0.3)
    step = footprint_of(flat(0, 0, 2, 4, 2.6), flat(2, 0, 5, 4, 2.2))
    assert weight_at(step, 4, 2) == 1


def test_tables_stand_in_rooms_and_the_tops_of_cupboards_say_nothing():
    found = footprint_of(flat(0, 0, 1, 1, 0.75), flat(2, 0, 3, 1, 1.7))
    assert weight_at(found, 0.5, 0.5) == pytest.approx(0.8)
    assert weight_at(found, 2.5, 0.5) == 0


def test_the_steps_of_a_stair_are_floor_as_high_as_they_lead():
    steps = [flat(0.28 * k, 0, 0.28 * (k + 1), 1, 0.18 * k) for k in range(11)]
    found = footprint_of(*steps)
    assert weight_at(found, 2.4, 0.5) == pytest.approx(0.8)
    row, column = COARSE.places(np.array([[2.4, 0.5]]))
    assert found.floor[row, column] == pytest.approx([1.44])


def test_the_heights_of_floor_and_ceiling_are_kept():
    found = footprint_of(flat(0, 0, 2, 2, 0.02), flat(0, 0, 2, 2, 0.9), flat(0, 0, 2, 2, 2.6))
    row, column = COARSE.places(np.array([[1.0, 1.0]]))
    assert found.floor[row, column] == pytest.approx([0.02])
    assert found.ceiling[row, column] == pytest.approx([2.6])


def test_the_pixels_of_a_wall_are_neutral_and_those_of_a_skirting_are_not():
    floor = flat(0, 0, 4, 4, 0.0)
    wall = footprint_of(floor, faces=[Face((2, 0), (2, 4))])
    assert np.isnan(weight_at(wall, 2.001, 2))
    skirting = footprint_of(floor, faces=[Face((2, 0), (2, 4), 0, 2)])
    assert weight_at(skirting, 2.001, 2) == pytest.approx(0.8)


def test_gaps_between_sparse_points_are_closed_and_not_those_as_wide_as_a_wall():
    found = footprint_of(flat(0, 0, 2, 2, 0.0, 0.1), flat(2.5, 0, 4, 2, 0.0, 0.1), spacing=0.1)
    inner = np.s_[COARSE.places(np.array([[0.2, 0.2]]))[0][0] : COARSE.places(np.array([[0, 1.8]]))[0][0]]
    assert (found.weight[inner, inner] > 0).all()
    assert weight_at(found, 2.25, 1) == 0


def test_floor_that_is_sparse_far_from_the_scanner_is_closed_beside_a_dense_one():
    found = footprint_of(flat(0, 0, 2, 2, 0.0, 0.02), flat(2.1, 0, 4, 2, 0.0, 0.12))
    assert weight_at(found, 3.06, 0.96) == pytest.approx(0.8)


def test_single_points_in_a_wall_do_not_widen_the_gaps_that_are_closed():
    floor = [flat(0, 0, 2, 2, 0.0, 0.02), flat(2.2, 0, 4, 2, 0.0, 0.02)]
    found = footprint_of(*floor, np.array([[2.1, 1.0, 0.0], [2.1, 1.4, 0.0]]))
    assert weight_at(found, 2.1, 1.2) == 0


def test_a_gap_along_a_sheet_is_not_closed():
    parts = [flat(0, 0, 1.97, 2, 0.0), flat(2.03, 0, 4, 2, 0.0)]
    assert weight_at(footprint_of(*parts, spacing=0.08), 2.0, 1) > 0
    # It continues beyond the end of a sheet, where the wall may be hidden.
    for stop in (2.0, 0.7):
        parted = footprint_of(*parts, faces=[Face((2, 0), (2, stop), 0, 4)], spacing=0.08)
        assert not weight_at(parted, 2.0, 1) > 0


def test_points_without_a_normal_count_only_on_floor_and_ceiling():
    found = footprint_of(flat(0, 0, 1, 1, 0.05), flat(2, 0, 3, 1, 1.0), normal=np.zeros(3, np.float32))
    assert weight_at(found, 0.5, 0.5) == pytest.approx(0.8)
    assert weight_at(found, 2.5, 0.5) == 0
