"""Memory and open files over many runs of every algorithm in one process.

make leaks, or: python3 -m ichnograph.benchmarks.leaks [--runs 200] [--points 20000] [--only thincloud]

The first tenth of the runs is not counted. Growth is printed of both halves of the others: what is lost at
every run grows as much in the second half, a cache that fills up does not. E57 files are opened as often too.
"""

import argparse
import gc
import os
import tempfile
from functools import partial
from pathlib import Path
from typing import Callable

from ichnograph.algorithms.clouds.cloud import open_cloud

from .provider_runs import ProviderRuns

MEGABYTE = 2**20


def memory() -> float:
    """Return the resident memory of this process, MB; of Linux."""
    gc.collect()
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / MEGABYTE


def handles() -> int:
    """Return the number of open files of this process; of Linux."""
    return len(list(Path("/proc/self/fd").iterdir()))


def row(name: str, run: Callable[[], object], runs: int) -> str:
    """Return the row of an algorithm."""
    for _ in range(max(runs // 10, 1)):
        run()
    files, memories = handles(), [memory()]
    for _ in range(2):
        for _ in range(runs // 2):
            run()
        memories.append(memory())
    before, half, after = memories
    return (
        f"| {name} | {runs} | {before:.0f} | {half - before:+.1f} | {after - half:+.1f} | "
        f"{2000 * (after - half) / runs:+.0f} | {handles() - files:+d} |"
    )


def main() -> None:
    """Print a row for every algorithm."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--runs", type=int, default=200)
    parser.add_argument("--points", type=int, help="of each cloud; without, a small room and facade")
    parser.add_argument("--only", nargs="*", help="names of algorithms")
    parser.add_argument("--e57", type=Path, help="a file to open as often")
    arguments = parser.parse_args()
    print(
        "| algorithm | runs | memory (MB) | 1st half (MB) | 2nd half (MB) | a run of it (kB) | open files |"
    )
    print("|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        runs = ProviderRuns(Path(folder), arguments.points)
        for name in runs.needed_for(arguments.only):
            # The inputs of some are the outputs of others.
            runs.run(name)
            if not arguments.only or name in arguments.only:
                print(row(name, partial(runs.run, name), arguments.runs), flush=True)
    if arguments.e57:
        print(row("opening E57", partial(open_cloud, [arguments.e57]), arguments.runs))


if __name__ == "__main__":
    main()
