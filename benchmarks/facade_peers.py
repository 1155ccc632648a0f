"""Planes, outlines and time of a facade, compared with other tools in one run.

make facade-peers, or: python3 -m ichnograph.benchmarks.facade_peers [--points 1000000]

`make peers` installs open3d, pyransac3d and alphashape; CloudCompare is used if it is installed and its
version has RANSAC on the command line (2.12 and newer). Each runs with its documented settings and the same
distance.
"""

import argparse
import os
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Callable, Optional

import numpy as np
from ichnograph.algorithms.facade.elevation import Points
from ichnograph.algorithms.facade.outlines.alpha_shape import alpha_shape
from ichnograph.algorithms.facade.planes.segmentation import find_planes
from ichnograph.algorithms.geometry.triangulation import triangulate
from ichnograph.tests.scenes.facades import FACADES, FacadeScan, FacadeScene
from ichnograph.tests.scenes.facades.__main__ import write_laz
from shapely.geometry import LinearRing
from shapely.geometry.base import BaseGeometry

from .facade import PLACE, points_of

DISTANCE = 0.05
OUTLINED = 20_000
"""Points of the outline: alphashape takes minutes for more."""

ITERATIONS = 1000


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--points", type=int, default=1_000_000)
    arguments = parser.parse_args()
    scene = FACADES["medina"](0).moved(*PLACE)
    scan = _scan_of(scene, arguments.points)
    points = points_of(scan)
    print(f"medina, {len(points.xyz)} points\n")
    print("| main plane | s | s / ours | angle (mrad) | offset (mm) | of the wall (%) | beyond DISTANCE |")
    print("|---|---|---|---|---|---|---|")
    ours = None
    for name, fit in PLANES.items():
        row, seconds = _plane_row(scene, points, fit, ours)
        ours = ours or seconds
        print(f"| {name} | {row} |", flush=True)
    _print_outlines()
    _print_whole(scan)


def _scan_of(scene: FacadeScene, count: int) -> FacadeScan:
    """Scan so that there are about as many points as asked for."""
    coarse = len(scene.scan(0.04).points)
    return scene.scan(0.04 * (coarse / count) ** 0.5)


def _ours(points: Points) -> np.ndarray:
    return find_planes(points, DISTANCE).labels == 1


def _open3d(points: Points) -> np.ndarray:
    geometry, utility = import_module("open3d").geometry, import_module("open3d").utility
    import_module("open3d").utility.random.seed(0)
    cloud = geometry.PointCloud(utility.Vector3dVector(points.xyz))
    _, rows = cloud.segment_plane(DISTANCE, 3, ITERATIONS)
    return _chosen(points, rows)


def _pyransac3d(points: Points) -> np.ndarray:
    np.random.seed(0)
    _, rows = import_module("pyransac3d").Plane().fit(points.xyz, DISTANCE, maxIteration=ITERATIONS)
    return _chosen(points, rows)


def _cloudcompare(points: Points) -> Optional[np.ndarray]:
    """Return the points of the largest plane; None if this CloudCompare has no RANSAC without a window."""
    with tempfile.TemporaryDirectory() as folder:
        text = Path(folder, "points.xyz")
        rows = np.column_stack([points.xyz, np.arange(len(points.xyz))])
        np.savetxt(text, rows, "%.4f %.4f %.4f %d")
        subprocess.run(
            [
                "CloudCompare", "-SILENT", "-AUTO_SAVE", "OFF", "-C_EXPORT_FMT", "ASC", "-PREC", "4",
                "-O", str(text), "-OCTREE_NORMALS", "AUTO", "-RANSAC", "EPSILON_ABSOLUTE", str(DISTANCE),
                "BITMAP_EPSILON_ABSOLUTE", "0.25", "SUPPORT_POINTS", "5000", "ENABLE_PRIMITIVE", "PLANE",
                "OUT_CLOUD_DIR", folder, "OUTPUT_INDIVIDUAL_SUBCLOUDS",
            ],
            env={**os.environ, "QT_QPA_PLATFORM": "offscreen"}, capture_output=True, check=False,
        )  # fmt: skip
        planes = [path for path in Path(folder).rglob("*.asc") if path != text]
        if not planes:
            return None
        largest = max(planes, key=lambda path: path.stat().st_size)
        return _chosen(points, np.loadtxt(largest)[:, 6].astype(int))


def _chosen(points: Points, rows: np.ndarray) -> np.ndarray:
    chosen = np.zeros(len(points.xyz), bool)
    chosen[np.asarray(rows)] = True
    return chosen


PLANES: dict[str, Callable[[Points], Optional[np.ndarray]]] = {
    "facadeplanes": _ours,
    "open3d": _open3d,
    "pyransac3d": _pyransac3d,
    "CloudCompare": _cloudcompare,
}


def _plane_row(
    scene: FacadeScene,
    points: Points,
    fit: Callable[[Points], Optional[np.ndarray]],
    ours: Optional[float],
) -> tuple[str, Optional[float]]:
    """Time a tool, and compare the plane of its points with the wall."""
    name = fit.__name__[1:]
    if name != "ours" and not (find_spec(name) or (name == "cloudcompare" and shutil.which("CloudCompare"))):
        return "not installed | | | | |", None
    if name == "ours":
        fit(points)  # compiles
    start = time.perf_counter()
    chosen = fit(points)
    seconds = time.perf_counter() - start
    if chosen is None:
        return "has no RANSAC on the command line | | | | |", None
    own = points.xyz[chosen]
    normal = np.linalg.eigh(np.cov((own - own.mean(axis=0)).T))[1][:, 0]
    truth = scene.frame.axes[2]
    uvw = scene.frame.local(points.xyz, points.origin)
    left, bottom, right, top = scene.wall.bounds
    wall = (np.abs(uvw[:, 2]) < 0.01) & (uvw[:, 0] > left) & (uvw[:, 0] < right)
    wall &= (uvw[:, 1] > bottom + 0.1) & (uvw[:, 1] < top)
    angle = np.arccos(min(abs(normal @ truth), 1.0))
    beyond = np.sum(np.abs((own - own.mean(axis=0)) @ normal) > DISTANCE)
    ratio = 1.0 if ours is None else seconds / ours
    return (
        f"{seconds:.2f} | {ratio:.1f} | {1000 * angle:.2f} | {1000 * abs(uvw[chosen, 2].mean()):.2f} "
        f"| {100 * chosen[wall].mean():.1f}, and {np.sum(chosen & ~wall)} others | {beyond}"
    ), seconds


def _print_outlines() -> None:
    """Compare outlines of random points on a wall with a window."""
    generator = np.random.default_rng(0)
    points = generator.uniform((0, 0), (4, 3), (OUTLINED, 2))
    hole = ((points > (1, 1)) & (points < (2, 2.2))).all(axis=1)
    points, truth = points[~hole], 12 - 1.2
    print(f"\n| outline of {len(points)} points | s | s / ours | area - truth (m2) | holes > 0.1 m2 |")
    print("|---|---|---|---|---|")
    ours = None
    for name, outline in _outlines():
        if outline is None:
            print(f"| {name} | not installed | | | |")
            continue
        start = time.perf_counter()
        shape = outline(points)
        seconds = time.perf_counter() - start
        ours = ours or seconds
        rings = [ring for part in getattr(shape, "geoms", [shape]) for ring in part.interiors]
        holes = sum(_area(ring) > 0.1 for ring in rings)
        print(f"| {name} | {seconds:.2f} | {seconds / ours:.1f} | {shape.area - truth:+.3f} | {holes} |")


def _area(ring: LinearRing) -> float:
    x, y = np.array(ring.coords)[:, :2].T
    return 0.5 * abs(float(np.dot(x, np.roll(y, 1)) - np.dot(y, np.roll(x, 1))))


def _outlines() -> Iterator[tuple[str, Optional[Callable[[np.ndarray], BaseGeometry]]]]:
    yield "facadedetails", lambda points: alpha_shape(triangulate(points))
    alpha = 1 / 0.06
    peer = import_module("alphashape").alphashape if find_spec("alphashape") else None
    yield (
        "alphashape",
        None if peer is None else lambda points: peer([tuple(point) for point in points], alpha),
    )


def _print_whole(scan: FacadeScan) -> None:
    """Time the whole chain, from the file to all layers, in a process of its own."""
    code = (
        "import sys; from pathlib import Path\n"
        "from ichnograph.algorithms.clouds.cloud import open_cloud\n"
        "from ichnograph.algorithms.facade import measurement, points, settings\n"
        "from ichnograph.algorithms.facade.output import elevation_layers, orthoimage, schedule\n"
        "cloud = points.read_points(open_cloud([sys.argv[1]]))\n"
        "elevation = measurement.measure_facade(cloud, settings.FacadeSettings())\n"
        "folder = Path(sys.argv[1]).parent\n"
        "elevation_layers.write_elevation(folder / 'elevation.shp', elevation)\n"
        "orthoimage.write_orthoimage(folder / 'orthoimage.tif', cloud, elevation, 0.02, False)\n"
        "schedule.write_schedule(folder / 'schedule.csv', elevation)\n"
    )
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "facade.laz")
        write_laz(path, scan)
        start = time.perf_counter()
        subprocess.run([sys.executable, "-c", code, str(path)], check=True)
        seconds = time.perf_counter() - start
    memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 2**20
    print(f"\nFrom the file to elevation, orthoimage and schedule: {seconds:.0f} s, at most {memory:.2f} GB.")


if __name__ == "__main__":
    main()
