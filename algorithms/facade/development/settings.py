"""Settings of facades that turn."""

from dataclasses import dataclass, field, replace

from ...settings import judged, physical
from ..planes.settings import PlaneSettings, VoxelSettings


@dataclass(frozen=True)
class CircleSettings:
    """The circle of a round tower."""

    cube_m: float = judged(0.1, "Side of the cubes whose normals point to the axis of the tower.")
    steep: float = physical(0.26, "Normals of walls are level within 15 degrees.")
    least_radius_m: float = physical(0.7, "Turrets and round stairs are not narrower.")
    largest_radius_m: float = physical(15.0, "Walls of wider towers are hardly distinguished from flat ones.")
    step_m: float = judged(0.1, "Radii and centres are tried in steps of this.")
    coarse: float = judged(0.1, "Centres are counted in squares of this part of the radius.")
    reach_m: float = judged(0.15, "Points this near to the first circle are fitted.")
    rounds: int = judged(8, "Rounds of the robust fit; its weights change little after them.")
    least_sigma_m: float = physical(0.001, "Points scatter by at least this; weights need a scale.")
    radial: float = judged(0.87, "Normals on the wall point to the axis within 30 degrees.")
    on_m: float = judged(0.05, "Cubes this near to the circle are of the wall.")
    least_deg: float = physical(50.0, "A tower of which less is seen has no certain radius.")
    bin_deg: float = judged(2.0, "Pieces of the circle that are seen or not.")
    share: float = judged(0.15, "This part of all upright cubes is on the circle.")


@dataclass(frozen=True)
class SidesSettings:
    """The sides of a bay or a polygonal tower."""

    planes: PlaneSettings = field(
        default_factory=lambda: replace(
            PlaneSettings(), most_planes=40, smallest_m2=0.8, voxels=VoxelSettings(most_cubes=250_000)
        )
    )
    cube_m: float = judged(0.1, "Side of the cubes whose normals show the sides.")
    upright_deg: float = physical(10.0, "Sides lean less.")
    corner_m: float = judged(
        0.6, "Two sides meet if their ends are this near to the corner; planes have squares of 25 cm."
    )
    beyond_m: float = physical(1.0, "Behind the oblique side of a bay, its wall goes on by less.")
    least_deg: float = judged(10.0, "Sides that turn by less are one wall.")
    most_deg: float = physical(75.0, "Sharper corners are those of buildings, with another facade beyond.")
    least_height: float = judged(0.4, "A side has this part of the height of the main one.")
    walled: float = judged(0.25, "Where less of its height is wall, a bay stands before a wall, or a gate.")
    gap_m: float = physical(0.5, "Bays are wider.")
    narrowest_m: float = physical(0.3, "A narrower side is a jamb or a pilaster.")


@dataclass(frozen=True)
class DevelopmentSettings:
    """From points to the line of the wall in plan."""

    circle: CircleSettings = CircleSettings()
    sides: SidesSettings = field(default_factory=SidesSettings)
    reach_m: float = judged(15.0, "The wall may turn up to this far beyond the ends of the chosen facade.")
    beside_m: float = judged(1.5, "What stands this far beyond the ends of the sides is kept.")
    same_m: float = judged(0.3, "A facade this near to a wall that is rolled out is a part of it.")
    on_line_m: float = judged(
        0.05, "Above a bay, what is this near to the line of the wall is wall, and not seen through a hole."
    )
    before_m: float = judged(12.0, "What is farther before the wall is left out.")
    behind_m: float = judged(6.0, "What is farther behind it is left out, as with any facade.")
    inner: float = judged(0.8, "Of a tower, what lies beyond this part of its radius is left out.")
