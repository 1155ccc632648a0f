"""The simulation: what it draws, what it counts, and what it tells the surveyor."""

import csv
from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.errors import CancelledError, InputError
from ichnograph.algorithms.progress import Progress
from ichnograph.algorithms.registration.lists.point_list import PointList
from ichnograph.algorithms.registration.settings import Matching, Model, Settings
from ichnograph.algorithms.registration.simulation.simulation import SUCCESS, simulate
from ichnograph.algorithms.registration.simulation.simulation_report import write_simulation_report
from ichnograph.algorithms.registration.simulation.trials import write_trials
from ichnograph.tests.scenes.targets import target_scene

FEW = 12


def points(xyz, **more):
    return PointList("hall", tuple(f"P{row}" for row in range(len(xyz))), np.array(xyz, float), **more)


def box_at(corner):
    """Return the corners of a box, which can be laid on itself in four ways."""
    corners = [(x, y, z) for x in (0, 4) for y in (0, 6) for z in (0, 3)]
    return np.array(corners) + corner


@pytest.fixture(scope="module")
def building():
    return target_scene(40, 5, 5, seed=3).control


@pytest.fixture(scope="module")
def found(building):
    return simulate(building, trials=FEW)


@pytest.fixture(scope="module")
def box():
    return simulate(points(box_at((500_000, 5_700_000, 100))), targets_per_scan=8, trials=5)


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


def test_points_that_no_scan_reaches_are_told():
    xyz = np.concatenate([target_scene(12, 5, 5, seed=1).control.xyz, [[600_000, 5_700_000, 0]]])
    done = simulate(points(xyz), trials=2, reach=100)

    assert done.warnings == (
        "These control points are in no trial, for too few others are within REACH: P12.",
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


def test_the_table_has_a_row_for_each_trial(found, box, tmp_path):
    write_trials(found, tmp_path / "found.csv")
    write_trials(box, tmp_path / "box.csv")

    with (tmp_path / "found.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["trial"] for row in rows] == [str(number) for number in range(1, FEW + 1)]
    assert [tuple(row["points"].split(";")) for row in rows] == [trial.points for trial in found.trials]
    assert {(row["outcome"], row["success"], row["wrong"]) for row in rows} == {(SUCCESS, "1", "0")}
    assert float(rows[0]["shift_error"]) == pytest.approx(found.trials[0].shift_error, abs=1e-6)
    with (tmp_path / "box.csv").open(encoding="utf-8", newline="") as file:
        refused = next(csv.DictReader(file))
    assert (refused["outcome"], refused["success"], refused["sigma0"]) == ("ambiguous", "0", "")


def test_the_report_names_failures_and_ambiguous_points(box, tmp_path):
    write_simulation_report(box, tmp_path / "box.html")

    page = (tmp_path / "box.html").read_text(encoding="utf-8")
    for words in (
        "In 0 of 5 trials (0.0%) all 8 targets",
        "ambiguous",
        "Points confused with each other",
        "P7",
    ):
        assert words in page
    assert "Errors of the transformations" not in page


def test_the_report_of_a_good_layout_has_errors_and_no_failures(found, tmp_path):
    write_simulation_report(found, tmp_path / "found.html")

    page = (tmp_path / "found.html").read_text(encoding="utf-8")
    assert "(100.0%)" in page
    assert "No control points were confused with each other." in page
    assert "Errors of the transformations" in page
    assert "Failures" not in page
    assert "nan" not in page
