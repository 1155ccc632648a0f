"""How well the site plan agrees with the known walls of simulated scans.

make accuracy, or: python3 -m ichnograph.benchmarks.accuracy [--angular-step 0.2] [--seed 0]

Prints a table and leaves layers and pictures in build/accuracy.
"""

import argparse
from pathlib import Path

from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.evaluation.plan import compare_plan
from ichnograph.algorithms.site_plan.settings import SitePlanSettings
from ichnograph.algorithms.site_plan.site_plan import make_site_plan
from ichnograph.algorithms.site_plan.walls.extraction import WallParameters
from ichnograph.scripts.picture import draw
from ichnograph.tests.scenes import SCENES
from ichnograph.tests.scenes.__main__ import write_laz
from shapely.ops import unary_union

from .layers import write_layers

TOLERANCES = (0.05, 0.10, 0.20)
PLACE = (12.0, (412_345.67, 5_812_345.71, 71.3))
"""Angle and shift of every scene: no wall runs along the pixels, and coordinates are those of a grid."""

CHAINS = {
    "default": SitePlanSettings(),
    "REFINE=no": SitePlanSettings(refine=False),
    "REFINE=no MIN_HEIGHT=0": SitePlanSettings(refine=False, wall_parameters=WallParameters(min_height=0)),
}
"""Settings by name; the last are those of the paper's plain chain."""


def measure(name: str, angular_step: float, seed: int, folder: Path) -> list[str]:
    """Scan a scene, run the chains and return a row of the table for each."""
    scene = SCENES[name](seed).moved(*PLACE)
    scan = scene.scan(angular_step, seed=seed)
    folder.mkdir(parents=True, exist_ok=True)
    cloud = folder / f"{name}.laz"
    write_laz(cloud, scan, slice(None), "EPSG:25833")
    rows = []
    for chain, settings in CHAINS.items():
        stem = f"{name}_{chain.replace('=', '').replace(' ', '_')}"
        plan = make_site_plan(open_cloud([cloud]), settings)
        density, layer = write_layers(plan, folder, stem)
        walls = unary_union([wall.outline for wall in plan.walls])
        agreement = compare_plan(walls, scene.truth, TOLERANCES[-1], scan.seen_boundary)
        found = [agreement.at(tolerance) for tolerance in TOLERANCES]
        draw(density, layer, layer.with_suffix(".png"), scene.truth)
        shares = " | ".join(f"{a.completeness:.2f} / {a.correctness:.2f}" for a in found)
        offset = f"{found[-1].median_offset * 100:.1f} / {found[-1].p95_offset * 100:.1f}"
        rows.append(
            f"| {name} | {chain} | {plan.density.points_in / 1e6:.1f} | {shares} | {found[0].iou:.2f} "
            f"| {offset} | {len(plan.walls)} |"
        )
    return rows


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--angular-step", type=float, default=0.2, help="of the scanner, degrees")
    parser.add_argument("--seed", type=int, default=0, help="of the scenes and the noise")
    parser.add_argument("--folder", type=Path, default=Path("build/accuracy"))
    arguments = parser.parse_args()
    tolerances = " | ".join(f"{t * 100:.0f} cm" for t in TOLERANCES)
    print(f"| scene | chain | M points | {tolerances} | IoU | offset median / 95 % (cm) | walls |")
    print("|---|---|---|---|---|---|---|---|---|")
    for name in SCENES:
        for row in measure(name, arguments.angular_step, arguments.seed, arguments.folder):
            print(row, flush=True)


if __name__ == "__main__":
    main()
