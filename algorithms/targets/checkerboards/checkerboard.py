"""From a candidate to a black and white target, or to the test that it fails."""

from dataclasses import dataclass, replace
from typing import Optional, Union

import numpy as np

from ..common_errors import CommonErrorSettings, common_covariance, dim_white_error
from ..examination import Examination, FailedError
from ..range_image.range_image import RangeImage
from ..results import Kind, Rejection, Target
from .candidates import Candidate
from .extent import Extent, Quadrants, extent_of, quadrants, tiled
from .pattern import Pattern, first_pattern, fit_pattern
from .plane import RayPlane, fit_plane
from .settings import AcceptanceSettings, CheckerboardSettings

TILES = "likeness of tiles around it"
"""The test that corners of tiles fail."""

WIDTH = "width of the pattern"
"""The test that crossings of large fields fail."""


@dataclass(frozen=True)
class Seen:
    """The points around a candidate.

    Attributes
    ----------
    rays : ndarray, shape (n, 3)
    ranges, intensities : ndarray, shape (n,)
    """

    rays: np.ndarray
    ranges: np.ndarray
    intensities: np.ndarray

    def __getitem__(self, rows: np.ndarray) -> "Seen":
        return Seen(self.rays[rows], self.ranges[rows], self.intensities[rows])


@dataclass(frozen=True)
class Frame:
    """Plane coordinates on the plane of a target: where rays meet it, not the scattered points themselves."""

    origin: np.ndarray
    axes: np.ndarray

    @classmethod
    def of(cls, plane: RayPlane, xyz: np.ndarray) -> "Frame":
        """Return the frame whose origin is where the ray to `xyz` meets the plane."""
        origin = plane.meets(xyz / np.linalg.norm(xyz))
        # The axis of the scanner that is least along the normal gives a stable direction.
        aside = np.eye(3)[int(np.argmin(np.abs(plane.normal)))]
        first = np.cross(aside, plane.normal)
        first /= np.linalg.norm(first)
        return cls(origin, np.stack([first, np.cross(plane.normal, first)]))

    def places(self, positions: np.ndarray) -> np.ndarray:
        """Return the coordinates of positions on the plane, shape (n, 2)."""
        return np.asarray((positions - self.origin) @ self.axes.T)

    def position(self, place: np.ndarray) -> np.ndarray:
        """Return the position of coordinates on the plane."""
        return np.asarray(self.origin + place @ self.axes)


def checkerboard_at(
    image: RangeImage, candidate: Candidate, size: Optional[float], settings: CheckerboardSettings
) -> Union[Target, Rejection]:
    """Fit a black and white target at a candidate and test it.

    Parameters
    ----------
    image : RangeImage
        With intensities.
    candidate : Candidate
    size : float, optional
        Width of the targets, metres; without it every usual width is accepted.
    settings : CheckerboardSettings
    """
    try:
        return _examined(image, candidate, size, settings)
    except FailedError as failure:
        return failure.rejection


def _examined(
    image: RangeImage, candidate: Candidate, size: Optional[float], settings: CheckerboardSettings
) -> Target:
    tests, xyz = settings.tests, candidate.xyz
    exam = Examination(Kind.CHECKERBOARD, xyz)
    seen = _seen(image, xyz, candidate.radius)
    exam.at_least("points around the centre", len(seen.ranges), tests.fewest_points)
    seen = seen[np.arange(0, len(seen.ranges), max(1, len(seen.ranges) // settings.pattern.trial_points))]
    plane = exam.found("planar surface", _plane(seen, settings))
    exam.at_least("share of the points on a plane", np.mean(plane.kept), tests.least_planar)
    exam.at_most("angle of incidence", plane.incidence_deg(xyz), tests.most_incidence_deg, "degrees")
    spacing = _spacing(image, xyz, plane)
    frame = Frame.of(plane, xyz)
    near = seen[plane.kept]
    places = frame.places(plane.meets(near.rays))
    first = first_pattern(places, near.intensities, max(spacing, candidate.radius / 6))
    exam.at_least("likeness of two edges", first.likeness(places, near.intensities), tests.least_likeness)
    trial = replace(settings.pattern, rounds=settings.pattern.trial_rounds)
    pattern = fit_pattern(first, places, near.intensities, trial)
    _examine_pattern(exam, pattern, tests)
    exam.at_most("shift of the centre", np.hypot(*pattern.centre), candidate.radius, "m")
    around = _seen(image, xyz, settings.extent.largest_m / 2)
    around = around[plane.holds(around.rays, around.ranges, settings.plane.sigmas)]
    places = frame.places(plane.meets(around.rays))
    extent = extent_of(pattern, places, around.intensities, spacing, settings.extent)
    _examine_extent(exam, extent, size, tests)
    likeness = tiled(pattern, extent.size / 2, places, around.intensities, settings.extent)
    exam.at_most(TILES, likeness, tests.most_tiled)
    return _fitted(exam, image, plane, pattern, extent, frame, settings)


def _fitted(
    exam: Examination,
    image: RangeImage,
    plane: RayPlane,
    pattern: Pattern,
    extent: Extent,
    frame: Frame,
    settings: CheckerboardSettings,
) -> Target:
    """Fit plane and pattern once more, to all points of the target."""
    tests = settings.tests
    half = extent.size / 2
    radius = half - min(tests.rim_blurs * pattern.blur, tests.most_rim * half)
    middle = frame.position(pattern.centre)
    seen = _seen(image, middle, radius)
    # The cone is wider than a slanting target, and would be filled by what is behind it.
    seen = seen[np.linalg.norm(plane.meets(seen.rays) - middle, axis=1) < radius]
    plane = exam.found("planar target", _plane(seen, settings))
    frame = Frame.of(plane, middle)
    seen = seen[plane.kept]
    places = frame.places(plane.meets(seen.rays))
    exam.at_least("points on the target", len(places), tests.fewest_points)
    first = first_pattern(places, seen.intensities, pattern.blur)
    pattern = fit_pattern(first, places, seen.intensities, settings.pattern)
    _examine_pattern(exam, pattern, tests)
    exam.at_most("shift of the centre", np.hypot(*pattern.centre), radius / 2, "m")
    four = quadrants(pattern, places, seen.intensities)
    exam.at_least("points in the poorest quadrant", four.counts.min(), tests.fewest_in_quadrant)
    exam.at_least("points of the colour of their quadrant", four.agreement.min(), tests.least_agreement)
    exam.at_most("difference between quadrants of one colour", four.unevenness, tests.most_uneven)
    ray = frame.position(pattern.centre)
    xyz = plane.meets(ray / np.linalg.norm(ray))
    covariance = _covariance(plane, frame, pattern, xyz, settings.common)
    target = Target(
        kind=Kind.CHECKERBOARD,
        xyz=xyz,
        covariance=covariance,
        size=extent.size,
        points=len(places),
        incidence_deg=plane.incidence_deg(xyz),
        quality=float(pattern.explained * min(1.0, four.counts.min() / four.counts.mean()) ** 0.5),
    )
    return replace(target, doubt=_doubt(target, pattern, four, extent, tests))


def _seen(image: RangeImage, xyz: np.ndarray, radius: float) -> Seen:
    rows = image.around(xyz, radius)
    points = image.xyz[rows].astype(np.float64)
    ranges = np.linalg.norm(points, axis=1)
    intensity = np.zeros(len(rows)) if image.intensity is None else image.intensity[rows].astype(np.float64)
    return Seen(points / ranges[:, None], ranges, intensity)


def _plane(seen: Seen, settings: CheckerboardSettings) -> Optional[RayPlane]:
    if not len(seen.ranges):
        return None
    low, high = np.percentile(seen.intensities, (10, 90))
    return fit_plane(seen.rays, seen.ranges, seen.intensities < (low + high) / 2, settings.plane)


def _spacing(image: RangeImage, xyz: np.ndarray, plane: RayPlane) -> float:
    """Return the distance of neighbouring points on the plane, mean of both directions, metres."""
    distance = np.linalg.norm(xyz)
    level = np.hypot(xyz[0], xyz[1]) / distance
    return float(image.step * distance * np.sqrt(level / np.cos(np.radians(plane.incidence_deg(xyz)))))


def _examine_pattern(exam: Examination, pattern: Pattern, tests: AcceptanceSettings) -> None:
    contrast = 0.0 if pattern.middle <= 0 else abs(pattern.half) / pattern.middle
    exam.at_least("contrast of black and white", contrast, tests.least_contrast)
    exam.at_least("share of the intensities explained by two edges", pattern.explained, tests.least_explained)
    skew = abs(np.degrees(pattern.angles[1] - pattern.angles[0]) - 90)
    exam.at_most("difference of the edges from a right angle", skew, tests.most_skew_deg, "degrees")


def _examine_extent(
    exam: Examination, extent: Extent, size: Optional[float], tests: AcceptanceSettings
) -> None:
    low, high = tests.sizes_m
    if size is not None:
        low, high = size * (1 - tests.size_tolerance), size * (1 + tests.size_tolerance)
    exam.at_least(WIDTH, extent.size, low - 2 * extent.ring, "m")
    exam.at_most(WIDTH, extent.size, high + 2 * extent.ring, "m")


def _covariance(
    plane: RayPlane, frame: Frame, pattern: Pattern, xyz: np.ndarray, common: CommonErrorSettings
) -> np.ndarray:
    """Return the covariance of the centre: on the plane from the edges, along the ray from the plane."""
    ray = xyz / np.linalg.norm(xyz)
    along = plane.range_std(ray) ** 2 * np.outer(ray, ray)
    dim = dim_white_error(plane.step, pattern.black, pattern.white, plane.incidence_deg(xyz), common)
    on_plane = frame.axes.T @ pattern.covariance @ frame.axes
    return np.asarray(on_plane + along + common_covariance(xyz, dim, common))


def _doubt(
    target: Target, pattern: Pattern, four: Quadrants, extent: Extent, tests: AcceptanceSettings
) -> str:
    """Return why a target is doubtful; empty if it is not."""
    if pattern.explained < tests.sure_explained:
        return f"two edges explain only {pattern.explained:.0%} of the intensities"
    if four.counts.min() < tests.sure_in_quadrant:
        return f"only {four.counts.min()} points in a quadrant"
    if four.unevenness > tests.sure_uneven:
        return "its quadrants of one colour differ in tone"
    if extent.evenness < tests.sure_evenness:
        return "its quadrants end at different distances"
    if target.std > tests.sure_std_m:
        return f"the standard deviation of the centre is {1000 * target.std:.1f} mm"
    return ""
