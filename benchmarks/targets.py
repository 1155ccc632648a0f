"""How many targets are found in simulated scans, how many false ones, and how exact the centres are.

Every station sees checkerboards of 75, 150 and 300 mm and spheres of 76, 145 and 200 mm before walls, at
distances and incidences at which the angular step leaves at least four points a quadrant, or twenty on the
sphere. Other stations see no target: posters, tiles, windows, lamps, balls, pipes, stripes, painted walls.
Errors are compared with the stated covariances: 95 % should lie within the 95 % ellipsoids. All points of a
target have the same error of direction and range, of the size that repeated scans of real targets show.

    python -m ichnograph.benchmarks.targets --stations 8
"""

import argparse
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product
from typing import Optional

import numpy as np
from ichnograph.algorithms.targets.range_image.range_image import image_of
from ichnograph.algorithms.targets.range_image.station import Station as Scan
from ichnograph.algorithms.targets.results import StationTargets, Target
from ichnograph.algorithms.targets.settings import TargetSettings
from ichnograph.algorithms.targets.station_search import search_station
from ichnograph.tests.scenes.stations.caster import Scanner
from ichnograph.tests.scenes.stations.layout import (
    CHECKERBOARD,
    SPHERE,
    Placed,
    Station,
    cluttered_station,
    target_station,
)
from scipy.stats import chi2

STEPS = (0.0006, 0.0003, 0.00015)
"""6, 3 and 1.5 mm at 10 m."""

DISTANCES = (3.0, 6.0, 12.0, 20.0, 30.0, 40.0)
INCIDENCES = (0.0, 20.0, 40.0, 60.0, 70.0)
BOARDS, BALLS = (0.075, 0.15, 0.3), (0.076, 0.145, 0.2)
WITHIN = chi2.ppf(0.95, 3)


@dataclass(frozen=True)
class Case:
    """A true target, and what was found there.

    Attributes
    ----------
    truth : Placed
    found : Target or None
    step : float
        Radians.
    """

    truth: Placed
    found: Optional[Target]
    step: float

    @property
    def sure(self) -> bool:
        """Whether it was found without doubt."""
        return self.found is not None and not self.found.doubt


def error(case: Case) -> float:
    """Return the error of a centre, metres."""
    assert case.found is not None
    return float(np.linalg.norm(case.found.xyz - case.truth.centre))


def normalised(case: Case) -> float:
    """Return the squared error of a centre in units of its covariance."""
    assert case.found is not None
    away = case.found.xyz - case.truth.centre
    return float(away @ np.linalg.solve(case.found.covariance, away))


def visible(kind: str, size: float, distance: float, incidence: float, step: float) -> bool:
    """Whether the scan is fine enough: four points a quadrant, or twenty on a sphere."""
    across = size / 2 / (step * distance)
    if kind == SPHERE:
        return np.pi * across**2 * 0.75 >= 20
    along = across * np.cos(np.radians(incidence))
    return along >= 1.5 and across * along >= 4


def places(step: float, most: int, rng: np.random.Generator) -> list[tuple[str, float, float, float]]:
    """Return targets that a scanner can see, drawn from all sizes, distances and incidences."""
    boards = product((CHECKERBOARD,), BOARDS, DISTANCES, INCIDENCES)
    balls = product((SPHERE,), BALLS, DISTANCES, (0.0,))
    good = [
        place
        for place in (*boards, *balls, *product((SPHERE,), BALLS, DISTANCES, (0.0,)))
        if visible(*place, step)
    ]
    chosen = rng.permutation(len(good))[:most]
    return [good[number] for number in chosen]


def search(station: Station) -> StationTargets:
    """Search a simulated scan as a file would be."""
    scan = Scan(np.zeros(3), station.xyz.astype(np.float32), station.intensity)
    return search_station("scan", image_of(scan, "scan"), TargetSettings())


def cases(station: Station, result: StationTargets, step: float) -> tuple[list[Case], list[Target]]:
    """Return what became of each target, and the sure targets where there is none."""
    left = list(result.targets)
    matched = []
    for truth in station.targets:
        near = [item for item in left if np.linalg.norm(item.xyz - truth.centre) < 0.5 * truth.size]
        best = min(near, key=lambda item: bool(item.doubt), default=None)
        left = [item for item in left if item is not best]
        matched.append(Case(truth, best, step))
    return matched, [item for item in left if not item.doubt]


def table(title: str, groups: Iterator[tuple[str, list[Case]]]) -> None:
    """Print a row of figures for each group of cases."""
    print(
        f"\n| {title} | targets | found | doubtful | error median / 95 % (mm) | stated (mm) "
        "| in 95 % ellipsoid |"
    )
    print("|---|---|---|---|---|---|---|")
    for name, group in groups:
        if not group:
            continue
        sure = [case for case in group if case.sure]
        doubtful = sum(1 for case in group if case.found) - len(sure)
        errors = 1000 * np.array([error(case) for case in sure] or [np.nan])
        stated = 1000 * np.median([case.found.std for case in sure if case.found] or [np.nan])
        inside = np.mean([normalised(case) < WITHIN for case in sure] or [np.nan])
        print(
            f"| {name} | {len(group)} | {len(sure)} | {doubtful} | {np.median(errors):.2f} / "
            f"{np.percentile(errors, 95):.2f} | {stated:.2f} | {100 * inside:.0f} % |"
        )


def main() -> None:
    """Run the benchmark."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--stations", type=int, default=8, help="stations of each angular step")
    parser.add_argument("--targets", type=int, default=24, help="targets of a station")
    parser.add_argument("--misses", action="store_true", help="print what was missed, and why")
    arguments = parser.parse_args()
    found: list[Case] = []
    false: list[tuple[float, Target]] = []
    for step, seed in product(STEPS, range(arguments.stations)):
        rng = np.random.default_rng(seed)
        scanner = Scanner(step=step, noise=rng.uniform(0.0007, 0.002), crosstalk=rng.uniform(-0.003, 0.003))
        station = target_station(scanner, places(step, arguments.targets, rng), seed)
        result = search(station)
        matched, wrong = cases(station, result, step)
        found += matched
        false += [(step, item) for item in wrong]
        if arguments.misses:
            print_misses(matched, result)
    clutter: list[tuple[float, Target]] = []
    for seed in range(arguments.stations):
        station = cluttered_station(Scanner(step=STEPS[0]), (3.0, 8.0), 1000 + seed)
        clutter += [(STEPS[0], item) for item in search(station).sure]
    kinds = (
        (f"{kind} {1000 * size:.0f} mm", kind, size)
        for kind, sizes in ((CHECKERBOARD, BOARDS), (SPHERE, BALLS))
        for size in sizes
    )
    table(
        "target",
        (
            (name, [c for c in found if (c.truth.kind, c.truth.size) == (kind, size)])
            for name, kind, size in kinds
        ),
    )
    table("distance", ((f"{d:.0f} m", [c for c in found if c.truth.distance == d]) for d in DISTANCES))
    boards = [case for case in found if case.truth.kind == CHECKERBOARD]
    table(
        "incidence", ((f"{i:.0f} degrees", [c for c in boards if c.truth.incidence == i]) for i in INCIDENCES)
    )
    table("step at 10 m", ((f"{1e4 * s:.1f} mm", [c for c in found if c.step == s]) for s in STEPS))
    table("all", iter([("all", found)]))
    print(f"\nFalse targets beside true ones: {len(false)}")
    print(f"False targets on {arguments.stations} stations without any: {len(clutter)}")
    for step, item in (*false, *clutter):
        print(
            f"  {item.kind.value}, {1000 * item.size:.0f} mm at {np.linalg.norm(item.xyz):.1f} m, "
            f"step {1e4 * step:.1f} mm, quality {item.quality:.2f}"
        )


def print_misses(matched: list[Case], result: StationTargets) -> None:
    """Print the missed and doubtful targets with the test they failed."""
    for case in matched:
        truth = case.truth
        what = (
            f"{truth.kind} {1000 * truth.size:.0f} mm at {truth.distance:.0f} m, "
            f"{truth.incidence:.0f} degrees, step {1e4 * case.step:.1f} mm"
        )
        if case.found is None:
            limit = 0.6 * truth.size
            near = [r for r in result.rejections if np.linalg.norm(r.xyz - truth.centre) < limit]
            tests = Counter(f"{r.test} {r.value:.3g} ({r.limit:.3g})" for r in near)
            print(f"missed {what}: {dict(tests.most_common(3)) or 'no candidate'}")
        elif case.found.doubt:
            print(f"doubtful {what}: {case.found.doubt}; error {1000 * error(case):.2f} mm")


if __name__ == "__main__":
    main()
