"""No translation is missing, out of date or wrong in form."""

import re

import pytest
from ichnograph.processing_provider.catalogue import HOLE
from ichnograph.processing_provider.language import CONTEXT, TRANSLATIONS
from ichnograph.scripts.texts import texts
from ichnograph.scripts.translations import LANGUAGES, read

SAME = {
    "de": {
        "%1 m in %2",
        "Detail",
        "Details",
        "Details: %1.",
        "Name",
        "Plan",
        "Radius (m)",
        "Scan",
        "Scans",
        "System",
        "Transformation",
        "in %1",
    },
    "fr": {
        "%1 pixels",
        "Axes",
        "Base (m)",
        "Date",
        "Dimension",
        "Image",
        "Orthoimage",
        "Plan",
        "Points",
        "Scan",
        "Scans",
        "Transformation",
        "Transformations",
        "distance (cm)",
        "distance (m)",
        "niche",
        "passage",
        "pixels",
        "plan",
        "point",
        "rectangle",
        "rotation",
        "rotation %1",
        "scan",
        "scans",
        "surface",
        "surfaces",
        "transformation",
        "triangles",
    },
}
"""Texts that are the same in English and in the other language."""

PARAMETER = re.compile(r"\b[A-Z][A-Z0-9]*_[A-Z_0-9]+\b")


@pytest.fixture(params=LANGUAGES)
def language(request):
    return request.param


@pytest.fixture
def translations(language):
    return read(TRANSLATIONS / f"ichnograph_{language}.ts")


def test_every_text_of_the_source_is_translated(translations):
    missing = [text for text in texts() if not translations.get(text)]
    assert not missing, "run `make translations` and translate what it lists"


def test_no_text_is_translated_that_the_source_has_no_more(translations):
    assert {*translations} == {*texts()}, "run `make translations`"


def test_translations_fill_in_what_the_text_fills_in(translations):
    for text, translation in translations.items():
        assert sorted(HOLE.findall(translation)) == sorted(HOLE.findall(text)), text


def test_translations_keep_the_ids_of_parameters(translations):
    for text, translation in translations.items():
        assert {*PARAMETER.findall(text)} <= {*PARAMETER.findall(translation)}, text


def test_translations_end_as_the_text_ends(translations):
    for text, translation in translations.items():
        if text.endswith("."):
            assert translation.endswith("."), text


def test_translations_differ_from_the_text_unless_both_languages_have_the_word(language, translations):
    assert {text for text, translation in translations.items() if text == translation} == SAME[language]


def test_the_compiled_catalogue_is_that_of_the_edited_one(language, translations):
    QtCore = pytest.importorskip("qgis.PyQt.QtCore")  # noqa: N806 - a module
    compiled = QtCore.QTranslator()
    assert compiled.load(str(TRANSLATIONS / f"ichnograph_{language}.qm"))
    for text, translation in translations.items():
        assert compiled.translate(CONTEXT, text.encode()) == translation
