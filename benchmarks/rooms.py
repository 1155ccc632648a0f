"""How well the rooms between walls are found in simulated scans.

make rooms, or: python3 -m ichnograph.benchmarks.rooms [--angular-step 0.2] [--seeds 3]

Prints the largest errors of areas over all seeds: between the true walls, and between those of the plan.
"""

import argparse
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.site_plan.rooms.rooms import Room, find_rooms
from ichnograph.algorithms.site_plan.settings import SitePlanSettings
from ichnograph.algorithms.site_plan.site_plan import make_site_plan
from ichnograph.tests.scenes import SCENES, Scene
from ichnograph.tests.scenes.__main__ import write_laz
from shapely.geometry import Polygon
from shapely.ops import unary_union

from .accuracy import PLACE

NAMES = ("interior", "rooms")
"""Scenes whose walls close rooms from all sides, but for doors."""

EXACT = 0.005
"""Largest share of its area by which a room is off, and still counts as within."""


def true_rooms(scene: Scene) -> list[Polygon]:
    """Return the spaces between the walls of a scene with its doors walled up."""
    solid = [prism.footprint for prism in scene.prisms if prism.material in ("wall", "lintel")]
    filled = unary_union([scene.pose.geometry(part).buffer(1e-6, join_style=2) for part in solid])
    return [Polygon(ring) for ring in filled.interiors]


def errors(found: Sequence[Room], true: list[Polygon]) -> list[float]:
    """Return the error of the area of each true room, as a share of it; nan if no room is there."""
    rooms = [
        next((room for room in found if room.outline.contains(space.representative_point())), None)
        for space in true
    ]
    return [room.area / space.area - 1 if room else np.nan for room, space in zip(rooms, true)]


def measure(name: str, angular_step: float, seeds: int, folder: Path) -> str:
    """Return a row of the table."""
    folder.mkdir(parents=True, exist_ok=True)
    ideal, real, surplus = [], [], 0
    for seed in range(seeds):
        scene = SCENES[name](seed).moved(*PLACE)
        true = true_rooms(scene)
        ideal += errors(find_rooms(scene.truth.geoms), true)
        write_laz(folder / "scan.laz", scene.scan(angular_step, seed=seed), slice(None), "EPSG:25833")
        plan = make_site_plan(open_cloud([folder / "scan.laz"]), SitePlanSettings(with_rooms=True))
        found = plan.rooms or ()
        real += errors(found, true)
        surplus += len(found) - len(true)
    worst = [100 * np.nanmax(np.abs(values)) for values in (ideal, real)]
    missed = int(np.isnan(real).sum())
    exact = int(np.sum(np.abs(real) <= EXACT))
    counts = f"{len(real)} | {missed} | {surplus + missed}"
    return f"| {name} | {counts} | {worst[0]:.4f} | {exact} | {worst[1]:.1f} |"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--angular-step", type=float, default=0.2, help="of the scanner, degrees")
    parser.add_argument("--seeds", type=int, default=3, help="so many scenes of each kind")
    parser.add_argument("--folder", type=Path, default=Path("build/rooms"))
    arguments = parser.parse_args()
    headings = "true walls: area error (%) | plan: within 0.5 % | plan: area error (%)"
    print(f"| scene | rooms | missed | surplus | {headings} |")
    print("|---|---|---|---|---|---|---|")
    for name in NAMES:
        print(measure(name, arguments.angular_step, arguments.seeds, arguments.folder), flush=True)


if __name__ == "__main__":
    main()
