"""The site of the documentation, and the commands of its tutorial."""

import re

import pytest
from ichnograph.scripts.house import ROOT
from ichnograph.scripts.provider import own_algorithms
from ichnograph.scripts.site.pages import CONTENTS, dialog_of
from ichnograph.scripts.tutorial import PAGE, commands

STEPS = re.findall(
    r"qgis_process run ichnograph:(\w+) -- (.*)", commands(PAGE.read_text()).replace("\\\n", "")
)


def test_the_page_of_an_algorithm_names_all_that_its_dialog_asks_for(provider):
    for algorithm in own_algorithms(provider):
        section = dialog_of(algorithm)
        missing = [
            definition.name()
            for definition in algorithm.parameterDefinitions()
            if f"| {definition.name()} | {definition.description()} | " not in section
        ]
        assert not missing, algorithm.name()


def test_every_page_is_in_the_margin_of_the_site():
    listed = {name for names in CONTENTS.values() for name in names}

    assert {f"docs/{page.stem}" for page in (ROOT / "docs").glob("*.md")} <= listed


def test_the_tutorial_leads_to_the_plan_and_the_elevation():
    keys = [key for key, _ in STEPS]
    assert keys[:4] == ["exampledata", "registerscans", "transformcloud", "siteplan"]
    assert keys[4:] == ["planlayout", "facadedetails", "planlayout"]


@pytest.mark.parametrize(("key", "rest"), STEPS)
def test_the_tutorial_gives_parameters_that_exist(provider, key, rest):
    given = {name.replace("printf '", "") for name in re.findall(r"\b([A-Z_]+)=", rest)}

    assert given <= {item.name() for item in provider.algorithm(key).parameterDefinitions()}
