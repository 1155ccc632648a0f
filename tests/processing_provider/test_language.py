"""The provider speaks the language of QGIS."""

import html
import re
from pathlib import Path

import pytest
from ichnograph.processing_provider.parameters.parameter import Number
from ichnograph.scripts.provider import own_algorithms
from ichnograph.scripts.texts import texts
from ichnograph.tests.processing_provider.room import CORNER

ENGLISH = {"the", "of", "and", "is", "are", "were", "with", "from", "which", "that", "not", "it", "by"}
"""Words that neither German nor French has."""

EXAMPLE = Path(__file__).parents[2] / "processing_provider" / "example"


@pytest.fixture(params=["de", "fr"])
def language(request, speaking):
    speaking(request.param)
    return request.param


@pytest.fixture
def speaking(qgis_application):
    """Set the language of QGIS, as its options do."""
    from qgis.core import QgsSettings

    def speaking(name):
        QgsSettings().setValue("locale/overrideFlag", True)
        QgsSettings().setValue("locale/userLocale", name)

    yield speaking
    QgsSettings().remove("locale")


def english_in(text):
    """Return the English words of a text that is not English, except those of ids and files."""
    # The folder of the tests has English words between hyphens.
    without_paths = re.sub(r"/\S+/", "/", text)
    return sorted({*re.findall(r"(?<![\w/._'=])[a-z]+(?![\w/._'=])", without_paths)} & ENGLISH)


def texts_of(page):
    text = re.sub(r"<style.*?</style>", "", page, flags=re.DOTALL)
    return [html.unescape(part) for part in re.split(r"<[^>]*>", text) if part.strip()]


def test_the_locale_of_qgis_chooses_the_language(speaking):
    from ichnograph.processing_provider.language import translated

    spoken = []
    for name in ("de_AT", "fr", "en_US", "it"):
        speaking(name)
        spoken.append(translated("Control points"))
    assert spoken == ["Passpunkte", "Points d'appui", "Control points", "Control points"]


def test_names_and_helps_of_all_algorithms_are_translated(language, provider):
    for algorithm in provider.algorithms():
        fresh = algorithm.create()
        texts = [fresh.displayName(), fresh.group(), fresh.shortDescription(), fresh.shortHelpString()]
        for item in (*fresh.parameterDefinitions(), *fresh.outputDefinitions()):
            texts += [item.description(), getattr(item, "help", str)(), *getattr(item, "options", list)()]
        assert not english_in(" ".join(texts)), algorithm.id()


def test_units_that_are_words_are_translated(provider):
    inputs = [item for algorithm in own_algorithms(provider) for item in algorithm.inputs]
    units = {item.unit for item in inputs if isinstance(item, Number)}
    assert {unit for unit in units if re.search("[a-z]{3}", unit)} - {"ppm"} <= {*texts()}


def test_ids_are_the_same_in_all_languages(language, provider):
    site_plan, model = (provider.algorithm(name).create() for name in ("siteplan", "Facade to drawing"))
    names = {item.name() for item in site_plan.parameterDefinitions()}
    assert {"INPUT", "MIN_HEIGHT", "WALLS"} <= names
    assert (site_plan.groupId(), model.name()) == ("siteplan", "Facade to drawing")


def test_a_registration_says_nothing_in_english(language, run, feedback, tmp_path):
    targets = [str(path) for path in sorted(EXAMPLE.glob("house_*.txt"))]
    run(
        "registerscans",
        feedback,
        CONTROL=str(EXAMPLE / "control.txt"),
        TARGETS=targets,
        TRANSFORMS=str(tmp_path / "transforms.json"),
        REPORT=str(tmp_path / "report.html"),
    )
    assert_translated(feedback, tmp_path / "report.html", language)


def test_a_site_plan_says_nothing_in_english(language, run, feedback, tmp_path, room):
    run("siteplan", feedback, INPUT=[room], WALLS=str(tmp_path / "w.gpkg"), REPORT=str(tmp_path / "r.html"))
    assert_translated(feedback, tmp_path / "r.html", language)


def test_a_simulation_says_nothing_in_english(language, run, feedback, tmp_path):
    run(
        "simulateregistration",
        feedback,
        CONTROL=str(EXAMPLE / "control.txt"),
        TRIALS=5,
        TABLE=str(tmp_path / "trials.csv"),
        REPORT=str(tmp_path / "report.html"),
    )
    assert_translated(feedback, tmp_path / "report.html", language)


def assert_translated(feedback, report, language):
    page = report.read_text(encoding="utf-8")
    assert f'<html lang="{language}">' in page
    # Processing itself ends a run with the values of its outputs.
    said = [text for text in feedback.infos if not text.startswith("Results: ")]
    said += feedback.warnings + feedback.steps
    assert said
    for text in (*said, *texts_of(page)):
        assert not english_in(text), text


def test_an_error_names_parameters_by_their_translated_labels(speaking, run, room, tmp_path):
    from qgis.core import QgsProcessingException

    speaking("de")
    above = float(CORNER[2]) + 100
    with pytest.raises(QgsProcessingException, match=r"Kein Punkt liegt von Niedrigste Höhe \(ZMIN\)"):
        run("siteplan", INPUT=[room], ZMIN=above, ZMAX=above + 5, WALLS=str(tmp_path / "walls.gpkg"))


def test_a_style_shows_translated_legends_and_fields(speaking, run, room, tmp_path):
    speaking("fr")
    run("siteplan", INPUT=[room], WALLS=str(tmp_path / "walls.gpkg"))
    style = (tmp_path / "walls.qml").read_text(encoding="utf-8")
    assert 'label="Mur droit"' in style
    assert 'name="Épaisseur (m)"' in style
    # What the file holds is the same in all languages.
    assert 'value="straight"' in style
