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
    beam_m: float = physical(
        0.01, "Laser spots are hardly larger; points farther from the wall are not mixed."
    )
    noise_sigmas: float = statistical(
        4.0, "Points further off a surface, in its standard deviations, belong to a jamb or are mixed."
    )
    reach_spacings: float = judged(
        5.0, "Where the wall is farther from a hole than this, its edge was not seen, but something hides it."
    )
    beside_m: float = physical(
        0.3, "What projects by less is a surround or a sill, on which an edge may lie."
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
    deepest_m: float = physical(0.6, "Jambs are hardly deeper than walls are thick.")
    beside_spacings: float = judged(2.0, "Points farther from the wall are not on a jamb.")
    start_m: float = physical(0.05, "Jambs begin at the wall, of which points up to this depth are part.")
    least_spread_m: float = physical(0.03, "The points of a jamb differ in depth by this at least.")
    square: float = physical(
        0.04, "Jambs are square to a wall within this slope, which is 2 mm over the depth of a window frame."
    )
    more: float = judged(
        1.5, "An oblique line has so many times the points of a square one; mixed points are fewer."
    )
    rounds: int = judged(
        5, "Rounds in which a line finds its points, each twice as deep as the one before; walls are thinner."
    )


@dataclass(frozen=True)
class EdgeSettings:
    """A straight edge of an outline."""

    fewest: int = judged(4, "With fewer crossings of its border an edge is not measured.")
    corner_gaps: float = judged(
        2.0, "Nearer to a corner than this many gaps, the border is rounded and belongs to no side."
    )
    window_gaps: float = judged(1.5, "The border of a straight edge scatters over a gap, and a little more.")
    window_sigmas: float = statistical(3.0, "And by the noise of the points.")
    most_stations: int = judged(200, "Stations along an edge at which its position is asked for.")
    step_spacings: float = judged(2.0, "At a station of this length an edge has a point, in spacings.")
    agreeing: float = judged(0.6, "An edge is measured if this part of its stations agrees on its position.")
    extent: float = judged(0.4, "The agreeing stations reach over this part of it.")
    rounds: int = judged(8, "Rounds of a robust mean; its weights change little after them.")
    systematic_m: float = physical(
        0.001, "Laser spots that hit an edge are averaged; no number of them makes an edge more certain."
    )
    uncorrected: float = judged(
        0.15, "Of the spacing, what the mean distance between the last points and the edge is uncertain by."
    )
    flush_gaps: float = judged(
        0.75, "Points of a jamb that starts at the wall are nearer than this many gaps to where it ends."
    )
    scattered: float = statistical(
        1.5,
        "The scatter along an edge is estimated from few points; this factor keeps chance from adding to it.",
    )
    leaning: float = statistical(
        4.0, "Chance makes an edge lean by the variance of its mean; by more than so many of them in 5 %."
    )


@dataclass(frozen=True)
class HeadSettings:
    """The head of an opening."""

    fewest: int = judged(6, "With fewer crossings a head cannot be recognised.")
    flat_extent: float = judged(0.7, "A head that is level over this part of its width is flat.")
    widest: float = judged(0.5, "The border of a head is seen over this part of its width.")
    steepest: float = physical(0.7, "Sloped heads follow stairs and roofs, up to 35 degrees.")
    level_m: float = physical(
        0.03, "Lintels of old walls that rise by less are level, and sag; their height is the mean one."
    )
    flattest: float = judged(8.0, "An arc of a larger radius, in half widths, is flat.")
    semicircle: float = judged(0.04, "An arc whose radius exceeds half the width by less is a semicircle.")
    outlying: float = statistical(4.0, "Expected deviations beyond which a part of the border lies off.")
    consistent: float = judged(1.5, "A head whose mean squared deviation is below this explains the border.")
    gain: float = judged(0.7, "A less simple head must lower the mean squared deviation to this part.")
    agreeing: float = judged(0.5, "A head agrees with this part of the border above.")


@dataclass(frozen=True)
class ShapeSettings:
    """Which outlines are regular."""

    rounds: int = judged(3, "Rounds of fitting the four sides, whose ends depend on each other.")
    near: float = judged(0.35, "A side is looked for within this part of the width or height from its start.")
    outlying_gaps: float = judged(3.0, "Farther from an outline than this many gaps, the border lies off.")
    outlying_m: float = judged(0.03, "Old jambs and sills are straight within this.")
    contradicted: float = judged(0.2, "A shape is accepted if no more of the border lies off.")
    most_contradicted: float = judged(0.4, "More may lie off where the area is the same.")
    alike: float = judged(0.8, "Areas are the same with this intersection over union.")
    fewest_sides: int = judged(2, "With fewer measured sides an outline is free.")
    sides_of_shadowed: int = judged(
        4, "With so many measured sides, what is empty beyond an outline is the shadow of something in front."
    )
    round_box: float = judged(0.85, "The box of a circle is as wide as high.")
    round_deviation: float = judged(3.0, "Half of the border of a circle is nearer, in expected deviations.")


@dataclass(frozen=True)
class AcceptanceSettings:
    """Which holes of a wall are openings."""

    measured: int = judged(2, "Sides that were measured on the wall or its jambs.")
    bounded: int = judged(3, "Sides that were measured, or are the ground.")
    damage_m: float = physical(0.12, "Weathered stones and lost joints are hardly deeper.")
    narrow_m: float = physical(
        0.3,
        "Shallow holes and those at the end of a wall are damage if narrower, free shapes up to twice this.",
    )
    shown: float = judged(
        0.5, "So narrow a hole shows something behind the wall along this part of its border."
    )
    lowest_gap_m: float = physical(
        1.6, "Without head and sill a hole is a gap, unless it is as high as a door."
    )
    solid: float = judged(0.85, "A free shape fills this part of its convex hull; shadows are ragged.")
    seen: float = judged(0.9, "The wall bounds this part of a free shape.")


@dataclass(frozen=True)
class WallSettings:
    """The outline of the whole wall."""

    hidden: float = judged(
        2.0, "A projection hides a strip of the wall up to this many times as wide as it is deep."
    )
    hidden_m: float = judged(0.5, "The strip of the wall that a projection hides is at most so wide.")
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
    edges: EdgeSettings = EdgeSettings()
    heads: HeadSettings = HeadSettings()
    shapes: ShapeSettings = ShapeSettings()
    acceptance: AcceptanceSettings = AcceptanceSettings()
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
