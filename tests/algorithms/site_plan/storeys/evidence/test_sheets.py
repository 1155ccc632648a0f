"""Straight upright surfaces found in points."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.storeys.evidence.levels import find_uprights, frame_around
from ichnograph.algorithms.site_plan.storeys.evidence.sheets import find_sheets
from ichnograph.algorithms.site_plan.storeys.evidence.voxels import make_voxels
from ichnograph.tests.algorithms.site_plan.storeys.scans import scanned, upright


def sheets_of(*surfaces, noise=0.002):
    voxels = make_voxels([scanned(*surfaces, noise=noise)])
    uprights = find_uprights(voxels, 0.0, frame_around(voxels, 0.02, 1.0))
    return find_sheets(uprights, voxels.noise_m, voxels.spacing_m)


def test_a_wall_is_one_sheet_on_its_face():
    (found,) = sheets_of(upright((1, 1), (5, 2)))
    assert found.length == pytest.approx(np.hypot(4, 1), abs=0.05)
    for end in (found.start, found.stop):
        away = end - (1, 1)
        assert abs(away[0] * 1 - away[1] * 4) / np.hypot(4, 1) < 0.002
    assert found.levels == pytest.approx(26, abs=1)


def test_a_narrow_gap_is_bridged_and_a_door_is_not():
    assert len(sheets_of(upright((0, 0), (2, 0)), upright((2.2, 0), (4, 0)))) == 1
    assert len(sheets_of(upright((0, 0), (2, 0)), upright((2.9, 0), (4, 0)))) == 2


def test_the_faces_of_a_thin_partition_stay_apart():
    found = sheets_of(upright((0, 0), (3, 0)), upright((0, 0.08), (3, 0.08)))
    assert sorted(round(one.start[1], 2) for one in found) == [0.0, 0.08]


def test_what_is_low_is_no_sheet():
    assert sheets_of(upright((0, 0), (3, 0), 0.0, 0.15)) == []


def test_a_corner_gives_two_sheets_square_to_each_other():
    first, second = sheets_of(upright((0, 0), (3, 0)), upright((3, 0), (3, 2)))
    assert abs(first.direction @ second.direction) < 0.005


def test_a_wall_beyond_a_gap_is_a_sheet_though_things_close_to_its_line_fill_the_gap():
    # Only the wider band in which pixels are taken reaches the casing.
    casing = upright((3.05, 0.021), (3.35, 0.021), 0.0, 0.2)
    found = sheets_of(upright((0, 0), (3, 0)), casing, upright((3.4, 0), (4.6, 0), 0.0, 2.0), noise=0.0005)
    assert sorted(round(one.length, 1) for one in found if one.levels > 5) == [1.2, 3.0]
