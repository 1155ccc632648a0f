"""The default chain on the real scans that a folder holds, to look at each plan.

make real, or: python3 -m ichnograph.benchmarks.real_clouds [FOLDER] [--out build/real]

FOLDER is the folder of test data (../shared/data), or any folder of clouds; each file, or each name given in
`SITES`, is one site. Leaves layers and a picture for each.
"""

import argparse
from pathlib import Path

import laspy
import numpy as np
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.errors import IchnographError
from ichnograph.scripts.picture import draw

from .chain import run_chain

SCANS = (".las", ".laz", ".xyz")
"""Extensions of scans; in others there are lists of points."""

UP_IS_Y = ("indoor",)
"""Clouds whose heights are in the second column: turned upright first."""


def upright(path: Path, folder: Path) -> Path:
    """Write a cloud whose y is up with z up, as LAZ in `folder`."""
    cloud = open_cloud([path])
    xyz = np.concatenate([chunk.xyz + cloud.origin for chunk in cloud.chunks()])
    header = laspy.LasHeader(point_format=0, version="1.2")
    header.scales = np.full(3, 0.001)
    las = laspy.LasData(header)
    las.x, las.y, las.z = xyz[:, 0], -xyz[:, 2], xyz[:, 1]
    turned = folder / f"{path.stem}_upright.laz"
    las.write(str(turned))
    return turned


def main() -> None:
    """Print a row for each cloud."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folder", type=Path, nargs="?", default=Path("../shared/data"))
    parser.add_argument("--out", type=Path, default=Path("build/real"))
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    files = sorted(p for p in arguments.folder.rglob("*") if p.suffix.lower() in SCANS)
    print("| cloud | points | walls | length (m) | seconds | remarks |")
    print("|---|---|---|---|---|---|")
    for path in files:
        try:
            cloud = upright(path, arguments.out) if path.stem in UP_IS_Y else path
            outputs = run_chain([cloud], arguments.out, path.stem)
        except IchnographError as error:
            print(f"| {path.stem} | | | | | {error} |", flush=True)
            continue
        draw(outputs.density, outputs.walls, arguments.out / f"{path.stem}.png")
        print(
            f"| {path.stem} | {outputs.points} | {len(outputs.plan.walls)} | {outputs.plan.length:.1f} "
            f"| {outputs.seconds:.1f} | {' '.join(outputs.warnings)} |",
            flush=True,
        )


if __name__ == "__main__":
    main()
