"""One plan of a site: what its storey shows under a roof, and what the density image shows elsewhere."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Optional

import numpy as np
from affine import Affine
from rasterio.features import rasterize
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

from ...clouds.tiles.lattice import LATTICE
from ...geometry.azimuths import line_azimuth
from ...geometry.polygons import box_sides, polygons_of
from ...progress import Progress
from ..density.density_image import SortedPoints
from ..rooms.rooms import Room
from ..walls.extraction import WallImage
from ..walls.wall import Wall, band_length
from .settings import JoiningSettings, StoreySettings
from .storey_plan import StoreyPlan, make_storey_plan

FLAT = 2
"""Cap style of buffers that end where their line ends."""


def plan_storey(
    points: SortedPoints, settings: StoreySettings, progress: Progress = Progress()
) -> Optional[StoreyPlan]:
    """Make the plan of the storey of a site, in world coordinates; None if no room lies under a ceiling.

    Parameters
    ----------
    points : SortedPoints
    settings : StoreySettings
    progress : Progress
        Reports and cancels.

    Raises
    ------
    InputError
        If what lies under a ceiling is too large.
    """
    edge = points.store.edge * LATTICE
    origin = np.floor(np.min(points.keys, axis=0) * edge)
    chunks = _chunks(points, origin, progress.part(0.0, 0.3))
    plan = make_storey_plan(chunks, settings, progress, under_ceiling=True)
    return under_roof(plan.moved(*origin), settings.joining) if plan.storey else None


def _chunks(points: SortedPoints, origin: np.ndarray, progress: Progress) -> Iterator[np.ndarray]:
    """Yield the points of each tile, shape (n, 3), metres, x and y relative to the origin."""
    for _, tile in points.store.tiles(points.keys, progress, "Reducing points to voxels"):
        xyz = tile.xyz * LATTICE
        xyz[:, :2] += np.array(tile.corner) * LATTICE - origin
        yield xyz


def under_roof(plan: StoreyPlan, settings: JoiningSettings) -> Optional[StoreyPlan]:
    """Return the part of a plan under its roof, with a margin for its region; None if few rooms lie there.

    The tops of walls and the crowns of trees look like a ceiling from above, but there are no rooms below.
    """
    rooms = tuple(
        room
        for room in plan.rooms
        if room.outline.intersection(plan.region).area >= settings.own_share * room.outline.area
    )
    if not rooms or sum(room.outline.area for room in rooms) < settings.roomy_share * plan.region.area:
        return None
    near = plan.region.buffer(settings.wall_reach_m)
    walls = tuple(wall for wall in plan.walls if wall.outline.intersects(near))
    covered = [plan.region, *(room.outline for room in rooms), *(wall.outline for wall in walls)]
    return replace(
        plan,
        rooms=rooms,
        walls=walls,
        region=unary_union(covered).buffer(settings.margin_m),
        limits=tuple(line for line in plan.limits if line.intersects(near)),
        left_out=tuple(item for item in plan.left_out if item.line.intersects(near)),
    )


def join_walls(
    walls: Sequence[Wall], storey: StoreyPlan, image: WallImage, transform: Affine, settings: JoiningSettings
) -> tuple[Wall, ...]:
    """Return the walls of a storey, and what lies outside of its region of the walls of the density image.

    Parameters
    ----------
    walls : sequence of Wall
        Of the density image.
    storey : StoreyPlan
        In world coordinates.
    image : WallImage
    transform : Affine
        From (column, row) to world coordinates.
    settings : JoiningSettings
    """
    outside = [part for wall in walls for part in _outside(wall, storey.region, settings)]
    outside += _columns(walls, storey, settings)
    measured = _measured([wall.outline for wall in storey.walls], image, transform)
    inside = [
        Wall(
            wall_id=0,
            outline=wall.outline,
            kind=wall.kind,
            length=band_length(wall.outline),
            z_base=wall.z_base,
            z_top=wall.z_top,
            height=None if wall.z_base is None or wall.z_top is None else wall.z_top - wall.z_base,
            azimuth=None if wall.kind == "column" else _azimuth(wall.outline),
            density=density,
            votes=votes,
            thickness=wall.thickness,
            coverage=wall.coverage,
            body=wall.body,
        )
        for wall, (density, votes) in zip(storey.walls, measured)
    ]
    return tuple(replace(wall, wall_id=number) for number, wall in enumerate([*inside, *outside], start=1))


def join_rooms(found: Sequence[Room], storey: StoreyPlan, settings: JoiningSettings) -> tuple[Room, ...]:
    """Return the rooms of a storey, and the closed spaces between walls outside of it; none overlap."""
    rooms = [Room(0, room.outline, None, room.z_floor, room.z_ceiling, room.seen) for room in storey.rooms]
    taken = unary_union([*(room.outline for room in storey.rooms), *(wall.outline for wall in storey.walls)])
    for room in found:
        if room.outline.intersection(storey.region).area < settings.own_share * room.outline.area:
            rooms += [_beside(room, taken)] if room.outline.intersects(taken) else [room]
    rooms.sort(key=lambda room: -room.area)
    return tuple(replace(room, room_id=number) for number, room in enumerate(rooms, start=1))


def _beside(room: Room, taken: BaseGeometry) -> Room:
    """Return the largest part of a room beside an area; the density image may miss walls between."""
    parts = polygons_of(room.outline.difference(taken))
    return replace(room, outline=max(parts, key=lambda part: part.area, default=room.outline))


def bodies(walls: Sequence[Wall]) -> list[tuple[int, Polygon]]:
    """Return one outline for each body of connected walls, with the number of the first wall in it."""
    groups: dict[int, list[Wall]] = {}
    for wall in walls:
        groups.setdefault(-wall.wall_id if not wall.body else wall.body, []).append(wall)
    return [
        (group[0].wall_id, outline)
        for group in groups.values()
        for outline in polygons_of(unary_union([wall.outline for wall in group]))
    ]


def _outside(wall: Wall, region: BaseGeometry, settings: JoiningSettings) -> list[Wall]:
    """Return what is left of a wall outside of a region; short ends are dropped."""
    if not wall.outline.intersects(region):
        return [wall]
    parts = polygons_of(wall.outline.difference(region))
    return [
        replace(wall, outline=part, length=band_length(part))
        for part in parts
        if band_length(part) >= settings.shortest_rest_m
    ]


def _columns(walls: Sequence[Wall], storey: StoreyPlan, settings: JoiningSettings) -> list[Wall]:
    """Return the free-standing columns of the density image that stand in rooms of a storey.

    A column seen from few sides bounds too little for the storey, but sheets higher than furniture stand on
    the sides that were seen.
    """
    rooms = unary_union([room.outline for room in storey.rooms])
    taken = unary_union([wall.outline for wall in storey.walls])
    high = [sheet.line for sheet in storey.sheets if sheet.levels >= settings.column_levels]
    beside = unary_union([line.buffer(settings.column_face_m, cap_style=FLAT) for line in high])
    return [
        wall
        for wall in walls
        if _is_compact(wall.outline, settings)
        and wall.outline.exterior.intersection(beside).length
        >= settings.column_coverage * wall.outline.exterior.length
        and rooms.contains(wall.outline)
        and not taken.intersects(wall.outline)
    ]


def _is_compact(outline: Polygon, settings: JoiningSettings) -> bool:
    """Return whether an outline is as small as a column, and no strip along a front of furniture."""
    width, length = box_sides(outline)
    return bool(width * length <= settings.column_m2 and length <= settings.column_slenderness * width)


def _measured(
    outlines: Sequence[Polygon], image: WallImage, transform: Affine
) -> list[tuple[Optional[float], Optional[int]]]:
    """Return the mean density and the usual votes of the pixels of outlines; None where there are none."""
    if not outlines:
        return []
    shapes = [(outline, number) for number, outline in enumerate(outlines, start=1)]
    numbers = rasterize(shapes, image.gated.shape, transform=transform, all_touched=True, dtype="int32")
    measured: list[tuple[Optional[float], Optional[int]]] = []
    order = np.argsort(numbers, axis=None, kind="stable")
    starts = np.searchsorted(numbers.ravel()[order], np.arange(1, len(outlines) + 2))
    for first, stop in zip(starts[:-1], starts[1:]):
        density = image.gated.ravel()[order[first:stop]]
        votes = image.votes.ravel()[order[first:stop]]
        density, votes = density[density > 0], votes[votes > 0]
        measured.append(
            (
                float(density.mean()) if len(density) else None,
                int(np.median(votes)) if len(votes) else None,
            )
        )
    return measured


def _azimuth(outline: Polygon) -> float:
    """Return the direction of the longest edge of an outline, degrees from north."""
    corners = np.asarray(outline.exterior.coords)
    edges = np.diff(corners, axis=0)
    return line_azimuth(edges[np.argmax(np.hypot(*edges.T))])
