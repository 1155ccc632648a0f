"""The decision about the best solution."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.matching.refusals import Refusal
from ichnograph.algorithms.registration.matching.scan_matching import match_scan
from ichnograph.algorithms.registration.matching.settings import MatchingSettings, SearchSettings
from ichnograph.algorithms.registration.settings import Matching, Model, Settings
from ichnograph.tests.algorithms.registration.hall import HALL, labels, listed, register, scanned
from ichnograph.tests.algorithms.registration.matching.matching_cases import network

COLUMNS = np.array([[6.0 * x, 6.0 * y, 1.5] for x in range(6) for y in range(5)])


@pytest.mark.parametrize("seed", range(40))
def test_a_nearly_regular_hall_is_never_labelled_wrong_even_if_sigma_is_too_small(seed):
    random = np.random.default_rng(seed)
    control = COLUMNS + random.normal(0, random.choice([0.0, 0.003, 0.01, 0.03]), COLUMNS.shape)
    seen = random.choice(len(control), random.integers(4, 10), replace=False)
    targets, _ = scanned(control[seen], heading=random.uniform(0, 360), noise=0.002, seed=seed)
    targets[0] += random.choice([0.0, 0.01, 0.1]) * np.array([0.6, 0.8, 0.0])
    scan = register(control, targets, sigma=0.001, model=Model([0, 2][seed % 2]))

    truth = {str(row + 1): f"P{number + 1}" for row, number in enumerate(seen)}
    assert not scan.registered or labels(scan).items() <= truth.items()


def matched(control, targets, explain=True, **chosen):
    return match_scan(listed("scan", targets), network(control), Settings(**chosen), explain)


def test_a_match_has_the_expected_number_of_accidents_and_by_names_none():
    targets = scanned(HALL)[0]
    by_distances = matched(HALL, targets)
    names = [f"P{row}" for row in range(1, 9)]
    by_names = match_scan(listed("scan", targets, names), network(HALL), Settings(matching=Matching.NAMES))

    assert by_distances.chance < 1e-8
    assert by_names.chance is None
    assert by_distances.solution.labels.tolist() == by_names.solution.labels.tolist() == list(range(8))


def test_the_reason_is_sought_only_if_asked_for():
    millimetres = 1000 * scanned(HALL)[0]

    assert matched(HALL, millimetres).status == "units"
    assert matched(HALL, millimetres, explain=False) == Refusal("no overlap", "")


def test_matched_targets_nearly_on_a_line_leave_the_rotation_uncertain():
    line = np.array([[0.0, 0, 0], [2.1, 0.03, 0], [5.2, 0, 0.02], [9.4, 0.02, 0], [11.9, 0, 0.03]])
    control = np.concatenate([line, HALL + [30, 0, 0]])
    found = matched(control, scanned(line)[0], sigma=0.003)

    assert found.status == "collinear"
    assert "degrees" in found.reason


def test_solutions_nearly_as_good_as_the_best_are_rivals():
    # A rectangle of targets; one control point of the other half is 1 mm off.
    square = np.array([[0.0, 0, 0], [6, 0, 0], [6, 6.001, 0], [0, 6, 0], [2.5, 3, 1.7], [3.5, 3, 1.7]])
    found = matched(square, scanned(square)[0])

    assert found.status == "ambiguous"
    assert len(found.rivals) == 2


def ended(**search):
    limits = MatchingSettings(search=SearchSettings(**search))
    return matched(HALL, scanned(HALL, scale=2.0)[0], model=Model.UNKNOWN_SCALE, matches=limits)


def test_a_search_that_is_ended_refuses_what_it_did_not_find_and_warns_of_what_it_may_have_missed():
    nothing, something = ended(most_placed=-1), ended(most_placed=50)

    assert nothing.status == "too many" and "was ended" in nothing.reason
    assert something.solution.matched == 8
    assert any("was ended" in warning for warning in something.warnings)
