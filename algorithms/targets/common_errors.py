"""Errors that all points of a target have in common, so that their number does not average them out."""

from dataclasses import dataclass

import numpy as np

from ..settings import judged, physical


@dataclass(frozen=True)
class CommonErrorSettings:
    """What repeated scans of one target differ by, and what the beam and the light add."""

    range_m: float = physical(
        0.00005, "Ranges drift: repeated scans of one target differ by 0.03 to 0.05 mm along the ray."
    )
    direction: float = physical(
        7e-6, "Radians. So do encoders and the tripod: such scans differ by 3 to 8 microradians across it."
    )
    beam_m: float = physical(
        0.001, "Standard deviation of the light across a beam that leaves the scanner 4 mm wide."
    )
    beam_growth: float = physical(
        0.0001, "By how much it grows each metre: beams diverge by 0.3 to 0.5 mrad."
    )
    known_part: float = judged(
        0.5, "Of how far white is off because it is dim: some scanners correct their ranges for intensity."
    )

    def footprint(self, distance: float) -> float:
        """Return the standard deviation of the light across the beam, metres."""
        return self.beam_m + self.beam_growth * distance


def common_covariance(
    xyz: np.ndarray, along_m: float, settings: CommonErrorSettings = CommonErrorSettings()
) -> np.ndarray:
    """Return the covariance of what all points of a target have in common, shape (3, 3).

    Parameters
    ----------
    xyz : ndarray, shape (3,)
        The centre, relative to the scanner.
    along_m : float
        Standard deviation of a further error along the ray, metres.
    settings : CommonErrorSettings
    """
    distance = float(np.linalg.norm(xyz))
    ray = xyz / distance
    along = np.outer(ray, ray)
    across = (settings.direction * distance) ** 2
    return np.asarray((settings.range_m**2 + along_m**2) * along + across * (np.eye(3) - along))


def dim_white_error(
    step: float, black: float, white: float, incidence_deg: float, settings: CommonErrorSettings
) -> float:
    """Return how far ranges on white may be off because it reflects less light aslant, metres.

    Black is measured by `step` farther than white, in proportion to the light that it lacks. White lacks
    light too: seen at an angle, it returns the cosine of what it returns when seen squarely (Lambert).

    Parameters
    ----------
    step : float
        Metres.
    black, white : float
        Intensities.
    incidence_deg : float
    settings : CommonErrorSettings
    """
    lost = white * (1.0 / np.cos(np.radians(incidence_deg)) - 1.0)
    return float(settings.known_part * abs(step) * lost / max(white - black, 1e-9))


def footprint_error(distance: float, radius: float, settings: CommonErrorSettings) -> float:
    """Return how much too far a sphere may be measured, metres.

    A beam meets a sphere not in a point. The surface recedes from its middle on all sides, by s^2 / R on
    average, where s is the standard deviation of the light across the beam.
    """
    return settings.footprint(distance) ** 2 / radius
