"""The default chain on the real scans that a folder holds, to look at each plan.

make real, or: python3 -m ichnograph.benchmarks.real_clouds [FOLDER] [--out build/real]

FOLDER is the folder of test data (../shared/data), or any folder of clouds; each file is one site. Leaves
layers and a picture for each: the density image, the outlines of pixels, and those on the faces.
"""

import argparse
import gzip
import time
import zipfile
from dataclasses import replace
from pathlib import Path

import laspy
import numpy as np
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.errors import IchnographError
from ichnograph.algorithms.site_plan.output.layers import write_walls
from ichnograph.algorithms.site_plan.site_plan import make_site_plan
from ichnograph.scripts.picture import draw

from .layers import write_layers

SCANS = (".las", ".laz", ".xyz")
"""Extensions of scans; in others there are lists of points."""

UP_IS_Y = ("indoor",)
"""Clouds whose heights are in the second column."""


def scans(folder: Path, work: Path) -> list[tuple[str, Path]]:
    """Return names and clouds; those in another frame or compressed ones are rewritten in `work`."""
    found = [(path.stem, path) for path in sorted(folder.rglob("*")) if path.suffix.lower() in SCANS]
    ready = [(name, path if name not in UP_IS_Y else upright(path, work)) for name, path in found]
    for packed in sorted(folder.rglob("*.pts.gz")):
        plain = work / packed.stem
        plain.write_bytes(gzip.decompress(packed.read_bytes()))
        ready.append((plain.stem, plain))
    ready += [("hall", hall(archive, work)) for archive in sorted(folder.glob("hall_3dtk*/*.zip"))]
    return ready


def upright(path: Path, work: Path) -> Path:
    """Write a cloud whose y is up with z up."""
    cloud = open_cloud([path])
    xyz = np.concatenate([chunk.xyz + cloud.origin for chunk in cloud.chunks()])
    return write(xyz[:, 0], -xyz[:, 2], xyz[:, 1], work / f"{path.stem}_upright.laz")


def hall(archive: Path, work: Path) -> Path:
    """Write the first scan of the hall: centimetres, left-handed, y up, no returns at 32.76 m."""
    with zipfile.ZipFile(archive) as files:
        x, y, z = np.loadtxt(files.read("scan000.3d").decode().splitlines()).T / 100
    near = np.sqrt(x**2 + y**2 + z**2) < 32
    return write(x[near], z[near], y[near], work / "hall.laz")


def write(x: np.ndarray, y: np.ndarray, z: np.ndarray, path: Path) -> Path:
    """Write coordinates in metres as LAZ."""
    header = laspy.LasHeader(point_format=0, version="1.2")
    header.scales = np.full(3, 0.001)
    las = laspy.LasData(header)
    las.x, las.y, las.z = x, y, z
    las.write(str(path))
    return path


def main() -> None:
    """Print a row for each cloud."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folder", type=Path, nargs="?", default=Path("../shared/data"))
    parser.add_argument("--out", type=Path, default=Path("build/real"))
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    print("| cloud | points | walls | length (m) | seconds | remarks |")
    print("|---|---|---|---|---|---|")
    for name, path in scans(arguments.folder, arguments.out):
        started = time.perf_counter()
        try:
            plan = make_site_plan(open_cloud([path]))
        except IchnographError as error:
            print(f"| {name} | | | | | {error} |", flush=True)
            continue
        density, walls = write_layers(plan, arguments.out, name)
        seconds = time.perf_counter() - started
        pixels = arguments.out / f"{name}_pixels_walls.shp"
        write_walls(pixels, replace(plan, walls=plan.pixel_walls))
        draw(density, walls, arguments.out / f"{name}.png", before=pixels)
        # These clouds have no coordinate reference system.
        remarks = " ".join(warning for warning in plan.warnings if "reference system" not in warning)
        print(
            f"| {name} | {plan.density.points_in} | {len(plan.walls)} | {plan.length:.1f} "
            f"| {seconds:.1f} | {remarks} |",
            flush=True,
        )


if __name__ == "__main__":
    main()
