"""Which kinds of bad input were tried with each parameter that is a file, and how many are refused.

make refusals, or: python3 -m ichnograph.benchmarks.refusals

The cases are those of tests/processing_provider/test_refusals.py: refused is an input that ends the run in
one sentence, with older outputs as they were.
"""

from collections import Counter, defaultdict
from pathlib import Path
from typing import Any

import pytest

TESTS = Path(__file__).parents[1] / "tests" / "processing_provider" / "test_refusals.py"


class Outcomes:
    """A plugin of pytest that notes the outcome of each case by algorithm and parameter."""

    def __init__(self) -> None:
        self.counts: dict[tuple[str, str], Counter[str]] = defaultdict(Counter)
        self._tried: dict[tuple[str, str], list[str]] = defaultdict(list)

    def pytest_runtest_makereport(self, item: Any, call: Any) -> None:
        """Note a case that ran; one whose package is not installed is skipped."""
        case = getattr(item, "callspec", None)
        if call.when != "call" or case is None:
            return
        key = case.params["algorithm"], case.params["parameter"]
        self._tried[key].append(case.params["kind"])
        skipped = call.excinfo is not None and call.excinfo.typename == "Skipped"
        self.counts[key]["skipped" if skipped else "failed" if call.excinfo else "refused"] += 1

    def families(self) -> dict[tuple[str, ...], list[str]]:
        """Return the parameters by the kinds that were tried with them."""
        found: dict[tuple[str, ...], list[str]] = defaultdict(list)
        for (algorithm, parameter), kinds in self._tried.items():
            found[tuple(kinds)].append(f"`{algorithm}` {parameter}")
        return found


def main() -> None:
    """Print a row for each parameter, and the kinds."""
    outcomes = Outcomes()
    pytest.main(
        [str(TESTS), "-qq", "--no-header", "--no-summary", "-p", "no:cacheprovider"], plugins=[outcomes]
    )
    print("\n| algorithm | parameter | kinds | refused |")
    print("|---|---|---|---|")
    for (algorithm, parameter), count in outcomes.counts.items():
        print(f"| {algorithm} | {parameter} | {sum(count.values())} | {count['refused']} |")
    for kinds, parameters in outcomes.families().items():
        print(f"\n{', '.join(parameters)}: {', '.join(kinds)}.")


if __name__ == "__main__":
    main()
