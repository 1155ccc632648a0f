"""Settings: the constants of a stage as a frozen dataclass, each with the reason for its value.

A stage declares its constants once, and passes them down as an argument:

    @dataclass(frozen=True)
    class ThresholdSettings:
        least_run_m: float = physical(0.3, "Shorter than a pillar is wide.")
        significance: float = statistical(0.001, "Baarda's choice for data snooping.")
        sharpness: float = judged(0.5, "Half of the peak separates floor from wall on all scenes.")

Settings of a chapter hold those of its stages. `docs/constants.md` is generated from them.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field, fields, is_dataclass, replace
from typing import Any, TypeVar

Settings = TypeVar("Settings")


def physical(default: Any, reason: str) -> Any:
    """Declare a constant that follows from the size or the nature of things."""
    return _declared("physical", default, reason)


def statistical(default: Any, reason: str) -> Any:
    """Declare a constant that follows from a distribution and a probability."""
    return _declared("statistical", default, reason)


def judged(default: Any, reason: str) -> Any:
    """Declare a constant that was chosen by looking at results."""
    return _declared("judged", default, reason)


def _declared(kind: str, default: Any, reason: str) -> Any:
    return field(default=default, metadata={"kind": kind, "reason": reason})


@dataclass(frozen=True)
class Constant:
    """A constant as it stands in the settings of a chapter.

    Attributes
    ----------
    path : tuple of str
        Names of the stages that lead to it, and its own.
    value : object
    kind : str
        physical, statistical or judged.
    reason : str
    """

    path: tuple[str, ...]
    value: Any
    kind: str
    reason: str


def constants(settings: Any) -> Iterator[Constant]:
    """Yield the constants of settings and of the stages within, in the order of their declaration."""
    for item in fields(settings):
        value = getattr(settings, item.name)
        if is_dataclass(value):
            for inner in constants(value):
                yield replace(inner, path=(item.name, *inner.path))
        elif "kind" in item.metadata:
            yield Constant((item.name,), value, item.metadata["kind"], item.metadata["reason"])


def with_constant(settings: Settings, path: tuple[str, ...], value: Any) -> Settings:
    """Return the settings with another value for the constant at a path."""
    first, *rest = path
    inner = with_constant(getattr(settings, first), tuple(rest), value) if rest else value
    return replace(settings, **{first: inner})  # type: ignore[type-var]
