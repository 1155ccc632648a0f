"""How long a cancel takes, and how long the progress stands still, for every algorithm.

make cancel, or: python3 -m ichnograph.benchmarks.cancel [--points 1000000] [--cancels 10] [--only siteplan]

Every algorithm runs to the end, as QGIS runs it, and then again and again; each of these runs is cancelled at
another moment. The latency is the time from the cancel to the end of the run. Where other programs keep the
machine busy, --cpu counts the seconds of the processor for runs and progress; latencies are always real time.
"""

import argparse
import math
import statistics
import tempfile
import threading
import time
from contextlib import suppress
from pathlib import Path
from typing import Any, Callable

from .provider_runs import ProviderRuns


def feedback_of(moves: list[float], clock: Callable[[], float] = time.monotonic) -> Any:
    """Return a feedback that notes the times at which its progress or its text changes."""
    from qgis.core import QgsProcessingFeedback

    class Noting(QgsProcessingFeedback):  # type: ignore[misc,unused-ignore]
        shown: tuple[Any, ...] = ()

        def setProgress(self, progress: float) -> None:  # noqa: N802 - QGIS names it
            self._note(("progress", progress))

        def setProgressText(self, text: str) -> None:  # noqa: N802 - QGIS names it
            self._note(("text", text))

        def _note(self, shown: tuple[Any, ...]) -> None:
            if shown != self.shown:
                self.shown = shown
                moves.append(clock())

    return Noting(False)


def whole_run(
    runs: ProviderRuns, name: str, clock: Callable[[], float] = time.monotonic
) -> tuple[float, float]:
    """Return the seconds of a run, and the longest time without progress."""
    from qgis.core import QgsProcessingException

    start = clock()
    moves = [start]
    # The searches end in a refusal, which is a result here.
    with suppress(QgsProcessingException):
        runs.run(name, feedback_of(moves, clock))
    moves.append(clock())
    return moves[-1] - start, max(after - before for before, after in zip(moves, moves[1:]))


def latency(runs: ProviderRuns, name: str, moment: float) -> float:
    """Return how long a run continues after it is cancelled at a moment; nan if it ends before."""
    from qgis.core import QgsProcessingException

    feedback, cancelled = feedback_of([]), []

    def cancel() -> None:
        cancelled.append(time.monotonic())
        feedback.cancel()

    timer = threading.Timer(moment, cancel)
    timer.start()
    with suppress(QgsProcessingException):
        runs.run(name, feedback)
    end = time.monotonic()
    timer.cancel()
    return end - cancelled[0] if cancelled and cancelled[0] < end else float("nan")


def row(runs: ProviderRuns, name: str, cancels: int, cpu: bool) -> str:
    """Return the row of an algorithm."""
    start = time.monotonic()
    seconds, still = whole_run(runs, name, time.process_time if cpu else time.monotonic)
    elapsed = time.monotonic() - start
    moments = [(number + 0.5) / cancels * elapsed for number in range(cancels)]
    found = [each for each in (latency(runs, name, moment) for moment in moments) if not math.isnan(each)]
    median, worst = (statistics.median(found), max(found)) if found else (math.nan, math.nan)
    return f"| {name} | {seconds:.1f} | {still:.1f} | {median:.2f} | {worst:.2f} | {len(found)} |"


def main() -> None:
    """Print a row for every algorithm."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--points", type=int, default=1_000_000)
    parser.add_argument("--cancels", type=int, default=10)
    parser.add_argument("--only", nargs="*", help="names of algorithms")
    parser.add_argument("--cpu", action="store_true", help="count seconds of the processor")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        runs = ProviderRuns(Path(folder), arguments.points)
        runs.harder_searches()
        print("| algorithm | run (s) | without progress (s) | cancel: median (s) | worst (s) | cancels |")
        print("|---|---|---|---|---|---|")
        for name in runs.needed_for(arguments.only):
            # The inputs of some are the outputs of others; and the first run compiles and imports.
            whole_run(runs, name)
            if not arguments.only or name in arguments.only:
                print(row(runs, name, arguments.cancels, arguments.cpu), flush=True)


if __name__ == "__main__":
    main()
