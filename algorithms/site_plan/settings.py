"""The settings of the chapter: what the user chooses, and those of the stages."""

from dataclasses import dataclass, field

from ..settings import judged
from .axes.settings import AxisSettings
from .density.height_range import HeightRange
from .density.settings import DensitySettings
from .faces.settings import FaceSettings
from .rooms.settings import RoomSettings
from .storeys.settings import StoreySettings
from .walls.extraction import WallParameters
from .walls.settings import WallSettings


@dataclass(frozen=True)
class SitePlanSettings:
    """How the plan of a site is made.

    Attributes
    ----------
    spacing_m : float
        Minimum distance between the points that are counted.
    pixel_size_m : float
        Edge of a pixel of the density image.
    neighbourhood_px : int
        A point spreads over the pixels up to this far from its own; 0 counts points per pixel.
    height_range : HeightRange
        Points outside are left out.
    wall_parameters : WallParameters
        What counts as wall.
    refine : bool
        Whether outlines are moved from the edges of pixels to the faces of the walls.
    storey : bool
        Whether faces and floor of the storey decide where a ceiling was seen, if outlines are refined.
    with_axes, with_rooms : bool
        Whether axes and rooms are looked for.
    density, walls, faces, axes, rooms, storeys
        Settings of the stages.
    """

    spacing_m: float = judged(0.05, "Mueller et al. found 5 cm better than 2.5 and 10 cm.")
    pixel_size_m: float = judged(0.10, "Mueller et al. found 10 cm best: smaller pixels leave gaps in walls.")
    neighbourhood_px: int = judged(1, "The next pixels take up how walls lie in the grid; more blurs them.")
    height_range: HeightRange = field(default_factory=HeightRange)
    wall_parameters: WallParameters = field(default_factory=WallParameters)
    refine: bool = True
    storey: bool = True
    with_axes: bool = False
    with_rooms: bool = False
    density: DensitySettings = field(default_factory=DensitySettings)
    walls: WallSettings = field(default_factory=WallSettings)
    faces: FaceSettings = field(default_factory=FaceSettings)
    axes: AxisSettings = field(default_factory=AxisSettings)
    rooms: RoomSettings = field(default_factory=RoomSettings)
    storeys: StoreySettings = field(default_factory=StoreySettings)
