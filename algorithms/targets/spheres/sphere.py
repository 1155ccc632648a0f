"""From a candidate to a sphere, or to the test that it fails."""

from dataclasses import replace
from typing import Union

import numpy as np

from ..common_errors import common_covariance, footprint_error
from ..examination import Examination, FailedError
from ..range_image.range_image import RangeImage
from ..results import Kind, Rejection, Target
from .candidates import Candidate
from .settings import AcceptanceSettings, SphereSettings
from .sphere_fit import SphereFit, fit_sphere


def sphere_at(
    image: RangeImage, candidate: Candidate, diameters: tuple[float, ...], settings: SphereSettings
) -> Union[Target, Rejection]:
    """Fit a sphere at a candidate and test it.

    Parameters
    ----------
    image : RangeImage
    candidate : Candidate
    diameters : tuple of float
        That a sphere may have, metres.
    settings : SphereSettings
    """
    try:
        return _examined(image, candidate, diameters, settings)
    except FailedError as failure:
        return failure.rejection


def _examined(
    image: RangeImage, candidate: Candidate, diameters: tuple[float, ...], settings: SphereSettings
) -> Target:
    limits = settings.acceptance
    distance = float(np.linalg.norm(candidate.xyz))
    centre = candidate.xyz * (1 + candidate.radius / distance)
    exam = Examination(Kind.SPHERE, centre)
    rays, ranges = _rays(image, centre, 1.5 * candidate.radius)
    exam.at_least("points around the centre", len(rays), limits.fewest_points)
    loose = exam.found("round surface", fit_sphere(rays, ranges, centre, candidate.radius, settings.fit))
    exam.at_least("points on the sphere", np.count_nonzero(loose.used), limits.fewest_points)
    most = min(limits.most_sigma_m, limits.most_scatter * candidate.radius)
    exam.at_most("scatter of the ranges", loose.sigma, most, "m")
    nearest = min(diameters, key=lambda diameter: abs(diameter - 2 * loose.radius))
    exam.at_most(
        "difference from a usual diameter",
        abs(2 * loose.radius - nearest),
        _tolerance(loose, nearest, limits),
        "m",
    )
    rays, ranges = _rays(image, loose.centre, 1.5 * nearest / 2)
    fit = exam.found(
        "round surface of this diameter",
        fit_sphere(rays, ranges, loose.centre, nearest / 2, settings.fit, free=False),
    )
    exam.at_most("scatter of the ranges", fit.sigma, most, "m")
    coverage, through, attached = _surroundings(fit, rays, ranges, limits)
    exam.at_least("part of the sphere that was seen", coverage, limits.least_coverage)
    exam.at_most("part of the rays that pass through it", through, limits.most_through)
    exam.at_most("part of the surroundings at its depth", attached, limits.most_attached)
    spot = footprint_error(distance, fit.radius, settings.common)
    target = Target(
        kind=Kind.SPHERE,
        xyz=fit.centre,
        covariance=fit.covariance[:3, :3] + common_covariance(fit.centre, spot, settings.common),
        size=nearest,
        points=int(np.count_nonzero(fit.used)),
        incidence_deg=None,
        quality=float(coverage * (1 - through) * max(0.0, 1 - fit.sigma / most) ** 0.5),
        possible=_possible(loose, diameters, limits),
    )
    return replace(target, doubt=_doubt(target, coverage, limits))


def _rays(image: RangeImage, centre: np.ndarray, radius: float) -> tuple[np.ndarray, np.ndarray]:
    xyz = image.xyz[image.around(centre, radius)].astype(np.float64)
    ranges = np.linalg.norm(xyz, axis=1)
    return xyz / ranges[:, None], ranges


def _tolerance(fit: SphereFit, diameter: float, limits: AcceptanceSettings) -> float:
    """Return how much a fitted diameter may differ from a usual one."""
    wide = max(limits.diameter_m, limits.sigmas * 2 * fit.radius_std)
    return min(wide, limits.size_tolerance * diameter)


def _possible(fit: SphereFit, diameters: tuple[float, ...], limits: AcceptanceSettings) -> tuple[float, ...]:
    """Return the diameters that the fitted one does not contradict."""
    return tuple(
        diameter
        for diameter in diameters
        if abs(2 * fit.radius - diameter) <= _tolerance(fit, diameter, limits)
    )


def _surroundings(
    fit: SphereFit, rays: np.ndarray, ranges: np.ndarray, limits: AcceptanceSettings
) -> tuple[float, float, float]:
    """Return the seen part of the cap, that of the rays that pass it, and that of the ring at its depth."""
    sectors = int(np.clip(np.count_nonzero(fit.used) // limits.points_of_sector, 4, limits.sectors))
    distance = float(np.linalg.norm(fit.centre))
    axis = fit.centre / distance
    first = np.cross(axis, np.eye(3)[int(np.argmin(np.abs(axis)))])
    first /= np.linalg.norm(first)
    across = np.stack([first, np.cross(axis, first)])
    offset = rays @ across.T * distance / fit.radius
    lateral = np.hypot(*offset.T)
    behind = ranges - distance
    cap = lateral < 0.8
    sector = np.floor((np.arctan2(offset[:, 1], offset[:, 0]) / (2 * np.pi) + 0.5) * sectors).astype(np.int64)
    cell = 2 * (sector % sectors) + (lateral > 0.55)
    touched = np.unique(cell[cap & fit.used])
    through = np.mean(behind[cap] > fit.radius) if np.any(cap) else 1.0
    ring = (lateral > 1.2) & (lateral < 1.5)
    attached = np.mean(np.abs(behind[ring]) < fit.radius) if np.any(ring) else 0.0
    return len(touched) / (2 * sectors), float(through), float(attached)


def _doubt(target: Target, coverage: float, limits: AcceptanceSettings) -> str:
    """Return why a sphere is doubtful; empty if it is not."""
    if len(target.possible) > 1:
        millimetres = " or ".join(f"{1000 * size:.0f}" for size in target.possible)
        return f"its diameter may be {millimetres} mm; set SIZE"
    if target.points < limits.sure_points:
        return f"only {target.points} points"
    if coverage < limits.sure_coverage:
        return f"only {coverage:.0%} of it was seen"
    if target.std > limits.sure_std_m:
        return f"the standard deviation of the centre is {1000 * target.std:.1f} mm"
    return ""
