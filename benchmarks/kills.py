"""Runs that are killed while they write: what the next run finds.

make kills, or: python3 -m ichnograph.benchmarks.kills [--random 50]

A process writes transformations, residuals, control points and the report of a registration over older ones.
It is killed at each of its operations on file names (renames, removals, new folders), and at random moments.
Then the folder is recovered as the next run does it, and must hold all outputs of one run.
"""

import argparse
import os
import shutil
import signal
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
from ichnograph.algorithms.files import Outputs
from ichnograph.algorithms.registration.output.layers import write_control, write_residuals
from ichnograph.algorithms.registration.output.report import write_report
from ichnograph.algorithms.registration.output.transforms import write_transforms
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.results import Registration
from ichnograph.algorithms.registration.settings import Settings
from ichnograph.algorithms.staging import SUFFIX, recover
from ichnograph.tests.scenes.targets import target_scene

WRITERS = {
    "transforms.json": write_transforms,
    "residuals.shp": write_residuals,
    "control.gpkg": write_control,
    "control.shp": write_control,
    "reports/report.html": write_report,
}
RENAME = ("os.rename",)
OPERATIONS = (*RENAME, "os.remove", "os.rmdir", "os.mkdir")
KILLED = 9
LONG_AGO_S = 3600.0


def registration(seed: int) -> Registration:
    """Return the registration of a simulated scan."""
    scene = target_scene(12, 9, 8, seed=seed)
    return register_scans(scene.control, [scene.targets], Settings())


def write(result: Registration, folder: Path) -> None:
    """Write all outputs, as a run of the provider does."""
    with Outputs() as outputs:
        for name, writer in WRITERS.items():
            with outputs.staged(folder / name) as temporary:
                writer(result, temporary)


def killed_write(result: Registration, folder: Path, kinds: tuple[str, ...], last: int) -> bool:
    """Write in a process that dies before its operation number `last`; return whether it did."""
    process = os.fork()
    if not process:
        done = Counter[str]()

        def hook(event: str, arguments: tuple[Any, ...]) -> None:
            if event in kinds and SUFFIX in " ".join(map(str, arguments)):
                done["all"] += 1
                if done["all"] == last:
                    os._exit(KILLED)

        sys.addaudithook(hook)
        write(result, folder)
        os._exit(0)
    _, status = os.waitpid(process, 0)
    return os.WEXITSTATUS(status) == KILLED


def write_killed_after(result: Registration, folder: Path, seconds: float) -> bool:
    """Write in a process that is killed after some time; return whether it was."""
    process = os.fork()
    if not process:
        write(result, folder)
        os._exit(0)
    time.sleep(seconds)
    os.kill(process, signal.SIGKILL)
    _, status = os.waitpid(process, 0)
    return os.WIFSIGNALED(status)


def contents(folder: Path) -> dict[str, bytes]:
    """Return all files by their names."""
    files = (path for path in folder.rglob("*") if path.is_file())
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


def recovered(folder: Path) -> dict[str, bytes]:
    """Return the files after the next run, an hour later."""
    for stage in folder.rglob(f".*{SUFFIX}"):
        os.utime(stage, (time.time() - LONG_AGO_S,) * 2)
    recover(folder)
    recover(folder / "reports")
    return contents(folder)


class Trials:
    """Runs over the same older outputs, and what they left."""

    def __init__(self, folder: Path) -> None:
        self.older, self.newer = registration(1), registration(2)
        self._folder = folder / "outputs"
        self._before = self._written(self.older)
        self._after = self._written(self.newer)
        if self._before == self._written(self.newer) or self._after != self._written(self.newer):
            raise SystemExit("The outputs of a run are not the same twice.")

    def fresh(self) -> Path:
        """Return the folder with the older outputs."""
        self._written(self.older)
        return self._folder

    def outcome(self) -> str:
        """Return what the folder holds after the next run: old, new, or a mix (of both, or with litter)."""
        whole = contents(self._folder) in (self._before, self._after)
        left = recovered(self._folder)
        if left not in (self._before, self._after):
            return "mix"
        state = "old" if left == self._before else "new"
        return state if whole else f"{state}, mended"

    def _written(self, result: Registration) -> dict[str, bytes]:
        shutil.rmtree(self._folder, ignore_errors=True)
        (self._folder / "reports").mkdir(parents=True)
        write(result, self._folder)
        return contents(self._folder)


def at_each(trials: Trials, kinds: tuple[str, ...]) -> Counter[str]:
    """Return the outcomes of kills at each operation."""
    outcomes: Counter[str] = Counter()
    last = 1
    while killed_write(trials.newer, trials.fresh(), kinds, last):
        outcomes[trials.outcome()] += 1
        last += 1
    return outcomes


def at_random(trials: Trials, count: int) -> Counter[str]:
    """Return the outcomes of kills at random moments."""
    start = time.perf_counter()
    trials.fresh()
    whole = time.perf_counter() - start
    outcomes: Counter[str] = Counter()
    for seconds in np.random.default_rng(0).uniform(0, whole, count):
        folder = trials.fresh()
        write_killed_after(trials.newer, folder, seconds)
        outcomes[trials.outcome()] += 1
    return outcomes


def main() -> None:
    """Print the outcomes."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--random", type=int, default=50, help="kills at random moments")
    arguments = parser.parse_args()
    print("| killed | runs | all old | all new | mended by the next run | mixes or litter |")
    print("|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        trials = Trials(Path(folder))
        for title, outcomes in (
            ("at each rename", at_each(trials, RENAME)),
            ("at each operation on file names", at_each(trials, OPERATIONS)),
            ("at random moments", at_random(trials, arguments.random)),
        ):
            count = {
                word: sum(n for each, n in outcomes.items() if word in each)
                for word in ("old", "new", "mended", "mix")
            }
            print(f"| {title} | {sum(outcomes.values())} | {' | '.join(map(str, count.values()))} |")


if __name__ == "__main__":
    main()
