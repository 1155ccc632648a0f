"""The centrelines of walls: straight pieces and arcs that meet at junctions, each with its thickness."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Callable, NamedTuple, Optional

import numpy as np
from shapely.affinity import translate
from shapely.geometry import LineString, Point, Polygon

from ...geometry.azimuths import line_azimuth
from ...geometry.circles import arc_through
from ...geometry.curves import Curve, Line, line_through
from ...progress import Progress
from .settings import AxisSettings, CentrelineSettings
from .skeleton import Chain, skeleton_of

WITHIN_M = 1e-3
"""An axis may touch the outline of its wall up to this."""


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


def find_axes(
    walls: Iterable[tuple[int, Polygon]],
    settings: AxisSettings = AxisSettings(),
    progress: Progress = Progress(),
) -> tuple[Axis, ...]:
    """Return the axes of walls; a wall not longer than thick, such as a column, has none.

    Parameters
    ----------
    walls : iterable of (int, Polygon)
        Numbers and outlines, world coordinates.
    settings : AxisSettings
    progress : Progress
        Reports and cancels.

    Returns
    -------
    tuple of Axis
    """
    walls, pieces = list(walls), []
    for done, (wall_id, outline) in enumerate(walls):
        progress.update(done / len(walls), "Finding axes")
        pieces += [(wall_id, piece) for piece in _axes_of(outline, settings)]
    return tuple(Axis(wall_id, number, *piece) for number, (wall_id, piece) in enumerate(pieces, start=1))


@dataclass(frozen=True)
class _Piece:
    """A curve through the middles of chords, and the nodes at its ends; None is where the wall ends."""

    points: np.ndarray
    chords: np.ndarray
    curve: Curve
    start: Optional[int]
    end: Optional[int]


class _Run(NamedTuple):
    """Points start..stop (exclusive) of a chain, and how the curve on which they lie is fitted."""

    start: int
    stop: int
    fit: Callable[[np.ndarray], Optional[Curve]]


_Measured = tuple[LineString, Optional[float], Optional[float], Optional[float], Optional[float]]


def _axes_of(outline: Polygon, settings: AxisSettings) -> list[_Measured]:
    """Return the line, thickness, its standard deviation, azimuth and radius of each axis of a wall."""
    own = settings.centrelines
    skeleton = skeleton_of(outline, settings)
    nodes = dict(skeleton.junctions)
    pieces = [piece for chain in skeleton.chains for piece in _pieces(chain, nodes, own)]
    local = translate(outline, *-skeleton.origin)
    curves: dict[Optional[int], list[Curve]] = {node: [] for node in (None, *nodes)}
    for piece in pieces:
        curves[piece.start].append(piece.curve)
        curves[piece.end].append(piece.curve)
    junctions = {
        node: _near(_meeting(where, curves[node], own.loose), where, max(skeleton.width, own.node_m), local)
        for node, where in nodes.items()
    }
    body = local.buffer(WITHIN_M)
    lines = [_inside(_drawn(piece, junctions, local, own), piece, body) for piece in pieces]
    if sum(line.length for line in lines) < own.compact * skeleton.width:
        return []
    return [
        (
            translate(line, *skeleton.origin),
            *_thickness(piece, own),
            _azimuth(piece.curve),
            piece.curve.radius,
        )
        for line, piece in zip(lines, pieces)
        if line.length > own.jog_m
    ]


def _pieces(chain: Chain, nodes: dict[int, np.ndarray], settings: CentrelineSettings) -> list[_Piece]:
    """Cut a chain into lines and arcs, and note the new node between each two."""
    chain = _without_fans(chain, settings.fan)
    shortest = settings.shortest * chain.width
    if chain.length < shortest or len(chain.middles) < 3:
        return []
    tolerance = settings.wander_m + settings.wander_share * chain.width
    runs = _adjusted(chain.middles, _runs(chain.middles, tolerance, chain.width, settings))
    longest = max(runs, key=lambda run: _length(chain.middles, run))
    runs = [run for run in runs if _length(chain.middles, run) >= shortest] or [longest]
    fitted = [_fitted(chain, run, tolerance) for run in runs]
    between = range(len(nodes), len(nodes) + len(fitted) - 1)
    for node, (before, *_), (after, *_) in zip(between, fitted, fitted[1:]):
        nodes[node] = (before[-1] + after[0]) / 2
    ends = (chain.start, *between, chain.end)
    return [_Piece(*parts, *pair) for parts, pair in zip(fitted, zip(ends, ends[1:]))]


def _without_fans(chain: Chain, fan: float) -> Chain:
    """Cut off the ends of a chain that run into a corner of the wall's end."""
    lengths = np.linalg.norm(chain.chords, axis=1)
    first, last = 0, len(lengths) - 1
    while chain.start is None and first + 3 < last and lengths[first + 1] > fan * lengths[first]:
        first += 1
    while chain.end is None and first + 3 < last and lengths[last - 1] > fan * lengths[last]:
        last -= 1
    return replace(chain, middles=chain.middles[first : last + 1], chords=chain.chords[first : last + 1])


def _runs(points: np.ndarray, tolerance: float, width: float, settings: CentrelineSettings) -> list[_Run]:
    """Return the runs of points that lie on one curve, each as long as possible."""
    runs: list[_Run] = []
    start = 0
    while start < len(points) - 1:
        run = _Run(start, _reach(points, start, line_through, tolerance), line_through)
        curved = _Run(start, _reach(points, start, arc_through, tolerance), arc_through)
        arc, length = arc_through(points[curved.start : curved.stop]), _length(points, curved)
        if arc is not None and length > max(settings.curved * _length(points, run), 2 * width):
            run = curved if width < arc.radius < length / settings.bent_rad else run
        runs.append(run)
        start = run.stop
    return runs


def _reach(
    points: np.ndarray, start: int, fit: Callable[[np.ndarray], Optional[Curve]], tolerance: float
) -> int:
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


def _length(points: np.ndarray, run: _Run) -> float:
    """Return the length of a run; a zigzag is as long as the line along it."""
    points = points[run.start : run.stop]
    if run.fit is line_through:
        return float(np.linalg.norm(points[-1] - points[0]))
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


def _adjusted(points: np.ndarray, runs: list[_Run]) -> list[_Run]:
    """Move the borders between adjacent runs to where they fit best: the longest run reaches too far."""
    runs = list(runs)
    for i in range(len(runs) - 1):
        (a, b, fit), (c, d, other) = runs[i : i + 2]
        if b == c and min(b - a, d - c) > 3:
            curves = (
                fit(points[a:b]) or line_through(points[a:b]),
                other(points[c:d]) or line_through(points[c:d]),
            )
            off, beyond = (curve.distances(points[a:d]) for curve in curves)
            error = np.cumsum(off**2) + np.cumsum(beyond[::-1] ** 2)[::-1] - beyond**2
            border = a + 2 + int(np.argmin(error[2:-2]))
            runs[i], runs[i + 1] = _Run(a, border, fit), _Run(border, d, other)
    return runs


def _fitted(chain: Chain, run: _Run, tolerance: float) -> tuple[np.ndarray, np.ndarray, Curve]:
    """Return the middles and chords of a run, and the curve through them.

    Half a thickness at each end, where the wall meets others or ends, is left out of the fit.
    """
    start, stop, fit = run
    points = chain.middles[start:stop]
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    margin = min(chain.width / 2, along[-1] / 4)
    core = (along >= margin) & (along <= along[-1] - margin)
    if core.sum() < 3:
        core[:] = True
    points = points[core]
    curve: Curve = line_through(points)
    if curve.distances(points).max() > tolerance:
        curve = fit(points) or curve
    return points, chain.chords[start:stop][core], curve


def _meeting(where: np.ndarray, curves: Sequence[Curve], loose: float) -> np.ndarray:
    """Return the point nearest to the curves that meet about a point."""
    for _ in range(2):
        matrix, vector = loose * np.eye(2), loose * where
        for line in (curve.tangent(where) for curve in curves):
            normal = line.normal(where)
            matrix = matrix + np.outer(normal, normal)
            vector = vector + normal * (normal @ line.point)
        where = np.linalg.solve(matrix, vector)
    return where


def _near(met: np.ndarray, where: np.ndarray, farthest: float, outline: Polygon) -> np.ndarray:
    """Return where curves meet, but no farther from their junction, and inside of the wall.

    Curves that are nearly parallel meet anywhere.
    """
    way = met - where
    met = where + way * min(1.0, farthest / max(np.hypot(*way), 1e-9))
    return met if outline.contains(Point(met)) else where


def _inside(line: LineString, piece: _Piece, body: Polygon) -> LineString:
    """Return a line, or one through the middles of the chords, so that it does not leave its wall."""
    if body.contains(line):
        return line
    ends = np.asarray(line.coords)[[0, -1]]
    through = LineString(np.concatenate([ends[:1], piece.points, ends[1:]]))
    if body.contains(through):
        return through.simplify(WITHIN_M)
    parts = body.intersection(min(line, through, key=lambda one: one.difference(body).length))
    return max(
        (part for part in getattr(parts, "geoms", [parts]) if part.geom_type == "LineString"),
        key=lambda part: part.length,
        default=line,
    )


def _drawn(
    piece: _Piece,
    junctions: dict[int, np.ndarray],
    outline: Polygon,
    settings: CentrelineSettings,
) -> LineString:
    """Draw a piece from node to node, or to the end of the wall."""
    first, last = (None if node is None else junctions.get(node) for node in (piece.start, piece.end))
    first = _wall_end(piece.curve, piece.points, outline) if first is None else first
    last = _wall_end(piece.curve, piece.points[::-1], outline) if last is None else last
    row = np.concatenate([[first], piece.points, [last]])
    corners = piece.curve.between(row, settings.curves.chord_m)
    if np.linalg.norm(corners[0] - first) <= settings.jog_m:
        corners = corners[1:]
    if np.linalg.norm(corners[-1] - last) <= settings.jog_m:
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


def _thickness(piece: _Piece, settings: CentrelineSettings) -> tuple[Optional[float], Optional[float]]:
    normals = np.array([piece.curve.normal(point) for point in piece.points])
    across = np.abs((piece.chords * normals).sum(axis=1))
    thickness = float(np.median(across))
    return (None, None) if thickness < settings.one_face_m else (thickness, float(np.std(across)))


def _azimuth(curve: Curve) -> Optional[float]:
    return line_azimuth(curve.direction) if isinstance(curve, Line) else None
