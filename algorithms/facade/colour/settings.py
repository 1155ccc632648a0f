"""Settings of the search for regions of one colour."""

from dataclasses import dataclass

from ...settings import judged, physical, statistical


@dataclass(frozen=True)
class SeedSettings:
    """Where a region can begin."""

    cells_across: int = judged(4, "Candidates for seeds across td; with fewer, narrow details have no seed.")
    halvings: int = judged(
        3, "Radii from td down, each half of the one before, so that small details have seeds."
    )
    fewest_points: int = judged(10, "A variance of fewer points is too uncertain.")
    free_share: float = judged(0.5, "Part of a seed surface that no other region may have taken already.")
    variance: float = judged(200.0, "Vr of the paper, used where the noise of the colours is lower.")
    noise_factor: float = judged(
        2.0,
        "Vr, if not given, is at least this many times the median variance of the smallest seed surfaces.",
    )


@dataclass(frozen=True)
class IntensitySettings:
    """How intensities are compared over a wall and between scans."""

    cell_m: float = judged(0.2, "Side of the squares whose median intensities the trend is fitted to.")
    fewest_points: int = judged(5, "Squares with fewer points have no reliable median.")
    fewest_cells: int = judged(30, "A scan in fewer squares has one level; its trend has 6 coefficients.")
    rounds: int = judged(10, "Rounds of the robust fit of the trend; its weights change little after them.")
    least_trend: float = judged(
        0.1,
        "The trend may not fall below this part of the level, or its sign could change beyond its squares.",
    )
    noise_factor: float = judged(2.0, "f, if not given, is this many times the noise of the intensity.")
    gate: float = judged(
        2.5,
        "A point whose intensity differs from the mean of a region by more, in units of f, does not join.",
    )
    clear: float = judged(
        3.0, "Intensity divides the two sides of a border where they differ by more, in units of f."
    )
    unequal: float = judged(
        1.2, "Ratio of the levels of two scans above which the log says that they differ."
    )


@dataclass(frozen=True)
class MixedSettings:
    """How points at a border, whose laser spots hit both sides, are divided between them."""

    band_spacings: float = judged(
        3.0, "Points nearer to a border may be mixed; lengths are in point spacings."
    )
    core_spacings: float = judged(
        10.0, "Points from the band to here show the pure colours of the two sides."
    )
    beam_m: float = physical(
        0.01, "The band of mixed points at a border is at least this wide; laser beams are rarely wider."
    )
    rounds: int = judged(5, "A border is divided this often at most; it ends when nothing changes.")
    compared: int = judged(
        24, "Points on either side with which a point at the border is compared; fewer are too noisy."
    )


@dataclass(frozen=True)
class StepSettings:
    """The step of colour at the border of a detail. Distances are in point spacings."""

    narrowest_m: float = physical(0.05, "Joints and cracks are narrower; painted bands are wider.")
    narrowest_spacings: float = judged(4.0, "Narrower regions have no points of their own colour alone.")
    near_spacings: float = judged(1.5, "Points nearer to the border are mixed.")
    middle_spacings: float = judged(5.0, "Points up to here show the colours of the two sides.")
    far_spacings: float = judged(8.5, "Points up to here show how much these colours change on their own.")
    station_spacings: float = judged(4.0, "Length of a station along the border.")
    most_stations: int = judged(400, "Stations along a border; on longer borders they are longer.")
    fewest_points: int = judged(4, "A median of fewer points is too uncertain.")
    sharper: float = judged(
        1.5, "A step exceeds the changes on both sides of it by this factor; a gradient has no step."
    )
    around_m: float = judged(1.0, "The wall up to this far around shows how much its colours vary.")
    texture_sigmas: float = statistical(
        3.0, "A step exceeds the standard deviation of these colours by this factor."
    )
    share: float = judged(0.7, "A detail has a clear step along this part of its border.")
    confirmed: float = judged(0.6, "Along this part of the border the intensity changes by f or more.")


@dataclass(frozen=True)
class ColourSettings:
    """Regions of one colour."""

    seeds: SeedSettings = SeedSettings()
    intensity: IntensitySettings = IntensitySettings()
    mixed: MixedSettings = MixedSettings()
    steps: StepSettings = StepSettings()
    smallest_region: float = judged(
        0.25,
        "Regions below this part of the smallest detail are specks; the regions beside them absorb them.",
    )
