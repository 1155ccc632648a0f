"""Write a simulated scan of a facade or a street as LAZ, and the true sizes of its details beside it.

python3 -m ichnograph.tests.scenes.facades medina out.laz --spacing 0.01 --truth lengths.csv
python3 -m ichnograph.tests.scenes.facades terrace out.laz --seed 3 --noise 0.004
"""

import argparse
import csv
from pathlib import Path
from typing import Optional

import laspy
import numpy as np

from . import FACADES, FacadeScan, FacadeScene
from .streets import STREETS

ALL = {**FACADES, **STREETS}


def write_laz(path: Path, scan: FacadeScan, crs: Optional[str] = None) -> None:
    """Write a scan; the station, from 1, is the point source id."""
    header = laspy.LasHeader(point_format=2, version="1.2")
    header.scales = np.full(3, 0.0001)
    header.offsets = np.floor(scan.points.min(axis=0))
    if crs:
        from pyproj import CRS

        header.add_crs(CRS.from_user_input(crs))
    cloud = laspy.LasData(header)
    cloud.x, cloud.y, cloud.z = scan.points.T
    cloud.red, cloud.green, cloud.blue = (scan.rgb.astype(np.uint16) * 257).T
    cloud.intensity = scan.intensity
    cloud.point_source_id = (scan.station + 1).astype(np.uint16)
    cloud.write(str(path))


def write_truth(path: Path, scene: FacadeScene) -> None:
    """Write kind, position, width, height and sill of every detail."""
    with path.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(["kind", "u", "v", "width", "height", "sill"])
        for detail in scene.details:
            middle = detail.outline.centroid
            sizes = (middle.x, middle.y, detail.width, detail.height, detail.sill)
            writer.writerow([detail.kind, *(f"{size:.4f}" for size in sizes)])


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="ichnograph.tests.scenes.facades", description=__doc__)
    parser.add_argument("facade", choices=sorted(ALL))
    parser.add_argument("output", type=Path, help="the .laz or .las file to write")
    parser.add_argument("--spacing", type=float, default=0.01, help="of the points on the wall, metres")
    parser.add_argument("--noise", type=float, default=0.002, help="metres along the ray")
    parser.add_argument("--seed", type=int, default=0, help="of the facade and of the scan")
    parser.add_argument("--move", type=float, nargs=4, metavar=("ANGLE", "X", "Y", "Z"), default=(0, 0, 0, 0))
    parser.add_argument("--truth", type=Path, help="also write the true lengths there, as csv")
    parser.add_argument("--crs", help="such as EPSG:25833")
    return parser.parse_args()


def main() -> None:
    """Scan the facade named on the command line."""
    arguments = _arguments()
    angle, *shift = arguments.move
    scene = ALL[arguments.facade](arguments.seed).moved(angle, tuple(shift))
    write_laz(arguments.output, scene.scan(arguments.spacing, arguments.noise, arguments.seed), arguments.crs)
    if arguments.truth:
        write_truth(arguments.truth, scene)


if __name__ == "__main__":
    main()
