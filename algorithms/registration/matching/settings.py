"""The settings of matching: when distances agree, how far to search, and when a match is believed."""

from dataclasses import dataclass

from ...settings import judged, physical, statistical


@dataclass(frozen=True)
class ToleranceSettings:
    """When a distance agrees, and when a target lies on a control point."""

    distance_factor: float = statistical(
        3.5,
        "Distances match if they differ by less than this many standard deviations of their difference. The "
        "paper's 2 standard deviations of a coordinate are 1.4 of a difference, and would lose one true pair "
        "in six.",
    )
    position_factor: float = statistical(
        1.45,
        "A position has three coordinates, so its limit is wider than that of a distance by this factor: "
        "beyond it lies one true target in 100 000 (chi-square with 3 degrees of freedom).",
    )
    scale_error: float = physical(
        600e-6, "Models with a scale near 1 allow this relative error: more than the usual projections have."
    )
    near_miss_factor: float = judged(
        3.0,
        "A target nearer to a control point than this many tolerances is taken for it and rejected; it does "
        "not become a new point (the paper's eps_D = 3 eps_t).",
    )


@dataclass(frozen=True)
class SearchSettings:
    """The search for all ways to lay the targets on the control points."""

    most_solutions: int = judged(
        48, "A cube has 24 equally good solutions; a list of more than 48 helps nobody."
    )
    slack_targets: int = judged(
        2,
        "Solutions with this many targets fewer than the best are kept as rivals, because noise may hide "
        "a target.",
    )
    misfit_share: float = judged(
        0.85,
        "A target has to leave if sigma0 exceeds this share of the distance factor: by default if the "
        "residuals are three times as large as expected.",
    )
    width_factor: float = judged(
        25.0,
        "The corner of a seed triangle lies this many times as far from its base as a target may err; the "
        "pose of a narrower one is so uncertain that wrong points join.",
    )
    width_share: float = judged(
        0.3, "If all targets are narrow, a seed may be as narrow as this share of their width."
    )
    most_changes: int = judged(
        4, "Each target is added or removed this often at most, which ends a search that alternates."
    )
    batch_size: int = physical(
        200_000,
        "Targets that are placed at once by the poses of seeds, a fifth of a second; so soon a search can be "
        "cancelled.",
    )
    most_edges: int = physical(
        4_000_000, "Edges of the matching matrix, which fit into 200 MB; only regular layouts have more."
    )
    most_placed: int = physical(
        10_000_000,
        "Targets that a search places in all, about a quarter of a minute. Only many outliers and an unknown "
        "scale need more.",
    )


@dataclass(frozen=True)
class TriangleSettings:
    """Similar triangles, which replace distances where the scale is unknown."""

    most_points: int = physical(
        300, "The triangles of more control points, 4.5 million for 300, do not fit into memory."
    )
    least_octave: int = judged(
        3, "A triangle is long enough if its longest side is 2 to this power times the tolerance."
    )
    batch_size: int = physical(
        300, "Triangles of targets that are looked up at once; each may be similar to thousands of others."
    )


@dataclass(frozen=True)
class AccidentSettings:
    """How many accidental matches are accepted."""

    most_expected: float = statistical(
        1e-4, "A match is refused if more accidental matches of as many targets are expected."
    )
    most_expected_of_all: float = statistical(
        1e-3, "The same if every target of the scan matches, which accidents seldom do."
    )
    certain: float = statistical(
        1e-8,
        "A scan with fewer expected accidental matches is registered at once; others wait, because more "
        "points may make them certain.",
    )
    window_share: float = judged(
        0.1,
        "Distances within this share of the longest one are counted to estimate how densely distances lie.",
    )


@dataclass(frozen=True)
class DecisionSettings:
    """Whether the best solution is the only one, and good enough."""

    most_odds: float = statistical(
        10_000.0,
        "Another solution of as many targets is as good as the best one unless the best one is this many "
        "times as likely, by their weighted sums of squares.",
    )
    sigma_redundancy: int = judged(
        8,
        "SIGMA counts as if it were estimated from so many redundant observations: within a factor of 1.7, "
        "19 times in 20. Where it is wrong, residuals outweigh it.",
    )
    poor_sigma0: float = judged(
        2.5, "Where sigma0 is larger, targets that the tests reject do not count as matched."
    )
    most_rotation_std_deg: float = physical(
        1.0, "A less certain rotation moves points at a distance of 10 m by more than 17 cm."
    )
    least_tilt_deg: float = physical(
        30.0, "No scanner on a tripod is tilted so much; the axes of a list are probably in another order."
    )


@dataclass(frozen=True)
class MatchingSettings:
    """The settings of matching."""

    tolerances: ToleranceSettings = ToleranceSettings()
    search: SearchSettings = SearchSettings()
    triangles: TriangleSettings = TriangleSettings()
    accidents: AccidentSettings = AccidentSettings()
    decision: DecisionSettings = DecisionSettings()
