"""The simulation: what it draws, what it counts, and what it advises the surveyor."""

from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.errors import CancelledError, InputError
from ichnograph.algorithms.progress import Progress
from ichnograph.algorithms.registration.settings import Matching, Model, Settings
from ichnograph.algorithms.registration.simulation.simulation import SUCCESS, simulate
from ichnograph.tests.algorithms.registration.simulation.simulated import FEW, box_at, points
from ichnograph.tests.scenes.targets import target_scene


def test_irregular_targets_are_all_recognised(found, building):
    assert found.success_rate == 1.0
    assert found.failures == {}
    assert found.confusions == ()
    for trial in found.trials:
        assert trial.outcome == SUCCESS
        assert len(set(trial.points)) == 5
        assert set(trial.points) <= set(building.names)


def test_errors_of_the_pose_are_of_the_size_of_the_noise(building):
    def largest_shift(sigma):
        done = simulate(building, Settings(sigma=sigma), 8, 0.0, trials=FEW)
        return max(trial.shift_error for trial in done.trials)

    assert 0.001 < largest_shift(0.003) < 0.02
    assert largest_shift(0.00003) < 0.0002


def test_sigma0_is_about_one_and_grows_with_a_scale_error_that_the_model_does_not_have(building):
    def mean_sigma0(ppm, model):
        done = simulate(building, Settings(model=model), 10, ppm, trials=FEW)
        return np.mean([trial.sigma0 for trial in done.trials])

    assert mean_sigma0(0, Model.RIGID) == pytest.approx(1.0, abs=0.2)
    assert mean_sigma0(150, Model.SIMILARITY) == pytest.approx(1.0, abs=0.2)
    assert mean_sigma0(150, Model.RIGID) > mean_sigma0(0, Model.RIGID)


@pytest.mark.parametrize("model", list(Model))
def test_every_model_is_simulated_with_scans_that_suit_it(building, model):
    control = replace(building, names=building.names[:20], xyz=building.xyz[:20])
    done = simulate(control, Settings(model=model), targets_per_scan=8, trials=3)

    assert done.success_rate == 1.0


def test_a_regular_layout_is_refused_and_its_points_are_named(box):
    assert box.success_rate == 0.0
    assert box.failures == {"ambiguous": 5}
    assert {name for pair in box.confusions for name in pair.points} == {f"P{row}" for row in range(8)}
    assert box.confusions[0].trials == 5
    assert all(np.isnan(trial.shift_error) and trial.wrong == 0 for trial in box.trials)


def test_pairs_of_points_stand_in_the_order_of_the_list_each_once(box):
    rows = [tuple(box.control.names.index(name) for name in pair.points) for pair in box.confusions]

    assert len(set(rows)) == len(rows)
    assert all(one < other for one, other in rows)


def test_a_seed_gives_the_same_trials_again_and_fewer_are_the_first_of_more(building, found):
    assert simulate(building, trials=FEW).trials == found.trials
    assert simulate(building, trials=3).trials == found.trials[:3]
    assert simulate(building, trials=3, seed=2).trials != found.trials[:3]


def test_names_play_no_part(building, found):
    by_names = simulate(building, Settings(matching=Matching.NAMES), trials=FEW)

    assert by_names.trials == found.trials


def test_within_reach_only_neighbours_are_seen_together(building):
    done = simulate(building, targets_per_scan=5, trials=FEW, reach=9.0)

    places = dict(zip(building.names, building.xyz))
    for trial in done.trials:
        seen = np.array([places[name] for name in trial.points])
        gaps = np.linalg.norm(building.xyz[:, None] - seen, axis=2)
        assert gaps.max(axis=1).min() <= 9.0


def test_points_that_no_scan_reaches_are_a_warning():
    xyz = np.concatenate([target_scene(12, 5, 5, seed=1).control.xyz, [[600_000, 5_700_000, 0]]])
    done = simulate(points(xyz), trials=2, reach=100)

    assert done.warnings == (
        "These control points are in no trial because too few others are within REACH: P12.",
    )


@pytest.mark.parametrize(
    ("targets", "reach", "model", "sentence"),
    [
        (
            9,
            None,
            Model.RIGID,
            "hall has 8 points, but TARGETS_PER_SCAN is 9; lower it, or survey more control",
        ),
        (2, None, Model.RIGID, "TARGETS_PER_SCAN is 2, but MODEL needs at least 3; raise it."),
        (1, None, Model.LEVELLED, "TARGETS_PER_SCAN is 1, but MODEL needs at least 2; raise it."),
        (
            5,
            0.5,
            Model.RIGID,
            "No control point of hall has 4 others within REACH, 0.5 m; raise it, or lower",
        ),
    ],
)
def test_what_cannot_be_simulated_is_refused(targets, reach, model, sentence):
    with pytest.raises(InputError, match=sentence.replace(".", r"\.")):
        simulate(points(box_at((0, 0, 0))), Settings(model=model), targets, reach=reach)


def test_it_stops_when_the_user_asks_for_it(building):
    asked = []

    with pytest.raises(CancelledError):
        simulate(building, progress=Progress(is_cancelled=lambda: asked.append(1) or len(asked) > 3))
    assert len(asked) == 4
