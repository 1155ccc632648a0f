"""The settings of the facade chapter: the user's parameters, with the paper's symbols, and its stages."""

from dataclasses import dataclass, field
from typing import Optional

from ..clouds.settings import StraySettings
from ..settings import judged, physical
from .buildings.settings import BuildingSettings
from .colour.settings import ColourSettings
from .development.settings import DevelopmentSettings
from .openings.settings import OpeningSettings
from .outlines.settings import OutlineSettings
from .output.settings import OrthoimageSettings
from .planes.settings import PlaneSettings

CLEAR_REGIONS, ALL_REGIONS, NO_REGIONS = range(3)
"""Values of COLOURED: regular regions with a clear step of colour; all regions, as in the paper; none."""


@dataclass(frozen=True)
class ExtentSettings:
    """How far the points of a facade may reach."""

    strays: StraySettings = field(default_factory=StraySettings)
    cell_m: float = judged(5.0, "Of the cells in which stray points are looked for: a part of a gap.")
    largest_m: float = physical(
        2000.0, "Longer than any facade; rasters of the search for planes then have 64 million cells at most."
    )


@dataclass(frozen=True)
class ThinningSettings:
    """How many points are measured at once."""

    most_points: int = physical(
        6_000_000, "A triangulation of more points needs more memory than most computers have."
    )
    finest_m: float = physical(
        0.002, "The first distance that points are thinned to; it grows until few enough remain."
    )
    coarser: float = judged(
        1.05, "Each further distance is larger by at least this factor, so that the search ends."
    )


@dataclass(frozen=True)
class CompletionSettings:
    """Edges that are completed by the openings of the same row."""

    fewest: int = judged(2, "Openings that agree; one alone may be another kind of window.")
    alike_m: float = physical(0.03, "Windows of one kind differ by less in old buildings.")
    farthest_m: float = physical(
        0.25, "An edge that was not seen is this near to where the hole ends: a sill hides less."
    )


@dataclass(frozen=True)
class LeftOutSettings:
    """Surfaces that an elevation does not show."""

    on_wall: float = judged(0.5, "A surface of which more lies on the wall or in an opening is shown.")
    parallel_deg: float = judged(10.0, "At a larger angle to the wall a surface is oblique.")
    square_spacings: float = judged(
        3.0, "Points are averaged in squares so wide: an outline of what is not drawn needs no more."
    )


@dataclass(frozen=True)
class FacadeSettings:
    """How the details of a facade are found.

    Attributes
    ----------
    distance_m : float
        ds, the largest distance of a point from its plane.
    seed_radius_m : float
        td, the largest radius of a seed surface.
    seed_colour : float
        tr, the largest distance of the colour of a seed to the mean of its surface.
    seed_variance : float, optional
        Vr, the largest sum of the variances of red, green and blue in a seed surface; derived from the
        noise of the colours if not given.
    grow_colour : float
        tr2, the largest distance of the colour of a point to the mean of the region it joins.
    intensity : float, optional
        f, regions whose mean intensities differ by less, relative to the wall's, are one; derived from the
        noise of the intensity if not given.
    triangle_factor : float
        delta over the mean area of the triangles.
    triangle_count : int
        eta, the number of larger triangles that a point may belong to.
    noise_iterations : int
        Rounds in which noise is removed, at most.
    alpha_m : float, optional
        Of the alpha shape; follows the spacing of the points if not given.
    min_area_m2 : float, optional
        Of a detail; the square of `seed_radius_m` if not given.
    regularise : bool
        Whether outlines become rectangles and arches where the points allow.
    side : int
        SIDE: 0 if it is found from the points; 1 if the facade faces the eastern half of the horizon, 2 if
        it faces the western one.
    unroll : int
        UNROLL: `FLAT`, `SIDES` or `ROUND` of `development.development`.
    coloured : int
        COLOURED: `CLEAR_REGIONS`, `ALL_REGIONS` or `NO_REGIONS`.
    row_m : float
        Details are numbered from above in rows of this height.
    """

    distance_m: float = judged(
        0.05, "ds of the paper; smaller divides bulging walls, larger swallows recesses."
    )
    seed_radius_m: float = judged(
        0.2, "td of the paper; details are hardly smaller than a surface of this radius."
    )
    seed_colour: float = judged(30.0, "tr of the paper; a seed is typical of the surface around it.")
    seed_variance: Optional[float] = None
    grow_colour: float = judged(
        60.0, "tr2 of the paper; smaller splits surfaces, larger joins similar colours."
    )
    intensity: Optional[float] = None
    triangle_factor: float = judged(3.0, "delta of the paper, in mean areas of the triangles.")
    triangle_count: int = judged(5, "eta of the paper.")
    noise_iterations: int = judged(10, "About ten rounds in the paper; they end when nothing is removed.")
    alpha_m: Optional[float] = None
    min_area_m2: Optional[float] = None
    regularise: bool = True
    side: int = 0
    unroll: int = 0
    coloured: int = CLEAR_REGIONS
    row_m: float = judged(0.5, "Details whose centres differ by less in height may share a row of numbers.")
    thinning: ThinningSettings = field(default_factory=ThinningSettings)
    buildings: BuildingSettings = field(default_factory=BuildingSettings)
    development: DevelopmentSettings = field(default_factory=DevelopmentSettings)
    planes: PlaneSettings = field(default_factory=PlaneSettings)
    openings: OpeningSettings = field(default_factory=OpeningSettings)
    colour: ColourSettings = field(default_factory=ColourSettings)
    outlines: OutlineSettings = field(default_factory=OutlineSettings)
    completion: CompletionSettings = field(default_factory=CompletionSettings)
    left_out: LeftOutSettings = field(default_factory=LeftOutSettings)
    orthoimage: OrthoimageSettings = field(default_factory=OrthoimageSettings)

    @property
    def smallest_m2(self) -> float:
        """The area of the smallest detail."""
        return self.seed_radius_m**2 if self.min_area_m2 is None else self.min_area_m2
