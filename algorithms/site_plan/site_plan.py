"""The site plan: from the points of scans to walls, axes and rooms (Mueller, Kohoutek and Theiler 2012)."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Optional

from ..clouds.cloud import Cloud
from ..clouds.tiles.tile_store import sort_here
from ..clouds.tiles.tiles import Sorter
from ..errors import InputError, NothingFoundError
from ..progress import Progress
from .axes.axes import Axis, find_axes
from .density.density_image import DensityImage, SortedPoints, sort_and_image
from .density.density_raster import DensityRaster
from .faces.refinement import refine_on_points
from .results import SitePlan, WallPlan
from .rooms.rooms import Room, find_rooms, with_floors
from .settings import SitePlanSettings
from .storeys.doubts import doubts
from .storeys.joining import bodies, join_rooms, join_walls, plan_storey
from .storeys.storey_plan import StoreyPlan
from .walls.extraction import WallParameters, extract_wall_pixels
from .walls.settings import WallSettings
from .walls.wall import Wall, describe_walls

NO_ROOM = "No room is closed: raise DOOR_WIDTH above the widest gap in its walls."


def make_site_plan(
    cloud: Cloud,
    settings: SitePlanSettings = SitePlanSettings(),
    progress: Progress = Progress(),
    sort: Sorter = sort_here,
) -> SitePlan:
    """Make the plan of a site.

    The cloud is thinned and a density image is computed, walls are extracted from it, and their outlines are
    moved onto the faces that the points show. Where a ceiling was seen, rooms and walls come from the faces
    and the floor of the storey instead. Axes follow from the outlines, and so do rooms in the open.

    Parameters
    ----------
    cloud : Cloud
        One site.
    settings : SitePlanSettings
    progress : Progress
    sort : Sorter
        Where the points are sorted and looked at.

    Raises
    ------
    InputError
        If the cloud cannot be a site, or two settings contradict each other.
    NothingFoundError
        If no wall is found.
    CancelledError
        If the caller asked to stop.
    """
    with _sorted(cloud, settings, sort, progress.part(0.0, 0.5)) as (density, points):
        found = _extracted(density, settings, progress.part(0.5, 0.6))
        plan, foliage, storey = _on_faces(found, points, density, settings, progress)
    walls, warnings = plan.walls, plan.warnings
    axes = _axes(walls, settings, progress.part(0.9, 0.95))
    rooms = _rooms(walls, storey, density, settings, progress.part(0.95, 1.0))
    progress.update(1.0)
    return SitePlan(
        transform=density.transform,
        crs=density.crs,
        image=found.image,
        walls=walls,
        warnings=(*warnings, NO_ROOM) if rooms == () else warnings,
        settings=settings,
        density=density,
        pixel_walls=found.walls,
        foliage=foliage,
        storey=storey,
        axes=axes,
        rooms=rooms,
    )


def extract_walls(
    raster: DensityRaster,
    parameters: WallParameters = WallParameters(),
    progress: Progress = Progress(),
    settings: WallSettings = WallSettings(),
) -> WallPlan:
    """Extract the walls from a density raster, with the outlines of their pixels.

    Parameters
    ----------
    raster : DensityRaster
    parameters : WallParameters
        What counts as wall.
    progress : Progress
    settings : WallSettings

    Raises
    ------
    InputError
        If the highest threshold is below the lowest.
    NothingFoundError
        If no wall is found.
    """
    pixel_size = raster.transform.a
    chosen = pixel_size, parameters, progress.part(0.0, 0.8), settings
    image = extract_wall_pixels(raster.density, raster.heights, *chosen)
    progress.update(0.8, "Tracing outlines")
    walls = describe_walls(image, raster.heights, raster.transform)
    warnings = (*raster.warnings, *image.gate.warnings)
    return WallPlan(raster.transform, raster.crs, image, walls, warnings)


@contextmanager
def _sorted(
    cloud: Cloud, settings: SitePlanSettings, sort: Sorter, progress: Progress
) -> Iterator[tuple[DensityImage, SortedPoints]]:
    """Compute the density image, and keep the points for the faces.

    If nothing is found, its warnings are added to the error, as they may say why.
    """
    with sort_and_image(
        cloud,
        settings.spacing_m,
        settings.pixel_size_m,
        settings.neighbourhood_px,
        progress,
        settings.height_range,
        settings.density,
        sort,
    ) as (density, points):
        try:
            yield density, points
        except NothingFoundError as error:
            raise NothingFoundError(str(error), density.warnings) from error


def _extracted(density: DensityImage, settings: SitePlanSettings, progress: Progress) -> WallPlan:
    raster = DensityRaster.of(density)
    return extract_walls(raster, settings.wall_parameters, progress, settings.walls)


def _on_faces(
    found: WallPlan,
    points: SortedPoints,
    density: DensityImage,
    settings: SitePlanSettings,
    progress: Progress,
) -> tuple[WallPlan, int, Optional[StoreyPlan]]:
    """Return the plan with outlines on the faces, the number left out as foliage, and the storey."""
    if not settings.refine:
        return found, 0, None
    chosen = progress.part(0.6, 0.7), settings.faces
    walls, foliage = refine_on_points(found.walls, found.image.walls, points, density, *chosen)
    if not settings.storey:
        return replace(found, walls=walls), foliage, None
    try:
        storey = plan_storey(points, settings.storeys, progress.part(0.7, 0.9))
    except InputError as error:
        # The density image has a plan of the largest site.
        return replace(found, walls=walls, warnings=(*found.warnings, str(error))), foliage, None
    warnings = found.warnings
    if storey:
        walls = join_walls(walls, storey, found.image, density.transform, settings.storeys.joining)
        warnings += doubts(storey, settings.storeys.doubts, settings.storeys.levels)
    return replace(found, walls=walls, warnings=warnings), foliage, storey


def _axes(
    walls: tuple[Wall, ...], settings: SitePlanSettings, progress: Progress
) -> Optional[tuple[Axis, ...]]:
    return find_axes(bodies(walls), settings.axes, progress) if settings.with_axes else None


def _rooms(
    walls: tuple[Wall, ...],
    storey: Optional[StoreyPlan],
    density: DensityImage,
    settings: SitePlanSettings,
    progress: Progress,
) -> Optional[tuple[Room, ...]]:
    if not settings.with_rooms:
        return None
    rooms = find_rooms([wall.outline for wall in walls], settings.rooms, progress)
    rooms = with_floors(rooms, density.ground, density.transform)
    return join_rooms(rooms, storey, settings.storeys.joining) if storey else rooms
