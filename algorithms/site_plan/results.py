"""The results of the chapter: walls from a density raster, and the whole plan of a site."""

from dataclasses import dataclass
from typing import Optional

from affine import Affine
from rasterio.crs import CRS

from .axes.axes import Axis
from .density.density_image import DensityImage
from .rooms.rooms import Room
from .settings import SitePlanSettings
from .storeys.storey_plan import StoreyPlan
from .walls.extraction import WallImage
from .walls.wall import Wall


@dataclass(frozen=True)
class WallPlan:
    """Walls, and how they were found.

    Attributes
    ----------
    transform : Affine
        From (column, row) to world coordinates.
    crs : CRS or None
    image : WallImage
        Wall pixels, thresholds, and what each criterion removed.
    walls : tuple of Wall
    warnings : tuple of str
        What the user may not have meant, and what could not be done.
    """

    transform: Affine
    crs: Optional[CRS]
    image: WallImage
    walls: tuple[Wall, ...]
    warnings: tuple[str, ...]

    @property
    def area(self) -> float:
        """Total area of the walls in m2."""
        return float(sum(wall.outline.area for wall in self.walls))

    @property
    def length(self) -> float:
        """Total length of the centrelines in metres."""
        return float(sum(wall.length for wall in self.walls))


@dataclass(frozen=True)
class SitePlan(WallPlan):
    """The plan of a site, with all that its layers and its report show.

    Attributes
    ----------
    settings : SitePlanSettings
        As they were given.
    density : DensityImage
        What the walls were extracted from.
    pixel_walls : tuple of Wall
        The walls with the outlines of their pixels; the same as `walls` unless these were refined.
    foliage : int
        Number of walls that were left out because their points lie on no face.
    storey : StoreyPlan or None
        The rooms and walls under a ceiling; None if no ceiling was seen, or outlines are those of pixels.
    axes : tuple of Axis or None
        None if they were not wanted.
    rooms : tuple of Room or None
        None if they were not wanted.
    """

    settings: SitePlanSettings
    density: DensityImage
    pixel_walls: tuple[Wall, ...]
    foliage: int
    storey: Optional[StoreyPlan]
    axes: Optional[tuple[Axis, ...]]
    rooms: Optional[tuple[Room, ...]]

    @property
    def coverage(self) -> float:
        """Share of the outlines on which there are points; 0 if the outlines are those of pixels."""
        covered = sum((wall.coverage or 0.0) * wall.outline.length for wall in self.walls)
        return float(covered / sum(wall.outline.length for wall in self.walls))

    @property
    def axes_length(self) -> float:
        """Total length of the axes in metres."""
        return float(sum(axis.length for axis in self.axes or ()))

    @property
    def room_area(self) -> float:
        """Total area of the rooms in m2."""
        return float(sum(room.area for room in self.rooms or ()))
