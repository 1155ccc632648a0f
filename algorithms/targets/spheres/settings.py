"""Settings of spheres."""

from dataclasses import dataclass, field

from ...settings import judged, physical, statistical
from ..common_errors import CommonErrorSettings


@dataclass(frozen=True)
class CandidateSettings:
    """Which pixels may show the middle of a sphere."""

    usual_m: tuple[float, ...] = physical(
        (0.076, 0.1, 0.139, 0.145, 0.15, 0.2), "Diameters of the spheres that makers of scanners sell."
    )
    least_pixels: float = physical(
        2.5, "Radius of the smallest image; a smaller one has under twenty pixels."
    )
    rings: tuple[float, float, float] = physical(
        (0.45, 0.75, 1.3), "In units of the radius: two on the sphere, one outside it."
    )
    tolerance: float = judged(0.15, "Of the depth at a ring, in units of the radius.")
    noise_m: float = judged(0.006, "And in metres: two standard deviations of a scanner that is noisy.")
    least_agreement: float = judged(
        0.7, "Share of the directions in which both inner rings agree; a rod or a cable may hide others."
    )
    least_free: float = judged(
        0.5, "Share of the directions in which the outer ring leaves the sphere; a mount takes the others."
    )


@dataclass(frozen=True)
class FitSettings:
    """The fit of a sphere along the rays."""

    rounds: int = judged(30, "Rounds of a fit at most; it ends when the centre no longer moves.")
    settled_m: float = physical(1e-6, "A fit ends when the centre moves less: no scanner resolves it.")
    most_incidence_deg: float = physical(
        60.0, "Farther out on the rim rays graze the sphere, and beams see what is behind it as well."
    )
    outlier: float = statistical(
        4.0, "Residuals above so many standard deviations have no weight (Tukey's biweight, 0.1 % lost)."
    )
    least_sigma_m: float = physical(0.0002, "No scanner measures ranges better.")


@dataclass(frozen=True)
class AcceptanceSettings:
    """What passes as a sphere, and what passes without doubt."""

    fewest_points: int = physical(16, "Four unknowns, and three times as many points to check them.")
    most_sigma_m: float = judged(0.005, "Scatter of the ranges; scanners have 1 to 3 mm on spheres.")
    most_scatter: float = judged(0.06, "Scatter over the radius; rough things scatter more than spheres.")
    sigmas: float = statistical(3.0, "A diameter within three standard deviations of a usual one is that.")
    diameter_m: float = physical(0.003, "Spheres are round to a millimetre; mixed pixels add two.")
    size_tolerance: float = judged(0.06, "Part of the diameter by which one may differ at all.")
    sectors: int = judged(12, "Of the visible cap, in two rings, that say how much of it was seen.")
    points_of_sector: int = statistical(
        8, "With as many points on average hardly a sector has none by chance; there are fewer sectors then."
    )
    least_coverage: float = judged(0.4, "Part of the cap that must be seen; the rest may be hidden.")
    most_through: float = judged(0.1, "Part of the rays to the cap that pass: a sphere is not transparent.")
    most_attached: float = judged(
        0.5, "Part of the surroundings at the depth of the sphere: half a globe on a wall has all of them."
    )
    sure_coverage: float = judged(0.6, "A sphere of which less is seen is doubtful.")
    sure_points: int = judged(25, "With fewer points a sphere is doubtful.")
    sure_std_m: float = judged(0.005, "A centre that is less certain does not help a registration.")


@dataclass(frozen=True)
class SphereSettings:
    """The constants of all stages."""

    candidates: CandidateSettings = CandidateSettings()
    fit: FitSettings = FitSettings()
    acceptance: AcceptanceSettings = AcceptanceSettings()
    common: CommonErrorSettings = field(default=CommonErrorSettings())
