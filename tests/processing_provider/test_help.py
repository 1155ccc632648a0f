"""The help: sections with bold names on the desktop, plain text headless; a manual without a network."""

import re
from pathlib import Path

import pytest
from ichnograph.processing_provider import help as helps
from ichnograph.processing_provider import manual
from qgis.PyQt.QtCore import QUrl


@pytest.fixture
def desktop(monkeypatch, provider):
    for module in (helps, manual):
        monkeypatch.setattr(module, "on_desktop", lambda: True)


def test_headless_help_is_plain(provider):
    assert "<" not in provider.algorithm("siteplan").shortHelpString()


def test_on_the_desktop_names_are_bold_in_sections(desktop, provider):
    text = provider.algorithm("siteplan").shortHelpString()

    sections = ["<h3>Parameters</h3>", "<h3>Advanced parameters</h3>", "<h3>Outputs</h3>"]
    places = [text.index(section) for section in sections]
    assert places == sorted(places)
    assert places[0] < text.index("<b>Lowest height (m)</b><br>") < places[1]
    assert places[1] < text.index("<b>Neighbourhood (pixels)</b><br>") < places[2]
    assert text.index("<b>Walls</b><br>") > places[2]


def test_on_the_desktop_parameters_and_algorithms_have_their_labels(desktop, provider):
    compared, image = (provider.algorithm(key).shortHelpString() for key in ("compareplan", "densityimage"))
    assert "as Site plan from laser scans (siteplan) writes them" in compared
    assert "What Lowest height (ZMIN) and Highest height (ZMAX) are counted from" in image


def test_limits_have_no_exponents(provider):
    helps = [item.help() for one in provider.algorithms() for item in one.parameterDefinitions()]
    assert not [text for text in helps if re.search(r"\de[+-]\d", text)]


def test_help_opens_the_page_that_is_installed(desktop, provider):
    page = Path(QUrl(provider.algorithm("siteplan").helpUrl()).toLocalFile())

    text = page.read_text(encoding="utf-8")
    assert "MIN_HEIGHT" in text and "<table" in text
    links = re.findall(r'href="([\w-]+\.html)', text)
    assert links and all((page.parent / link).is_file() for link in links)


def test_the_menu_opens_the_list_of_pages(desktop):
    assert Path(QUrl(manual.page_url("index")).toLocalFile()).is_file()


def test_a_page_that_is_not_installed_is_online(desktop):
    assert manual.page_url("nowhere").startswith("https://")
