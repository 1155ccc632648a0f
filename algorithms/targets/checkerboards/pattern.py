"""The pattern of a black and white target: two edges that cross, between black and white quadrants."""

from dataclasses import dataclass, replace

import numpy as np
from scipy.special import erf

from ...geometry.robust import sigma_of_residuals, tukey_weights
from .settings import PatternSettings

UNKNOWNS = 7
"""Two coordinates of the centre, two angles, the blur, two intensities."""


@dataclass(frozen=True)
class Pattern:
    """Two edges on a plane, blurred by the beam of the scanner.

    Attributes
    ----------
    centre : ndarray, shape (2,)
        Where they cross, metres.
    angles : tuple of 2 float
        Of the edges against the first axis, radians.
    blur : float
        Standard deviation of the blur, metres.
    middle, half : float
        Mean of the intensities of black and white, and half of their difference. White is where the signs
        of the distances from both edges are equal.
    covariance : ndarray, shape (2, 2)
        Of the centre.
    explained : float
        Part of the variance of the intensities that the pattern explains, at most 1.
    """

    centre: np.ndarray
    angles: tuple[float, float]
    blur: float
    middle: float
    half: float
    covariance: np.ndarray
    explained: float = 0.0

    @property
    def black(self) -> float:
        """Intensity of black."""
        return self.middle - abs(self.half)

    @property
    def white(self) -> float:
        """Intensity of white."""
        return self.middle + abs(self.half)

    def distances(self, places: np.ndarray) -> np.ndarray:
        """Return the signed distances from both edges, shape (n, 2)."""
        u, v = (places - self.centre).T
        return np.column_stack([v * np.cos(angle) - u * np.sin(angle) for angle in self.angles])

    def steps(self, places: np.ndarray) -> np.ndarray:
        """Return the profile across each edge, from -1 to 1, shape (n, 2)."""
        return np.asarray(erf(self.distances(places) / (np.sqrt(2.0) * self.blur)))

    def intensities(self, places: np.ndarray) -> np.ndarray:
        """Return what the pattern reflects at places on its plane, shape (n, 2)."""
        return self.middle + self.half * np.prod(self.steps(places), axis=1)

    def likeness(self, places: np.ndarray, intensities: np.ndarray) -> float:
        """Return the correlation of intensities with the pattern, 0 if there is none."""
        wanted = self.intensities(places)
        if np.ptp(wanted) == 0 or np.ptp(intensities) == 0:
            return 0.0
        return float(np.corrcoef(wanted, intensities)[0, 1])


def first_pattern(places: np.ndarray, intensities: np.ndarray, blur: float) -> Pattern:
    """Return a pattern about the origin, to start from.

    The direction of its white quadrants is the phase of the second harmonic of the intensities around it.

    Parameters
    ----------
    places : ndarray, shape (n, 2)
    intensities : ndarray, shape (n,)
    blur : float
        Metres.
    """
    white = np.angle(np.sum((intensities - intensities.mean()) * np.exp(2j * _azimuth(places)))) / 2
    low, high = np.percentile(intensities, (15, 85))
    half = (high - low) / 2
    # Between edges at 45 degrees from it both distances have unequal signs.
    return Pattern(
        np.zeros(2), (white - np.pi / 4, white + np.pi / 4), blur, (low + high) / 2, -half, np.zeros((2, 2))
    )


def fit_pattern(
    first: Pattern, places: np.ndarray, intensities: np.ndarray, settings: PatternSettings
) -> Pattern:
    """Fit the two edges to intensities by robust least squares.

    Parameters
    ----------
    first : Pattern
        Near the solution.
    places : ndarray, shape (n, 2)
        On the plane of the target, metres.
    intensities : ndarray, shape (n,)
    settings : PatternSettings
    """
    pattern = first
    spacing = _spacing(places)
    for number in range(settings.rounds):
        design, residuals = _linearised(pattern, places, intensities)
        weights = _weights(residuals, pattern, places, settings.outlier)
        normal, right = _normal(design, residuals, weights, pattern, settings)
        change = np.linalg.lstsq(normal, right, rcond=None)[0]
        pattern = _moved(pattern, change, spacing, free=number >= 3)
        if np.hypot(change[0], change[1]) < settings.settled * pattern.blur and number > 3:
            break
    design, residuals = _linearised(pattern, places, intensities)
    weights = _weights(residuals, pattern, places, settings.outlier)
    covariance = _covariance(design, residuals, weights, pattern, places, settings)
    used = weights > 0
    spread = intensities[used] - intensities[used].mean()
    explained = 1.0 - float(np.sum(residuals[used] ** 2) / max(np.sum(spread**2), 1e-9))
    return replace(pattern, covariance=covariance, explained=explained)


def _azimuth(places: np.ndarray) -> np.ndarray:
    return np.arctan2(places[:, 1], places[:, 0])


def _spacing(places: np.ndarray) -> float:
    """Return the spacing of points that cover their rectangle evenly."""
    return float(np.sqrt(np.prod(np.ptp(places, axis=0)) / len(places)))


def _linearised(
    pattern: Pattern, places: np.ndarray, intensities: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the derivatives by centre, angles, blur, middle and half, and what the pattern leaves."""
    u, v = (places - pattern.centre).T
    distances = pattern.distances(places)
    steps = pattern.steps(places)
    slopes = np.sqrt(2.0 / np.pi) / pattern.blur * np.exp(-0.5 * (distances / pattern.blur) ** 2)
    columns = np.zeros((len(places), 7))
    for edge, angle in enumerate(pattern.angles):
        steepness = pattern.half * slopes[:, edge] * steps[:, 1 - edge]
        columns[:, 0] += steepness * np.sin(angle)
        columns[:, 1] -= steepness * np.cos(angle)
        columns[:, 2 + edge] = -steepness * (u * np.cos(angle) + v * np.sin(angle))
        columns[:, 4] -= steepness * distances[:, edge] / pattern.blur
    product = np.prod(steps, axis=1)
    columns[:, 5] = 1.0
    columns[:, 6] = product
    return columns, intensities - (pattern.middle + pattern.half * product)


def _weights(residuals: np.ndarray, pattern: Pattern, places: np.ndarray, outlier: float) -> np.ndarray:
    """Return weights by the scatter of each colour, 0 for outliers."""
    steps = np.prod(pattern.steps(places), axis=1) * np.sign(pattern.half)
    white = steps > 0
    least = abs(pattern.half) * 1e-3 + 1e-9
    scatter = [
        max(sigma_of_residuals(residuals[side]), least) if np.any(side) else least for side in (~white, white)
    ]
    share = (1.0 + steps) / 2.0
    variance = scatter[0] ** 2 * (1 - share) + scatter[1] ** 2 * share
    # On the edges errors of direction and of the shape of the beam become errors of intensity.
    slope = 1.0 - steps**2
    edge = slope > 0.3
    if np.any(edge):
        rough = sigma_of_residuals(residuals[edge] / np.sqrt(slope[edge]))
        variance = variance + np.maximum(rough, 0.02 * abs(pattern.half)) ** 2 * slope
    return tukey_weights(residuals / np.sqrt(variance), 1.0, outlier) / variance


def _normal(
    design: np.ndarray,
    residuals: np.ndarray,
    weights: np.ndarray,
    pattern: Pattern,
    settings: PatternSettings,
) -> tuple[np.ndarray, np.ndarray]:
    """Return the normal equations, with the observation that the edges are at a right angle."""
    weighted = design * weights[:, None]
    normal, right = weighted.T @ design, weighted.T @ residuals
    square = np.zeros(7)
    square[2:4] = -1.0, 1.0
    gap = np.pi / 2 - (pattern.angles[1] - pattern.angles[0])
    weight = settings.angle_std**-2
    return normal + weight * np.outer(square, square), right + weight * gap * square


def _moved(pattern: Pattern, change: np.ndarray, spacing: float, free: bool) -> Pattern:
    """Return the pattern after a step, which is damped; the blur is fixed at first."""
    shift = change[:2]
    length = float(np.hypot(*shift))
    most = 2.0 * pattern.blur + spacing
    shift = shift * min(1.0, most / max(length, 1e-12))
    turns = np.clip(change[2:4], -0.2, 0.2)
    blur = pattern.blur
    if free:
        blur = float(np.clip(blur + np.clip(change[4], -blur / 2, blur), 0.2 * spacing, 4.0 * spacing + blur))
    return replace(
        pattern,
        centre=pattern.centre + shift,
        angles=(pattern.angles[0] + turns[0], pattern.angles[1] + turns[1]),
        blur=blur,
        middle=pattern.middle + change[5],
        half=pattern.half + change[6],
    )


def _covariance(
    design: np.ndarray,
    residuals: np.ndarray,
    weights: np.ndarray,
    pattern: Pattern,
    places: np.ndarray,
    settings: PatternSettings,
) -> np.ndarray:
    """Return the covariance of the centre from the scatter of blocks, within which errors are alike.

    Neighbouring beams overlap, and lines of a scan are off as a whole: residuals depend on each other, and
    their number says too much about the centre (White's sandwich estimator, by blocks).
    """
    normal, _ = _normal(design, residuals, weights, pattern, settings)
    inverse = np.linalg.pinv(normal)
    cells = np.floor(places / (settings.block_blurs * pattern.blur)).astype(np.int64)
    _, block = np.unique(cells, axis=0, return_inverse=True)
    scores = design * (weights * residuals)[:, None]
    joined = np.zeros((int(block.max()) + 1, 8))
    np.add.at(joined, block.ravel(), np.column_stack([scores, weights * np.sum(design[:, :2] ** 2, axis=1)]))
    # Blocks count by what they say about the centre: those on the edges.
    count = np.sum(joined[:, 7]) ** 2 / max(np.sum(joined[:, 7] ** 2), 1e-300)
    if count >= settings.fewest_blocks:
        scores, factor = joined[:, :7], count / (count - UNKNOWNS - 2)
    else:
        # A fit comes near to each point the more the fewer there are.
        leverage = np.einsum("ij,jk,ik->i", design, inverse, design) * weights
        scores = scores / (1 - np.minimum(leverage, 0.9))[:, None]
        freedom = np.count_nonzero(weights) - UNKNOWNS
        factor = freedom / max(freedom - 2, 0.5)
    return np.asarray((inverse @ (scores.T @ scores) @ inverse * factor)[:2, :2])
