"""Figures: alike whatever the settings of matplotlib, the same every time, and fit for a page."""

import re

import matplotlib
import pytest
from ichnograph.algorithms.reporting.figures import canvas, plain, svg
from ichnograph.tests.algorithms.reporting.reading import parsed, texts


def drawn(text="x"):
    with canvas(100.0) as figure:
        axes = figure.add_axes((0, 0, 1, 1))
        axes.plot([0, 1], [0, 1], "o-")
        axes.set_title(plain(text))
        return svg(figure)


def test_the_same_figure_is_the_same_bytes():
    assert drawn() == drawn()


def test_a_figure_needs_nothing_from_elsewhere():
    assert not re.search(r"(?i)http|<script|<style|url\(|@import|<!|<\?", drawn())


def test_a_figure_is_as_large_as_its_canvas():
    root = parsed(drawn())

    assert (root.tag, root.get("width"), root.get("height")) == ("svg", "900", "100")
    assert root.get("viewBox") == "0 0 900 100"


def test_signs_are_found_where_they_are_used():
    root = parsed(drawn())
    targets = {node.get("href") for node in root.iter("use")}

    assert targets
    assert targets <= {f"#{node.get('id')}" for node in root.iter("path")}


def test_settings_of_others_neither_matter_nor_change():
    before, expected = dict(matplotlib.rcParams), drawn()
    with matplotlib.rc_context(
        {"font.size": 30, "axes.titlesize": 40, "svg.fonttype": "path", "axes.grid": False}
    ):
        changed = dict(matplotlib.rcParams)
        assert drawn() == expected
        assert dict(matplotlib.rcParams) == changed
    assert dict(matplotlib.rcParams) == before


@pytest.mark.parametrize(
    "text",
    [
        "$x^2$",
        r"\$1$",
        "<img src=x>&\"'",
        "100 %",
        "a_b",
        "Ünïcode",
        "漢字",
        'a clip-path="x" xlink:href=',
        "\N{GREEK SMALL LETTER TAU}",
    ],
)
def test_any_name_is_written_letter_by_letter(text, recwarn):
    assert texts(drawn(text))[-1] == text
    assert not recwarn


def test_letters_that_are_no_text_and_line_breaks_do_not_stop_a_figure():
    assert texts(drawn("scan\udce4\nnext"))[-1] == "scan? next"
