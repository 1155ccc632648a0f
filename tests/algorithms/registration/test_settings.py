"""The settings of a registration."""

import pytest
from ichnograph.algorithms.registration.settings import Matching, Model, Settings
from ichnograph.algorithms.settings import constants, with_constant


@pytest.mark.parametrize(
    ("model", "unknowns", "least_targets"),
    [
        (Model.RIGID, 6, 3),
        (Model.SIMILARITY, 7, 3),
        (Model.LEVELLED, 4, 2),
        (Model.LEVELLED_SCALE, 5, 2),
        (Model.UNKNOWN_SCALE, 7, 3),
    ],
)
def test_models_have_as_many_unknowns_as_the_paper_says(model, unknowns, least_targets):
    assert (model.unknowns, model.least_targets) == (unknowns, least_targets)


def test_the_tolerance_follows_from_the_standard_deviations():
    assert Settings(sigma=0.002).distance_tolerance == pytest.approx(3.5 * 2**0.5 * 0.002)
    assert Settings(sigma=0.003, control_sigma=0.004).distance_tolerance == pytest.approx(
        3.5 * 2**0.5 * 0.005
    )


def test_a_chosen_tolerance_is_kept_as_a_multiple_of_the_standard_deviation():
    settings = Settings(sigma=0.002, tolerance=0.02)

    assert settings.distance_tolerance == pytest.approx(0.02)
    assert settings.distance_factor == pytest.approx(0.02 / (2**0.5 * 0.002))


@pytest.mark.parametrize("matching", Matching)
@pytest.mark.parametrize("model", Model)
def test_the_scale_may_be_any_if_unknown_or_if_names_identify_the_points(matching, model):
    free = Settings(matching=matching, model=model).free_scale

    assert free == (model is Model.UNKNOWN_SCALE or (matching is Matching.NAMES and model.scaled))


def test_every_constant_of_a_stage_can_be_changed_from_outside():
    for constant in constants(Settings()):
        changed = with_constant(Settings(), constant.path, constant.value * 2)

        assert constant.reason.endswith(".")
        values = {item.path: item.value for item in constants(changed)}
        assert values[constant.path] == constant.value * 2
        assert sum(values[item.path] != item.value for item in constants(Settings())) == 1
