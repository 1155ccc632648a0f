"""How well the details of simulated facades are measured.

make facade, or: python3 -m ichnograph.benchmarks.facade [--spacing 0.005 0.01 0.02] [--seeds 3]

Prints the numbers of details found, missed and invented, the agreement of the outlines, the errors of widths
and heights, and how many of these are within two standard deviations. Writes pictures to build/facade.
"""

import argparse
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from ichnograph.algorithms.facade.elevation import Elevation, Points
from ichnograph.algorithms.facade.measurement import measure_facade
from ichnograph.algorithms.facade.settings import FacadeSettings
from ichnograph.tests.scenes.facades import FACADES, FacadeScan, FacadeScene
from ichnograph.tests.scenes.facades.judging import Judgement, in_scene, judge

PLACE = (31.0, (412_345.67, 5_812_345.71, 71.3))
"""Angle and shift of every facade, to coordinates of a national grid."""

SPACINGS = (0.005, 0.01, 0.02)


def points_of(scan: FacadeScan) -> Points:
    """Return a scan as points for the core."""
    origin = np.floor(scan.points.min(axis=0))
    return Points(
        scan.points - origin,
        origin,
        scan.rgb.astype(np.float32),
        scan.intensity.astype(np.float32),
        scan.station.astype(np.int32),
    )


def _judged(name: str, spacing: float, seed: int, folder: Path) -> Judgement:
    scene = FACADES[name](seed).moved(*PLACE)
    points = points_of(scene.scan(spacing, seed=seed))
    elevation = measure_facade(points, FacadeSettings())
    judgement = judge(elevation, scene)
    draw(scene, elevation, judgement, points, folder / f"{name}_{spacing * 1000:g}mm_{seed}.png")
    return judgement


def draw(scene: FacadeScene, elevation: Elevation, judgement: Judgement, points: Points, path: Path) -> None:
    """Draw the points, the true outlines in green and the found ones in red."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure((14, 10))
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    rows = elevation.rows[:: max(len(elevation.rows) // 300_000, 1)]
    site = points.xyz[rows] + points.origin
    if elevation.curve is not None:
        site[:, :2] = elevation.curve.site(site[:, :2])
    uvw = scene.frame.local(site, np.zeros(3))
    colours = "grey" if points.rgb is None else points.rgb[rows] / 255
    axes.scatter(*uvw[:, :2].T, s=0.2, c=colours, linewidths=0)
    for part in elevation.wall.geoms:
        axes.plot(*in_scene(part, elevation, scene).exterior.xy, color="magenta", linewidth=0.6)
    for area in elevation.unseen:
        axes.plot(*in_scene(area, elevation, scene).exterior.xy, color="black", linestyle=":")
    for true in scene.details:
        axes.plot(*true.outline.exterior.xy, color="lime", linewidth=1.2)
    for detail in elevation.details:
        outline = in_scene(detail.outline, elevation, scene)
        axes.plot(*outline.exterior.xy, color="red", linewidth=0.8)
        axes.text(outline.centroid.x, outline.centroid.y, f"{detail.number} {detail.kind} {detail.shape}")
    for detail in judgement.invented:
        axes.plot(*in_scene(detail.outline, elevation, scene).exterior.xy, color="blue", linewidth=2)
    axes.set_aspect("equal")
    figure.savefig(path, dpi=110, bbox_inches="tight")


def _row(label: str, judgements: list[Judgement]) -> str:
    pairs = [pair for judgement in judgements for pair in judgement.pairs]
    missed = sum(len(judgement.missed) for judgement in judgements)
    invented = sum(len(judgement.invented) for judgement in judgements)
    errors = np.array([pair.size for pair in pairs])
    stds = np.array([(pair.found.width_std, pair.found.height_std) for pair in pairs])
    within = np.abs(errors) <= 2 * stds
    sizes = " | ".join(
        f"{1000 * values.mean():+.1f} / {1000 * values.std():.1f} / {1000 * np.abs(values).max():.1f}"
        for values in (errors[:, 0], errors[:, 1])
    )
    iou = np.median([pair.iou for pair in pairs])
    return (
        f"| {label} | {len(pairs)} / {missed} / {invented} | {iou:.3f} | {sizes} "
        f"| {100 * np.mean(within[np.isfinite(stds)]):.0f} % |"
    )


def _each(judgement: Judgement) -> Iterator[str]:
    """Yield a line for each detail: the errors of its edges and their standard deviations, in millimetres."""
    for pair in judgement.pairs:
        edges, stds = 1000 * pair.edges, pair.found.edges
        deviations = 1000 * np.array([stds.left, stds.bottom, stds.right, stds.top])
        sides = "  ".join(f"{error:+6.1f} ({std:4.1f})" for error, std in zip(edges, deviations))
        yield f"  {pair.found.number:3d} {pair.true.kind:16s} {pair.found.shape:9s} {sides}"
    for true in judgement.missed:
        yield f"  missed {true.kind} at {true.outline.centroid.x:.2f}, {true.outline.centroid.y:.2f}"
    for detail in judgement.invented:
        middle = detail.outline.centroid
        yield f"  invented {detail.kind} {detail.number} at {middle.x:.2f}, {middle.y:.2f}"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--facade", nargs="+", choices=sorted(FACADES), default=sorted(FACADES))
    parser.add_argument("--spacing", type=float, nargs="+", default=SPACINGS, help="of the points, metres")
    parser.add_argument("--seeds", type=int, default=1, help="facades of each name")
    parser.add_argument("--each", action="store_true", help="also print the edges of every detail")
    parser.add_argument("--folder", type=Path, default=Path("build/facade"))
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    sizes = "width: mean / std / max (mm) | height: mean / std / max (mm)"
    print(f"| spacing (mm) | facade | found / missed / invented | median IoU | {sizes} | within 2 std |")
    print("|---|---|---|---|---|---|---|")
    for spacing in arguments.spacing:
        every = []
        for name in arguments.facade:
            judgements = [_judged(name, spacing, seed, arguments.folder) for seed in range(arguments.seeds)]
            print(_row(f"{1000 * spacing:g} | {name}", judgements), flush=True)
            if arguments.each:
                print("\n".join(line for judgement in judgements for line in _each(judgement)))
            every += judgements
        print(_row(f"{1000 * spacing:g} | all", every), flush=True)


if __name__ == "__main__":
    main()
