"""The figures of the report: what is drawn where, and what the captions say."""

import re
from dataclasses import replace

import numpy as np
import pytest
from ichnograph.algorithms.registration.output.report_figures import (
    APPENDED,
    RESIDUAL,
    SURVEYED,
    residual_bars,
    scan_plan,
    site_plan,
)
from ichnograph.algorithms.reporting.figures import GREY, INK, RED
from ichnograph.tests.algorithms.registration.made_registrations import (
    CORNER,
    correspondence,
    registration,
    rejected,
    scan,
)
from ichnograph.tests.algorithms.reporting.reading import of_colour, texts

CORNERS = [(0, 0, 0), (10, 0, 0), (10, 8, 0), (0, 8, 0)]


def square(*more, station=CORNER + (5, 4, 1.5), residual=(0.001, 0.0, 0.002)):
    """Return a scan of the corners of a rectangle and further targets, seen from its middle."""
    seen = [
        correspondence(f"T{row}", f"P{row}", CORNER + offset, residual) for row, offset in enumerate(CORNERS)
    ]
    return scan("S01", (*seen, *more), station)


def alone(made, points=()):
    return replace(registration(1), scans=(made,), points=tuple(points))


def places(drawing, colour, kind="use"):
    return np.array(
        [[float(node.get("x")), float(node.get("y"))] for node in of_colour(drawing, colour, kind)]
    )


def numbers(node):
    return np.array(re.findall(r"-?[\d.]+", node.get("d")), dtype=float).reshape(-1, 2)


def test_the_plan_shows_every_station_and_point_of_the_registration():
    result = registration(3)
    drawing, caption = site_plan(result)
    surveyed = sum(point.surveyed for point in result.points)

    assert len(places(drawing, INK)) == 3
    assert len(places(drawing, SURVEYED)) == surveyed
    assert len(places(drawing, APPENDED)) == len(result.points) - surveyed == 3
    assert {"S01", "S02", "S03"} <= {*texts(drawing)}
    assert "with 95 % ellipses drawn" in caption


def test_the_largest_ellipse_is_well_seen_however_precise_the_points_are():
    def longest(factor):
        points = [
            replace(point, covariance=factor * point.covariance) if not point.surveyed else point
            for point in registration(3).points
        ]
        drawing, caption = site_plan(replace(registration(3), points=tuple(points)))
        times = float(re.search(r"drawn ([\d.e+]+) times", caption)[1])
        (first, *_others) = of_colour(drawing, f"fill: none; stroke: {APPENDED}")
        return times, np.ptp(numbers(first), axis=0).max()

    (times, size), (times_of_better, size_of_better) = longest(1.0), longest(0.01)
    # Factors are rounded to 1, 2 or 5.
    assert times_of_better == pytest.approx(10 * times)
    assert size_of_better == pytest.approx(size, abs=0.1)
    assert 10 < size < 200


def test_without_appended_points_the_caption_has_no_ellipses():
    points = [point for point in registration(1).points if point.surveyed]
    drawing, caption = site_plan(alone(square(), points))

    assert "ellipses" not in caption
    assert len(places(drawing, APPENDED)) == 0


def test_a_station_is_drawn_where_the_scan_stands_among_its_targets():
    drawing, _caption = scan_plan(square(), alone(square()))

    (station,) = places(drawing, INK)
    np.testing.assert_allclose(station, places(drawing, SURVEYED).mean(axis=0), atol=0.02)


def test_no_station_is_drawn_where_the_origin_is_far_from_the_targets():
    far = square(station=(0.0, 0.0, 0.0))
    drawing, _caption = scan_plan(far, alone(far))

    assert len(places(drawing, INK)) == 0
    assert len(places(drawing, SURVEYED)) == 4


def test_arrows_are_the_horizontal_residuals_times_the_factor_of_the_caption():
    made = square(residual=(0.003, 0.004, 0.1))
    drawing, caption = scan_plan(made, alone(made))
    times = float(re.search(r"drawn (\d+) times", caption)[1])
    corners = places(drawing, SURVEYED)
    pixels_per_metre = np.ptp(corners[:, 0]) / 10

    arrows = of_colour(drawing, RESIDUAL)
    assert len(arrows) == 4
    for start, arrow in zip(corners, arrows):
        away = numbers(arrow) - start
        tip = away[np.argmax(np.linalg.norm(away, axis=1))]
        np.testing.assert_allclose(tip, np.array([0.003, -0.004]) * times * pixels_per_metre, atol=0.5)


def test_a_rejected_target_is_a_cross_without_an_arrow():
    off = rejected("T9", "P9", CORNER + (5, 6, 0), (0.3, 0.0, 0.0))
    made = square(off)
    drawing, caption = scan_plan(made, alone(made))

    assert len(places(drawing, RED)) == 1
    assert len(of_colour(drawing, RESIDUAL)) == 4
    assert "Crosses: rejected targets." in caption
    assert "Crosses" not in scan_plan(square(), alone(square()))[1]


def test_points_that_the_scan_does_not_use_are_grey_if_they_are_on_its_map():
    (point, *_others) = registration(1).points
    near = replace(point, position=CORNER + (5, 2, 0))
    far = replace(point, position=CORNER + (500, 0, 0))
    drawing, _caption = scan_plan(square(), alone(square(), [near, far]))

    assert len(places(drawing, GREY)) == 1


def test_bars_show_components_and_lengths_in_millimetres():
    made = square(residual=(0.003, -0.004, 0.012))
    components, lengths = residual_bars(made)

    assert {"vx", "vy", "vz"} <= {*texts(components)}
    for drawing in (components, lengths):
        assert "mm" in texts(drawing)
        assert [text for text in texts(drawing) if text.startswith("P")] == ["P0", "P1", "P2", "P3"]


def test_the_bar_of_a_rejected_target_is_cut_and_its_length_written():
    off = rejected("T9", "P9", CORNER + (5, 6, 0), (0.3, 0.0, 0.0))
    components, lengths = residual_bars(square(off))

    for drawing in (components, lengths):
        assert "300" in texts(drawing)
        (label,) = [node for node in of_colour(drawing, RED, "text") if node.text == "P9"]
        assert label is not None
    assert "300" not in texts(residual_bars(square())[1])
