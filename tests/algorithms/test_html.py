"""Pages, charts and maps: whole, escaped and the same every time."""

import re
from html.parser import HTMLParser
from xml.etree import ElementTree

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from ichnograph.algorithms.reporting.charts import bar_chart, histogram
from ichnograph.algorithms.reporting.html import (
    MISSING,
    Markup,
    bullets,
    element,
    number,
    page,
    paragraph,
    section,
    table,
    write_page,
)
from ichnograph.algorithms.reporting.maps import Map
from ichnograph.algorithms.reporting.svg import LETTER, WIDTH, round_step

DIAGONAL = np.array([[0.0, 0.0], [100.0, 50.0]]) + (412_300.0, 5_812_300.0)


def parsed(markup):
    return ElementTree.fromstring(str(markup))


def texts(markup):
    return [node.text for node in parsed(markup).iter("text")]


class Reader(HTMLParser):
    """Collects the text of a page."""

    def __init__(self):
        super().__init__()
        self.data = []

    def handle_data(self, data):
        self.data.append(data)


@given(st.text(alphabet=st.characters(blacklist_categories=("Cs", "Cc"))))
def test_any_text_comes_back_from_the_page(text):
    reader = Reader()
    reader.feed(str(paragraph(text)))

    assert "".join(reader.data) == text


def test_attributes_are_escaped_and_left_out_if_none():
    assert element("a", "b", title='"<', href=None) == '<a title="&quot;&lt;">b</a>'


def test_markup_is_not_escaped_twice():
    assert paragraph(Markup("<b>x</b>"), "<") == "<p><b>x</b>&lt;</p>"


def test_a_page_is_whole_and_needs_no_other_file(tmp_path):
    write_page(tmp_path / "report.html", "A & B", section("Head", paragraph("ü"), anchor="one"))
    text = (tmp_path / "report.html").read_text(encoding="utf-8")

    assert text.startswith("<!DOCTYPE html>")
    assert '<meta charset="utf-8"><title>A &amp; B</title>' in text
    assert '<h2 id="one">Head</h2><p>ü</p>' in text
    assert not re.search(r"(?i)https?:|<script|<link|url\(|@import", text)


def test_a_name_with_bytes_that_are_no_text_does_not_stop_the_page(tmp_path):
    write_page(tmp_path / "report.html", "scan\udce4", paragraph("x"))

    assert "scan?" in (tmp_path / "report.html").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("value", "text"),
    [(1.25, "1.2"), (None, MISSING), (float("nan"), MISSING), (-0.04, "0.0"), (-0.06, "-0.1")],
)
def test_a_number_has_its_decimals_or_is_told_to_be_missing(value, text):
    assert number(value, 1) == text


def test_a_table_marks_words_and_rows():
    rows = parsed(table(("a", "b"), [("x", "1"), ("<y>", "2")], marked=[1], caption="c")).findall(".//tr")

    assert [cell.get("class") for row in rows for cell in row] == ["w", None] * 3
    assert [row.get("class") for row in rows] == [None, None, "marked"]
    assert rows[2][0].text == "<y>"


def test_an_empty_list_is_nothing():
    assert bullets([]) == ""


def test_the_same_parts_make_the_same_page():
    def made():
        chart = bar_chart(["a", "b"], {"vx": [1.0, 2.0]}, "mm")
        return page("t", chart, histogram(np.arange(20.0), "mm"))

    assert made() == made()


@given(st.floats(1e-9, 1e9))
def test_a_round_step_is_below_a_value_but_near_it(value):
    step = round_step(value)
    mantissa = step / 10 ** np.floor(np.log10(step) + 1e-9)

    assert round(mantissa) in (1, 2, 5)
    assert value / 2.5 * (1 - 1e-6) <= step <= value * (1 + 1e-6)


def test_bars_that_are_cut_end_in_their_value():
    chart = bar_chart(["a", "b"], {"v": [3.0, 80.0]}, "mm", limit=5.0, marked=[False, True])

    assert "80" in texts(chart)
    assert "10" not in texts(chart)
    assert [node.get("class") for node in parsed(chart).iter("text") if node.text == "b"] == ["middle red"]


def test_a_missing_value_has_no_bar():
    chart = parsed(bar_chart(["a", "b"], {"v": [float("nan"), 1.0]}, "mm"))

    assert chart.findall("path")[-1].get("d").count("M") == 1


@pytest.mark.parametrize("count", [0, 1, 3, 40, 2000])
def test_labels_of_bars_do_not_run_into_each_other(count):
    names = [f"P{place:04d}" for place in range(count)]
    chart = bar_chart(names, {axis: np.ones(count) for axis in ("vx", "vy", "vz")}, "mm")
    shown = [node for node in parsed(chart).iter("text") if str(node.text).startswith("P")]

    assert bool(shown) == bool(count)
    places = [float(re.findall(r"[\d.]+", node.get("transform") or node.get("x"))[0]) for node in shown]
    upright = any(node.get("transform") for node in shown)
    assert all(np.diff(places) >= (10 if upright else 5 * LETTER))


@pytest.mark.parametrize("values", [[], [2.0], [2.0, 2.0], [float("nan"), 1.0, 3.0]])
def test_a_histogram_can_be_drawn_of_anything(values):
    parsed(histogram(values, "mm", limits=[2.0]))


def test_a_map_has_equal_scales_and_north_up():
    sheet = Map.around(DIAGONAL)
    (left, bottom), (right, top) = sheet.place(DIAGONAL)

    assert right - left == pytest.approx(100 * sheet.scale)
    assert bottom - top == pytest.approx(50 * sheet.scale)
    assert 0 < left < right < WIDTH
    assert 0 < top < bottom < sheet.height
    assert sheet.shows(DIAGONAL).all()
    assert not sheet.shows(DIAGONAL + 200).any()


@pytest.mark.parametrize("points", [[[5.0, 5.0]], [[0.0, 0.0], [0.0, 30.0]], [[0.0, 0.0], [3000.0, 0.0]]])
def test_a_map_can_be_drawn_of_points_in_a_line_or_one(points):
    points = np.array(points)
    sheet = Map.around(points)

    assert sheet.shows(points).all()
    drawn = sheet.sheet(
        sheet.dots(points, "#000"), sheet.names(points, ["P"] * len(points), [""] * len(points))
    )
    assert texts(drawn).count("P") == len(points)


def test_names_on_a_map_never_overlap_and_the_first_ones_win():
    points = np.random.default_rng(0).uniform(0, 10, (300, 2))
    sheet = Map.around(points)
    texts = [f"P{place:03d}" for place in range(300)]
    drawn = sheet.sheet(sheet.names(points, texts, [""] * 300, leading=3))
    names = [node for node in parsed(drawn).iter("text") if node.text in texts]
    boxes = np.array([(float(node.get("x")), float(node.get("y"))) for node in names])

    assert {"P000", "P001", "P002"} <= {node.text for node in names}
    assert 20 < len(names) < 300
    apart = np.abs(boxes[:, None] - boxes[None])
    clash = (apart[..., 0] < 4 * LETTER - 0.2) & (apart[..., 1] < 10)
    assert clash.sum() == len(names)


def test_an_ellipse_points_along_its_largest_variance():
    sheet = Map.around(DIAGONAL)
    ellipse = parsed(sheet.ellipse(DIAGONAL[0], np.array([[2.0, 1.0], [1.0, 2.0]]), 1.0, "#000"))

    assert float(ellipse.get("rx")) == pytest.approx(3**0.5 * sheet.scale, abs=0.1)
    assert float(ellipse.get("ry")) == pytest.approx(sheet.scale, abs=0.1)
    turn = float(re.search(r"rotate\((.*)\)", ellipse.get("transform")).group(1))
    assert turn % 180 == pytest.approx(135.0)
