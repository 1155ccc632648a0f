"""The straight edges of an outline: each fitted on its own, robustly, to the border beside it."""

from dataclasses import dataclass, replace

import numpy as np

from ...geometry.robust import EFFICIENT_CUT, sigma_about_median, sigma_of_residuals, tukey_weights
from .settings import EdgeSettings, OutlineSettings


@dataclass(frozen=True)
class Edge:
    """A level or plumb edge.

    Attributes
    ----------
    position : float
        Of the edge, across it (m).
    std : float
        Standard deviation of the position (m); nan if the edge was not measured.
    first, last : float
        Stations along the edge between which the border agrees with it; nan if it was not measured.
    """

    position: float
    std: float
    first: float = float("nan")
    last: float = float("nan")

    @property
    def measured(self) -> bool:
        """Whether enough of the border agrees with the edge."""
        return bool(np.isfinite(self.std))


def fit_edge(
    across: np.ndarray,
    along: np.ndarray,
    gaps: np.ndarray,
    limits: tuple[float, float],
    fallback: float,
    settings: OutlineSettings = OutlineSettings(),
    spacing: float = 0.0,
) -> Edge:
    """Return the edge on which most of the border agrees.

    The border beside an edge is also that of frames, of branches in front, and of the edges beyond its
    corners. The edge is where it is densest: the position that most stations along it agree on. Where too few
    agree, the edge was not measured and is where the fallback says.

    Parameters
    ----------
    across, along, gaps : ndarray of float64, shape (k,)
        Positions of the border across the edge, stations along it, and widths within which the border lies.
    limits : tuple of float
        Stations at which the edge begins and ends.
    fallback : float
        Position of an edge that was not measured.
    settings : OutlineSettings
    spacing : float
        Of the positions along the edge, if it is larger than the gaps (m).
    """
    edges = settings.edges
    if len(across) < edges.fewest:
        return Edge(fallback, float("nan"))
    gap = float(np.median(gaps))
    corner = min(edges.corner_gaps * max(gap, spacing), 0.25 * (limits[1] - limits[0]))
    inner = (along > limits[0] + corner) & (along < limits[1] - corner)
    across, along, gaps = across[inner], along[inner], gaps[inner]
    if len(across) < edges.fewest:
        return Edge(fallback, float("nan"))
    window = edges.window_gaps * gap + edges.window_sigmas * settings.noise_m
    step = max(gap, edges.step_spacings * spacing, (limits[1] - limits[0]) / edges.most_stations)
    stations = np.floor((along - limits[0]) / step).astype(np.int64)
    near = np.abs(across - _densest(across, stations, window)) <= window
    middle = biweight(across[near], float(np.median(across[near])), edges)
    near = np.abs(across - middle) <= window
    first, last = np.percentile(along[near], (2, 98)) if near.any() else (0.0, 0.0)
    between = max((last - first) / step, 1.0)
    share = len(np.unique(stations[near])) / between
    long_enough = last - first >= edges.extent * (limits[1] - limits[0] - 2 * corner)
    if share < edges.agreeing or not long_enough:
        return Edge(fallback, float("nan"))
    crossings = np.stack([across[near], along[near]], axis=1)
    std = border_deviation(across[near] - middle, crossings, gaps[near], spacing, settings)
    return Edge(middle, std, float(first), float(last))


def edge_at_wall(
    edge: Edge,
    across: np.ndarray,
    depths: np.ndarray,
    reach: float,
    settings: OutlineSettings = OutlineSettings(),
) -> Edge:
    """Return the edge where its jamb meets the wall, if the jamb is oblique to it.

    Jambs are square to a flat wall. Those of a round one are parallel to each other, so that they are oblique
    where the wall is rolled out.

    Parameters
    ----------
    edge : Edge
        As the points of the jamb show it, whatever their depth.
    across, depths : ndarray of float64, shape (k,)
        Of all points of jambs: positions across the edge, and depths behind the wall (m).
    reach : float
        Points of the jamb are as near to a line (m).
    settings : OutlineSettings
    """
    limits, line = settings.jambs, np.array([0.0, edge.position])
    for doubled in range(1, limits.rounds + 1):
        # Panes and leaves, deeper in the wall, may cross the line as long as it is not known.
        near = np.abs(across - np.polyval(line, depths)) <= reach
        near &= depths <= limits.least_spread_m * 2**doubled
        if near.sum() < limits.fewest_points or np.ptp(depths[near]) < limits.least_spread_m:
            return edge
        line, covariance = np.polyfit(depths[near], across[near], 1, cov="unscaled")
    held = np.abs(across - np.polyval(line, depths)) <= reach
    square = np.abs(across - edge.position) <= reach
    if abs(line[0]) < limits.square or held.sum() < limits.more * square.sum():
        return edge
    scatter = float(sigma_about_median(across[near] - np.polyval(line, depths[near])))
    return replace(
        edge, position=float(line[1]), std=float(np.hypot(edge.std, scatter * covariance[1, 1] ** 0.5))
    )


def _densest(across: np.ndarray, stations: np.ndarray, window: float) -> float:
    """Return the middle of the window across which most stations have border."""
    _, which, counts = np.unique(stations, return_inverse=True, return_counts=True)
    order = np.argsort(across, kind="stable")
    sums = np.concatenate([[0.0], np.cumsum(1.0 / counts[which.reshape(-1)][order])])
    positions = across[order]
    ends = np.searchsorted(positions, positions + window, side="right")
    weights = sums[ends] - sums[:-1]
    best = int(np.argmax(weights))
    return float(np.median(positions[best : ends[best]]))


def biweight(values: np.ndarray, start: float, settings: EdgeSettings = EdgeSettings()) -> float:
    """Return a robust mean of values, by Tukey's biweight (Beaton and Tukey 1974)."""
    middle = start
    for _ in range(settings.rounds):
        scale = max(sigma_of_residuals(values - middle), 1e-4)
        weights = tukey_weights(values - middle, scale, EFFICIENT_CUT)
        middle = float(np.average(values, weights=weights))
    return middle


def border_deviation(
    residuals: np.ndarray,
    crossings: np.ndarray,
    gaps: np.ndarray,
    spacing: float,
    settings: OutlineSettings = OutlineSettings(),
) -> float:
    """Return the standard deviation of an edge, straight or curved (m); nan if nothing was seen of it.

    Where the end of a surface shows the edge, and no jamb, the mean distance to it is uncertain too.

    Parameters
    ----------
    residuals, gaps : ndarray of float64, shape (k,)
        Signed; gaps are 0 on jambs.
    crossings : ndarray of float64, shape (k, 2)
    spacing : float
        Of the points of the surface (m).
    settings : OutlineSettings
    """
    if not (gaps > 0).any():
        return edge_deviation(residuals, crossings, np.full(len(gaps), 1e-9), settings)
    # Of two scans the outermost lines may lie close together by chance; the edge is not surer for it.
    std = edge_deviation(residuals, crossings, np.maximum(gaps, spacing), settings)
    return float(np.hypot(std, settings.edges.uncorrected * spacing))


def edge_deviation(
    residuals: np.ndarray,
    crossings: np.ndarray,
    gaps: np.ndarray,
    settings: OutlineSettings = OutlineSettings(),
) -> float:
    """Return the standard deviation of the position of an edge (m); nan if nothing was seen of it.

    The border lies anywhere within the gap. The part of this that appears as scatter along the edge
    averages out. The rest does not, for example where a line of the scan runs along the edge.
    Nor does a lean, by which one end of the edge lies elsewhere than the other.

    Parameters
    ----------
    residuals, gaps : ndarray of float64, shape (k,)
    crossings : ndarray of float64, shape (k, 2)
    settings : OutlineSettings
    """
    if len(residuals) < 2:
        return float("nan")
    gap = float(np.median(gaps))
    length = float(np.hypot(*np.ptp(crossings, axis=0)))
    independent = max(min(length / max(gap, 1e-6), len(residuals)) / 2, 1.0)
    trend = _trend(residuals, crossings)
    lean = float(np.mean(trend**2))
    if lean > settings.edges.leaning * float(np.var(residuals - trend)) / independent:
        residuals = residuals - trend
    else:
        lean = 0.0
    scatter = float(sigma_about_median(residuals)) ** 2
    unseen = max(gap**2 / 12 - settings.edges.scattered * scatter, 0.0)
    systematic = settings.edges.systematic_m**2
    return float(np.sqrt(unseen + lean + (scatter + settings.noise_m**2) / independent + systematic))


def _trend(residuals: np.ndarray, crossings: np.ndarray) -> np.ndarray:
    """Return the part of residuals that changes evenly along an edge."""
    along = crossings[:, int(np.argmax(np.ptp(crossings, axis=0)))]
    along = along - along.mean()
    return np.asarray(along * (along @ residuals) / max(float(along @ along), 1e-18))
