"""How far the openings of one facade depend on what else is in its cloud.

make facade-cuts CLOUDS="street.laz bare.laz rooms.laz", or: python3 -m ichnograph.benchmarks.facade_cuts
CLOUD CLOUD ... [--near X Y] [--tolerance 0.01] [--plain]

The clouds are cut from one scan, in one coordinate system: with the street or without, with rooms or without,
the facade alone, the whole building. Prints the openings of each cloud in the frame of the first: position
and size, and "-" where a cloud does not show it; then how many were found in all clouds, and how far edges
differ that were measured in each of them. All defaults; of a building or a street, the facade nearest to
--near is taken. Colour and intensity are ignored with --plain.
"""

import argparse
import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Optional

import numpy as np
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.facade.elevation import COLOURED, PROJECTION, Detail, Elevation
from ichnograph.algorithms.facade.every_facade import measure_selection
from ichnograph.algorithms.facade.points import read_points
from ichnograph.algorithms.facade.selection import select_facade
from ichnograph.algorithms.facade.settings import FacadeSettings
from ichnograph.tests.scenes.facades.judging import ALIKE, iou
from shapely.geometry import Polygon

SIDES = ("left", "bottom", "right", "top")
"""In the order of the bounds of a polygon."""

Seen = tuple[Detail, Polygon]
"""An opening, and its outline in the frame of the first cloud."""


def measure(path: Path, plain: bool, near: Optional[Sequence[float]]) -> Elevation:
    """Return the elevation of a cloud, of the facade near a point of the site if there is one."""
    points = read_points(open_cloud([path]))
    if plain:
        points = replace(points, rgb=None, intensity=None)
    settings = FacadeSettings()
    return measure_selection(select_facade(points, settings, near=near), settings).elevation


def openings_of(elevation: Elevation, first: Elevation) -> list[Seen]:
    """Return the openings of an elevation, in the frame of the first one."""
    found = [detail for detail in elevation.details if detail.kind not in (COLOURED, PROJECTION)]
    return [(detail, _in_first(detail.outline, elevation, first)) for detail in found]


def _in_first(outline: Polygon, elevation: Elevation, first: Elevation) -> Polygon:
    corners = np.array(outline.exterior.coords)
    site = elevation.frame.world(np.column_stack([corners, np.zeros(len(corners))]))
    return Polygon(first.frame.local(site, np.zeros(3))[:, :2])


def matched(every: Sequence[Sequence[Seen]]) -> list[list[Optional[Seen]]]:
    """Return a row for each opening: as each cloud shows it, or None."""
    rows: list[list[Optional[Seen]]] = []
    for number, found in enumerate(every):
        for opening in found:
            shares = [
                iou(opening[1], _any(row)[1]) if row[number] is None else 0.0 for row in rows
            ]  # A row holds one opening of each cloud.
            best = int(np.argmax(shares)) if shares else -1
            if shares and shares[best] >= ALIKE:
                rows[best][number] = opening
            else:
                rows.append([*[None] * number, opening, *[None] * (len(every) - number - 1)])
    return sorted(rows, key=lambda row: (-_any(row)[1].bounds[1] // 1.0, _any(row)[1].bounds[0]))


def _any(row: Sequence[Optional[Seen]]) -> Seen:
    return next(seen for seen in row if seen is not None)


def differences(row: Sequence[Optional[Seen]]) -> np.ndarray:
    """Return how far each edge differs between the clouds that measured it (m); nan if fewer than two did."""
    edges = np.array([
        [
            bound if np.isfinite(getattr(detail.edges, side)) else np.nan
            for side, bound in zip(SIDES, outline.bounds)
        ]
        for detail, outline in filter(None, row)
    ])  # fmt: skip
    several = np.isfinite(edges).sum(axis=0) >= 2
    spread = np.full(4, np.nan)
    spread[several] = np.nanmax(edges[:, several], axis=0) - np.nanmin(edges[:, several], axis=0)
    return spread


def line(row: Sequence[Optional[Seen]]) -> str:
    """Return a row of the table."""
    left, bottom, *_ = _any(row)[1].bounds
    sizes = " | ".join("-" if seen is None else _size(*seen) for seen in row)
    spread = differences(row)
    largest = f"{1000 * np.nanmax(spread):.0f}" if np.isfinite(spread).any() else "-"
    return f"| {left:.2f}, {bottom:.2f} | {sizes} | {largest} |"


def _size(detail: Detail, outline: Polygon) -> str:
    left, bottom, right, top = outline.bounds
    marks = ["" if np.isfinite(getattr(detail.edges, side)) else side[0].upper() for side in SIDES]
    return f"{right - left:.3f} x {top - bottom:.3f} {detail.shape} {''.join(marks)}".strip()


def summary(rows: Sequence[Sequence[Optional[Seen]]], tolerance: float) -> str:
    """Return what the clouds have in common."""
    everywhere = [row for row in rows if None not in row]
    spread = np.concatenate([differences(row) for row in rows]) if rows else np.empty(0)
    spread = spread[np.isfinite(spread)]
    within = f"{100 * np.mean(spread <= tolerance):.0f} %" if len(spread) else "-"
    largest = f"{1000 * spread.max():.0f} mm" if len(spread) else "-"
    return (
        f"{len(everywhere)} of {len(rows)} openings are in all clouds; of {len(spread)} edges that several "
        f"clouds measured, {within} differ by at most {1000 * tolerance:g} mm, the worst by {largest}."
    )


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("clouds", nargs="+", type=Path, help="of one facade, in one coordinate system")
    parser.add_argument("--near", nargs=2, type=float, metavar=("X", "Y"), help="a point near the facade")
    parser.add_argument("--tolerance", type=float, default=0.01, help="of the edges, metres")
    parser.add_argument("--plain", action="store_true", help="without colour and intensity")
    arguments = parser.parse_args()
    elevations = []
    for path in arguments.clouds:
        started = time.perf_counter()
        elevations.append(measure(path, arguments.plain, arguments.near))
        facing, seconds = elevations[-1].frame.azimuth, time.perf_counter() - started
        print(f"{path.name}: faces azimuth {facing:.1f} degrees, {seconds:.0f} s", flush=True)
    rows = matched([openings_of(elevation, elevations[0]) for elevation in elevations])
    names = " | ".join(path.stem for path in arguments.clouds)
    print(f"\n| left, bottom (m) | {names} | largest difference (mm) |")
    print("|---|" + "---|" * (len(elevations) + 1))
    print("\n".join(map(line, rows)))
    print("\nWidth x height (m), shape, and the first letters of edges that were not measured.")
    print(summary(rows, arguments.tolerance))


if __name__ == "__main__":
    main()
