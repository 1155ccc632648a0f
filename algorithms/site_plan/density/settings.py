"""The settings of the density image: what a person may doubt, each with its reason."""

from dataclasses import dataclass, field

from ...clouds.settings import StraySettings
from ...settings import judged, physical


@dataclass(frozen=True)
class SiteSettings:
    """Which points belong to the site, and how large it may be."""

    strays: StraySettings = field(default_factory=StraySettings)
    most_pixels: int = physical(100_000_000, "A square kilometre at 10 cm; it takes about 8 GB of memory.")
    smallest_pixel_m: float = physical(1e-3, "No scan is denser.")
    largest_pixel_m: float = physical(10.0, "Larger pixels hold no wall.")


@dataclass(frozen=True)
class HeightWindowSettings:
    """The heights above the local ground in which a wall is looked for."""

    lowest_m: float = judged(
        0.3, "Above the roughness of the ground, and low enough for the walls of a ruin."
    )
    highest_m: float = judged(2.3, "Below most ceilings and crowns, and about as high as a door.")
    bin_m: float = judged(0.1, "Scan lines on a near wall are closer together; lower bins would stay empty.")

    @property
    def bins(self) -> int:
        """Number of bins in the window."""
        return round((self.highest_m - self.lowest_m) / self.bin_m)


@dataclass(frozen=True)
class GroundSettings:
    """The surface from which heights are counted."""

    cell_m: float = physical(
        0.5,
        "Wider than most walls are thick, so that ground is seen beside them; a tile holds whole cells.",
    )
    layer_m: float = judged(0.1, "Higher than ground is rough within a cell.")
    support_share: float = judged(0.01, "Single points below the ground are reflections.")
    support_points: int = judged(5, "Enough in any case: under a crown few points reach the ground.")
    steepest: float = physical(0.7, "Rise by run; soil does not lie steeper, and a higher step is an edge.")
    clearance_layers: int = judged(
        5, "Half a metre above ground is clear, unlike that above a wall's stones."
    )
    pit_m: float = judged(1.0, "A cell this far below nearly all around it is a reflection.")
    usual_percentile: float = judged(10.0, "Of the heights around a cell: low, but not the lowest of all.")
    usual_cells: int = judged(7, "Size of those surroundings: wider than a wall, narrower than a terrace.")
    patch_cells: int = judged(4, "Ground somewhere holds a smooth square of 2 m; a table does not.")
    smooth_m: float = judged(
        0.15, "Largest change of the rise on smooth ground; the underside of a crown bends more."
    )
    room_m: float = physical(
        1.0, "A surface with so much space below it is a ceiling, if the ground was cut off."
    )
    room_share: float = judged(
        0.05, "Share of the cells that lie that far below a ceiling at least; not a few pits."
    )


@dataclass(frozen=True)
class SpreadSettings:
    """How far the points of a pixel spread: it separates foliage from walls."""

    parts: int = judged(
        4, "A pixel is cut so many times each way: parts narrower than the noise add nothing."
    )
    fewest_points: int = judged(8, "The spread of fewer points is a matter of chance.")


@dataclass(frozen=True)
class CeilingSettings:
    """Where a ceiling was seen."""

    cell_m: float = judged(0.5, "Wide enough for the ceiling to fill most of a cell beside a wall.")
    lowest_m: float = physical(
        2.0, "Nobody builds a lower ceiling to live under; tables and cupboards are lower."
    )
    cover: float = judged(
        0.7, "Share of a cell's pixels that a ceiling covers; a beam or a crown covers less."
    )
    clear_bins: int = judged(5, "Half a metre below a ceiling is free of all but walls and beams.")
    clutter: float = judged(0.25, "Share of that space which walls and beams take at most.")
    patch_cells: int = judged(4, "A ceiling somewhere holds a level square of 2 m.")
    detected_share: float = judged(
        0.6, "Share of a ceiling's cells in which it is detected; crowns reach half, beams hide the rest."
    )
    beside_cells: int = judged(2, "Points as high as a ceiling within a metre of it belong to it.")
    beam_bins: int = judged(6, "A beam reaches less than 0.6 m below its ceiling.")
    gap_bins: int = judged(2, "Scan lines on a distant wall leave so many bins empty between them.")


@dataclass(frozen=True)
class DensitySettings:
    """The settings of the density image, by stage."""

    site: SiteSettings = SiteSettings()
    window: HeightWindowSettings = HeightWindowSettings()
    ground: GroundSettings = GroundSettings()
    spread: SpreadSettings = SpreadSettings()
    ceiling: CeilingSettings = CeilingSettings()
