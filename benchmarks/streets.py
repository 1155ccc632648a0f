"""How well openings are found and measured in simulated streets.

make streets, or: python3 -m ichnograph.benchmarks.streets [--spacing 0.005 0.01 0.02] [--seeds 3]
[--street bay] [--cut rooms] [--sides] [--plain]

Prints, by kind of street and spacing of the points: openings found, missed and invented; the facades drawn
from outside; how many widths and heights were measured of those whose two edges a station saw; their errors,
and how many of them are within two standard deviations. Range noise is 2 to 5 mm, other for each street.
Towers are rolled out. With --pictures, draws each street to build/streets.
"""

import argparse
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from ichnograph.algorithms.errors import NothingFoundError
from ichnograph.algorithms.facade.development.development import FLAT, ROUND, SIDES
from ichnograph.algorithms.facade.every_facade import DrawnFacade, measure_selection
from ichnograph.algorithms.facade.selection import select_facade
from ichnograph.algorithms.facade.settings import FacadeSettings
from ichnograph.tests.scenes.facades import FacadeScene
from ichnograph.tests.scenes.facades.streets import STREETS
from ichnograph.tests.scenes.facades.streets.cuts import CUTS, WHOLE, cut
from ichnograph.tests.scenes.facades.streets.judging import (
    BOTTOM,
    LEFT,
    REQUIRED,
    RIGHT,
    TOP,
    SeenPair,
    StreetJudgement,
    judge_street,
    nothing_found,
)

from .facade import PLACE, draw, points_of

SPACINGS = (0.005, 0.01, 0.02)
NOISE = (0.002, 0.005)

TURNING = {"polygonal_tower": SIDES, "round_tower": ROUND}
"""UNROLL of the streets that have nothing flat."""


@dataclass(frozen=True)
class Run:
    """A street, measured.

    Attributes
    ----------
    scene : FacadeScene
    judgement : StreetJudgement
    seconds : float
        For measuring.
    points : int
    """

    scene: FacadeScene
    judgement: StreetJudgement
    seconds: float
    points: int


def _run(name: str, spacing: float, seed: int, arguments: argparse.Namespace) -> Run:
    scene = STREETS[name](seed).moved(*PLACE)
    noise = float(np.random.default_rng(seed).uniform(*NOISE))
    scan = cut(scene.scan(spacing, noise, seed), scene, arguments.cut)
    points = points_of(scan)
    if arguments.plain:
        points = replace(points, rgb=None, intensity=None)
    started = time.perf_counter()
    settings = FacadeSettings(unroll=SIDES if arguments.sides else TURNING.get(name, FLAT))
    try:
        drawn = measure_selection(select_facade(points, settings), settings)
    except NothingFoundError:
        return Run(scene, nothing_found(scene), time.perf_counter() - started, len(points.xyz))
    seconds = time.perf_counter() - started
    judgement = judge_street(drawn.elevation, scene)
    if arguments.pictures:
        _draw(scene, drawn, judgement, f"{name}_{spacing * 1000:g}mm_{seed}.png")
    return Run(scene, judgement, seconds, len(points.xyz))


def _draw(scene: FacadeScene, drawn: DrawnFacade, judgement: StreetJudgement, file: str) -> None:
    folder = Path("build/streets")
    folder.mkdir(parents=True, exist_ok=True)
    draw(scene, drawn.elevation, judgement, drawn.selection.points, folder / file)


def _errors(pairs: list[SeenPair]) -> np.ndarray:
    """Return errors and standard deviations of the widths and heights that a station saw, shape (n, 2, 2).

    Both are nan where a station did not see both edges, the second also where the edge was not measured.
    """
    rows = np.full((len(pairs), 2, 2), np.nan)
    for row, pair in zip(rows, pairs):
        # Along the ground there is no wall to see.
        seen = np.nan_to_num(pair.seen, nan=1.0) >= REQUIRED
        for size, (low, high) in enumerate(((LEFT, RIGHT), (BOTTOM, TOP))):
            if seen[low] and seen[high]:
                row[size] = pair.size[size], (pair.found.width_std, pair.found.height_std)[size]
    return rows


def _row(label: str, runs: list[Run]) -> str:
    judgements = [run.judgement for run in runs]
    pairs = [pair for judgement in judgements for pair in judgement.pairs]
    found = sum(len(judgement.pairs) for judgement in judgements)
    missed = sum(len(judgement.missed) for judgement in judgements)
    invented = sum(len(judgement.invented) for judgement in judgements)
    share = 100 * found / max(found + missed, 1)
    errors = _errors(pairs)
    fair, stated = np.isfinite(errors[..., 0]), np.isfinite(errors[..., 1])
    within = np.abs(errors[..., 0]) <= 2 * errors[..., 1]
    held = f"{100 * within[stated].mean():.0f} %" if stated.any() else "-"
    errors[~stated] = np.nan
    right = sum(judgement.right_side for judgement in judgements)
    return (
        f"| {label} | {right} of {len(runs)} | {found} / {missed} / {invented} | {share:.1f} % "
        f"| {stated.sum()} of {fair.sum()} | {_spread(errors[:, 0, 0])} | {_spread(errors[:, 1, 0])} "
        f"| {held} "
        f"| {np.mean([run.seconds for run in runs]):.0f} |"
    )


def _spread(errors: np.ndarray) -> str:
    errors = 1000 * errors[np.isfinite(errors)]
    if not len(errors):
        return "-"
    return f"{errors.mean():+.1f} / {errors.std():.1f} / {np.abs(errors).max():.0f}"


def _each(run: Run, seed: int) -> Iterator[str]:
    """Yield a line for each opening: errors of its edges, their standard deviations (mm), what was seen."""
    for pair in run.judgement.pairs:
        stds = pair.found.edges
        deviations = (stds.left, stds.bottom, stds.right, stds.top)
        edges = "  ".join(
            f"{1000 * error:+6.1f} ({1000 * std:4.1f}, {100 * seen:3.0f} %)"
            for error, std, seen in zip(pair.edges, deviations, pair.seen)
        )
        yield f"  {seed} {pair.true.kind:8s} {pair.true.shape:14s} {pair.found.shape:10s} {edges}"
    for true in run.judgement.missed:
        middle = true.outline.centroid
        yield f"  {seed} missed {true.kind} ({true.shape}) at {middle.x:.2f}, {middle.y:.2f}"
    for detail in run.judgement.invented:
        u, v = detail.outline.centroid.coords[0]
        yield f"  {seed} invented {detail.kind} {detail.number} at {u:.2f}, {v:.2f} of the elevation"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--street", nargs="+", choices=sorted(STREETS), default=list(STREETS))
    parser.add_argument("--spacing", type=float, nargs="+", default=SPACINGS, help="of the points, metres")
    parser.add_argument("--seeds", type=int, default=3, help="streets of each kind")
    parser.add_argument("--first", type=int, default=0, help="seed")
    parser.add_argument("--cut", choices=CUTS, default=WHOLE, help="what is kept of the scan")
    parser.add_argument("--sides", action="store_true", help="with the sides of a bay (UNROLL=1)")
    parser.add_argument("--plain", action="store_true", help="without colour and intensity")
    parser.add_argument("--each", action="store_true", help="also print the edges of every opening")
    parser.add_argument("--pictures", action="store_true", help="also draw every street")
    arguments = parser.parse_args()
    sizes = "width: mean / std / max (mm) | height: mean / std / max (mm)"
    print(
        "| spacing (mm) | street | side right | found / missed / invented | found "
        f"| sizes measured | {sizes} | within 2 std | seconds |"
    )
    print("|---|---|---|---|---|---|---|---|---|---|")
    for spacing in arguments.spacing:
        every = []
        for name in arguments.street:
            seeds = range(arguments.first, arguments.first + arguments.seeds)
            runs = [_run(name, spacing, seed, arguments) for seed in seeds]
            print(_row(f"{1000 * spacing:g} | {name}", runs), flush=True)
            if arguments.each:
                print("\n".join(line for seed, run in zip(seeds, runs) for line in _each(run, seed)))
            every += runs
        print(_row(f"{1000 * spacing:g} | all", every), flush=True)


if __name__ == "__main__":
    main()
