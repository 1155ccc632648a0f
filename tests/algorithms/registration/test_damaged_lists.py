"""Lists with one mistake, in every model and layout: the scanner is right, or refused, or warned of."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.settings import Matching, Model, Settings
from ichnograph.tests.algorithms.registration.hall import HALL, listed, register, scanned
from ichnograph.tests.algorithms.registration.matching.test_mirror_images import LAYOUTS, SIZE, laid_out

TILT = np.radians(1)


def moved(targets, shift):
    return np.concatenate([targets[:1] + shift, targets[1:]])


MISTAKES = {
    "none": lambda targets: targets,
    "millimetres": lambda targets: 1000 * targets,
    "feet": lambda targets: targets / 0.3048,
    "y up": lambda targets: targets[:, [0, 2, 1]] * [1, 1, -1],
    "left-handed": lambda targets: targets * [1, -1, 1],
    "one target 0.3 m beside": lambda targets: moved(targets, [0.3, 0, 0]),
    "one height 0.5 m too large": lambda targets: moved(targets, [0, 0, 0.5]),
    "one target twice": lambda targets: np.concatenate([targets[1:2], targets[1:]]),
    "tilted by 1 degree": lambda targets: (
        targets @ [[1, 0, 0], [0, np.cos(TILT), -np.sin(TILT)], [0, np.sin(TILT), np.cos(TILT)]]
    ),
    "rounded to 0.1 m": lambda targets: np.round(targets, 1),
}
NAMES = {
    "right": lambda names: names,
    "two exchanged": lambda names: [names[1], names[0], *names[2:]],
    "one row further": lambda names: [*names[1:], names[0]],
}


@settings(max_examples=150, deadline=None, derandomize=True)
@given(
    layout=st.sampled_from(LAYOUTS),
    mistake=st.sampled_from(list(MISTAKES)),
    naming=st.sampled_from(list(NAMES)),
    model=st.sampled_from(list(Model)),
    matching=st.sampled_from(list(Matching)),
    count=st.integers(3, 7),
    seed=st.integers(0, 2**16),
)
def test_no_mistake_puts_the_scanner_elsewhere_without_a_word(
    layout, mistake, naming, model, matching, count, seed
):
    random = np.random.default_rng(seed)
    control = np.concatenate([laid_out(layout, count, random), random.uniform(0, SIZE, (seed % 4, 3))])
    if len(control) < model.least_targets:
        return
    seen = control[: 2 if layout == "two points" else count]
    tilt = 0.0 if model.levelled else 20.0
    targets, true = scanned(seen, 360 * random.random(), tilt, noise=0.001, seed=seed)
    names = [f"P{row}" for row in range(len(control))]
    scans = [listed("scan", MISTAKES[mistake](targets), NAMES[naming](names[: len(seen)]))]
    found = register_scans(listed("control", control, names), scans, Settings(matching=matching, model=model))
    (scan,) = found.scans

    assert scan.registered or scan.reason
    if scan.registered and not (scan.warnings or found.warnings):
        assert np.linalg.norm((scan.matrix - true)[:3, 3]) < max(0.05, 10 * (scan.std or 0.0))


@pytest.mark.parametrize("model", Model)
def test_two_targets_in_one_place_end_no_search(model):
    targets = scanned(HALL)[0]
    scan = register(HALL, np.concatenate([targets[1:2], targets[1:]]), model=model)

    assert scan.registered or scan.reason
