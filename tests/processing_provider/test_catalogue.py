"""Finished sentences are translated by the patterns that they were made of."""

import pytest
from ichnograph.processing_provider.catalogue import Catalogue

CATALOGUE = Catalogue(
    {
        "%1 has %2 targets; pick more.": "%1 hat %2 Zielmarken; mehr messen.",
        "%1 is not registered (%2): %3": "%1 ist nicht registriert (%2): %3",
        "Rooms: %1, %2 m².": "Räume: %1, %2 m².",
        "%2 of %1": "unused",
        "Matching %1": "%1 wird zugeordnet",
        "%1 m in %2": "%1 m in %2",
        "%1 by the %2": "%1 am „%2“",
        "of %1, %2 were read": "%2 wurden von %1 gelesen",
        "Point spacing": "Punktabstand",
        "0 to 255": "0 bis 255",
        "standard deviations": "Standardabweichungen",
        "too few": "zu wenige",
        "surveyed": "eingemessen",
        "It ends early.": "Sie endet vorzeitig.",
    }
)


@pytest.mark.parametrize(
    ("english", "german"),
    [
        ("too few", "zu wenige"),
        ("Matching house_01", "house_01 wird zugeordnet"),
        ("Rooms: 4, 61.20 m².", "Räume: 4, 61.20 m²."),
        ("of a.laz, 3 were read", "3 wurden von a.laz gelesen"),
    ],
)
def test_a_text_is_translated_by_its_pattern_and_keeps_names_and_numbers(english, german):
    assert CATALOGUE.translate(english) == german


def test_a_number_at_the_edge_of_a_part_belongs_to_it():
    assert CATALOGUE.translate("Point spacing (0 to 255)") == "Punktabstand (0 bis 255)"


def test_what_is_filled_in_is_translated_likewise():
    english = "S1 is not registered (too few): S1 has 2 targets; pick more."
    assert (
        CATALOGUE.translate(english)
        == "S1 ist nicht registriert (zu wenige): S1 hat 2 Zielmarken; mehr messen."
    )


def test_sentences_in_a_row_are_translated_one_by_one():
    english = "It ends early. S1 has 2 targets; pick more. It ends early."
    german = "Sie endet vorzeitig. S1 hat 2 Zielmarken; mehr messen. Sie endet vorzeitig."
    assert CATALOGUE.translate(english) == german


def test_parts_without_a_common_pattern_are_translated_by_themselves():
    assert CATALOGUE.translate("Point spacing (standard deviations)") == "Punktabstand (Standardabweichungen)"
    assert CATALOGUE.translate("2 surveyed (too few)") == "2 eingemessen (zu wenige)"


def test_a_list_is_translated_item_by_item():
    assert CATALOGUE.translate("3 by the size, 2 by the shape") == "3 am „size“, 2 am „shape“"


def test_the_pattern_that_knows_most_of_a_text_is_taken():
    # "%1 m in %2" fits as well.
    english = "3 m in S1 is not registered (too few): no"
    assert CATALOGUE.translate(english).startswith("3 m in S1 ist nicht registriert")


def test_patterns_within_patterns_end_in_any_text():
    assert "%" not in CATALOGUE.translate("a m in b by the c, " * 200)


@pytest.mark.parametrize("text", ["", "12.5", "/data/too few.laz", "Something else entirely.", "100 %1"])
def test_a_text_without_a_pattern_remains_as_it_is(text):
    assert CATALOGUE.translate(text) == text


def test_of_equal_patterns_that_of_the_first_word_is_taken():
    pairs = [(f"ahead{letter}", f"behind{letter}") for letter in "abcdefghijkl"]
    for first, last in pairs:
        catalogue = Catalogue({f"{first} %1": "%1, first", f"%1 {last}x": "%1, last"})
        assert catalogue.translate(f"{first} 7 {last}x") == "7, last, first"
