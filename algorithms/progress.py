"""Progress: the core reports how far it is, and asks whether it is cancelled."""

from dataclasses import dataclass
from typing import Callable

from .errors import CancelledError


def _ignore(fraction: float, message: str) -> None:
    pass


def _never() -> bool:
    return False


@dataclass(frozen=True)
class Progress:
    """Two callables of the caller, and the part of the whole task that they are about.

    Parameters
    ----------
    report : callable(float, str)
        Takes the fraction done, 0..1, and a message that may be empty.
    is_cancelled : callable() -> bool
        Asked at every update.
    start, stop : float
        The part of 0..1 that this object covers.
    """

    report: Callable[[float, str], None] = _ignore
    is_cancelled: Callable[[], bool] = _never
    start: float = 0.0
    stop: float = 1.0

    def check(self) -> None:
        """Ask whether to stop, without a report; for loops whose length is not known beforehand.

        Raises
        ------
        CancelledError
            If the caller asked to stop.
        """
        if self.is_cancelled():
            raise CancelledError("Cancelled.")

    def update(self, fraction: float, message: str = "") -> None:
        """Report `fraction` (0..1) of this part.

        Raises
        ------
        CancelledError
            If the caller asked to stop.
        """
        self.check()
        share = min(max(fraction, 0.0), 1.0)
        self.report(self.start + share * (self.stop - self.start), message)

    def part(self, start: float, stop: float) -> "Progress":
        """Return the progress of a step that takes from `start` to `stop` of this part."""
        width = self.stop - self.start
        return Progress(
            self.report,
            self.is_cancelled,
            self.start + start * width,
            self.start + stop * width,
        )
