"""Texts of the core name parameters by their ids; a person reads their labels."""

import re
from collections.abc import Mapping

NOT_BEFORE, NOT_AFTER = r"(?<![\w/+=(\\.-])", r"(?![\w/+=\\-]|\.\w)"
"""What an id never touches: parts of a path or of a picture, and an id that has its label already."""


def with_labels(text: str, labels: Mapping[str, str]) -> str:
    """Return `text` with `Label (ID)` in place of each id of `labels`."""
    ids = "|".join(sorted(map(re.escape, labels), key=len, reverse=True))
    if not ids:
        return text
    return re.sub(f"{NOT_BEFORE}({ids}){NOT_AFTER}", lambda found: _named(found[1], labels), text)


def _named(name: str, labels: Mapping[str, str]) -> str:
    # What follows a comma explains the label in the dialog.
    return f"{labels[name].partition(',')[0]} ({name})"
