"""The paper's figure 2 on a simulated site: point spacing against pixel size.

make figure2, or: python3 -m ichnograph.benchmarks.figure2 [--out build/figure2.png]
"""

import argparse
from pathlib import Path

import numpy as np
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.evaluation.plan import compare_plan
from ichnograph.algorithms.site_plan.settings import SitePlanSettings
from ichnograph.algorithms.site_plan.site_plan import make_site_plan
from ichnograph.tests.scenes import SCENES
from ichnograph.tests.scenes.__main__ import write_laz
from matplotlib.figure import Figure
from shapely.ops import unary_union

SPACINGS = (0.025, 0.05, 0.10)
PIXEL_SIZES = (0.01, 0.10)
PART = (-1.0, 14.0, 13.0, 25.0)
"""The part of the site that is shown: west, south, east, north (m)."""


def main() -> None:
    """Draw the six images and print what the default chain finds in each."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--out", type=Path, default=Path("build/figure2.png"))
    out = parser.parse_args().out
    out.parent.mkdir(parents=True, exist_ok=True)
    scene = SCENES["ruins"](0)
    scan = scene.scan(angular_step=0.1)
    west, south, east, north = scene.truth.bounds
    x, y = scan.points[:, 0], scan.points[:, 1]
    near = (x > west - 3) & (x < east + 3) & (y > south - 3) & (y < north + 3)
    cloud = out.with_name("figure2.laz")
    write_laz(cloud, scan, near, None)
    print("| pixel | spacing | points kept | completeness / correctness at 10 cm | walls |")
    print("|---|---|---|---|---|")
    figure = Figure(figsize=(15, 9), layout="constrained")
    for row, pixel_size in zip(figure.subplots(2, 3), PIXEL_SIZES):
        for axes, spacing in zip(row, SPACINGS):
            plan = make_site_plan(open_cloud([cloud]), SitePlanSettings(spacing, pixel_size, refine=False))
            image = plan.density
            walls = unary_union([wall.outline for wall in plan.walls])
            found = compare_plan(walls, scene.truth, 0.10, scan.seen_boundary)
            print(
                f"| {pixel_size * 100:g} cm | {spacing * 100:g} cm | {image.points_kept} "
                f"| {found.completeness:.2f} / {found.correctness:.2f} | {len(plan.walls)} |"
            )
            rows, columns = image.density.shape
            east = image.transform.c + columns * pixel_size
            south = image.transform.f - rows * pixel_size
            axes.imshow(
                np.nan_to_num(image.density),
                extent=(image.transform.c, east, south, image.transform.f),
                cmap="gray_r",
                vmin=0,
                vmax=np.nanmean(image.density) + 2 * np.nanstd(image.density),
            )
            axes.set(xlim=PART[::2], ylim=PART[1::2], xticks=[], yticks=[])
            axes.set_title(f"spacing {spacing * 100:g} cm, pixel {pixel_size * 100:g} cm")
    figure.savefig(out, dpi=75)


if __name__ == "__main__":
    main()
