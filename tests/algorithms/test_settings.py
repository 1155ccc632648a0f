"""Settings: constants with reasons, in frozen dataclasses that hold one another."""

from dataclasses import FrozenInstanceError, dataclass

import pytest
from ichnograph.algorithms.settings import Constant, constants, judged, physical, statistical, with_constant


@dataclass(frozen=True)
class Faces:
    width_m: float = physical(0.05, "Half of a thin wall.")
    rounds: int = judged(12, "No face moves after that.")


@dataclass(frozen=True)
class Plan:
    faces: Faces = Faces()
    significance: float = statistical(0.001, "Baarda's.")
    name: str = "no constant"


def test_constants_come_with_their_path_value_kind_and_reason():
    assert list(constants(Plan())) == [
        Constant(("faces", "width_m"), 0.05, "physical", "Half of a thin wall."),
        Constant(("faces", "rounds"), 12, "judged", "No face moves after that."),
        Constant(("significance",), 0.001, "statistical", "Baarda's."),
    ]


def test_a_constant_is_replaced_wherever_it_stands():
    changed = with_constant(Plan(), ("faces", "width_m"), 0.07)
    assert changed.faces == Faces(width_m=0.07)
    assert changed.significance == 0.001
    assert with_constant(Plan(), ("significance",), 0.01).significance == 0.01


def test_settings_cannot_be_altered():
    with pytest.raises(FrozenInstanceError):
        Plan().significance = 1
