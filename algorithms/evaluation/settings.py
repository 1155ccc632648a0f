"""The constants of the evaluation, each with its reason."""

from dataclasses import dataclass, field

from ..geometry.settings import WallSizeSettings
from ..settings import judged, physical


@dataclass(frozen=True)
class OutlineSettings:
    """How the outlines of a layer are read."""

    seam_m: float = physical(
        0.001,
        "Gaps between polygons of one wall come from rounded coordinates; gaps between walls are wider.",
    )
    same_position_m: float = physical(
        0.001, "Reference systems that place a point closer than a survey resolves are the same system."
    )


@dataclass(frozen=True)
class ComparisonSettings:
    """How the boundaries of a plan and its reference are compared."""

    step_m: float = judged(
        0.02,
        "Pieces this short find the end of an error to a fraction of a wall's width; shorter ones cost time.",
    )
    most_pieces: int = physical(
        5_000_000, "100 km of outlines in pieces of 2 cm, which take about 1 GB of memory; no site has more."
    )
    neighbours: int = judged(
        8,
        "The nearest piece has one of the nearest middles; fewer may miss it where several lines meet.",
    )
    sizes: WallSizeSettings = field(default_factory=WallSizeSettings)


@dataclass(frozen=True)
class DrawnPlanSettings:
    """How a plan is compared with one drawn by hand."""

    step_m: float = judged(0.02, "Pieces this short find the end of an error; shorter ones cost time.")
    angle_deg: float = judged(25.0, "A line across a face does not stand for it.")
    seam_m: float = physical(0.001, "Gaps between touching walls come from rounded coordinates.")
    strip_m: float = physical(
        0.08, "A wall of which one face was seen is drawn as a strip up to this thick; its back was not seen."
    )
    thinnest_m: float = physical(0.005, "Pieces nearer across than this are of one side of a strip.")
    nearer: float = judged(0.25, "By this share of the strip its front is nearer to a face than its back.")
    neutral_m: float = physical(0.15, "Leaves, frames and sashes are up to this far from the face.")
    room_overlap: float = judged(0.85, "Above this intersection over union two outlines are one room.")
    search_m: float = judged(1.0, "Farther from all faces, a distance has no meaning.")


@dataclass(frozen=True)
class EvaluationSettings:
    """All constants of the evaluation."""

    outlines: OutlineSettings = OutlineSettings()
    comparison: ComparisonSettings = ComparisonSettings()
    drawn_plan: DrawnPlanSettings = DrawnPlanSettings()


@dataclass(frozen=True)
class LengthSettings:
    """How lengths of two lists are compared."""

    same_unit: float = judged(
        0.05, "Half of the lengths of a schedule and a tape agree to less, so that their ratio shows a unit."
    )
