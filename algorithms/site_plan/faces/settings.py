"""The settings of the faces of walls: what a person may doubt, each with its reason."""

from dataclasses import dataclass, field

import numpy as np

from ...geometry.settings import CurveSettings, WallSizeSettings
from ...settings import judged, physical, statistical


@dataclass(frozen=True)
class FacePointSettings:
    """Which points may belong to faces, and how they are thinned to voxels."""

    reach_m: float = judged(0.3, "Outlines of pixels lie nearer to their faces than this, even at rubble.")
    voxel_m: float = judged(0.02, "Finer than a wall is rough; finer voxels would count by scan density.")
    levels: int = judged(40, "The window of 2 m is cut into levels of 5 cm, coarser than scan lines.")
    seen_share: float = judged(0.5, "Where fewer wall pixels are occupied, as in a slice, all heights count.")
    top_percentile: float = judged(99.0, "Of the highest points: what lies above a slice does not count.")


@dataclass(frozen=True)
class RidgeSettings:
    """The line of most voxels beside each station of an outline."""

    finest_m: float = judged(0.1, "Finer pixels use windows of this pixel size: faces do not become sharper.")
    step_px: float = judged(0.5, "Distance of the stations: two ridge points for each pixel.")
    half_chord_px: float = judged(1.5, "Longer than the steps of an outline of pixels, shorter than a jamb.")
    along_m: float = judged(0.15, "Half the window along: curved walls bend little in it, a jamb fills most.")
    longest_m: float = judged(0.3, "Half of it where points are sparse: the side of a column is as long.")
    usual_voxels: float = statistical(
        11.0, "Where a window holds so many on average, 98 in 100 hold the fewest that fix a line."
    )
    across_px: float = judged(1.3, "Half the window across: outlines of pixels are off by a pixel at most.")
    usual_px: float = judged(0.8, "Standard deviation of a face within the window.")
    widest_turn_deg: float = judged(50, "Beside a step an outline runs up to 45 degrees off its face.")
    turn_step_deg: float = judged(5, "Half of it moves the ends of the window by less than the band is wide.")
    cell_m: float = judged(0.01, "Width of the lines that are tried: a third of the scatter of rubble.")
    band_m: float = judged(0.025, "Points so near to a line belong to it: the scatter of plaster and noise.")
    apart_m: float = judged(0.06, "Of ridges farther apart, as those of a partition, the outer is the face.")
    strong_share: float = judged(0.5, "An outer ridge with fewer of the voxels is clutter before the face.")
    fewest_voxels: int = judged(5, "Fewer voxels do not fix a line.")
    fewest_levels: int = judged(3, "Fewer levels are a sill or a beam's edge; a flat cloud has fewer in all.")
    least_spread_m: float = judged(0.018, "The end of an unseen wall shows only the section of its faces.")

    @property
    def turns(self) -> np.ndarray:
        """Directions that are tried, from that of the outline, radians."""
        return np.radians(np.arange(-self.widest_turn_deg, self.widest_turn_deg + 1, self.turn_step_deg))


@dataclass(frozen=True)
class SegmentSettings:
    """The costs by which a row of ridge points is cut into straight and curved segments.

    Costs are squares of standard deviations.
    """

    straight_cost: float = statistical(10.0, "About 3 sigma for each point that a line needs.")
    curved_cost: float = statistical(25.0, "More than that of two lines would have to save on noise.")
    omitted_cost: float = statistical(6.0, "A point is omitted from about 2.4 sigma on.")
    straight_points: int = judged(3, "A line through two points has no misfit.")
    curved_points: int = judged(8, "Short arcs fit any noise.")
    longest_points: int = judged(500, "Bounds the time; equal neighbours are joined afterwards.")
    least_radius_m: float = physical(0.12, "A thinner column is narrower than its ridge's window.")
    largest_radius_m: float = physical(50.0, "Larger circles do not differ from lines over a wall's length.")
    least_sigma_m: float = judged(0.010, "Ridge points of a plastered wall.")
    largest_sigma_m: float = judged(0.03, "Ridge points of rubble.")
    sigma_direction_rad: float = judged(0.3, "Standard deviation of the direction of a ridge.")


@dataclass(frozen=True)
class FaceFitSettings:
    """The fit of a line or an arc to voxels."""

    wide_m: float = physical(0.05, "Thin walls are twice as thick; voxels farther off are of another face.")
    least_scatter_m: float = judged(0.002, "Scanners measure no better.")
    tukey_cut: float = statistical(
        3.0, "Beyond so many standard deviations voxels have no weight; Tukey's 4.7 admits more clutter."
    )
    rounds: int = judged(12, "The weights have settled by then.")


@dataclass(frozen=True)
class FaceExtentSettings:
    """Where a face begins and ends, and whether it is one."""

    patch_m: float = judged(0.05, "Patches, a level high, count alike however many points they hold.")
    overhang_m: float = judged(0.15, "A face reaches beyond its last ridge point by half a window at most.")
    solid_share: float = judged(0.2, "Patches with a smaller share of the usual levels are lintels or sills.")
    outermost_voxels: int = judged(3, "So many voxels lie beyond the end of a face: single ones are noise.")
    shortest_m: float = judged(0.06, "A shorter face is a column of points.")
    rough_m: float = judged(0.015, "Rougher faces are foliage if there are points before them as well.")
    roughest_m: float = judged(0.027, "Rougher faces than rubble are foliage.")
    open_share: float = judged(0.2, "Fewer voxels lie before a face; a bush is as full outside as inside.")


@dataclass(frozen=True)
class RingSettings:
    """Which segments of a ring belong to one face."""

    gap_m: float = judged(0.4, "A face continues behind what hides so much of it, as a post does.")
    least_cosine: float = judged(
        0.9, "Segments whose directions differ by more than 26 degrees are two faces."
    )
    worse: float = judged(1.15, "One face may fit two segments so many times worse: relief separates them.")


@dataclass(frozen=True)
class HiddenFaceSettings:
    """The hidden back of a face that was seen from one side."""

    same_m: float = judged(0.03, "Ridges so near are one face; the thinnest walls are thicker.")
    share: float = judged(0.5, "Most of a hidden face lies on the one that was seen.")
    largest_cosine: float = judged(-0.9, "The two sides of a face run in opposite directions.")
    beside_m: tuple[float, ...] = judged(
        (0.25, 0.35, 0.45), "Beside the front, beyond the blur of the pixels, there are points of the ground."
    )
    least_depth_m: float = judged(0.01, "The back of a face lies behind it, by more than rounding.")


@dataclass(frozen=True)
class FaceOutlineSettings:
    """How an outline is drawn along its faces."""

    corner_gap_m: float = judged(0.6, "Across a longer gap in the outline neighbouring faces do not meet.")
    corner_reach_m: float = judged(0.3, "A corner farther from the points of its faces is invented.")
    least_sine: float = physical(0.26, "Faces that cross at less than 15 degrees do not fix a corner.")
    chord_gap_m: float = judged(1.2, "Across shorter gaps in the outline, ends of faces are joined.")
    least_left: float = judged(
        0.75, "If dropping faces that cross leaves less of them, the crossing is kept."
    )
    bias_px: float = physical(0.5, "An outline of pixels lies half a pixel outside the face.")
    curves: CurveSettings = field(default_factory=CurveSettings)


@dataclass(frozen=True)
class MeasureSettings:
    """The measures of a wall by its faces."""

    step_m: float = judged(0.05, "Distance of the stations at which the thickness is measured.")
    sizes: WallSizeSettings = field(default_factory=WallSizeSettings)
    square: float = judged(1.2, "Faces farther apart than so many times their length are a wall's two ends.")
    largest_cosine: float = judged(-0.97, "Faces that differ by more than 14 degrees are not parallel.")
    fewest_stations: int = judged(3, "A thickness from fewer stations is not sure.")
    round_share: float = judged(0.5, "A wall has a radius if so much of its faces is round about one centre.")
    centre_share: float = judged(0.1, "Centres that differ by less of the radius are one.")


@dataclass(frozen=True)
class RefinementSettings:
    """Which outlines and faces are kept."""

    outside_px: float = judged(0.75, "Faces are not looked for farther outside an outline of pixels.")
    beside_m: float = judged(0.03, "A face whose middle is at most so far from an outline runs along it.")
    foliage_coverage: float = judged(
        0.1, "Where less of an outline has faces, though it has points enough, they are foliage."
    )


@dataclass(frozen=True)
class FaceSettings:
    """The settings of the faces of walls, by stage."""

    points: FacePointSettings = FacePointSettings()
    ridges: RidgeSettings = RidgeSettings()
    segments: SegmentSettings = SegmentSettings()
    fit: FaceFitSettings = FaceFitSettings()
    extent: FaceExtentSettings = FaceExtentSettings()
    rings: RingSettings = RingSettings()
    hidden: HiddenFaceSettings = HiddenFaceSettings()
    outline: FaceOutlineSettings = FaceOutlineSettings()
    measures: MeasureSettings = MeasureSettings()
    refinement: RefinementSettings = RefinementSettings()
