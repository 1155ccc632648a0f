"""Where a storey lies under a roof."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.storeys.evidence.footprint import Footprint
from ichnograph.algorithms.site_plan.storeys.evidence.levels import Frame
from ichnograph.algorithms.site_plan.storeys.evidence.roof import roofed
from ichnograph.tests.algorithms.site_plan.storeys.drawn import footprint_of
from shapely.geometry import box


def test_the_roof_reaches_as_far_as_the_ceiling():
    found = roofed(footprint_of((0, 0, 4, 3)))
    assert found.symmetric_difference(box(0, 0, 4, 3)).area < 0.01


def test_walls_between_rooms_lie_under_one_roof_and_yards_between_houses_under_none():
    walls = roofed(footprint_of((0, 0, 4, 3), (4.4, 0, 8, 3)))
    assert walls.geom_type == "Polygon"
    yard = roofed(footprint_of((0, 0, 4, 3), (6, 0, 8, 3)))
    assert len(yard.geoms) == 2


def test_a_lintel_or_a_canopy_is_no_roof():
    found = roofed(footprint_of((0, 0, 4, 3), (7, 0, 8, 1)))
    assert not found.intersects(box(6, -1, 9, 2))


def test_a_floor_in_the_open_has_no_roof():
    assert roofed(footprint_of((0, 0, 4, 3), ceiling=np.nan)).is_empty


@pytest.mark.parametrize("shape", [(103, 97), (3, 2)])
def test_a_frame_need_not_be_whole_cells(shape):
    ceiling = np.full(shape, 2.6, np.float32)
    found = roofed(Footprint(Frame(10.0, 20.0, 0.04, shape), ceiling, ceiling, ceiling))
    if shape[0] > 50:
        assert found.bounds == pytest.approx((10, 20, 14, 24.2))
    else:
        assert found.is_empty


def test_high_ground_over_no_floor_is_no_roof():
    terrace = footprint_of((5, 0, 9, 6), floor=np.nan)
    ground = footprint_of((0, 0, 4.6, 6), ceiling=np.nan)
    slope = Footprint(ground.frame, ground.weight, ground.floor, terrace.ceiling)
    assert roofed(slope).area < 6 * 0.5


def test_furniture_hides_the_floor_of_a_room_but_not_its_roof():
    room = footprint_of((0, 0, 4, 3))
    clear = footprint_of((0, 0, 4, 2.2))
    found = roofed(Footprint(room.frame, room.weight, clear.floor, room.ceiling))
    assert found.area > 0.75 * 12
