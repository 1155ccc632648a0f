"""How good plans are over random scenes, rotations and shifts: the worst, and the median in brackets.

make plan, or: python3 -m ichnograph.benchmarks.plan [--scene yard] [--variant full] [--seeds 3]

Every scene is simulated with several seeds, rotated and shifted at random, and scanned in each
variant. The columns are explained in docs/accuracy.md.
"""

import argparse
import os
import tempfile
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import suppress
from dataclasses import dataclass, fields
from functools import partial
from itertools import product
from pathlib import Path

import numpy as np
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.errors import NothingFoundError
from ichnograph.algorithms.evaluation.plan import compare_plan
from ichnograph.algorithms.site_plan.settings import SitePlanSettings
from ichnograph.algorithms.site_plan.site_plan import make_site_plan
from ichnograph.algorithms.site_plan.walls.wall import Wall
from ichnograph.tests.scenes import SCENES, Scan, Scene
from ichnograph.tests.scenes.__main__ import write_laz
from ichnograph.tests.scenes.judging import phantom_length, room_errors, thickness_errors
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

TOLERANCE = 0.05
"""Of completeness and correctness, metres."""

SEARCH = 0.20
"""Up to this distance a boundary has an offset, metres."""

CHAINS = ("default", "REFINE=no")

VARIANTS = ("full", "quarter", "noise", "stations")
"""All points; a quarter of them; 10 mm of range noise; two stations fewer."""


@dataclass(frozen=True)
class Quality:
    """How good one plan is; lengths in metres, nan if there is nothing to measure.

    Attributes
    ----------
    completeness, correctness : float
        At `TOLERANCE`.
    median_offset, p95_offset : float
        Of the boundary that was found within `SEARCH`.
    thickness, p95_thickness : float
        Median and 95 % of the absolute errors of the thickness, where both faces were seen.
    room_area : float
        Largest error of the area of a room, as a share of it; a room that is lost counts 1.
    phantom : float
        Length of the longest piece of wall where there is no wall.
    """

    completeness: float
    correctness: float
    median_offset: float
    p95_offset: float
    thickness: float
    p95_thickness: float
    room_area: float
    phantom: float


COLUMNS = {
    "completeness": ("complete", 1, "{:.3f}", min),
    "correctness": ("correct", 1, "{:.3f}", min),
    "median_offset": ("offset median (mm)", 1000, "{:.1f}", max),
    "p95_offset": ("95 % (mm)", 1000, "{:.1f}", max),
    "thickness": ("thickness median (mm)", 1000, "{:.1f}", max),
    "p95_thickness": ("95 % (mm)", 1000, "{:.1f}", max),
    "room_area": ("room area (%)", 100, "{:.2f}", max),
    "phantom": ("phantom (m)", 1, "{:.1f}", max),
}
"""Heading, factor and format of each measure, and the function that gives the worst value."""


def placed(name: str, seed: int) -> Scene:
    """Return a scene, rotated and shifted at random on a national grid."""
    random = np.random.default_rng([seed, 2012])
    shift = (*random.uniform((3e5, 5.2e6), (7e5, 6.1e6)), random.uniform(-50, 900))
    return SCENES[name](seed).moved(random.uniform(0, 360), shift)


def scanned(scene: Scene, variant: str, angular_step: float, seed: int) -> Scan:
    """Scan a scene as a variant says."""
    random = np.random.default_rng([seed, 2013])
    return scene.scan(
        angular_step * (2 if variant == "quarter" else 1),
        0.010 if variant == "noise" else 0.003,
        seed,
        random.choice(len(scene.stations), 2, replace=False) if variant == "stations" else (),
    )


def qualities(seed: int, name: str, variant: str, angular_step: float) -> dict[str, Quality]:
    """Return the quality of the plan that each chain makes of a scan, by the name of the chain."""
    scene = placed(name, seed)
    scan = scanned(scene, variant, angular_step, seed)
    with tempfile.TemporaryDirectory() as folder:
        cloud = Path(folder) / "scan.laz"
        write_laz(cloud, scan, slice(None), "EPSG:25833")
        plans = outlines(cloud)
    return {chain: quality(plans.get(chain, Polygon()), scene, scan) for chain in CHAINS}


def outlines(path: Path) -> dict[str, BaseGeometry]:
    """Return the walls of a cloud with all defaults, by `CHAINS`; those that are not found are missing."""
    cloud = open_cloud([path])
    with suppress(NothingFoundError):
        plan = make_site_plan(cloud)
        return {"default": joined(plan.walls), "REFINE=no": joined(plan.pixel_walls)}
    with suppress(NothingFoundError):
        return {"REFINE=no": joined(make_site_plan(cloud, SitePlanSettings(refine=False)).walls)}
    return {}


def joined(walls: Sequence[Wall]) -> BaseGeometry:
    """Return the outlines of walls as one geometry."""
    return unary_union([wall.outline for wall in walls])


def quality(walls: BaseGeometry, scene: Scene, scan: Scan) -> Quality:
    """Measure a plan against the truth that the scan has seen."""
    agreement = compare_plan(walls, scene.truth, TOLERANCE, scan.seen_boundary)
    offsets = agreement.at(SEARCH)
    thickness = np.abs(thickness_errors(walls, scene.truth, scan.seen_boundary))
    return Quality(
        agreement.completeness,
        agreement.correctness,
        offsets.median_offset,
        offsets.p95_offset,
        float(np.median(thickness)) if len(thickness) else np.nan,
        float(np.quantile(thickness, 0.95)) if len(thickness) else np.nan,
        max(room_errors(walls, scene.truth, scan.seen_boundary), default=np.nan),
        phantom_length(walls, unary_union([scene.truth, scene.footings])),
    )


def row(label: str, found: list[Quality]) -> str:
    """Return the row of a table: the worst and, in brackets, the median of several plans."""
    cells = []
    for measure in fields(Quality):
        _, factor, form, worst = COLUMNS[measure.name]
        values = factor * np.array([getattr(one, measure.name) for one in found])
        values = values[np.isfinite(values)]
        numbers = (worst(values), np.median(values)) if len(values) else ()
        cells.append("{} ({})".format(*map(form.format, numbers)) if numbers else "-")
    return f"| {label} | {' | '.join(cells)} |"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--scene", nargs="+", choices=sorted(SCENES), default=list(SCENES))
    parser.add_argument("--variant", nargs="+", choices=VARIANTS, default=VARIANTS)
    parser.add_argument("--seeds", type=int, default=20, help="scenes of each name")
    parser.add_argument("--first-seed", type=int, default=0)
    parser.add_argument("--angular-step", type=float, default=0.2, help="of the scanner, degrees")
    parser.add_argument("--each", action="store_true", help="also print a row for each seed")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="processes side by side")
    arguments = parser.parse_args()
    headings = [heading for heading, *_ in COLUMNS.values()]
    print(f"| scene | variant | chain | {' | '.join(headings)} |")
    print("|" + "---|" * (3 + len(headings)))
    seeds = range(arguments.first_seed, arguments.first_seed + arguments.seeds)
    with ProcessPoolExecutor(arguments.jobs) as pool:
        for name, variant in product(arguments.scene, arguments.variant):
            measure = partial(qualities, name=name, variant=variant, angular_step=arguments.angular_step)
            found = list(pool.map(measure, seeds))
            for chain in CHAINS:
                every = [one[chain] for one in found]
                if arguments.each:
                    for seed, one in zip(seeds, every):
                        print(row(f"{name} {seed} | {variant} | {chain}", [one]))
                print(row(f"{name} | {variant} | {chain}", every), flush=True)


if __name__ == "__main__":
    main()
