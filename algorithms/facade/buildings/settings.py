"""Settings of the search for the facades of a cloud."""

from dataclasses import dataclass, field, replace

from ...settings import judged, physical
from ..planes.settings import PlaneSettings, VoxelSettings


@dataclass(frozen=True)
class UprightSettings:
    """Columns of points that can be wall."""

    column_m: float = judged(0.25, "Side of the columns in which heights are counted.")
    level_m: float = judged(0.25, "Height of the levels that hold points or not.")
    least_m: float = physical(
        1.5, "Cars, hedges and fences are lower; a facade has points on more levels in each column."
    )


@dataclass(frozen=True)
class OpennessSettings:
    """On which side of a wall the open air is."""

    cube_m: float = judged(0.2, "Cubes that hold points or not; this is how well the density is evened out.")
    nearest_m: float = physical(0.6, "Nearer points may be cornices, sills, balconies or the wall itself.")
    room_m: float = physical(2.6, "Rooms are hardly shallower; balconies and eaves are.")
    farthest_m: float = judged(8.0, "Where no ceiling shows the side, most of the street was seen this near.")
    cell_m: float = judged(
        0.25, "Pieces of the wall before which ceilings are looked for, and of their depth."
    )
    head_m: float = physical(1.9, "Ceilings are higher above the foot of a wall; people and cars are lower.")
    flat: float = judged(0.6, "A ceiling was seen over this part of the depth; the limit of air is the rest.")
    air_m: float = physical(
        0.5, "There is air this far below a ceiling and above the floor on it; not so within foliage."
    )
    covered: float = judged(0.5, "Walls with a ceiling along this part on either side are inside a building.")
    outside: float = judged(
        0.3, "A wall before rooms is a facade if at least this part of their area was seen outside too."
    )
    clearer: float = judged(
        0.3,
        "The side with ceilings along so much more of the wall is the inside; trees and porches have less.",
    )


@dataclass(frozen=True)
class BuildingSettings:
    """What a facade of a cloud is.

    Attributes
    ----------
    planes : PlaneSettings
        Of the planes that facades consist of.
    """

    upright: UprightSettings = field(default_factory=UprightSettings)
    openness: OpennessSettings = field(default_factory=OpennessSettings)
    planes: PlaneSettings = field(
        default_factory=lambda: replace(
            PlaneSettings(), most_planes=60, smallest_m2=3.0, voxels=VoxelSettings(most_cubes=250_000)
        )
    )
    cube_m: float = judged(0.15, "Cubes of points give the normal of a wall even where windows interrupt it.")
    lean_deg: float = physical(15.0, "Walls that lean more are roofs or rock.")
    thin: float = judged(0.35, "Points of a wall are this near to its plane, in sides of a cube.")
    flat: float = judged(
        0.5,
        "Of the points in the cubes of a wall, so many are that near; in hedges and crowns only a third is.",
    )
    parallel_deg: float = judged(10.0, "Walls that turn by less belong to one facade.")
    apart_m: float = physical(
        2.0, "Storeys set back, bays and balconies lie this near to the main plane of their facade."
    )
    gap_m: float = judged(1.0, "Parallel walls with a wider gap between them are two facades.")
    least_length_m: float = physical(1.5, "A shorter wall is a pier or a chimney.")
    least_height_m: float = physical(1.8, "A lower wall is a parapet or a fence.")
    least_m2: float = physical(4.0, "The area of a small gable; less is a fragment.")
    before_it_m: float = physical(0.1, "A surface this far before another one hides it from the street.")
    hidden: float = judged(
        0.4,
        "A plane that lies behind others with more of itself is an inner face; windows interrupt them.",
    )
    small: float = judged(
        0.4, "A wall behind a facade is a part of its rooms if its area is this part at most."
    )
    on_wall_m: float = physical(0.1, "Points this near to a wall count as its points.")
    nearest_m: float = physical(30.0, "A picked point farther from every facade is in another system.")
    along_m: float = judged(
        2.0, "A line along a facade is drawn this near to it; the inner side of a wall is nearer too."
    )
    along_deg: float = judged(20.0, "Lines that turn by more do not run along it.")
    along_step_m: float = judged(0.1, "Pieces of a line, each of which runs along one facade.")
    along_share: float = judged(0.5, "A shape that runs along this part of a facade has it.")
    key_m: float = judged(0.1, "Squares of the key plan; a metre is about 10 pixels on a small site.")
    around_m: float = judged(1.5, "What stands this far beyond the ends of a facade is measured with it.")
    before_m: float = judged(
        12.0, "What stands this far before a facade is kept: it hides parts of it, and shows its front."
    )
    behind_m: float = judged(6.0, "What is seen this far behind a facade is kept: rooms, passages.")
