"""Texts of the core name parameters by their ids; a person reads their labels."""

import re
from collections.abc import Mapping

NOT_BEFORE, NOT_AFTER = r"(?<![\w/+=\\.-])", r"(?![\w/+=\\-]|\.\w)"
"""What an id never touches: parts of a path or of a picture."""


def with_labels(text: str, labels: Mapping[str, str]) -> str:
    """Return `text` with `Label (ID)` in place of each id of `labels`."""
    ids = "|".join(sorted(map(re.escape, labels), key=len, reverse=True))
    if not ids:
        return text
    return re.sub(f"{NOT_BEFORE}({ids}){NOT_AFTER}", lambda found: _named(found, labels), text)


def _named(found: "re.Match[str]", labels: Mapping[str, str]) -> str:
    name, (start, end) = found[1], found.span()
    if start and found.string[start - 1 : end + 1] == f"({name})":
        # It has its label already.
        return name
    # What follows a comma explains the label in the dialog.
    return f"{labels[name].partition(',')[0]} ({name})"
