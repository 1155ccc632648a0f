"""The planes of a facade and their points, apart from ground, side walls and trees."""

from dataclasses import replace
from typing import Optional

import numpy as np

from ...errors import NothingFoundError
from ...geometry.robust import sigma_of_residuals
from ...progress import Progress
from ..elevation import Plane, Points, Segmentation
from .patches import Patch, extract, make_patch
from .ransac import NORMAL, SHARP, refit
from .voxels import Voxels, make_voxels

UPRIGHT = 45.0
"""A facade leans by less (degrees)."""

FACING = 60.0
"""Planes on the facade are turned against the main one by less (degrees)."""

DEPTH, BESIDE = 1.0, 0.3
"""How far before, behind and beside the main plane the facade reaches (m)."""

FAR_SIDE, AROUND = 0.5, 2.0
"""What is further from the main plane, and not much beside it, tells where the scanner stood (m)."""

SMALLEST = 0.25
"""The smallest plane (m2)."""

MOST_COMPETITORS = 15
SHARE, FEWEST = 0.01, 100
"""The derived number of points of the smallest plane: a share of the main plane's, and no less than this."""

COARSE = 2.0
"""The cubes in which the main plane is looked for, in units of ds."""

STEP = 100
"""Every so-manyth point tells which way the facade faces."""

CERTAIN = 3.0
"""Points within this many standard deviations are of a plane, whatever the normal around them."""

LONGEST_FACADE = 500.0
"""A facade that is longer is not in metres."""

NONE, OTHER = 0, -1
"""Labels of points of no plane of the facade, and of a plane before it, such as the street."""


def find_planes(
    points: Points,
    distance: float,
    min_points: Optional[int] = None,
    max_planes: int = 10,
    progress: Progress = Progress(),
) -> Segmentation:
    """Find the main plane of a facade and the secondary planes on it, and assign the points.

    A first pass over the whole scan sets the facade apart: its main plane is the largest upright one;
    ground and side walls become its competitors. A second pass finds the planes on it.

    Parameters
    ----------
    points : Points
    distance : float
        ds, the largest distance of a point from its plane (m).
    min_points : int, optional
        Of the smallest plane; derived from the main plane if not given.
    max_planes : int
        The main one included.
    progress : Progress

    Raises
    ------
    NothingFoundError
        If there is no upright plane.
    """
    axes = _axes_of_facade(points.xyz, distance)
    progress.update(0.3)
    found = _in_frame(points.xyz @ axes.T, distance, min_points, max_planes, progress)
    planes = tuple(
        replace(plane, normal=plane.normal @ axes, centre=plane.centre @ axes) for plane in found.planes
    )
    return Segmentation(planes, found.labels)


def _axes_of_facade(xyz: np.ndarray, distance: float) -> np.ndarray:
    """Return x along the main plane, y at right angles to it and z up, as rows, shape (3, 3).

    Cubes that lie along the wall are the same however the site is turned, and so are the planes.
    """
    voxels = make_voxels(xyz, COARSE * distance)
    main = _largest_upright(extract(voxels, distance, MOST_COMPETITORS, SMALLEST), xyz, distance)
    whole, xyz = xyz, xyz[np.abs(main.heights(xyz)) <= COARSE * distance]
    normal, place = refit(xyz, main.normal, main.place, SHARP * distance)
    out = np.array([normal[0], normal[1], 0.0]) / np.hypot(*normal[:2])
    # Of both directions the same one, wherever north is.
    behind, before = np.percentile((whole[::STEP] - place) @ out, (5, 95))
    out = -out if -behind > before else out
    return np.array([[-out[1], out[0], 0.0], out, [0.0, 0.0, 1.0]])


def _largest_upright(patches: list[Patch], xyz: np.ndarray, distance: float) -> Patch:
    upright = [patch for patch in patches if abs(patch.normal[2]) < np.sin(np.radians(UPRIGHT))]
    if not upright:
        raise NothingFoundError(_nothing(xyz, distance))
    return max(upright, key=lambda patch: patch.area)


def _in_frame(
    xyz: np.ndarray, distance: float, min_points: Optional[int], max_planes: int, progress: Progress
) -> Segmentation:
    voxels = make_voxels(xyz, distance)
    progress.update(0.4, f"{len(xyz)} points are in {len(voxels.centres)} cubes of {voxels.size:.3f} m.")
    every = extract(voxels, distance, MOST_COMPETITORS, SMALLEST)
    main = _facing_scanner(_largest_upright(every, xyz, distance), voxels.centres)
    progress.update(0.6, f"The main plane covers {main.area:.1f} m2.")
    competitors = [patch for patch in every if not _is_facade(patch, main)]
    secondary = _secondary(xyz, main, competitors, distance)[: max(max_planes - 1, 0)]
    progress.update(0.8)
    patches = [main, *(_along(patch, main) for patch in secondary)]
    labels = _assign(xyz, voxels, [*patches, *competitors], distance)
    before = [_is_before(patch, main) for patch in competitors]
    others = np.array([NONE, *range(1, len(patches) + 1), *np.where(before, OTHER, NONE)], np.int16)
    labels = others[labels]
    return _largest_first(xyz, patches, labels, min_points, progress)


def _nothing(xyz: np.ndarray, distance: float) -> str:
    largest = float(np.ptp(xyz, axis=0).max())
    if largest > LONGEST_FACADE:
        return (
            f"No upright plane was found in a cloud of {largest:.0f} m; if the coordinates are in "
            "millimetres or feet, convert them to metres."
        )
    return (
        f"No upright plane of {SMALLEST} m2 or more was found with DISTANCE {distance:g} m; "
        "increase DISTANCE, and check that z points up and that the coordinates are in metres."
    )


def _facing_scanner(main: Patch, centres: np.ndarray) -> Patch:
    """Return the patch with its normal on the side that most was seen on."""
    own = (main.centres_of_squares() - main.place) @ main.axes.T
    places = (centres - main.place) @ main.axes.T
    near = ((places > own.min(axis=0) - AROUND) & (places < own.max(axis=0) + AROUND)).all(axis=1)
    heights = main.heights(centres[near])
    before, behind = np.sum(heights > FAR_SIDE), np.sum(heights < -FAR_SIDE)
    return main.flipped() if behind > before else main


def _is_facade(patch: Patch, main: Patch) -> bool:
    """Tell whether a plane of the whole scan faces the viewer and lies near the main one, or is it."""
    steep = abs(patch.normal[2]) < np.sin(np.radians(UPRIGHT))
    facing = abs(patch.normal @ main.normal) > np.cos(np.radians(FACING))
    return bool(steep and facing and abs(np.median(main.heights(patch.centres_of_squares()))) <= DEPTH)


def _is_before(patch: Patch, main: Patch) -> bool:
    """Tell whether a plane is on the scanner's side of the main one, as the street, not a room behind it."""
    return bool(np.median(main.heights(patch.centres_of_squares())) > 0)


def _secondary(xyz: np.ndarray, main: Patch, competitors: list[Patch], distance: float) -> list[Patch]:
    """Return the planes on the facade, from what the main plane and the competitors leave."""
    own = (main.centres_of_squares() - main.place) @ main.axes.T
    low, high = own.min(axis=0) - BESIDE, own.max(axis=0) + BESIDE
    places = (xyz - main.place) @ main.axes.T
    zone = ((places > low) & (places < high)).all(axis=1) & (np.abs(main.heights(xyz)) <= DEPTH)
    for patch in (main, *competitors):
        zone[zone] = ~((np.abs(patch.heights(xyz[zone])) <= distance) & patch.covers(xyz[zone]))
    left = xyz[zone]
    if len(left) < FEWEST:
        return []
    found = extract(make_voxels(left, distance), distance, MOST_COMPETITORS, SMALLEST)
    refitted = [_refitted(patch, left, distance) for patch in found]
    return [patch for patch in refitted if _is_facade(patch, main)]


def _refitted(patch: Patch, xyz: np.ndarray, distance: float) -> Patch:
    """Return the plane of the points themselves: cubes at its edges hold points of its sides too."""
    near = np.flatnonzero(np.abs(patch.heights(xyz)) <= distance)
    near = near[patch.covers(xyz[near])]
    plane = refit(xyz[near], patch.normal, patch.place, SHARP * distance)
    return make_patch(*plane, patch.centres_of_squares(), patch.area)


def _along(patch: Patch, main: Patch) -> Patch:
    return patch.flipped() if patch.normal @ main.normal < 0 else patch


def _assign(xyz: np.ndarray, voxels: Voxels, patches: list[Patch], distance: float) -> np.ndarray:
    """Return for each point the number, from 1, of the plane that is nearest; `NONE` beyond ds."""
    labels = np.zeros(len(xyz), np.int16)
    least = np.full(len(xyz), np.inf)
    for number, patch in enumerate(patches, start=1):
        beside = np.abs(patch.heights(voxels.centres)) <= distance + np.sqrt(3) * voxels.size
        near = np.flatnonzero(beside[voxels.of_point])
        heights = np.abs(patch.heights(xyz[near]))
        own = heights <= distance
        own[own] = patch.covers(xyz[near[own]])
        near, heights = near[own], heights[own]
        sigma = sigma_of_residuals(heights[heights <= SHARP * distance]) if len(near) else 0.0
        alike = np.abs(voxels.normals @ patch.normal) >= NORMAL
        fits = (alike[voxels.of_point[near]] | (heights <= CERTAIN * sigma)) & (heights < least[near])
        labels[near[fits]] = number
        least[near[fits]] = heights[fits]
    return labels


def _largest_first(
    xyz: np.ndarray, patches: list[Patch], labels: np.ndarray, min_points: Optional[int], progress: Progress
) -> Segmentation:
    """Return the planes with enough points, the main one first, then by falling number of points."""
    counts = np.bincount(labels[labels > 0], minlength=len(patches) + 1)
    fewest = max(FEWEST, int(SHARE * counts[1])) if min_points is None else min_points
    progress.update(0.95, f"Planes of fewer than {fewest} points are left out.")
    others = [label for label in range(2, len(patches) + 1) if counts[label] >= fewest]
    order = [1, *sorted(others, key=lambda label: -counts[label])]
    renamed = np.zeros(len(patches) + 2, np.int16)
    renamed[OTHER] = OTHER
    for new, old in enumerate(order, start=1):
        renamed[old] = new
    labels = renamed[labels]
    planes = tuple(_plane(patches[old - 1], xyz[labels == new]) for new, old in enumerate(order, start=1))
    return Segmentation(planes, labels)


def _plane(patch: Patch, xyz: np.ndarray) -> Plane:
    heights = patch.heights(xyz)
    centre = xyz.mean(axis=0) - heights.mean() * patch.normal
    return Plane(patch.normal, centre, float(np.sqrt(np.mean(heights**2))), len(xyz))
