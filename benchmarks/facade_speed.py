"""Time and memory of a facade of a million points, by stage, compared with only decoding its file.

make facade-speed, or: python3 -m ichnograph.benchmarks.facade_speed [--points 1000000]
[--facade townhouse terrace] [--profile]

The terrace has rooms behind its windows. Each facade is measured in a process of its own; the
kernels must have been compiled by a run before. With --profile, also prints where the CPU time goes.
"""

import argparse
import cProfile
import json
import pstats
import resource
import subprocess
import sys
import time
from pathlib import Path

import laspy
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.facade.measurement import measure_facade
from ichnograph.algorithms.facade.planes.segmentation import find_planes
from ichnograph.algorithms.facade.points import read_points
from ichnograph.algorithms.facade.selection import select_facade
from ichnograph.algorithms.facade.settings import FacadeSettings
from ichnograph.tests.scenes.facades.__main__ import ALL, write_laz

from .facade import PLACE
from .speed import PEAK_UNIT

COARSE = 0.04
"""Spacing of a first scan, from which that of a scan with so many points follows (m)."""

STAGES = ("decode", "read", "facades", "planes", "measure")
FUNCTIONS = 40


def make_scan(path: Path, name: str, points: int) -> None:
    """Write a simulated facade with about so many points."""
    scene = ALL[name](0).moved(*PLACE)
    share = len(scene.scan(COARSE).points) / points
    write_laz(path, scene.scan(COARSE * share**0.5))


def measure(path: Path, profile: bool) -> dict[str, float]:
    """Run the stages; return the CPU seconds of each, the seconds of the whole, and its peak memory.

    The planes are found once more within the last stage, which the whole does not count twice.
    """
    settings, profiler = FacadeSettings(), cProfile.Profile(time.process_time)
    clocks = [time.process_time()]
    with laspy.open(path) as reader:
        number = sum(len(chunk.x) for chunk in reader.chunk_iterator(1_000_000))
    clocks.append(time.process_time())
    started = time.perf_counter()
    points = read_points(open_cloud([path]))
    clocks.append(time.process_time())
    selection = select_facade(points, settings)
    clocks.append(time.process_time())
    apart = time.perf_counter()
    find_planes(selection.points, settings.distance_m, settings.planes, wanted=selection.plane)
    started += time.perf_counter() - apart
    clocks.append(time.process_time())
    if profile:
        profiler.enable()
    measure_facade(selection.points, settings, wanted=selection.plane)
    profiler.disable()
    clocks.append(time.process_time())
    if profile:
        pstats.Stats(profiler, stream=sys.stderr).sort_stats("cumtime").print_stats(FUNCTIONS)
    found = {stage: after - before for stage, before, after in zip(STAGES, clocks, clocks[1:])}
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * PEAK_UNIT / 1e9
    return {**found, "points": number, "seconds": time.perf_counter() - started, "gigabytes": peak}


def _row(name: str, found: dict[str, float]) -> str:
    whole = found["read"] + found["facades"] + found["measure"]
    seconds = " | ".join(f"{found[stage]:.1f}" for stage in STAGES)
    return (
        f"| {name} | {found['points']:.0f} | {seconds} | {whole:.1f} | {whole / found['decode']:.0f} "
        f"| {found['seconds']:.1f} | {found['gigabytes']:.2f} |"
    )


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--points", type=int, default=1_000_000)
    parser.add_argument("--facade", nargs="+", choices=sorted(ALL), default=["townhouse", "terrace"])
    parser.add_argument("--profile", action="store_true", help="also print the functions that take longest")
    parser.add_argument("--folder", type=Path, default=Path("build/facade_speed"))
    parser.add_argument("--task", type=Path, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.task:
        print(json.dumps(measure(arguments.task, arguments.profile)))
        return
    arguments.folder.mkdir(parents=True, exist_ok=True)
    stages = " | ".join(f"{stage} (CPU s)" for stage in STAGES)
    print(f"| facade | points | {stages} | whole (CPU s) | whole / decode | whole (s) | peak (GB) |")
    print("|---" * (len(STAGES) + 6) + "|")
    for name in arguments.facade:
        path = arguments.folder / f"{name}_{arguments.points}.laz"
        if not path.exists():
            make_scan(path, name, arguments.points)
        command = [sys.executable, "-m", "ichnograph.benchmarks.facade_speed", "--task", str(path)]
        command += ["--profile"] if arguments.profile else []
        found = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
        print(_row(name, json.loads(found)), flush=True)


if __name__ == "__main__":
    main()
