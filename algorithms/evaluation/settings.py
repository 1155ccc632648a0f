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
    neighbours: int = judged(
        8,
        "The nearest piece has one of the nearest middles; fewer may miss it where several lines meet.",
    )
    sizes: WallSizeSettings = field(default_factory=WallSizeSettings)


@dataclass(frozen=True)
class EvaluationSettings:
    """All constants of the evaluation."""

    outlines: OutlineSettings = OutlineSettings()
    comparison: ComparisonSettings = ComparisonSettings()
