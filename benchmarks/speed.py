"""Ten million LAZ points to walls: seconds, peak memory, and the ratio to only decoding the file.

make benchmark, or: python3 -m ichnograph.benchmarks.speed [--points 10000000] [--runs 3]

Both are timed in processes of their own, in turn, after a first round that compiles the kernels.
"""

import argparse
import json
import resource
import statistics
import subprocess
import sys
import time
from pathlib import Path

import laspy
import numpy as np
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.site_plan.site_plan import make_site_plan
from ichnograph.tests.scenes import SCENES
from ichnograph.tests.scenes.__main__ import write_laz

from .layers import write_layers

PEAK_UNIT = 1 if sys.platform == "darwin" else 1024
"""Bytes in the unit of the operating system's peak memory."""


def make_scan(path: Path, points: int) -> int:
    """Write a simulated interior with exactly `points` points."""
    scan = SCENES["interior"](0).scan(angular_step=0.2 * (10_000_000 / points) ** 0.5)
    if len(scan.points) < points:
        raise SystemExit(f"The scan has only {len(scan.points)} points.")
    chosen = np.sort(np.random.default_rng(0).permutation(len(scan.points))[:points])
    write_laz(path, scan, chosen, "EPSG:25833")
    return points


def decode(path: Path, points: int) -> int:
    """Decode the file with laspy, a million points at a time."""
    with laspy.open(path) as reader:
        return sum(len(chunk.x) for chunk in reader.chunk_iterator(1_000_000))


def chain(path: Path, points: int) -> int:
    """Run the whole chain with its defaults."""
    plan = make_site_plan(open_cloud([path]))
    write_layers(plan, path.parent, "speed")
    return len(plan.walls)


TASKS = {"make_scan": make_scan, "decode": decode, "chain": chain}
TIMED = ("decode", "chain")


def timed(task: str, path: Path, points: int) -> dict[str, float]:
    """Run a task in a process of its own; return its seconds without imports, and its peak memory."""
    command = [sys.executable, "-m", "ichnograph.benchmarks.speed", "--task", task]
    command += ["--file", str(path), "--points", str(points)]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def run_task(task: str, path: Path, points: int) -> None:
    """Do one task here, and print what it took."""
    started = time.perf_counter()
    result = TASKS[task](path, points)
    seconds = time.perf_counter() - started
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * PEAK_UNIT / 1e6
    print(json.dumps({"result": result, "seconds": seconds, "megabytes": peak}))


def main() -> None:
    """Print medians and the ratio."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--points", type=int, default=10_000_000)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--file", type=Path, default=Path("build/speed/interior.laz"))
    parser.add_argument("--task", choices=sorted(TASKS), help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.task:
        run_task(arguments.task, arguments.file, arguments.points)
        return
    arguments.file.parent.mkdir(parents=True, exist_ok=True)
    # In a process of its own as well: a child's peak memory is at least its parent's.
    timed("make_scan", arguments.file, arguments.points)
    rounds = [
        {task: timed(task, arguments.file, arguments.points) for task in TIMED}
        for _ in range(arguments.runs + 1)
    ][1:]
    print(f"{arguments.points:,} points, {arguments.runs} rounds, medians")
    for task in TIMED:
        seconds = statistics.median(r[task]["seconds"] for r in rounds)
        peak = statistics.median(r[task]["megabytes"] for r in rounds)
        print(f"{task:7s} {seconds:6.2f} s  {peak:6.0f} MB")
    ratio = statistics.median(r["chain"]["seconds"] / r["decode"]["seconds"] for r in rounds)
    print(f"ratio chain / decode: {ratio:.2f}")


if __name__ == "__main__":
    main()
