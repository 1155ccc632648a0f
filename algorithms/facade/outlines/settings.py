"""Settings of the outlines of details. Lengths in spacings are multiples of the point spacing."""

from dataclasses import dataclass

from ...settings import judged, physical, statistical


@dataclass(frozen=True)
class BorderSettings:
    """The border between a detail and what surrounds it."""

    margin_spacings: float = judged(12.0, "Points up to here around a detail determine its border.")
    local_edges: int = judged(60, "Edges across the border over which the spacing of the points is averaged.")
    lost_radius_m: float = judged(0.1, "Mixed points are counted within this distance along the border.")
    mixed_depth_m: float = judged(
        0.3, "A laser spot on two surfaces gives one point between them up to this depth; beyond, two points."
    )
    noise_sigmas: float = statistical(
        4.0, "Points further off a surface, in its standard deviations, belong to a jamb or are mixed."
    )
    inset_spacings: float = judged(
        3.0, "Distance from the border of a hole of the positions that stand in for points far behind."
    )


@dataclass(frozen=True)
class JambSettings:
    """Points between a wall and what lies behind it."""

    neighbours: int = judged(
        30, "Neighbouring points from which the slope of a jamb is estimated; fewer are too noisy."
    )
    steepest: float = judged(
        0.1, "Points that move further into the hole, per depth, are not on a plumb jamb."
    )
    outlying: float = judged(
        2.0, "Points further within the hole than their neighbours, in units of their scatter, are mixed."
    )
    fewest_points: int = judged(5, "With fewer points no jamb is recognised.")


@dataclass(frozen=True)
class HoleSettings:
    """Holes in a wall, and what was seen through them."""

    farthest_m: float = judged(6.0, "Points further behind the wall are not used to classify its holes.")
    filled: float = judged(0.5, "A recess has a surface behind at least this part of it; an opening has not.")
    jambs: float = judged(0.1, "An opening has points close behind the wall along this part of its border.")
    jamb_depth_m: float = physical(
        0.5, "Walls are about this thick; what is deeper may have been seen through a window beside the hole."
    )
    cell_spacings: float = judged(
        3.0, "Side of the cells that count the area with points behind a hole; smaller ones may miss points."
    )
    mouth: float = judged(
        0.45, "Largest part of the circumference of a gate that lies on the foot of the wall."
    )


@dataclass(frozen=True)
class ShapeSettings:
    """Rectangles and arches, and the standard deviations of their sides."""

    rounds: int = judged(8, "Rounds of a robust fit, and of moving the sides of a shape to the border.")
    corner_gaps: float = judged(
        2.0, "Nearer to a corner than this many gaps, the border is rounded and belongs to no side."
    )
    tolerance: float = judged(
        1.8, "A shape is accepted if its rms is at most this many times the expected one."
    )
    outliers: float = judged(0.15, "Part of the border that may lie off a shape because something hides it.")
    outlying: float = statistical(4.0, "Expected deviations beyond which a part of the border lies off.")
    scattered: float = statistical(
        1.5,
        "The scatter along an edge is estimated from few points; this factor keeps chance from adding to it.",
    )
    gain: float = judged(
        0.8, "An arch must lower the rms to this part of that of a rectangle, the simpler shape."
    )


@dataclass(frozen=True)
class WallSettings:
    """The outline of the whole wall."""

    hidden: float = judged(
        2.0, "A projection hides a strip of the wall up to this many times as wide as it is deep."
    )
    hidden_m: float = judged(0.5, "The strip of the wall that a projection hides is no wider than this.")
    beside_spacings: float = judged(3.0, "A gap is hidden by a projection that is nearer than this.")
    smooth_spacings: float = physical(
        0.5, "The wall ends half a spacing beyond its outermost points; less than that is roughness."
    )
    notch_spacings: float = judged(2.0, "Notches narrower than twice this are filled.")


@dataclass(frozen=True)
class OutlineSettings:
    """From the points of a detail to its outline."""

    border: BorderSettings = BorderSettings()
    jambs: JambSettings = JambSettings()
    holes: HoleSettings = HoleSettings()
    shapes: ShapeSettings = ShapeSettings()
    wall: WallSettings = WallSettings()
    alpha_spacings: float = judged(
        1.8,
        "Alpha, if not given: twice the least that closes a lattice, with room for noise and denser rows.",
    )
    noise_rings: int = judged(3, "Rings of neighbours around removed points that are triangulated again.")
    noise_m: float = physical(0.002, "The noise of the points; no edge is measured better, whatever the gap.")
    parallel_deg: float = judged(
        10.0, "Planes in front of the wall at a larger angle to it are not projections of it."
    )
