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
class SurfaceSettings:
    """The settings of all stages."""

    patches: PatchSettings = PatchSettings()
    stations: StationSettings = StationSettings()
    pairs: PairSettings = PairSettings()
    refinement: RefinementSettings = RefinementSettings()
