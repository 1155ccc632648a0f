"""The plans of real scans with all defaults, compared with plans drawn by hand where there are any.

make real [CLOUDS=folder] [REFERENCES=folder], or: python3 -m ichnograph.benchmarks.real_clouds [FOLDER]
    [--references FOLDER] [--out build/real]

FOLDER holds clouds, each a site; ../shared/data if not given. A reference
is a drawn plan (see `algorithms.evaluation.drawn_plan`) called <cloud>.geojson, in the folder of references,
in FOLDER, or among those of this project (benchmarks/references). Tolerance 5 cm; the offset is that of
outlines within 20 cm of a face. Leaves layers and pictures for each cloud: density image and walls;
and the plan over a slice, where it agrees with the reference and where not.
"""

import argparse
import gzip
import time
import zipfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

import laspy
import numpy as np
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.errors import IchnographError
from ichnograph.algorithms.evaluation.drawn_plan import (
    RoomAgreement,
    compare_rooms,
    compare_with_drawn,
    read_drawn_plan,
)
from ichnograph.algorithms.evaluation.plan import AGREES, MISSING, WRONG, PlanAgreement
from ichnograph.algorithms.site_plan.results import SitePlan
from ichnograph.algorithms.site_plan.settings import SitePlanSettings
from ichnograph.algorithms.site_plan.site_plan import make_site_plan
from ichnograph.scripts.picture import draw
from matplotlib.figure import Figure

from .layers import write_layers

TOLERANCE, SEARCH = 0.05, 0.20
"""Of completeness and correctness, and of offsets, metres."""

SLICE = (1.0, 1.2)
"""Heights above the ground of the points below a plan in a picture, metres."""

ROOMS = "found / missed / invented"
STATES = {AGREES: "#1b7837", WRONG: "#d7301f", MISSING: "#2166ac"}

SCANS = (".las", ".laz", ".xyz")
"""Extensions of scans; in others there are lists of points."""

UP_IS_Y = ("indoor",)
"""Clouds whose heights are in the second column."""

ROOM = "room_two_stations"

REFERENCES = Path(__file__).resolve().parent / "references"
"""Plans drawn by hand of scans that may be passed on."""

ROOM_STATIONS = (
    (
        (0.999965, 0.000041, 0.008399, 0.0),
        (0.000041, 0.999953, -0.009699, 0.0),
        (-0.008399, 0.009699, 0.999918, 0.0),
    ),
    (
        (0.756482, -0.653261, 0.031382, 1.968232),
        (0.653519, 0.756905, 0.002584, 0.057683),
        (-0.025441, 0.018554, 0.999504, -0.003026),
    ),
)
"""From the two stations of the room to one level frame: by least squares on their common planes, metres."""

TRIPOD = 0.6
"""Points nearer to a station of the room are of what carries the scanner, metres."""


def scans(folder: Path, work: Path) -> list[tuple[str, Path]]:
    """Return names and clouds; those in another frame or compressed ones are rewritten in `work`."""
    found = [(path.stem, path) for path in sorted(folder.rglob("*")) if path.suffix.lower() in SCANS]
    ready = [(name, path if name not in UP_IS_Y else upright(path, work)) for name, path in found]
    for packed in sorted(folder.rglob("*.pts.gz")):
        plain = work / packed.stem
        plain.write_bytes(gzip.decompress(packed.read_bytes()))
        ready.append((plain.stem, plain))
    ready += [(ROOM, room(rows, work)) for rows in sorted(folder.glob("rooms_pcl_scan_pair"))]
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


def room(folder: Path, work: Path) -> Path:
    """Write the two stations of the room in one frame."""
    stations = []
    for number, matrix in enumerate(np.array(ROOM_STATIONS), start=1):
        xyz = np.loadtxt(folder / f"room_scan{number}.xyz", usecols=(0, 1, 2))
        far = xyz[np.sum(xyz**2, axis=1) > TRIPOD**2]
        stations.append(far @ matrix[:, :3].T + matrix[:, 3])
    x, y, z = np.concatenate(stations).T
    return write(x, y, z, work / f"{ROOM}.laz")


def reference_of(name: str, *folders: Optional[Path]) -> Optional[Path]:
    """Return the drawn plan of a cloud in the first of the folders that has one, if there is any."""
    paths = [folder / f"{name}.geojson" for folder in folders if folder]
    return next((path for path in paths if path.exists()), None)


def write(x: np.ndarray, y: np.ndarray, z: np.ndarray, path: Path) -> Path:
    """Write coordinates in metres as LAZ."""
    header = laspy.LasHeader(point_format=0, version="1.2")
    header.scales = np.full(3, 0.001)
    las = laspy.LasData(header)
    las.x, las.y, las.z = x, y, z
    las.write(str(path))
    return path


@dataclass(frozen=True)
class Row:
    """How a plan agrees with a drawn one; lengths in metres."""

    agreement: PlanAgreement
    rooms: Optional[RoomAgreement]

    @property
    def p95_offset(self) -> float:
        """Distance that 95 % of the outlines near a face do not exceed."""
        return self.agreement.plan.quantile(0.95, SEARCH)


def compared(plan: SitePlan, reference: Path) -> Row:
    """Compare a plan with the drawn one in a file."""
    drawn = read_drawn_plan(reference)
    agreement = compare_with_drawn([wall.outline for wall in plan.walls], drawn, TOLERANCE)
    rooms = [room.outline for room in plan.rooms or ()]
    return Row(agreement, compare_rooms(rooms, drawn) if drawn.rooms else None)


def cells(row: Optional[Row]) -> str:
    """Return the cells of a row of the table."""
    if row is None:
        return "- | - | - | - | -"
    found, rooms = row.agreement, row.rooms
    counts = f"{rooms.found} / {rooms.missed} / {rooms.invented}" if rooms else "-"
    area = f"{100 * rooms.median_area_error:.1f}" if rooms and rooms.area_errors else "-"
    return f"{found.completeness:.3f} | {found.correctness:.3f} | {row.p95_offset:.3f} | {counts} | {area}"


def mean(rows: Sequence[Row]) -> str:
    """Return the last row of the table: means, and the sums of rooms."""
    found = [row.agreement for row in rows]
    counts = [row.rooms for row in rows if row.rooms]
    sums = [sum(getattr(count, name) for count in counts) for name in ("found", "missed", "invented")]
    errors = [error for count in counts for error in count.area_errors]
    return (
        f"| mean | {np.mean([item.completeness for item in found]):.3f} "
        f"| {np.mean([item.correctness for item in found]):.3f} "
        f"| {np.mean([row.p95_offset for row in rows]):.3f} | {' / '.join(map(str, sums))} "
        f"| {100 * np.median(errors) if errors else float('nan'):.1f} | | | |"
    )


def slice_of(path: Path, plan: SitePlan) -> np.ndarray:
    """Return the points of a cloud about the height at which plans are cut, shape (n, 2)."""
    cloud, ground, grid = open_cloud([path]), plan.density.ground, ~plan.transform
    found = []
    for chunk in cloud.chunks():
        x, y, z = (chunk.xyz + cloud.origin).T
        column, row = (np.floor(values).astype(int) for values in grid * (x, y))
        inside = (row >= 0) & (row < ground.shape[0]) & (column >= 0) & (column < ground.shape[1])
        above = z[inside] - ground[row[inside], column[inside]]
        near = (above > SLICE[0]) & (above < SLICE[1])
        found.append(np.column_stack([x[inside][near], y[inside][near]]))
    return np.concatenate(found)


def draw_compared(path: Path, points: np.ndarray, plan: SitePlan, row: Row) -> None:
    """Draw a plan over a slice: what agrees green, wrong outlines red, missing faces blue."""
    figure = Figure(figsize=(13, 13), layout="constrained")
    axes = figure.add_subplot()
    axes.scatter(*points.T, s=0.2, c="0.6", linewidths=0)
    for room in plan.rooms or ():
        axes.fill(*room.outline.exterior.xy, color="#2a8a96", alpha=0.12)
    for stretch in row.agreement.stretches():
        axes.plot(*stretch.line.xy, color=STATES[stretch.state], linewidth=1.4)
    axes.set(aspect="equal", xticks=[], yticks=[])
    figure.savefig(path, dpi=80)


def main() -> None:
    """Print a row for each cloud, and the mean of those with references."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folder", type=Path, nargs="?", default=Path("../shared/data"))
    parser.add_argument("--references", type=Path, help="folder of <cloud>.geojson")
    parser.add_argument("--out", type=Path, default=Path("build/real"))
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    rows: list[Row] = []
    print(f"| cloud | complete | correct | 95 % (m) | rooms {ROOMS} | area error (%) | walls | s | remarks |")
    print("|---|---|---|---|---|---|---|---|---|")
    for name, path in scans(arguments.folder, arguments.out):
        started = time.perf_counter()
        try:
            plan = make_site_plan(open_cloud([path]), SitePlanSettings(with_rooms=True))
        except IchnographError as error:
            print(f"| {name} | | | | | | | | {error} |", flush=True)
            continue
        seconds = time.perf_counter() - started
        density, walls = write_layers(plan, arguments.out, name)
        draw(density, walls, arguments.out / f"{name}.png")
        reference = reference_of(name, arguments.references, arguments.folder, REFERENCES)
        row = compared(plan, reference) if reference else None
        if row:
            rows.append(row)
            draw_compared(arguments.out / f"{name}_compared.png", slice_of(path, plan), plan, row)
        # These clouds have no coordinate reference system.
        remarks = " ".join(warning for warning in plan.warnings if "reference system" not in warning)
        print(f"| {name} | {cells(row)} | {len(plan.walls)} | {seconds:.1f} | {remarks} |", flush=True)
    if rows:
        print(mean(rows))


if __name__ == "__main__":
    main()
