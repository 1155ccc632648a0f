"""The settings of the axes of walls: what a person may doubt, each with its reason."""

from dataclasses import dataclass, field

from ...geometry.settings import CurveSettings, OutlineMeshSettings
from ...settings import judged, physical


@dataclass(frozen=True)
class SkeletonSettings:
    """Which branches of a skeleton are walls."""

    least_protrusion: float = judged(
        1.0, "What stands out less than so many times its own width is a corner or rubble."
    )


@dataclass(frozen=True)
class CentrelineSettings:
    """How centrelines are cut into lines and arcs, and where these meet."""

    wander_m: float = judged(0.01, "A centreline may lie so far off its line at a thin wall.")
    wander_share: float = judged(0.12, "And by this share of the thickness more: thick walls are rougher.")
    curved: float = judged(1.5, "An arc is drawn where it follows the wall so many times as far as a line.")
    bent_rad: float = judged(0.25, "An arc that turns by less differs little from a line.")
    shortest: float = judged(1.0, "A piece shorter than so many thicknesses is a corner, or part of a wall.")
    compact: float = judged(1.5, "A wall whose axes are shorter than so many widths is a column.")
    fan: float = judged(1.02, "Towards a corner in which a skeleton ends, chords grow by more than this.")
    one_face_m: float = physical(0.03, "A narrower outline is a face seen from one side.")
    loose: float = judged(1e-2, "Weight of where a junction was found against where the axes meet.")
    node_m: float = judged(
        0.05, "Axes meet within a thickness of where a junction was found; at thin walls, within this."
    )
    jog_m: float = judged(0.01, "An axis is bent to a junction that is nearer; else it makes a step.")
    curves: CurveSettings = field(default_factory=CurveSettings)


@dataclass(frozen=True)
class AxisSettings:
    """The settings of the axes of walls, by stage."""

    mesh: OutlineMeshSettings = field(default_factory=OutlineMeshSettings)
    skeleton: SkeletonSettings = SkeletonSettings()
    centrelines: CentrelineSettings = CentrelineSettings()
