"""The plan of a storey: faces and seen floor first."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Optional

import numpy as np
from shapely.affinity import translate
from shapely.geometry import LineString, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import linemerge

from ...progress import Progress
from .division.division import Division, divide
from .division.outlines import parts_of, sound, united
from .evidence.footprint import Footprint, find_footprint
from .evidence.levels import (
    Frame,
    Storey,
    Uprights,
    find_storey,
    find_uprights,
    frame_around,
    with_measured_ceiling,
)
from .evidence.regular import share_lines, square_up
from .evidence.roof import near_roof, roofed
from .evidence.sheets import Sheet, find_sheets
from .evidence.uprights_along import UprightsAlong
from .evidence.voxels import Voxels, make_voxels
from .rooms.room_cells import Room, find_rooms
from .settings import StoreySettings, WallSettings
from .walls.free_faces import clear_before, free_faces, screens
from .walls.left_out import LeftOut, find_left_out
from .walls.wall_bodies import behind, wall_bodies
from .walls.walls import Wall, describe_walls


@dataclass(frozen=True)
class StoreyPlan:
    """The plan of a storey; lengths in metres, relative to the local origin of the points.

    Attributes
    ----------
    walls : tuple of Wall
    rooms : tuple of Room
    limits : tuple of LineString
        Borders of rooms without a face: where the scan ends.
    left_out : tuple of LeftOut
    sheets : tuple of Sheet
        All straight upright surfaces.
    region : Polygon or MultiPolygon
        Where a ceiling was seen.
    storey : Storey or None
        Heights of floor and ceiling; None if neither was seen, then all is empty.
    spacing_m, noise_m : float
        Measured on the points.
    """

    walls: tuple[Wall, ...]
    rooms: tuple[Room, ...]
    limits: tuple[LineString, ...]
    left_out: tuple[LeftOut, ...]
    sheets: tuple[Sheet, ...]
    region: BaseGeometry
    storey: Optional[Storey]
    spacing_m: float
    noise_m: float

    def moved(self, x: float, y: float) -> "StoreyPlan":
        """Return the plan shifted in plan, metres; the rounding of large coordinates may spoil an outline."""
        shift = np.array([x, y])
        return replace(
            self,
            walls=tuple(replace(wall, outline=sound(translate(wall.outline, x, y))) for wall in self.walls),
            rooms=tuple(replace(room, outline=sound(translate(room.outline, x, y))) for room in self.rooms),
            limits=tuple(translate(line, x, y) for line in self.limits),
            left_out=tuple(replace(item, line=translate(item.line, x, y)) for item in self.left_out),
            sheets=tuple(
                replace(sheet, start=sheet.start + shift, stop=sheet.stop + shift) for sheet in self.sheets
            ),
            region=translate(self.region, x, y),
        )


def make_storey_plan(
    chunks: Iterable[np.ndarray],
    settings: StoreySettings = StoreySettings(),
    progress: Progress = Progress(),
    under_ceiling: bool = False,
) -> StoreyPlan:
    """Make the plan of a storey from its points.

    Parameters
    ----------
    chunks : iterable of ndarray of float64, shape (n, 3)
        Points of one storey, metres, relative to a local origin; any division into chunks.
    settings : StoreySettings
    progress : Progress
        Reports and cancels.
    under_ceiling : bool
        Whether nothing is looked for where no ceiling was seen; this saves time in the open.
    """
    progress.update(0.0, "Reducing points to voxels")
    voxels = make_voxels(chunks, settings.voxels)
    progress.update(0.3, "Finding the storey")
    storey = find_storey(voxels, settings.levels)
    if storey is None or (under_ceiling and storey.ceiling is None):
        return _nothing(voxels)
    if storey.ceiling is not None:
        progress.update(0.35)
        voxels = near_roof(voxels, storey, settings.levels, settings.roof)
    progress.update(0.4, "Finding faces")
    fine, coarse = _frames(voxels, settings)
    uprights = find_uprights(voxels, storey.floor, fine, settings.levels)
    progress.update(0.5)
    sheets = find_sheets(uprights, voxels.noise_m, voxels.spacing_m, settings.sheets)
    sheets = share_lines(square_up(sheets, settings.sheets), settings.sheets)
    if not sheets:
        return _nothing(voxels)
    progress.update(0.6, "Finding floor and ceiling")
    footprint = find_footprint(voxels, storey, uprights, sheets, coarse, settings.footprint, settings.levels)
    progress.update(0.7, "Dividing rooms from solid")
    along = _along(uprights, voxels.spacing_m, settings)
    division = divide(sheets, footprint, along, settings.cut, settings.levels)
    progress.update(0.8, "Finding rooms and walls")
    thin = _screens(division, sheets, along, settings)
    roof = roofed(footprint, settings.roof)
    seen = roof, footprint, storey, along
    rooms, parapets = find_rooms(division, thin, *seen, settings.rooms, settings.levels)
    progress.update(0.9)
    walls = _walls(division, sheets, thin, parapets, footprint, along, storey, settings)
    progress.update(0.95)
    return StoreyPlan(
        walls=tuple(walls),
        rooms=tuple(rooms),
        limits=tuple(_limits(division, settings)),
        left_out=tuple(_left_out(division, sheets, walls, along, settings)),
        sheets=tuple(sheets),
        region=roof,
        storey=with_measured_ceiling(storey, voxels, settings.levels),
        spacing_m=voxels.spacing_m,
        noise_m=voxels.noise_m,
    )


def _nothing(voxels: Voxels) -> StoreyPlan:
    """Return the plan of points that show no storey."""
    return StoreyPlan((), (), (), (), (), Polygon(), None, voxels.spacing_m, voxels.noise_m)


def _frames(voxels: Voxels, settings: StoreySettings) -> tuple[Frame, Frame]:
    """Return the pixels of upright surfaces, and those of floor and ceiling."""
    fine = frame_around(voxels, settings.levels.pixel_m, settings.margin_m, settings.levels)
    coarse = frame_around(voxels, settings.footprint.pixel_m, settings.margin_m, settings.levels)
    return fine, coarse


def _along(uprights: Uprights, spacing: float, settings: StoreySettings) -> UprightsAlong:
    """Return what looks up upright surface beside lines; sparse points are looked for farther away."""
    cut = settings.cut
    step, reach = max(cut.station_m, spacing), max(cut.corner_m, spacing)
    return UprightsAlong(uprights, cut.beside_m, step, reach, settings.sheets.turn_deg)


def _screens(
    division: Division, sheets: list[Sheet], along: UprightsAlong, settings: StoreySettings
) -> np.ndarray:
    """Return the thin walls that stand free in rooms."""
    faces, _ = division.faces(settings.cut)
    return screens(sheets, division.rooms, faces, along, settings.free_faces, settings.levels)


def _walls(
    division: Division,
    sheets: list[Sheet],
    thin: np.ndarray,
    parapets: list[Polygon],
    footprint: Footprint,
    along: UprightsAlong,
    storey: Storey,
    settings: StoreySettings,
) -> list[Wall]:
    """Return the walls behind the faces that bound rooms, and behind those that stand free."""
    faces, _ = division.faces(settings.cut)
    rooms, solid = division.rooms, division.solid
    free = free_faces(sheets, rooms, faces, along, footprint, settings.free_faces, settings.levels)
    if len(free):
        solid = solid.difference(clear_before(free, settings.free_faces.front_m))
    if len(thin):
        solid = united([solid, behind(thin, settings.walls.strip_m)])
    bodies = wall_bodies(np.vstack([faces, free, thin]), solid, settings.walls)
    walls = describe_walls(bodies, parapets, along, storey, settings.walls, settings.cut, settings.levels)
    return [wall for wall in walls if not _lines_parapet(wall, parapets, settings.walls)]


def _lines_parapet(wall: Wall, parapets: list[Polygon], settings: WallSettings) -> bool:
    """Return whether a wall of which one face was seen is the other face of a parapet."""
    if wall.kind == "parapet" or wall.thickness is not None:
        return False
    edge = wall.outline.buffer(settings.parapet_edge_m)
    return any(edge.intersection(parapet.boundary).length > wall.outline.length / 3 for parapet in parapets)


def _limits(division: Division, settings: StoreySettings) -> list[LineString]:
    """Return the borders of rooms without a face."""
    arrangement = division.arrangement
    bare = division.are_borders() & ~division.has_face(settings.cut)
    merged = linemerge([LineString(end.reshape(2, 2)) for end in arrangement.ends[bare]])
    return [line for line in parts_of(merged) if line.length >= settings.shortest_limit_m]


def _left_out(
    division: Division, sheets: list[Sheet], walls: list[Wall], along: UprightsAlong, settings: StoreySettings
) -> list[LeftOut]:
    """Return the surfaces in rooms that are not walls."""
    faces, _ = division.faces(settings.cut)
    outlines = [wall.outline for wall in walls]
    chosen = settings.free_faces, settings.cut, settings.levels
    return find_left_out(sheets, division.rooms, outlines, faces, along, *chosen)
