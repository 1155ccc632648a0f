"""Mirrored lists: x and y swapped, or an axis reversed, in every model, by distances and by names."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.registration.matching.matching_task import matching_task
from ichnograph.algorithms.registration.matching.mirror_images import mirror_images
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.settings import Matching, Model, Settings
from ichnograph.tests.algorithms.registration.hall import HALL, listed, register, scanned
from ichnograph.tests.algorithms.registration.matching.matching_cases import network

SIZE = np.array([12.0, 10.0, 4.0])
MIRRORS = {
    "right": np.eye(3),
    "x and y swapped": np.array([[0.0, 1, 0], [1, 0, 0], [0, 0, 1]]),
    "x reversed": np.diag([-1.0, 1, 1]),
    "z reversed": np.diag([1.0, 1, -1]),
}
LAYOUTS = (
    *("line", "vertical plane", "nearly vertical plane", "horizontal plane", "nearly horizontal plane"),
    *("oblique plane", "corners of a cube", "two points", "anywhere"),
)


def laid_out(layout, count, random):
    """Return up to `count` places of a layout; "nearly" is within 50 mm."""
    places = random.uniform(0, SIZE, (count, 3))
    if layout == "line":
        return np.linspace([0, 0, 1], [9, 5, 2], 40)[np.sort(random.choice(40, count, replace=False))]
    if layout == "corners of a cube":
        corners = np.array([[x, y, z] for x in (0, 4) for y in (0, 4) for z in (0, 4)], float)
        return corners[random.choice(8, count, replace=False)]
    if "vertical" in layout:
        places[:, :2] = random.uniform(0, 12, (count, 1)) * random.normal(size=2)
    if "horizontal" in layout:
        places[:, 2] = 1.5
    if layout == "oblique plane":
        places[:, 2] = 0.4 * places[:, 0] + 0.3 * places[:, 1]
    if "nearly" in layout:
        places += random.uniform(-0.05, 0.05, places.shape)
    return places[:2] if layout == "two points" else places


@settings(max_examples=150, deadline=None, derandomize=True)
@given(
    layout=st.sampled_from(LAYOUTS),
    mirror=st.sampled_from(list(MIRRORS)),
    model=st.sampled_from(list(Model)),
    matching=st.sampled_from(list(Matching)),
    count=st.integers(3, 7),
    seed=st.integers(0, 2**16),
)
def test_no_layout_puts_the_scanner_elsewhere_without_a_word(layout, mirror, model, matching, count, seed):
    random = np.random.default_rng(seed)
    control = np.concatenate([laid_out(layout, count, random), random.uniform(0, SIZE, (seed % 3, 3))])
    fresh = random.uniform(0, SIZE, (seed % 2, 3))
    seen = control[: 2 if layout == "two points" else count]
    if len(control) < model.least_targets:
        return
    tilt = 0.0 if model.levelled else 20.0
    targets, true = scanned(
        np.concatenate([seen, fresh]), 360 * random.random(), tilt, noise=0.001, seed=seed
    )
    names = [f"P{row}" for row in range(len(control))]
    targets = listed("scan", targets @ MIRRORS[mirror], [*names[: len(seen)], "new"][: len(targets)])
    chosen = Settings(matching=matching, model=model)
    (scan,) = register_scans(listed("control", control, names), [targets], chosen).scans

    asked = any("mirrored" in warning for warning in scan.warnings)
    assert not scan.registered or asked or np.linalg.norm((scan.matrix - true)[:3, 3]) < 0.3
    assert scan.registered or scan.reason
    assert mirror != "right" or scan.status != "mirrored", "a right list is never called mirrored"


@pytest.mark.parametrize("matching", Matching)
@pytest.mark.parametrize("model", [Model.LEVELLED, Model.LEVELLED_SCALE, Model.UNKNOWN_SCALE])
def test_swapped_axes_of_targets_on_a_facade_are_asked_for(model, matching):
    names = ["A", "B", "C"]
    control = listed("control", [[5000.0, 1000, 201], [5000, 1008, 206.5], [5000, 1015, 202]], names)
    targets = [[-10.0, 15, -0.6], [-2, 15, 4.9], [5, 15, 0.4]]
    scan = register_scans(
        control, [listed("scan", targets, names)], Settings(model=model, matching=matching)
    ).scans[0]

    assert not scan.registered or any("mirrored list would fit as well" in item for item in scan.warnings)


def test_two_levelled_targets_always_fit_their_mirror_image():
    names = ["P1", "P2"]
    scan = register_scans(
        listed("control", HALL[:2], names),
        [listed("scan", scanned(HALL[:2])[0], names)],
        Settings(model=Model.LEVELLED, matching=Matching.NAMES),
    ).scans[0]

    assert any("mirrored list would fit as well" in item for item in scan.warnings)


@pytest.mark.parametrize("model", Model)
def test_targets_in_space_raise_no_question(model):
    scan = register(HALL, scanned(HALL, noise=0.001)[0], model=model)

    assert scan.registered and not scan.warnings


def test_a_mirrored_list_of_unknown_scale_is_called_mirrored_though_parts_of_it_fit_in_many_ways():
    hall = np.array([[4.0 * x, 4.0 * y, 1.5] for x in range(4) for y in range(3)])
    control = np.concatenate([hall, [[1.3, 5.2, 3.9], [9.1, 2.2, 0.3], [6.2, 7.7, 2.8]]])
    scan = register(control, scanned(control, scale=2.5)[0][:, [1, 0, 2]], model=Model.UNKNOWN_SCALE)

    assert scan.status == "mirrored"


def test_without_a_level_one_mirror_image_stands_for_all_and_levelled_two():
    floor = HALL * [1, 1, 0]
    images = {
        model: mirror_images(
            matching_task(listed("scan", scanned(floor)[0]), network(floor), Settings(model=model)), 8
        )
        for model in (Model.RIGID, Model.LEVELLED)
    }

    assert len(images[Model.RIGID]) == 1
    assert [image.cause for image in images[Model.LEVELLED]] == ["z is reversed"]
