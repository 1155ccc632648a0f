"""Labels of points, as many as there is room for."""

import numpy as np
from ichnograph.algorithms.reporting.labels import place_labels

SIZE = (900.0, 600.0)


def test_labels_never_overlap_and_the_first_ones_win():
    places = np.random.default_rng(0).uniform(50, 550, (300, 2))
    boxes = place_labels(places, [f"P{number:03d}" for number in range(300)], SIZE, leading=3)
    shown = np.array([box for box in boxes if box is not None])

    assert all(box is not None for box in boxes[:3])
    assert 20 < len(shown) < 300
    overlap = np.all(
        (shown[:, None, :2] < shown[None, :, 2:]) & (shown[:, None, 2:] > shown[None, :, :2]), axis=2
    )
    assert overlap.sum() == len(shown)


def test_labels_do_not_hide_points_but_leading_ones_may():
    row = np.array(
        [[300.0 + 4 * number, 300.0 + 12 * side] for number in range(-20, 20) for side in (-1, 0, 1)]
    )
    places = np.vstack([[300.0, 300.0], row])
    texts = ["name"] + [""] * len(row)

    assert place_labels(places, texts, SIZE)[0] is None
    assert place_labels(places, texts, SIZE, leading=1)[0] is not None


def test_a_label_at_the_border_stays_on_the_map():
    (box,) = place_labels(np.array([[895.0, 300.0]]), ["a long name"], SIZE)

    assert box[2] < 895
    assert box[0] >= 0
