"""The planes of a facade and their points, without ground, side walls and trees."""

from dataclasses import replace
from typing import Optional

import numpy as np

from ...errors import NothingFoundError
from ...geometry.robust import sigma_of_residuals
from ...progress import Progress
from ..elevation import Plane, Points, Segmentation
from .front import AUTOMATIC, EAST, Side, find_side, given_side
from .patches import Patch, extract, make_patch
from .ransac import refit
from .settings import FitSettings, PlaneSettings
from .voxels import Voxels, make_voxels

NONE, OTHER = 0, -1
"""Labels of points outside the planes of the facade, and on a plane in front of it, such as the street."""

OPEN_AIR = (
    "ceilings, or the area seen on each side, show where the open air is; the points close to the wall "
    "do not show its front"
)


def find_planes(
    points: Points,
    distance: float,
    settings: PlaneSettings = PlaneSettings(),
    progress: Progress = Progress(),
    side: int = AUTOMATIC,
    wanted: Optional[Plane] = None,
) -> Segmentation:
    """Find the main plane of a facade and the secondary planes on it, and assign the points.

    A first pass over the whole scan finds the main plane, the largest upright one. Ground and side walls
    compete with it for their points. A second pass finds the secondary planes on the facade.

    Parameters
    ----------
    points : Points
    distance : float
        ds, the largest distance of a point from its plane (m).
    settings : PlaneSettings
    progress : Progress
    side : int
        SIDE: `AUTOMATIC`, `EAST` or `WEST`.
    wanted : Plane, optional
        About the main plane, if it is not to be the largest one; its normal points outward.

    Raises
    ------
    NothingFoundError
        If there is no upright plane, or none like the wanted one.
    """
    axes = _axes_of_facade(points.xyz, distance, settings, wanted)
    progress.update(0.3)
    if side == AUTOMATIC:
        return _along_axes(points, axes, side, distance, settings, progress, wanted)
    if _faces_east(axes[1]) != (side == EAST):
        axes[:2] = -axes[:2]
    found = _along_axes(points, axes, side, distance, settings, progress, wanted)
    if _faces_east(found.planes[0].normal) != (side == EAST):
        # The first, coarse plane was on the other side of north.
        axes[:2] = -axes[:2]
        silent = Progress(is_cancelled=progress.is_cancelled)
        found = _along_axes(points, axes, side, distance, settings, silent, wanted)
    return found


def _faces_east(normal: np.ndarray) -> bool:
    """Whether an azimuth is less than 180 degrees."""
    return bool(np.degrees(np.arctan2(normal[0], normal[1])) % 360 < 180)


def _along_axes(
    points: Points,
    axes: np.ndarray,
    side: int,
    distance: float,
    settings: PlaneSettings,
    progress: Progress,
    wanted: Optional[Plane],
) -> Segmentation:
    """Return the planes and the labels of the points, found along the axes of the facade."""
    scanners = None if points.stations is None else (points.stations @ axes.T)[points.scan]
    if wanted is not None:
        wanted = replace(wanted, normal=axes @ wanted.normal, centre=axes @ wanted.centre)
    found = _in_frame(points.xyz @ axes.T, scanners, side == AUTOMATIC, distance, settings, progress, wanted)
    planes = tuple(
        replace(plane, normal=plane.normal @ axes, centre=plane.centre @ axes) for plane in found.planes
    )
    return replace(found, planes=planes)


def _axes_of_facade(
    xyz: np.ndarray, distance: float, settings: PlaneSettings, wanted: Optional[Plane]
) -> np.ndarray:
    """Return x along the main plane, y at right angles to it and z up, as rows, shape (3, 3).

    Cubes along the wall are the same in every orientation of the site, and so are the planes.
    """
    coarse = settings.coarse * distance
    patches = extract(make_voxels(xyz, coarse, settings.voxels), distance, settings)
    main = _largest_upright(patches, xyz, distance, settings, wanted)
    near = xyz[np.abs(main.heights(xyz)) <= coarse]
    normal, anchor = refit(
        near, main.normal, main.anchor, settings.fit.vote * distance, settings=settings.fit
    )
    out = np.array([normal[0], normal[1], 0.0]) / np.hypot(*normal[:2])
    # The sign must not depend on the orientation of the site.
    limits = (settings.percentile, 100 - settings.percentile)
    behind, before = np.percentile((xyz[:: settings.sampled] - anchor) @ out, limits)
    out = -out if -behind > before else out
    return np.array([[-out[1], out[0], 0.0], out, [0.0, 0.0, 1.0]])


def _largest_upright(
    patches: list[Patch],
    xyz: np.ndarray,
    distance: float,
    settings: PlaneSettings,
    wanted: Optional[Plane] = None,
) -> Patch:
    steepest = np.sin(np.radians(settings.upright_deg))
    upright = [patch for patch in patches if abs(patch.normal[2]) < steepest]
    if not upright:
        raise NothingFoundError(_nothing(xyz, distance, settings))
    if wanted is not None:
        upright = [patch for patch in upright if _is_alike(patch, wanted, settings)]
    if not upright:
        raise NothingFoundError(
            f"The chosen facade has no plane with DISTANCE {distance:g} m; increase DISTANCE, or choose "
            "another FACADE."
        )
    return max(upright, key=lambda patch: patch.area)


def _is_alike(patch: Patch, wanted: Plane, settings: PlaneSettings) -> bool:
    """Whether a plane lies and faces about as a wanted one does."""
    facing = abs(patch.normal @ wanted.normal) > np.cos(np.radians(settings.alike_deg))
    away = np.median(wanted.distances(patch.centres_of_squares()))
    return bool(facing and abs(away) <= settings.alike_m)


def _in_frame(
    xyz: np.ndarray,
    scanners: Optional[np.ndarray],
    automatic: bool,
    distance: float,
    settings: PlaneSettings,
    progress: Progress,
    wanted: Optional[Plane],
) -> Segmentation:
    voxels = make_voxels(xyz, distance, settings.voxels)
    progress.update(0.4, f"{len(xyz)} points are in {len(voxels.centres)} cubes of {voxels.size:.3f} m.")
    every = extract(voxels, distance, settings)
    main = _largest_upright(every, xyz, distance, settings, wanted)
    main = main if main.normal[1] > 0 else main.flipped()
    side = _side(main, xyz, scanners, automatic, distance, settings)
    if automatic and wanted is not None and side.sure < settings.side.doubtful:
        side = replace(side, sign=1 if main.normal @ wanted.normal > 0 else -1, reason=OPEN_AIR)
    main = main if side.sign > 0 else main.flipped()
    progress.update(0.6, f"The main plane covers {main.area:.1f} m².")
    competitors = [patch for patch in every if not _is_facade(patch, main, settings)]
    secondary = _secondary(xyz, main, competitors, distance, settings)[: max(settings.max_planes - 1, 0)]
    progress.update(0.8)
    patches = [main, *(_along(patch, main) for patch in secondary)]
    labels = _assign(xyz, voxels, [*patches, *competitors], distance, settings.fit)
    before = [_is_before(patch, main) for patch in competitors]
    others = np.array([NONE, *range(1, len(patches) + 1), *np.where(before, OTHER, NONE)], np.int16)
    labels = others[labels]
    return _largest_first(xyz, patches, labels, side, settings, progress)


def _nothing(xyz: np.ndarray, distance: float, settings: PlaneSettings) -> str:
    largest = float(np.ptp(xyz, axis=0).max())
    if largest > settings.longest_facade_m:
        return (
            f"No upright plane was found in a cloud of {largest:.0f} m; if the coordinates are in "
            "millimetres or feet, convert them to metres."
        )
    return (
        f"No upright plane of {settings.smallest_m2} m² or more was found with DISTANCE {distance:g} m; "
        "increase DISTANCE, and check that z points up and that the coordinates are in metres."
    )


def _side(
    main: Patch,
    xyz: np.ndarray,
    scanners: Optional[np.ndarray],
    automatic: bool,
    distance: float,
    settings: PlaneSettings,
) -> Side:
    """Return from which side of its plane the facade is seen; scanners in the coordinates of the points."""
    uvw = np.column_stack([(xyz - main.anchor) @ main.axes.T, main.heights(xyz)])
    wall = np.abs(uvw[:, 2]) <= distance
    wall[wall] = main.covers(xyz[wall])
    if not automatic:
        return given_side(uvw, wall, settings.side)
    heights = np.full(len(xyz), np.nan) if scanners is None else main.heights(scanners)
    return find_side(uvw, wall, heights, settings.side)


def _is_facade(patch: Patch, main: Patch, settings: PlaneSettings) -> bool:
    """Whether a plane faces as the main one does and lies near it; true for the main plane itself."""
    steep = abs(patch.normal[2]) < np.sin(np.radians(settings.upright_deg))
    facing = abs(patch.normal @ main.normal) > np.cos(np.radians(settings.facing_deg))
    height = np.median(main.heights(patch.centres_of_squares()))
    return bool(steep and facing and abs(height) <= settings.depth_m)


def _is_before(patch: Patch, main: Patch) -> bool:
    """Whether a plane is on the scanner's side of the main one, as the street is, and a room is not."""
    return bool(np.median(main.heights(patch.centres_of_squares())) > 0)


def _secondary(
    xyz: np.ndarray, main: Patch, competitors: list[Patch], distance: float, settings: PlaneSettings
) -> list[Patch]:
    """Return the planes on the facade, from the points that the main plane and the competitors leave."""
    own = (main.centres_of_squares() - main.anchor) @ main.axes.T
    low, high = own.min(axis=0) - settings.beside_m, own.max(axis=0) + settings.beside_m
    places = (xyz - main.anchor) @ main.axes.T
    zone = ((places > low) & (places < high)).all(axis=1) & (np.abs(main.heights(xyz)) <= settings.depth_m)
    for patch in (main, *competitors):
        zone[zone] = ~((np.abs(patch.heights(xyz[zone])) <= distance) & patch.covers(xyz[zone]))
    left = xyz[zone]
    if len(left) < settings.fewest_points:
        return []
    found = extract(make_voxels(left, distance, settings.voxels), distance, settings)
    refitted = [_refitted(patch, left, distance, settings.fit) for patch in found]
    return [patch for patch in refitted if _is_facade(patch, main, settings)]


def _refitted(patch: Patch, xyz: np.ndarray, distance: float, settings: FitSettings) -> Patch:
    """Return the plane of the points themselves: cubes at its edges hold points of its sides too."""
    near = np.flatnonzero(np.abs(patch.heights(xyz)) <= distance)
    near = near[patch.covers(xyz[near])]
    plane = refit(xyz[near], patch.normal, patch.anchor, settings.vote * distance, settings=settings)
    return make_patch(*plane, patch.centres_of_squares(), patch.side, patch.area)


def _along(patch: Patch, main: Patch) -> Patch:
    return patch.flipped() if patch.normal @ main.normal < 0 else patch


def _assign(
    xyz: np.ndarray, voxels: Voxels, patches: list[Patch], distance: float, settings: FitSettings
) -> np.ndarray:
    """Return the number, from 1, of the plane nearest to each point; `NONE` beyond ds."""
    labels = np.zeros(len(xyz), np.int16)
    least = np.full(len(xyz), np.inf)
    for number, patch in enumerate(patches, start=1):
        beside = np.abs(patch.heights(voxels.centres)) <= distance + np.sqrt(3) * voxels.size
        near = np.flatnonzero(beside[voxels.of_point])
        heights = np.abs(patch.heights(xyz[near]))
        own = heights <= distance
        own[own] = patch.covers(xyz[near[own]])
        near, heights = near[own], heights[own]
        sigma = sigma_of_residuals(heights[heights <= settings.vote * distance]) if len(near) else 0.0
        alike = np.abs(voxels.normals @ patch.normal) >= settings.least_cosine
        fits = (alike[voxels.of_point[near]] | (heights <= settings.sigmas * sigma)) & (heights < least[near])
        labels[near[fits]] = number
        least[near[fits]] = heights[fits]
    return labels


def _largest_first(
    xyz: np.ndarray,
    patches: list[Patch],
    labels: np.ndarray,
    side: Side,
    settings: PlaneSettings,
    progress: Progress,
) -> Segmentation:
    """Return the planes with enough points, the main one first, then by falling number of points."""
    counts = np.bincount(labels[labels > 0], minlength=len(patches) + 1)
    fewest = settings.min_points
    if fewest is None:
        fewest = max(settings.fewest_points, int(settings.share * counts[1]))
    progress.update(0.95, f"Planes of fewer than {fewest} points are left out.")
    others = [label for label in range(2, len(patches) + 1) if counts[label] >= fewest]
    order = [1, *sorted(others, key=lambda label: -counts[label])]
    renamed = np.zeros(len(patches) + 2, np.int16)
    renamed[OTHER] = OTHER
    for new, old in enumerate(order, start=1):
        renamed[old] = new
    labels = renamed[labels]
    planes = tuple(_plane(patches[old - 1], xyz[labels == new]) for new, old in enumerate(order, start=1))
    return Segmentation(planes, labels, side)


def _plane(patch: Patch, xyz: np.ndarray) -> Plane:
    heights = patch.heights(xyz)
    centre = xyz.mean(axis=0) - heights.mean() * patch.normal
    return Plane(patch.normal, centre, float(np.sqrt(np.mean(heights**2))), len(xyz))
