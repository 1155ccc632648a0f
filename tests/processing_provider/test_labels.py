"""Ids of parameters in texts of the core get their labels."""

import pytest
from ichnograph.processing_provider.labels import with_labels

LABELS = {"MIN_HEIGHT": "Least height", "HEIGHT": "Height", "CRS": "Coordinate reference system, if none"}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Lower MIN_HEIGHT, or set CRS.", "Lower Least height (MIN_HEIGHT), or set "),
        ("16 regions (HEIGHT 3 m)", "16 regions (Height (HEIGHT) 3 m)"),
        ("HEIGHT 3 m is not MIN_HEIGHT", "Height (HEIGHT) 3 m is not Least height (MIN_HEIGHT)"),
    ],
)
def test_an_id_is_replaced_by_its_label_and_the_id(text, expected):
    assert with_labels(text, LABELS).startswith(expected)


def test_what_follows_a_comma_in_a_label_explains_the_dialog_only():
    assert with_labels("set CRS.", LABELS) == "set Coordinate reference system (CRS)."


@pytest.mark.parametrize(
    "text",
    [
        "/data/HEIGHT/CRS.gpkg",
        "CRS.tif",
        "C:\\CRS\\a.tif",
        "Least height (MIN_HEIGHT)",
        "iV/CRS+HEIGHT=",
        "SCRS",
    ],
)
def test_paths_pictures_and_longer_words_are_left_alone(text):
    assert with_labels(text, LABELS) == text
