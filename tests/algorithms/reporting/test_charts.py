"""Bars, histograms and curves."""

import re

import numpy as np
import pytest
from ichnograph.algorithms.reporting.charts import LEFT, RIGHT, bar_chart, curve_chart, histogram
from ichnograph.algorithms.reporting.figures import COLOURS, LETTER, RED, WIDTH
from ichnograph.tests.algorithms.reporting.reading import parsed, texts


def filled(svg, colour):
    """Return left, right, top and bottom of the shapes that are filled in a colour."""
    paths = [
        node.get("d") for node in parsed(svg).iter("path") if f"fill: {colour}" in (node.get("style") or "")
    ]
    shapes = [shape for path in paths for shape in path.split("M")[1:]]
    corners = [np.array(re.findall(r"[\d.]+", shape), dtype=float).reshape(-1, 2) for shape in shapes]
    return [(*np.sort(each[:, 0])[[0, -1]], *np.sort(each[:, 1])[[0, -1]]) for each in corners]


def dashed(svg):
    """Return where across the lines of limits are."""
    paths = [node.get("d") for node in parsed(svg).iter("path") if "dasharray" in (node.get("style") or "")]
    return [float(re.search(r"[\d.]+", path).group()) for path in paths]


def test_the_same_values_make_the_same_chart():
    assert bar_chart(["a", "b"], {"vx": [1.0, 2.0]}, "mm") == bar_chart(["a", "b"], {"vx": [1.0, 2.0]}, "mm")


def test_bars_are_as_high_as_their_values_and_have_their_unit():
    chart = bar_chart(["a", "b", "c"], {"v": [1.0, 2.0, -1.0]}, "mm")
    heights = [bottom - top for _left, _right, top, bottom in filled(chart, COLOURS[0])]

    assert heights == pytest.approx([heights[0], 2 * heights[0], heights[0]])
    assert {"a", "b", "c", "mm"} <= set(texts(chart))


def test_series_stand_side_by_side_and_the_legend_names_them():
    chart = bar_chart(["a"], {"vx": [1.0], "vy": [1.0]}, "mm")
    one, other = (max(filled(chart, colour), key=lambda box: box[3] - box[2]) for colour in COLOURS[:2])

    assert one[1] == pytest.approx(other[0], abs=0.01)
    assert {"vx", "vy"} <= set(texts(chart))


def test_bars_that_are_cut_end_in_their_value():
    chart = bar_chart(["a", "b"], {"v": [3.0, 80.0]}, "mm", limit=5.0, marked=[False, True])
    red = {node.text for node in parsed(chart).iter("text") if RED in node.get("style")}

    assert red == {"80", "b"}
    assert "10" not in texts(chart)
    low, high = (bottom - top for _left, _right, top, bottom in filled(chart, COLOURS[0]))
    assert high == pytest.approx(low * 5 / 3, rel=1e-3)


def test_a_missing_value_has_no_bar():
    assert len(filled(bar_chart(["a", "b"], {"v": [float("nan"), 1.0]}, "mm"), COLOURS[0])) == 1


@pytest.mark.parametrize("count", [0, 1, 3, 40, 500])
def test_labels_of_bars_do_not_run_into_each_other(count):
    names = [f"P{place:04d}" for place in range(count)]
    chart = bar_chart(names, {axis: np.ones(count) for axis in ("vx", "vy", "vz")}, "mm")
    shown = [node for node in parsed(chart).iter("text") if str(node.text).startswith("P")]

    assert bool(shown) == bool(count)
    upright = any("-90" in (node.get("transform") or "") for node in shown)
    assert upright == (count > (WIDTH - LEFT - RIGHT) / (5 * LETTER))
    places = [float(node.get("x")) for node in shown]
    assert all(np.diff(places) >= (10 if upright else 5 * LETTER))


def test_a_long_upright_label_is_cut():
    chart = bar_chart(["x" * 40] * 30, {"v": np.ones(30)}, "mm")

    assert "x" * 13 + "\N{HORIZONTAL ELLIPSIS}" in texts(chart)


@pytest.mark.parametrize("values", [[], [2.0], [2.0, 2.0], [float("nan"), 1.0, 3.0]])
def test_a_histogram_can_be_drawn_of_anything(values):
    parsed(histogram(values, "mm", limits=[2.0]))


def test_a_histogram_counts_and_marks_limits_within_the_values():
    chart = histogram([0.0] * 3 + [10.0], "shift (mm)", bins=2, limits=[5.0, 50.0])
    (few, many) = sorted(bottom - top for _left, _right, top, bottom in filled(chart, COLOURS[0]))

    assert many == pytest.approx(3 * few)
    assert dashed(chart) == [pytest.approx(LEFT + (WIDTH - LEFT - RIGHT) / 2)]
    assert "shift (mm)" in texts(chart)


def test_curves_are_named_and_limits_are_marked_where_they_are():
    chart = curve_chart({"plan": ([0, 5, 10], [0, 50, 100])}, "distance (cm)", "%", [2.5, 11.0])

    assert dashed(chart) == [pytest.approx(LEFT + (WIDTH - LEFT - RIGHT) / 4)]
    assert {"plan", "distance (cm)", "%", "100"} <= set(texts(chart))
