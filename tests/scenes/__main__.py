"""Write a simulated scan as LAZ, and the true walls beside it.

python3 -m ichnograph.tests.scenes ruins out.laz --angular-step 0.2 --truth walls.geojson

With --survey, every station is a file in its own frame, with a list of its targets, as in the field.
"""

import argparse
from dataclasses import replace
from pathlib import Path
from typing import Optional

import fiona
import laspy
import numpy as np
from shapely.geometry import MultiPolygon, mapping

from . import SCENES, Scan, Scene
from .survey import in_frame, survey

DRIVERS = {".geojson": "GeoJSON", ".shp": "ESRI Shapefile", ".gpkg": "GPKG"}


def write_laz(path: Path, scan: Scan, chosen: np.ndarray, crs: Optional[str]) -> None:
    """Write the `chosen` points of `scan`; the station, from 1, is the point source id."""
    points = scan.points[chosen]
    header = laspy.LasHeader(point_format=0, version="1.2")
    header.scales = np.full(3, 0.001)
    header.offsets = np.floor(points.min(axis=0))
    if crs:
        from pyproj import CRS

        header.add_crs(CRS.from_user_input(crs))
    cloud = laspy.LasData(header)
    cloud.x, cloud.y, cloud.z = points.T
    cloud.intensity = scan.intensity[chosen]
    cloud.point_source_id = (scan.station[chosen] + 1).astype(np.uint16)
    cloud.write(str(path))


def write_truth(path: Path, truth: MultiPolygon, crs: Optional[str]) -> None:
    """Write every polygon of `truth` as a feature."""
    schema = {"geometry": "Polygon", "properties": {"wall_id": "int"}}
    driver = DRIVERS[path.suffix.lower()]
    with fiona.open(str(path), "w", driver=driver, schema=schema, crs=crs) as layer:
        for number, wall in enumerate(truth.geoms, start=1):
            layer.write({"geometry": mapping(wall), "properties": {"wall_id": number}})


def write_survey(arguments: argparse.Namespace, scene: Scene, scan: Scan) -> None:
    """Write the control points, and for every station its points and its targets in its own frame."""
    lists = survey(scene, scan, seed=arguments.seed)
    rows = [f"{name} {x:.4f} {y:.4f} {z:.4f}" for name, (x, y, z) in lists.control.items()]
    arguments.survey.write_text("\n".join(["name x y z", *rows, ""]))
    for station, (frame, picked) in enumerate(zip(lists.frames, lists.picked)):
        path = _numbered(arguments.output, station)
        own = replace(scan, points=in_frame(frame, scan.points))
        write_laz(path, own, scan.station == station, None)
        np.savetxt(path.with_suffix(".txt"), picked, fmt="%.4f")


def _numbered(path: Path, station: int) -> Path:
    return path.with_name(f"{path.stem}_{station + 1:02d}{path.suffix}")


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="ichnograph.tests.scenes", description=__doc__)
    parser.add_argument("scene", choices=sorted(SCENES))
    parser.add_argument("output", type=Path, help="the .laz or .las file to write")
    parser.add_argument("--angular-step", type=float, default=0.1, help="degrees")
    parser.add_argument("--noise", type=float, default=0.003, help="metres along the ray")
    parser.add_argument("--seed", type=int, default=0, help="of the scene and of the scan")
    parser.add_argument("--move", type=float, nargs=4, metavar=("ANGLE", "X", "Y", "Z"), default=(0, 0, 0, 0))
    parser.add_argument("--split", action="store_true", help="one file a station")
    parser.add_argument("--survey", type=Path, help="one file a station, and a list of control points there")
    parser.add_argument("--truth", type=Path, help="also write the true walls there")
    parser.add_argument("--crs", help="such as EPSG:25833")
    return parser.parse_args()


def main() -> None:
    """Scan the scene named on the command line."""
    arguments = _arguments()
    angle, *shift = arguments.move
    scene = SCENES[arguments.scene](arguments.seed).moved(angle, shift)
    scan = scene.scan(arguments.angular_step, arguments.noise, arguments.seed)
    if arguments.survey:
        write_survey(arguments, scene, scan)
    elif arguments.split:
        for station in np.unique(scan.station):
            write_laz(_numbered(arguments.output, station), scan, scan.station == station, arguments.crs)
    else:
        write_laz(arguments.output, scan, np.ones(len(scan.points), bool), arguments.crs)
    if arguments.truth:
        write_truth(arguments.truth, scene.truth, arguments.crs)


if __name__ == "__main__":
    main()
