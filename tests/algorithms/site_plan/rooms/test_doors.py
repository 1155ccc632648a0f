"""A room ends at a door on the faces of the wall."""

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.rooms.doors import trim
from ichnograph.algorithms.site_plan.rooms.settings import DoorSettings
from shapely.geometry import Polygon, box


def room(*passage):
    """Return a room of 4 x 3 m with a passage through its southern wall, given by its corners."""
    return Polygon([(0, 0), *passage, (4, 0), (4, 3), (0, 3)])


def gap(*ends):
    return np.array([ends])


def test_a_room_is_cut_at_the_face_of_the_wall():
    passage = (1, 0), (1, -0.15), (1.9, -0.15), (1.9, 0)
    trimmed = trim(room(*passage), gap((1.0, -0.15), (1.9, -0.15)))
    assert trimmed.symmetric_difference(box(0, 0, 4, 3)).area < 1e-6


def test_at_a_splay_the_room_ends_where_the_jambs_run_apart():
    passage = (0.8, 0), (1, -0.2), (1, -0.4), (1.9, -0.4), (1.9, -0.2), (2.1, 0)
    trimmed = trim(room(*passage), gap((1.0, -0.4), (1.9, -0.4)))
    assert trimmed.bounds[1] == pytest.approx(-0.2, abs=1e-6)


def test_a_room_without_doors_loses_only_the_samples_on_its_walls():
    sampled = Polygon([(0, 0), (1, 0), (2, 0), (4, 0), (4, 3), (0, 3)])
    trimmed = trim(sampled, np.empty((0, 2, 2)))
    assert len(trimmed.exterior.coords) == 5
    assert trimmed.equals(box(0, 0, 4, 3))


def test_a_passage_deeper_than_the_settings_allow_is_shortened_only_so_far():
    passage = (1, 0), (1, -2.0), (1.9, -2.0), (1.9, 0)
    deep = trim(room(*passage), gap((1.0, -2.0), (1.9, -2.0)))
    shallow = trim(room(*passage), gap((1.0, -2.0), (1.9, -2.0)), DoorSettings(deepest_m=0.5))
    assert deep.bounds[1] == pytest.approx(0.0, abs=1e-6)
    assert shallow.bounds[1] < -1
