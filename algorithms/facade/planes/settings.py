"""Settings of the search for planes."""

from dataclasses import dataclass
from typing import Optional

from ...settings import judged, physical, statistical


@dataclass(frozen=True)
class VoxelSettings:
    """Cubes into which the points are sorted, so that a plane counts by its area."""

    most_cubes: int = judged(
        100_000, "The cubes grow until there are no more; this bounds the time and memory of the search."
    )
    neighbours: int = judged(
        10, "Cubes that give the normal of one; with fewer, noise tilts it, with more, it leans over edges."
    )


@dataclass(frozen=True)
class FitSettings:
    """The random search for a plane, and its fit by total least squares."""

    samples: int = statistical(
        400, "Random samples of three points find a plane with a third of the points in 9999 of 10 000 runs."
    )
    tries: int = judged(30, "Points that are drawn before a sample that does not become a plane is given up.")
    vote: float = judged(
        0.4,
        "Part of ds within which points vote for a plane; two planes little more than ds apart remain two.",
    )
    least_cosine: float = judged(
        0.85, "The normal of a voxel is not sharp: it may differ from that of its plane by up to 32 degrees."
    )
    slope: float = judged(
        0.1, "A point of a sample may lie this far off the normal of the first, per metre between them."
    )
    rounds: int = judged(30, "Rounds of a fit at most; it ends when the normal no longer changes.")
    settled: float = physical(1e-7, "A fit ends when the normal changes by less: 10 micrometres in 100 m.")
    sigmas: float = statistical(
        3.0, "Points within three standard deviations belong to a plane; of normal noise that is 99.7 %."
    )
    least_sigma_m: float = physical(
        1e-4, "Least scatter that is assumed, so that points without any noise do not exclude each other."
    )


@dataclass(frozen=True)
class SideSettings:
    """From which side a facade is seen."""

    pixel_m: float = judged(
        0.08, "Pixels that compare the wall with what lies beside it; at 5 cm spacing each still has a point."
    )
    nearest_m: float = physical(0.1, "Nearer points may be on the wall itself, or on its mouldings.")
    farthest_m: float = physical(
        1.5,
        "Farther points are seen at a slant, so that they no longer project into the hole they are seen in.",
    )
    far_m: float = judged(0.5, "If nothing else decides, the side with more points farther off is the front.")
    least_difference: float = judged(
        0.1, "If the shares of the two sides that lie on the wall differ by less, holes show no side."
    )
    fewest_pixels: int = judged(10, "Fewer pixels beside the wall are chance and hardly count.")
    most_m2: float = judged(2.0, "A single hole counts up to this area, so that many windows outvote a bay.")
    thinnest_m: float = physical(0.15, "Outer walls between street and room are not thinner.")
    thickest_m: float = physical(0.9, "Walls are hardly thicker; what lies farther off is another wall.")
    flat_m: float = judged(0.03, "Half of the range within which the points of a face lie.")
    covered: float = judged(0.05, "An inner face covers at least this part of the wall.")
    clearer: float = judged(4.0, "It covers this many times what a parallel face on the other side covers.")
    doubtful: float = judged(0.3, "Below this certainty the user is asked to check the side.")


@dataclass(frozen=True)
class PlaneSettings:
    """What a plane of a facade is.

    Attributes
    ----------
    min_points : int, optional
        MIN_POINTS, of the smallest plane; derived from the main plane if not given.
    max_planes : int
        MAX_PLANES, the main one included.
    """

    min_points: Optional[int] = None
    max_planes: int = 10
    voxels: VoxelSettings = VoxelSettings()
    fit: FitSettings = FitSettings()
    side: SideSettings = SideSettings()
    cell_m: float = judged(
        0.25, "Side of the squares that say where a plane has points; its extent is known this well."
    )
    gap_squares: int = judged(
        4, "Empty squares that a plane may cross, 1 m in all: a door or a window does not divide it."
    )
    most_planes: int = judged(
        15, "Planes that are taken from a cloud, with ground, side walls and neighbours."
    )
    smallest_m2: float = physical(0.25, "The smallest plane is a square with sides of half a metre.")
    upright_deg: float = judged(
        45.0, "What leans from the vertical by more is a roof or the ground, not a facade."
    )
    facing_deg: float = judged(
        60.0, "Planes at a larger angle to the main one belong to its returns or side walls."
    )
    alike_deg: float = judged(10.0, "A wall that was found before faces this nearly the same way.")
    alike_m: float = judged(0.3, "A wall that was found before lies this near; its inner face is farther.")
    depth_m: float = physical(
        1.0,
        "A facade reaches this far in front of and behind its main plane: bays, cornices, doors, panes.",
    )
    beside_m: float = physical(
        0.3, "A facade reaches this far beyond the ends of its main plane; planes at its corners are found."
    )
    share: float = judged(
        0.01, "If MIN_POINTS is not given, it is this share of the points of the main plane."
    )
    fewest_points: int = judged(
        100, "Least MIN_POINTS, if it is not given; fewer remaining points are not searched for planes."
    )
    coarse: float = judged(
        2.0, "Cubes in which the main plane is first searched, in units of ds; finer cost time."
    )
    sampled: int = judged(
        100, "Every hundredth point is enough to see on which side of the wall most points lie."
    )
    percentile: float = judged(
        5.0, "The side that reaches further is the front; the outermost five per cent may be strays."
    )
    longest_facade_m: float = physical(
        500.0, "No facade is longer; a longer cloud is probably not in metres."
    )
