"""The tests that a candidate must pass, in their order."""

from typing import Optional, TypeVar

import numpy as np

from .results import Kind, Rejection

Value = TypeVar("Value")


class FailedError(Exception):
    """A candidate failed a test.

    Parameters
    ----------
    rejection : Rejection
    """

    def __init__(self, rejection: Rejection) -> None:
        super().__init__(rejection.test)
        self.rejection = rejection


class Examination:
    """Compares values with their limits, and counts the tests that are passed.

    Parameters
    ----------
    kind : Kind
    xyz : ndarray, shape (3,)
        Where the candidate is, relative to the scanner.
    """

    def __init__(self, kind: Kind, xyz: np.ndarray) -> None:
        self.kind = kind
        self.xyz = xyz
        self.passed = 0

    def at_least(self, test: str, value: float, limit: float, unit: str = "") -> None:
        """Raise FailedError if a value is below its limit or unknown."""
        self._count(value >= limit, test, value, limit, unit)

    def at_most(self, test: str, value: float, limit: float, unit: str = "") -> None:
        """Raise FailedError if a value is above its limit or unknown."""
        self._count(value <= limit, test, value, limit, unit)

    def found(self, test: str, value: Optional[Value]) -> Value:
        """Return a value, or raise FailedError if there is none."""
        if value is None:
            raise FailedError(Rejection(self.kind, self.xyz, test, self.passed, 0.0, 1.0))
        self.passed += 1
        return value

    def _count(self, passes: bool, test: str, value: float, limit: float, unit: str) -> None:
        if not passes:
            raise FailedError(
                Rejection(self.kind, self.xyz, test, self.passed, float(value), float(limit), unit)
            )
        self.passed += 1
