"""How good plans of simulated buildings in use are: the worst over seeds, and the median in brackets.

make lived-in, or: python3 -m ichnograph.benchmarks.lived_in [--scene flat] [--seeds 3] [--each]

Every scene is rotated and shifted at random. The truth is used as a drawn plan: a plan should have the
faces that the scan has seen, it may have all others, and doors and windows are neutral. A phantom is a
piece of wall where there is neither wall nor opening. All defaults.
"""

import argparse
import os
import tempfile
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.errors import NothingFoundError
from ichnograph.algorithms.evaluation.drawn_plan import DrawnPlan, compare_rooms, compare_with_drawn
from ichnograph.algorithms.site_plan.settings import SitePlanSettings
from ichnograph.algorithms.site_plan.site_plan import make_site_plan
from ichnograph.tests.scenes import Scan, Scene
from ichnograph.tests.scenes.__main__ import write_laz
from ichnograph.tests.scenes.judging import phantom_length, seen_share
from ichnograph.tests.scenes.lived_in import LIVED_IN
from shapely.geometry import MultiLineString, Polygon
from shapely.ops import unary_union

TOLERANCE, SEARCH = 0.05, 0.20
"""Of completeness and correctness, and of offsets, metres."""

AROUND = 20.0
"""Phantoms are looked for so far around a building, metres."""

SEEN_ROOM = 0.9
"""Who draws a plan leaves out rooms of which less was seen, because their far end is not known."""

REVEAL = 0.2
"""Opposite lines of an opening are no farther apart than twice this, metres."""


@dataclass(frozen=True)
class Quality:
    """How good one plan is; lengths in metres, the median error of areas as a share."""

    completeness: float
    correctness: float
    p95_offset: float
    found: int
    missed: int
    invented: int
    area_error: float
    phantom: float


def placed(name: str, seed: int) -> Scene:
    """Return a scene, rotated and shifted at random on a national grid."""
    random = np.random.default_rng([seed, 2012])
    shift = (*random.uniform((3e5, 5.2e6), (7e5, 6.1e6)), random.uniform(-50, 900))
    return LIVED_IN[name](seed).moved(random.uniform(0, 360), shift)


def truth_of(scene: Scene, scan: Scan) -> DrawnPlan:
    """Return the truth of a scan as a drawn plan, by the rules of plans that people draw from scans."""
    whole: list[Polygon] = []
    cut_short = list(scene.doubtful_rooms)
    for room in scene.rooms:
        (whole if seen_share(room, scan.points) >= SEEN_ROOM else cut_short).append(room)
    return DrawnPlan(
        demanded=scan.seen_boundary,
        allowed=scene.faces,
        neutral=MultiLineString([*scene.openings, *scene.fitted]),
        judged=scene.truth.envelope.buffer(AROUND),
        rooms=tuple(whole),
        optional_rooms=tuple(cut_short),
    )


def quality(seed: int, name: str, angular_step: float) -> Quality:
    """Return the quality of the plan of a scene."""
    scene = placed(name, seed)
    scan = scene.scan(angular_step, seed=seed)
    walls: list[Polygon] = []
    rooms: list[Polygon] = []
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scan.laz"
        write_laz(path, scan, slice(None), "EPSG:25833")
        try:
            plan = make_site_plan(open_cloud([path]), SitePlanSettings(with_rooms=True))
        except NothingFoundError:
            pass
        else:
            walls, rooms = [wall.outline for wall in plan.walls], [room.outline for room in plan.rooms or ()]
    truth = truth_of(scene, scan)
    agreement, found = compare_with_drawn(walls, truth, TOLERANCE), compare_rooms(rooms, truth)
    known = unary_union([scene.truth, scene.footings, truth.neutral.buffer(REVEAL)])
    return Quality(
        agreement.completeness,
        agreement.correctness,
        agreement.plan.quantile(0.95, SEARCH),
        found.found,
        found.missed,
        found.invented,
        found.median_area_error,
        phantom_length(unary_union(walls), known),
    )


def row(label: str, every: Sequence[Quality]) -> str:
    """Return a row of the table: the worst and, in brackets, the median; rooms are added up."""

    def both(name: str, worst: str, form: str, factor: float = 1.0) -> str:
        values = factor * np.array([getattr(one, name) for one in every])
        values = values[np.isfinite(values)]
        if not len(values):
            return "-"
        return f"{getattr(np, worst)(values):{form}} ({np.median(values):{form}})"

    sums = [sum(getattr(one, name) for one in every) for name in ("found", "missed", "invented")]
    cells = [
        both("completeness", "min", ".3f"),
        both("correctness", "min", ".3f"),
        both("p95_offset", "max", ".0f", 1000),
        " / ".join(map(str, sums)),
        both("area_error", "max", ".1f", 100),
        both("phantom", "max", ".1f"),
    ]
    return f"| {label} | {' | '.join(cells)} |"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--scene", nargs="+", choices=sorted(LIVED_IN), default=list(LIVED_IN))
    parser.add_argument("--seeds", type=int, default=20, help="scenes of each name")
    parser.add_argument("--first-seed", type=int, default=0)
    parser.add_argument("--angular-step", type=float, default=0.3, help="of the scanner, degrees")
    parser.add_argument("--each", action="store_true", help="also print a row for each seed")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="processes side by side")
    arguments = parser.parse_args()
    print(
        "| scene | complete | correct | 95 % (mm) | rooms found / missed / invented | area error (%) | "
        "phantom (m) |"
    )
    print("|---|---|---|---|---|---|---|")
    seeds = range(arguments.first_seed, arguments.first_seed + arguments.seeds)
    with ProcessPoolExecutor(arguments.jobs) as pool:
        for name in arguments.scene:
            measure = partial(quality, name=name, angular_step=arguments.angular_step)
            found = []
            for seed, one in zip(seeds, pool.map(measure, seeds)):
                found.append(one)
                if arguments.each:
                    print(row(f"{name} {seed}", [one]), flush=True)
            print(row(name, found), flush=True)


if __name__ == "__main__":
    main()
