"""Pages: whole, escaped and the same every time."""

import re

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.reporting.page import render, write_page
from ichnograph.tests.algorithms.reporting.reading import parsed, text_of
from jinja2 import UndefinedError

HEAD = '{% extends "page.html" %}{% import "macros.html" as m %}{% set title = name %}{% block content %}'


@pytest.fixture
def template(tmp_path):
    """Return the path of a template with this content."""

    def template(content):
        path = tmp_path / "template.html"
        path.write_text(f"{HEAD}{content}{{% endblock %}}", encoding="utf-8")
        return path

    return template


def body(page):
    return re.search(r"</h1>\s*(.*?)\s*</body>", page, re.DOTALL).group(1)


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(st.text(alphabet=st.characters(blacklist_categories=("Cs", "Cc"))))
def test_any_text_comes_back_from_the_page(template, text):
    assert text in text_of(render(template("{{ text }}"), name="x", text=text))


def test_a_page_is_whole_and_needs_no_other_file(template, tmp_path):
    write_page(
        tmp_path / "report.html", template('<h2 id="one">Head</h2><p>{{ text }}</p>'), name="A & B", text="ü"
    )
    text = (tmp_path / "report.html").read_text(encoding="utf-8")

    assert text.startswith("<!DOCTYPE html>")
    assert '<meta charset="utf-8"><title>A &amp; B</title>' in text
    assert "<h1>A &amp; B</h1>" in text
    assert '<h2 id="one">Head</h2><p>ü</p>' in text
    assert not re.search(r"(?i)https?:|<script|<link|url\(|@import", text)


def test_a_name_with_bytes_that_are_no_text_does_not_stop_the_page(template, tmp_path):
    write_page(tmp_path / "report.html", template("x"), name="scan\udce4")

    assert "scan?" in (tmp_path / "report.html").read_text(encoding="utf-8")


def test_a_page_that_cannot_be_written_is_refused(template, tmp_path):
    with pytest.raises(InputError, match="folder"):
        write_page(tmp_path / "nowhere" / "report.html", template("x"), name="x")


def test_a_value_that_is_missing_is_an_error_and_not_a_gap(template):
    with pytest.raises(UndefinedError, match="tolerance"):
        render(template("{{ tolerance }}"), name="x")


def test_a_table_marks_words_and_rows(template):
    page = render(
        template('{{ m.table(["a", "b"], rows, marked=[1], caption="c") }}'),
        name="x",
        rows=[("x", "1"), ("<y>", "2")],
    )
    rows = parsed(body(page)).findall(".//tr")

    assert [cell.get("class") for row in rows for cell in row] == ["w", None] * 3
    assert [row.get("class") for row in rows] == [None, None, "marked"]
    assert rows[2][0].text == "<y>"
    assert parsed(body(page)).findtext(".//caption") == "c"


def test_a_caller_may_write_the_rows_itself(template):
    content = '{% call m.table(["a", "b"]) %}{{ m.row([m.link("<y>", "one"), "1"]) }}{% endcall %}'
    (cell, _) = parsed(body(render(template(content), name="x"))).findall(".//td")

    assert (cell[0].get("href"), cell[0].text) == ("#one", "<y>")


def test_notes_bullets_and_definitions_escape_what_they_show(template):
    content = "{{ m.notes(items) }}{{ m.bullets(items) }}{{ m.definitions(terms) }}"
    page = body(render(template(content), name="x", items=["<a>"], terms={"<b>": "<c>"}))

    assert '<p class="note">&lt;a&gt;</p>' in page
    assert "<ul><li>&lt;a&gt;</li></ul>" in page
    assert "<dl><dt>&lt;b&gt;</dt><dd>&lt;c&gt;</dd></dl>" in page


def test_an_empty_list_is_nothing(template):
    assert body(render(template("{{ m.bullets([]) }}{{ m.notes([]) }}"), name="x")) == ""


def test_a_drawing_is_markup_and_its_caption_is_not(template):
    page = body(
        render(template("{{ m.figure(drawing, caption) }}"), name="x", drawing="<svg/>", caption="<b>")
    )

    assert page == "<figure><svg/><figcaption>&lt;b&gt;</figcaption></figure>"
