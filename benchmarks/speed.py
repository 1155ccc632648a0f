"""Clouds at the speed of reading them: every ratio to bare decoding, beside other tools, in one run.

make benchmark, or: python3 -m ichnograph.benchmarks.speed [--points 10000000] [--runs 3] [--stages]

Bare decoding is laspy with lazrs on all cores. Every task runs in a process of its own, in turn, after a
first round that compiles the kernels. Seconds are without imports. Ratios are of one round: of elapsed
seconds, and of processor seconds, which other work on the computer changes less. --copies reads the scan
several times over, as so many files of one site, to see what grows with the points alone. `make peers`
installs open3d and datashader; PDAL is used if it is installed.
"""

import argparse
import json
import os
import resource
import shutil
import statistics
import subprocess
import sys
import time
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Callable, Optional

import laspy
import numpy as np
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.clouds.thinning.thinning import thin_cloud
from ichnograph.algorithms.clouds.writing.point_selection import write_cloud
from ichnograph.algorithms.clouds.writing.transformation import transform_cloud
from ichnograph.algorithms.progress import Progress
from ichnograph.algorithms.site_plan.density.density_image import density_image
from ichnograph.algorithms.site_plan.site_plan import make_site_plan
from ichnograph.tests.scenes import SCENES
from ichnograph.tests.scenes.__main__ import write_laz

from .layers import write_layers

PEAK_UNIT = 1 if sys.platform == "darwin" else 1024
"""Bytes in the unit of the operating system's peak memory."""

CHUNK = 1_000_000

WARM_UP = 300_000
"""Points of the first round, which compiles the kernels."""

SPACING, PIXEL = 0.05, 0.10
"""The defaults of `thincloud` and `densityimage`, metres."""

MATRIX = np.array([[0.6, -0.8, 0.0, 10.0], [0.8, 0.6, 0.0, 20.0], [0.0, 0.0, 1.0, 1.0], [0.0, 0.0, 0.0, 1.0]])

Report = Callable[[float, str], None]


def _ignored(fraction: float, message: str) -> None:
    pass


def make_scan(path: Path, points: int) -> None:
    """Write a simulated interior with exactly `points` points."""
    scan = SCENES["interior"](0).scan(angular_step=0.2 * (10_000_000 / points) ** 0.5)
    if len(scan.points) < points:
        raise SystemExit(f"The scan has only {len(scan.points)} points.")
    chosen = np.sort(np.random.default_rng(0).permutation(len(scan.points))[:points])
    write_laz(path, scan, chosen, "EPSG:25833")


def decode(paths: Sequence[Path], report: Report) -> None:
    """Decode the files, a million points at a time."""
    for path in paths:
        with laspy.open(path) as reader:
            for _ in reader.chunk_iterator(CHUNK):
                pass


def siteplan(paths: Sequence[Path], report: Report) -> None:
    """Make the plan with all defaults, and write its rasters and walls."""
    plan = make_site_plan(open_cloud(paths), progress=Progress(report))
    report(1.0, "Writing")
    write_layers(plan, paths[0].parent, "speed")


def densityimage(paths: Sequence[Path], report: Report) -> None:
    """Compute the density image."""
    density_image(open_cloud(paths), SPACING, PIXEL, progress=Progress(report))


def thincloud(paths: Sequence[Path], report: Report) -> None:
    """Thin the cloud, and write it as LAZ."""
    cloud = open_cloud(paths)
    kept = thin_cloud(cloud, SPACING, Progress(report)).kept
    report(1.0, "Writing")
    write_cloud(cloud, kept, paths[0].parent / "thinned.laz")


def transformcloud(paths: Sequence[Path], report: Report) -> None:
    """Move each file, and write it as LAZ."""
    for source in open_cloud(paths).sources:
        target = source.path.with_name(f"moved_{source.path.name}")
        transform_cloud(source, MATRIX, target, progress=Progress(report))
        target.unlink()


def _positions(paths: Sequence[Path]) -> np.ndarray:
    parts = [laspy.read(path) for path in paths]
    return np.concatenate([np.column_stack([part.x, part.y, part.z]) for part in parts])


def numpy_histogram(paths: Sequence[Path], report: Report) -> None:
    """Count points by pixel with numpy, a chunk at a time, in the extent of the headers."""
    headers = [laspy.open(path).header for path in paths]
    low, high = np.min([h.mins for h in headers], axis=0), np.max([h.maxs for h in headers], axis=0)
    edges = [np.arange(low[axis], high[axis] + PIXEL, PIXEL) for axis in (0, 1)]
    counts = np.zeros([len(edge) - 1 for edge in edges])
    for path in paths:
        with laspy.open(path) as reader:
            for chunk in reader.chunk_iterator(CHUNK):
                counts += np.histogram2d(chunk.x, chunk.y, bins=edges)[0]


def datashader_canvas(paths: Sequence[Path], report: Report) -> None:
    """Count points by pixel with datashader."""
    import datashader
    import pandas

    xyz = _positions(paths)
    width, height = np.ceil(np.ptp(xyz[:, :2], axis=0) / PIXEL).astype(int).tolist()
    canvas = datashader.Canvas(plot_width=width, plot_height=height)
    canvas.points(pandas.DataFrame({"x": xyz[:, 0], "y": xyz[:, 1]}), "x", "y")


def open3d_voxels(paths: Sequence[Path], report: Report) -> None:
    """Keep one point, the mean, in each cube of SPACING; write nothing, because open3d has no LAZ."""
    import open3d

    cloud = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(_positions(paths)))
    cloud.voxel_down_sample(SPACING)


def pdal_sample(paths: Sequence[Path], report: Report) -> None:
    """Thin to a minimum distance with PDAL, and write it as LAZ."""
    steps = [*map(str, paths), {"type": "filters.merge"}, {"type": "filters.sample", "radius": SPACING}]
    steps.append(
        {"type": "writers.las", "filename": str(paths[0].parent / "pdal.laz"), "compression": "true"}
    )
    subprocess.run(["pdal", "pipeline", "--stdin"], input=json.dumps(steps), text=True, check=True)


Task = Callable[[Sequence[Path], Report], None]
OURS: dict[str, Task] = {
    "decode": decode,
    "densityimage": densityimage,
    "thincloud": thincloud,
    "transformcloud": transformcloud,
    "siteplan": siteplan,
}
PEERS: dict[str, tuple[Task, bool]] = {
    "numpy histogram2d": (numpy_histogram, True),
    "datashader points": (datashader_canvas, find_spec("datashader") is not None),
    "open3d voxels": (open3d_voxels, find_spec("open3d") is not None),
    "PDAL filters.sample": (pdal_sample, shutil.which("pdal") is not None),
}
TASKS = {**OURS, **{name: task for name, (task, _) in PEERS.items()}}


class Stages:
    """Elapsed and processor seconds by the messages of a run."""

    def __init__(self) -> None:
        self.seconds: dict[str, list[float]] = {}
        self._stage, self._since = "Opening", _now()

    def report(self, fraction: float, message: str) -> None:
        """Begin the stage that a message names; thresholds are one."""
        if message:
            now = _now()
            spent = self.seconds.setdefault(self._stage, [0.0, 0.0])
            for k in range(2):
                spent[k] += now[k] - self._since[k]
            self._stage, self._since = (
                message.split(" 0")[0].split(" interior")[0].rstrip("0123456789. "),
                now,
            )


def _now() -> tuple[float, float]:
    """Return elapsed seconds, and those of all cores, of this process and of those it ran."""
    own, others = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return time.perf_counter(), own.ru_utime + own.ru_stime + others.ru_utime + others.ru_stime


def run_task(task: str, paths: Sequence[Path]) -> None:
    """Do one task here, and print what it took."""
    stages, started = Stages(), _now()
    TASKS[task](paths, stages.report)
    stages.report(1.0, "End")
    elapsed, processor = (stop - start for start, stop in zip(started, _now()))
    peak = max(resource.getrusage(who).ru_maxrss for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    print(
        json.dumps(
            {
                "elapsed": elapsed,
                "processor": processor,
                "start": started[1],
                "megabytes": peak * PEAK_UNIT / 1e6,
                "stages": stages.seconds,
            }
        )
    )


def timed(task: str, paths: Sequence[Path]) -> dict[str, Any]:
    """Run a task in a process of its own; return its seconds without imports, and its peak memory."""
    command = [sys.executable, "-m", "ichnograph.benchmarks.speed", "--task", task, *map(str, paths)]
    # What a tool says is not of interest; the last line is ours.
    output = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return json.loads(output.splitlines()[-1])


def copies_of(path: Path, count: int) -> list[Path]:
    """Return a scan and copies of it, as so many files."""
    copies = [path.with_name(f"{path.stem}_{number}{path.suffix}") for number in range(1, count)]
    for copy in copies:
        shutil.copyfile(path, copy)
    return [path, *copies]


def main() -> None:
    """Print medians and ratios."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--points", type=int, default=10_000_000)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--copies", type=int, default=1)
    parser.add_argument("--only", nargs="*", help="tasks beside decode; all without it")
    parser.add_argument("--stages", action="store_true", help="print the shares of the stages")
    parser.add_argument("--task", choices=sorted(TASKS), help=argparse.SUPPRESS)
    parser.add_argument("files", type=Path, nargs="*", help="a scan other than the simulated one")
    arguments = parser.parse_args()
    if arguments.task:
        run_task(arguments.task, arguments.files)
        return
    paths = arguments.files or copies_of(_scan(arguments.points), arguments.copies)
    points = sum(source.expected_points for source in open_cloud(paths).sources)
    available = [*OURS, *(name for name, (_, is_there) in PEERS.items() if is_there)]
    names = [
        name
        for name in available
        if name == "decode" or arguments.only in (None, []) or name in arguments.only
    ]
    for name in names:
        timed(name, [_scan(WARM_UP)])
    rounds = [{name: timed(name, paths) for name in names} for _ in range(arguments.runs)]
    files, cores = f"{points:,} points in {len(paths)} file(s)", f"{os.cpu_count()} cores"
    print(f"{files}, medians of {arguments.runs} round(s), {cores}\n")
    _print_table(names, rounds, points)
    missing = [name for name, (_, is_there) in PEERS.items() if not is_there]
    print(f"\nNot installed: {', '.join(missing) or 'nothing'}.")
    if arguments.stages:
        for name in OURS:
            if name in names[1:]:
                _print_stages(name, rounds)


def _scan(points: int) -> Path:
    """Return the simulated scan of so many points, made once, in a process of its own."""
    path = Path(f"build/speed/interior_{points}.laz")
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        make = f"from ichnograph.benchmarks.speed import *; make_scan(Path({str(path)!r}), {points})"
        subprocess.run([sys.executable, "-c", make], check=True)
    return path


def _print_table(names: list[str], rounds: list[dict[str, dict[str, Any]]], points: int) -> None:
    print("| task | s | of decoding | processor s | of decoding | million points/s | peak MB | start s |")
    print("|---|---|---|---|---|---|---|---|")
    for name in names:

        def median(key: str, base: Optional[str] = None, name: str = name) -> float:
            return statistics.median(one[name][key] / (one[base][key] if base else 1) for one in rounds)

        elapsed, processor = median("elapsed"), median("processor")
        print(
            f"| {name} | {elapsed:.2f} | {median('elapsed', 'decode'):.1f} "
            f"| {processor:.2f} | {median('processor', 'decode'):.1f} | {points / 1e6 / elapsed:.2f} "
            f"| {median('megabytes'):.0f} | {median('start'):.1f} |"
        )


def _print_stages(name: str, rounds: list[dict[str, dict[str, Any]]]) -> None:
    """Print the shares of the stages in the processor seconds of the last round."""
    stages = rounds[-1][name]["stages"]
    total = sum(processor for _, processor in stages.values())
    print(f"\n| {name} | share of processor | processor s | cores in use |")
    print("|---|---|---|---|")
    for stage, (elapsed, processor) in stages.items():
        print(
            f"| {stage} | {processor / total:.0%} | {processor:.2f} | {processor / max(elapsed, 1e-9):.1f} |"
        )


if __name__ == "__main__":
    main()
