"""Settings of black and white targets."""

from dataclasses import dataclass, field

from ...settings import judged, physical, statistical
from ..common_errors import CommonErrorSettings


@dataclass(frozen=True)
class CandidateSettings:
    """Which pixels may show the centre of a target."""

    radii_m: tuple[float, ...] = physical(
        (0.016, 0.030, 0.055),
        "Of the circles that are looked at: they lie on targets of 75, 150 and 300 mm seen at 60 degrees.",
    )
    least_pixels: float = physical(
        1.4, "Smaller circles reach the neighbouring pixels only, with less than four points a quadrant."
    )
    least_contrast: float = judged(
        0.12, "Of the harmonic, in units of the mean. Black on white has 0.8, worn grey on white 0.2."
    )
    least_response: float = judged(
        0.4, "Part of the variance. A target has 0.81, or 0.62 at 60 degrees, before noise."
    )
    most_odd: float = judged(
        0.35, "Part of the variance that differs between opposite directions: at a target only noise."
    )


@dataclass(frozen=True)
class PlaneSettings:
    """The plane of a target, fitted along the rays."""

    sample: int = judged(200, "Points that such a plane is judged by.")
    trials: int = statistical(
        60, "Random triples find a plane that holds half of the points in 9997 of 10 000 runs."
    )
    rounds: int = judged(5, "The weights of a robust fit settle in so many.")
    sigmas: float = statistical(
        3.0, "Points within three standard deviations lie on the plane; of normal noise that is 99.7 %."
    )
    least_sigma_m: float = physical(
        0.0002, "No scanner measures ranges better; noise-free points would exclude each other."
    )
    most_sigma_m: float = judged(0.02, "More scatter than this on white is not a plane of a target.")


@dataclass(frozen=True)
class PatternSettings:
    """The fit of the two edges."""

    trial_points: int = judged(800, "Of the first fit at a candidate; the final one takes all points.")
    trial_rounds: int = judged(
        12, "Rounds of the first fit; from a candidate on a target it settles in six to ten."
    )
    rounds: int = judged(25, "Rounds of a fit at most; it ends when the centre no longer moves.")
    settled: float = judged(3e-4, "A fit ends when the centre moves less, in units of the blur.")
    angle_std: float = physical(
        0.03, "Radians that the edges of a printed target may differ from a right angle, with a tilted plane."
    )
    outlier: float = statistical(
        4.0, "Residuals above so many standard deviations have no weight (Tukey's biweight, 0.1 % lost)."
    )
    block_blurs: float = judged(
        2.0, "Side of the blocks within which residuals depend on each other, in widths of the blurred edge."
    )
    fewest_blocks: int = statistical(
        20, "Twice the unknowns and more; the scatter of fewer blocks says less than that of the points."
    )


@dataclass(frozen=True)
class ExtentSettings:
    """How far a pattern reaches."""

    largest_m: float = physical(0.45, "A target of 300 mm, with what is beside it, is looked at.")
    ring_m: float = judged(0.004, "Width of the rings, where points are not sparser; the size is so exact.")
    sectors: int = judged(3, "Beside each edge of a quadrant; their median is not misled by a clip.")
    sector_points: float = statistical(
        2.0, "Points across a sector at 40 mm from the centre; sparser patterns have fewer sectors."
    )
    flank: float = judged(0.38, "Part of a quadrant beside each edge that is looked at, 34 degrees.")
    margin: float = judged(0.12, "Part of a quadrant beside each edge that is not looked at, nor its blur.")
    tone: float = judged(
        0.5, "Most distance from the colour, in units of half the contrast; the other colour is 2 away."
    )
    tile_scales: tuple[float, ...] = judged(
        (1.0, 1.15, 1.3, 1.5), "Sides of tiles that are tried, in units of the reach of the quadrants."
    )
    fewest_beside: int = statistical(8, "Points beside a pattern; a correlation of fewer is chance.")
    share: float = statistical(0.5, "A ring ends the pattern if at most half of its points agree.")


@dataclass(frozen=True)
class AcceptanceSettings:
    """What passes as a target, and what passes without doubt."""

    fewest_points: int = physical(16, "Four points a quadrant; fewer do not show two edges.")
    fewest_in_quadrant: int = physical(3, "Of four points one may lie on the blurred edge.")
    least_planar: float = judged(0.5, "A clip, a cable or a hand may hide less than half of the circle.")
    most_incidence_deg: float = judged(75.0, "At a flatter view the beam is four times as long as wide.")
    least_contrast: float = judged(0.2, "Half the difference of white and black over their mean.")
    least_likeness: float = judged(
        0.5, "Correlation with edges through the candidate before the fit; a quarter of the circle off, 0.6."
    )
    most_tiled: float = judged(
        0.5, "Correlation of what is beside a pattern with its continuation: 0 on a wall, 0.9 among tiles."
    )
    least_explained: float = judged(
        0.6, "Part of the variance of the intensities. Prints reach 0.9, at four points a quadrant 0.7."
    )
    most_skew_deg: float = judged(8.0, "Prints are square; a tilt of the plane by noise skews them less.")
    least_agreement: float = judged(
        0.8, "Share of the points in each quadrant that are nearer to its colour than to the other one."
    )
    most_uneven: float = judged(
        0.4,
        "Of half the contrast. Prints differ by 0.05; fields that meet by chance have tones of their own.",
    )
    sure_uneven: float = judged(0.15, "Where the tones differ more, a target is doubtful.")
    rim_blurs: float = statistical(
        2.5, "Points nearer to the rim, in units of the blur, mix the target with what is behind it."
    )
    most_rim: float = judged(0.25, "Part of the half width that is given up for it at most.")
    sizes_m: tuple[float, float] = physical(
        (0.065, 0.33), "Targets are 75 to 300 mm wide; a tenth, and the width of a ring, are allowed."
    )
    size_tolerance: float = judged(0.15, "The width of the pattern is measured to a tenth.")
    sure_explained: float = judged(0.75, "Below this a target is doubtful.")
    sure_in_quadrant: int = judged(4, "With fewer points in a quadrant a target is doubtful.")
    sure_evenness: float = judged(0.5, "Two quadrants of one colour whose reach differs more are doubtful.")
    sure_std_m: float = judged(0.005, "A centre that is less certain does not help a registration.")


@dataclass(frozen=True)
class CheckerboardSettings:
    """The constants of all stages."""

    candidates: CandidateSettings = CandidateSettings()
    plane: PlaneSettings = PlaneSettings()
    pattern: PatternSettings = PatternSettings()
    extent: ExtentSettings = ExtentSettings()
    tests: AcceptanceSettings = AcceptanceSettings()
    common: CommonErrorSettings = field(default=CommonErrorSettings())
