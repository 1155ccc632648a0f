"""The centrelines of walls: straight pieces and arcs that meet at junctions, each with its thickness."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Optional

import numpy as np
from shapely.affinity import translate
from shapely.geometry import LineString, Polygon

from ...geometry.azimuths import line_azimuth
from ...geometry.circles import fit_arc
from ...geometry.curves import Curve, Line, fit_line
from .skeleton import Chain, skeleton_of

WANDER = (0.01, 0.12)
"""How far a centreline may lie off a piece: metres, and a share of the wall's thickness."""

CURVED = 1.5
"""An arc is taken where it follows the wall so many times as far as a line,"""

BENT = 0.25
"""and turns by at least this angle, in radians."""

SHORT = 1.0
"""A piece shorter than this share of the thickness is the corner in which others meet, or part of a wall."""

COMPACT = 1.5
"""A wall whose axes are shorter than so many times the widest circle in it is a column."""

FAN = 1.02
"""Towards the corner in which a skeleton ends, each chord is longer than so many times the next."""

ONE_FACE = 0.03
"""An outline narrower than this, in metres, is a face seen from one side: the thickness is unknown."""

LOOSE = 1e-2
"""Weight of where a junction was found against where the axes meet."""

JOG = 0.01
"""An axis that passes a junction nearer than this, in metres, is bent there; else it makes a step."""


@dataclass(frozen=True)
class Axis:
    """A piece of the centreline of a wall.

    Attributes
    ----------
    wall_id, axis_id : int
        Of the wall; of the piece, from 1.
    line : LineString
        World coordinates; pieces that meet share their ends.
    thickness, thick_sd : float or None
        Median width of the outline across the piece, and its standard deviation, metres; None if only one
        face was seen.
    azimuth : float or None
        Direction of a straight piece, degrees clockwise from grid north, 0..180.
    radius : float or None
        Of an arc, metres.
    """

    wall_id: int
    axis_id: int
    line: LineString
    thickness: Optional[float]
    thick_sd: Optional[float]
    azimuth: Optional[float]
    radius: Optional[float]

    @property
    def length(self) -> float:
        """Metres."""
        return float(self.line.length)


def find_axes(walls: Iterable) -> tuple:
    """Return the axes of walls; a wall not longer than thick, such as a column, has none.

    Parameters
    ----------
    walls : iterable of (int, Polygon)
        Numbers and outlines, world coordinates.

    Returns
    -------
    tuple of Axis
    """
    pieces = [(wall_id, piece) for wall_id, outline in walls for piece in _axes_of(outline)]
    return tuple(Axis(wall_id, number, *piece) for number, (wall_id, piece) in enumerate(pieces, start=1))


@dataclass(frozen=True)
class _Piece:
    """A curve through the middles of chords, and the nodes at its ends; None is where the wall ends."""

    points: np.ndarray
    chords: np.ndarray
    curve: Curve
    start: Optional[int]
    end: Optional[int]


def _axes_of(outline: Polygon) -> list:
    skeleton = skeleton_of(outline)
    nodes = dict(skeleton.junctions)
    pieces = [piece for chain in skeleton.chains for piece in _pieces(chain, nodes)]
    local = translate(outline, *-skeleton.origin)
    curves = {node: [] for node in (None, *nodes)}
    for piece in pieces:
        curves[piece.start].append(piece.curve)
        curves[piece.end].append(piece.curve)
    places = {node: _meeting(where, curves[node]) for node, where in nodes.items()}
    lines = [_drawn(piece, places, local) for piece in pieces]
    if sum(line.length for line in lines) < COMPACT * skeleton.width:
        return []
    return [
        (translate(line, *skeleton.origin), *_thickness(piece), _azimuth(piece.curve), piece.curve.radius)
        for line, piece in zip(lines, pieces)
        if line.length > JOG
    ]


def _pieces(chain: Chain, nodes: dict) -> list:
    """Cut a chain into lines and arcs, and note the new node between each two."""
    chain = _without_fans(chain)
    if chain.length < SHORT * chain.width or len(chain.middles) < 3:
        return []
    tolerance = WANDER[0] + WANDER[1] * chain.width
    runs = _adjusted(chain.middles, _runs(chain.middles, tolerance, chain.width))
    longest = max(runs, key=lambda run: _length(chain.middles, run))
    runs = [run for run in runs if _length(chain.middles, run) >= SHORT * chain.width] or [longest]
    fitted = [_fitted(chain, run, tolerance) for run in runs]
    between = range(len(nodes), len(nodes) + len(fitted) - 1)
    for node, (before, *_), (after, *_) in zip(between, fitted, fitted[1:]):
        nodes[node] = (before[-1] + after[0]) / 2
    ends = (chain.start, *between, chain.end)
    return [_Piece(*parts, *pair) for parts, pair in zip(fitted, zip(ends, ends[1:]))]


def _without_fans(chain: Chain) -> Chain:
    """Cut off the ends of a chain that run into a corner of the wall's end."""
    lengths = np.linalg.norm(chain.chords, axis=1)
    first, last = 0, len(lengths) - 1
    while chain.start is None and first + 3 < last and lengths[first + 1] > FAN * lengths[first]:
        first += 1
    while chain.end is None and first + 3 < last and lengths[last - 1] > FAN * lengths[last]:
        last -= 1
    return replace(chain, middles=chain.middles[first : last + 1], chords=chain.chords[first : last + 1])


def _runs(points: np.ndarray, tolerance: float, width: float) -> list:
    """Return from where to where points lie on one curve, and how it is fitted: the longest runs in turn."""
    runs, start = [], 0
    while start < len(points) - 1:
        run = (start, _reach(points, start, fit_line, tolerance), fit_line)
        curved = (start, _reach(points, start, fit_arc, tolerance), fit_arc)
        if _length(points, curved) > max(CURVED * _length(points, run), 2 * width):
            radius = fit_arc(points[slice(*curved[:2])]).radius
            run = curved if width < radius < _length(points, curved) / BENT else run
        runs.append(run)
        start = run[1]
    return runs


def _reach(points: np.ndarray, start: int, fit, tolerance: float) -> int:
    """Return up to where points from `start` on lie within the tolerance of one curve."""

    def follows(stop: int) -> bool:
        curve = fit(points[start:stop])
        return curve is not None and curve.distances(points[start:stop]).max() <= tolerance

    low = step = min(start + 4, len(points)) - start
    low += start
    while low < len(points) and follows(min(low + step, len(points))):
        low = min(low + step, len(points))
        step *= 2
    high = min(low + step, len(points))
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if follows(middle) else (low, middle)
    return low if len(points) - low > 1 else len(points)


def _length(points: np.ndarray, run: tuple) -> float:
    """Return the length of a run; a zigzag is as long as the line along it."""
    points = points[run[0] : run[1]]
    if run[2] is fit_line:
        return float(np.linalg.norm(points[-1] - points[0]))
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


def _adjusted(points: np.ndarray, runs: list) -> list:
    """Move the borders between adjacent runs to where they fit best: the longest run reaches too far."""
    runs = list(runs)
    for i in range(len(runs) - 1):
        (a, b, fit), (c, d, other) = runs[i : i + 2]
        if b == c and min(b - a, d - c) > 3:
            curves = (fit(points[a:b]) or fit_line(points[a:b]), other(points[c:d]) or fit_line(points[c:d]))
            off, beyond = (curve.distances(points[a:d]) for curve in curves)
            error = np.cumsum(off**2) + np.cumsum(beyond[::-1] ** 2)[::-1] - beyond**2
            border = a + 2 + int(np.argmin(error[2:-2]))
            runs[i], runs[i + 1] = (a, border, fit), (border, d, other)
    return runs


def _fitted(chain: Chain, run: tuple, tolerance: float) -> tuple:
    """Return the middles and chords of a run, and the curve through them.

    Half a thickness at each end, where the wall meets others or ends, has no say.
    """
    start, stop, fit = run
    points = chain.middles[start:stop]
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    margin = min(chain.width / 2, along[-1] / 4)
    core = (along >= margin) & (along <= along[-1] - margin)
    if core.sum() < 3:
        core[:] = True
    points, curve = points[core], fit_line(points[core])
    if curve.distances(points).max() > tolerance:
        curve = fit(points) or curve
    return points, chain.chords[start:stop][core], curve


def _meeting(where: np.ndarray, curves: Sequence) -> np.ndarray:
    """Return the point nearest to the curves that meet about a place."""
    for _ in range(2):
        matrix, vector = LOOSE * np.eye(2), LOOSE * where
        for line in (curve.tangent(where) for curve in curves):
            normal = line.normal(where)
            matrix = matrix + np.outer(normal, normal)
            vector = vector + normal * (normal @ line.point)
        where = np.linalg.solve(matrix, vector)
    return where


def _drawn(piece: _Piece, places: dict, outline: Polygon) -> LineString:
    """Draw a piece from node to node, or to the end of the wall."""
    first = places.get(piece.start)
    last = places.get(piece.end)
    first = _wall_end(piece.curve, piece.points, outline) if first is None else first
    last = _wall_end(piece.curve, piece.points[::-1], outline) if last is None else last
    corners = piece.curve.between(np.concatenate([[first], piece.points, [last]]))
    if np.linalg.norm(corners[0] - first) <= JOG:
        corners = corners[1:]
    if np.linalg.norm(corners[-1] - last) <= JOG:
        corners = corners[:-1]
    return LineString(np.concatenate([[first], corners, [last]]))


def _wall_end(curve: Curve, points: np.ndarray, outline: Polygon) -> np.ndarray:
    """Return where a curve, followed beyond the first of its points, leaves the outline."""
    start = curve.foot(points[0])
    direction = curve.tangent(points[0]).direction
    outward = direction if (points[0] - points[min(3, len(points) - 1)]) @ direction > 0 else -direction
    west, south, east, north = outline.bounds
    ray = LineString([start, start + outward * (east - west + north - south)])
    hits = ray.intersection(outline.boundary)
    ends = [corner for part in getattr(hits, "geoms", [hits]) for corner in part.coords]
    return np.array(min(ends, key=lambda end: np.linalg.norm(np.subtract(end, start)))) if ends else start


def _thickness(piece: _Piece) -> tuple:
    normals = np.array([piece.curve.normal(point) for point in piece.points])
    across = np.abs((piece.chords * normals).sum(axis=1))
    thickness = float(np.median(across))
    return (None, None) if thickness < ONE_FACE else (thickness, float(np.std(across)))


def _azimuth(curve: Curve) -> Optional[float]:
    return line_azimuth(curve.direction) if isinstance(curve, Line) else None
