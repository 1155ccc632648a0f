"""The file that a cloud is written to."""

from pathlib import Path

from ...errors import InputError
from ..cloud import Cloud
from ..formats import format_of, writable_formats


def check_target(cloud: Cloud, target: Path) -> None:
    """Refuse a path that cannot be written.

    Raises
    ------
    InputError
        If its extension is not known, or it is an input.
    """
    known = format_of(target)
    if known is None or not known.is_written or target.name.lower().endswith(".copc.laz"):
        raise InputError(f"{target} has an extension that cannot be written; choose {writable_formats()}.")
    if target.resolve() in [source.path.resolve() for source in cloud.sources]:
        raise InputError(f"{target} is an input as well; choose another name for the output.")


def is_text(target: Path) -> bool:
    """Whether a file that can be written holds lines of text."""
    known = format_of(target)
    return known is not None and known.is_text
