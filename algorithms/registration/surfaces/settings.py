"""The settings of the surfaces that tie scans to each other."""

from dataclasses import dataclass

from ...settings import judged, physical, statistical


@dataclass(frozen=True)
class PatchSettings:
    """Which cells of a scan are plane."""

    edges_m: tuple[float, ...] = judged(
        (0.2, 0.4, 0.8),
        "Smaller than walls are wide, and each twice the one before, because sparse scans need larger cells.",
    )
    fewest_points: int = statistical(10, "A plane through fewer points leans by their noise.")
    thickest: float = judged(
        0.2, "A face is thinner than this part of its width, with the noise of hand-held scanners."
    )
    narrowest: float = judged(
        0.15, "Points along a line have no normal; those of a face spread over this part of the cell's edge."
    )
    bend_deg: float = judged(
        5.0, "Neighbouring cells of one plane differ by less through noise, those of corners by more."
    )


@dataclass(frozen=True)
class StationSettings:
    """Whether the origin of a file that states no station was the scanner."""

    rays: int = statistical(400, "From a scanner to its cells; they show shares to a few percent.")
    clearance: float = judged(
        1.0, "Times the sum of both edges: one surface, as noise bends it, does not hide itself."
    )
    most_hidden: float = judged(
        0.05, "Mirrors and windows show some surfaces behind walls; from the next room, walls hide most."
    )


@dataclass(frozen=True)
class PairSettings:
    """Which patches of two scans are the same surface, and how exactly."""

    gate_m: float = judged(
        0.25, "Scans are registered to better than this by their targets; rooms are wider than twice of it."
    )
    least_gate_m: float = judged(0.02, "Rough masonry; narrower gates would lose pairs and gain nothing.")
    facing_deg: float = judged(15.0, "The same face seen by two scans differs by less, other faces by more.")
    trim: float = statistical(
        3.0, "Standard deviations beyond which a patch is not the same surface: moved things and people."
    )
    trimming_rounds: int = judged(10, "Three are usual; this stops patches that come and go without end.")
    patch_m: float = judged(
        1.0, "Cells within it share the errors of the surface and of the scanner, and count as one patch."
    )
    fewest_patches: int = statistical(
        12, "Two for each unknown of a pose, so that most of them may be moved things before the pose fails."
    )
    least_std_m: float = physical(
        0.0005, "Plaster, edges of tiles and the spot of the beam let no two scans see one face more alike."
    )
    common_std_m: float = physical(
        0.0003,
        "What a scanner's range and angles err by in common from one station to the next; it bounds the "
        "weight of thousands of points against that of a few targets.",
    )


@dataclass(frozen=True)
class RefinementSettings:
    """The iteration of pairing and adjustment, and the test against the targets."""

    most_rounds: int = judged(12, "Seven are usual; this stops pairs that come and go without end.")
    smallest_move_m: float = physical(0.0005, "As much as two scans of one face differ anyway.")
    significance: float = statistical(
        0.001, "Baarda's choice: surfaces that contradict the targets so clearly are not the same surfaces."
    )
    weak_share: float = judged(
        0.02, "Of the patches, by the squares of their normals: less of them hold a direction by noise only."
    )


@dataclass(frozen=True)
class SearchSettings:
    """Where a scan may stand, as its surfaces and those of another scan show it."""

    direction_deg: float = judged(
        10.0, "Walls that differ by less have one direction; the sides of an octagon differ by 45."
    )
    least_share: float = judged(0.03, "Of all surface; a direction with less of it hardly fixes a rotation.")
    most_directions: int = judged(
        10, "Rooms have six; every two of them are tried, which takes their square."
    )
    same_rotation_deg: float = judged(5.0, "Less apart, the same motion is found from both.")
    voxel_m: float = judged(
        0.4, "The motion comes from it to half of this, from where pairs of cells lead on."
    )
    most_voxels: int = judged(2**21, "Of a grid around both scans; larger ones take seconds for a rotation.")
    least_peak: float = judged(
        0.3,
        "Of the highest peak: where two scans share a third of their surface, the right one may be so low.",
    )
    most_peaks: int = judged(8, "Of a rotation; in rooms alike, one peak for each of a few of them.")
    most_motions: int = judged(40, "Of all rotations, the highest peaks; each is settled in some 20 ms.")
    gates_m: tuple[float, ...] = judged(
        (0.8, 0.4, 0.2, 0.1), "How far partners lie apart, from two voxels down to what agrees."
    )
    rounds: int = judged(6, "At each of them; a scan slides slowly where few surfaces lie across.")


@dataclass(frozen=True)
class ViewSettings:
    """What a scanner saw in each direction, compared with the surfaces of another scan."""

    pixel_deg: float = judged(
        1.0, "A cell of 0.2 m has this angle at 11 m; larger pixels would mix surfaces."
    )
    nearest_m: float = judged(0.5, "The tripod, and what hangs on it; cells nearer would fill the view.")
    reach: float = judged(0.75, "Times its edge: as far from its middle, a ray still meets a cell.")
    same_m: float = judged(0.1, "Off its plane: as much as hand-held scanners and rough masonry differ.")
    through_m: float = judged(0.25, "Before the surface that was seen: nothing can have been there.")
    parallel_m: float = judged(
        0.15, "The same of surface that faces the same way, whose place is more certain."
    )
    facing_deg: float = judged(15.0, "As of pairs of cells.")


@dataclass(frozen=True)
class PlacementSettings:
    """Whether surfaces alone place a scan beyond doubt."""

    search: SearchSettings = SearchSettings()
    view: ViewSettings = ViewSettings()
    against: float = statistical(
        10.0,
        "Rooms repeat: 9 of 10 patches agree at a wrong pose as well, and 98 of 100 at the right one, so "
        "that one that does not weighs log(0.02 / 0.1), 20 of the others; but cupboards are moved.",
    )
    least_evidence: float = statistical(
        30.0,
        "Patches: half of them agree by chance, and of a million poses one does in 20; half as many more.",
    )
    contradicted: float = judged(
        0.02, "Of the patches at the right pose: people, and pixels at the edges of what is nearer."
    )
    unlikely: float = statistical(
        0.01,
        "Probability of as many that contradict; a wrong pose among rooms alike is some times as unlikely.",
    )
    most_rival: float = judged(
        0.8, "Of the evidence of the best pose; cupboards moved between the scans make up less than the rest."
    )
    most_consistent: float = judged(
        0.5,
        "The same of a pose that is contradicted no more often than the best: less overlap may explain it.",
    )
    as_mirrored: float = judged(
        0.9,
        "Of the evidence of the mirror image; a nave, its own mirror image, differs by less through noise.",
    )
    significance: float = statistical(
        0.001, "Of the test whether a pose is contradicted more often than the best; Baarda's choice."
    )
    least_across: float = statistical(
        5.0, "Patches that face each direction, by the squares of cosines; fewer may be one door that moved."
    )
    same_pose_m: float = judged(0.5, "Poses at which no surface differs by more are one.")
    met_m: float = judged(0.1, "A target so near to a point may be it; a scan is placed to some centimetres.")
    placed_m: float = judged(
        0.02, "Standard deviation of a scan that surfaces placed, to append its targets."
    )


@dataclass(frozen=True)
class SurfaceSettings:
    """The settings of all stages."""

    patches: PatchSettings = PatchSettings()
    stations: StationSettings = StationSettings()
    pairs: PairSettings = PairSettings()
    refinement: RefinementSettings = RefinementSettings()
    placement: PlacementSettings = PlacementSettings()
