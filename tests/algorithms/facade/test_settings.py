"""The constants of the chapter: each has a reason, and a path that leads to it."""

from ichnograph.algorithms.facade.settings import FacadeSettings
from ichnograph.algorithms.settings import constants, with_constant


def test_every_constant_has_a_reason_in_a_sentence():
    found = list(constants(FacadeSettings()))

    assert len(found) > 70
    for constant in found:
        assert len(constant.reason) > 10 and constant.reason.endswith("."), constant.path


def test_paths_lead_to_the_constants_of_the_stages():
    changed = with_constant(FacadeSettings(), ("openings", "content", "filled"), 0.7)

    assert changed.openings.content.filled == 0.7
    assert FacadeSettings().openings.content.filled == 0.5


def test_the_smallest_detail_is_a_square_of_the_seed_radius_unless_given():
    assert FacadeSettings(seed_radius_m=0.3).smallest_m2 == 0.09
    assert FacadeSettings(seed_radius_m=0.3, min_area_m2=1.0).smallest_m2 == 1.0
