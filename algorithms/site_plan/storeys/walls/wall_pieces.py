"""Bodies of walls cut into pieces between junctions and openings, as a surveyor schedules them."""

from collections.abc import Iterator

import numpy as np
from shapely.geometry import LineString, Point, Polygon
from shapely.ops import polygonize, unary_union
from shapely.prepared import prep

from ..settings import WallSettings

OVER = 1e-3
"""A cut extends beyond the outline by so much, metres."""

START = 1e-4
"""A cut is looked for from so far before its corner, metres."""


def cut_at_junctions(body: Polygon, settings: WallSettings = WallSettings()) -> list[Polygon]:
    """Cut a body at the corners where walls meet; return its pieces, which share their edges exactly.

    A body juts out at such a corner: each is cut once, by the shortest cut along one of its two sides or
    to another such corner.
    """
    corners, ways = _inner_corners(body, settings.junction_sine)
    if not len(corners):
        return [body]
    chosen: list[LineString] = []
    done = np.zeros(len(corners), bool)
    for _, cut, ends in sorted(_cuts(body, corners, ways, settings), key=lambda entry: entry[0]):
        if done[list(ends)].any() or any(_cross(cut, other) for other in chosen):
            continue
        chosen.append(cut)
        done[list(ends)] = True
    while True:
        pieces = _pieces(body, chosen)
        scraps = [piece for piece in pieces if piece.length < 2 * settings.shortest_piece_m]
        needless = [cut for cut in chosen if any(_bounds(cut, scrap) for scrap in scraps)]
        if not needless:
            return pieces
        chosen = [cut for cut in chosen if cut not in needless]


def _pieces(body: Polygon, cuts: list[LineString]) -> list[Polygon]:
    pieces = polygonize(unary_union([body.exterior, *body.interiors, *cuts]))
    inside = prep(body.buffer(OVER))
    return [piece for piece in pieces if inside.contains(piece.representative_point()) and piece.area > 1e-6]


def _bounds(cut: LineString, piece: Polygon) -> bool:
    """Return whether a cut lies on the outline of a piece."""
    return cut.intersection(piece.buffer(START)).length > 0.5 * (cut.length - OVER)


def _inner_corners(body: Polygon, least: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the corners with over 180 degrees inside the body, and where to their sides continue."""
    corners, ways = [], []
    for ring, sign in ((body.exterior, 1), *((ring, -1) for ring in body.interiors)):
        xy = np.asarray(ring.coords)[:-1]
        if ring.is_ccw != (sign > 0):
            xy = xy[::-1]
        before = _unit(xy - np.roll(xy, 1, axis=0))
        after = _unit(np.roll(xy, -1, axis=0) - xy)
        inner = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0] < -least
        corners.append(xy[inner])
        ways.append(np.stack([before[inner], -after[inner]], axis=1))
    return np.concatenate(corners), np.concatenate(ways)


def _unit(vectors: np.ndarray) -> np.ndarray:
    return vectors / np.maximum(np.hypot(*vectors.T), 1e-12)[:, None]


def _cuts(
    body: Polygon, corners: np.ndarray, ways: np.ndarray, settings: WallSettings
) -> Iterator[tuple[float, LineString, tuple[int, ...]]]:
    """Yield the possible cuts: rank, line, and the corners that it starts from."""
    longest = settings.longest_cut_m
    within = prep(body.buffer(1e-6))
    for i, corner in enumerate(corners):
        for way in ways[i]:
            ray = LineString([corner + START * way, corner + longest * way])
            hit = ray.intersection(body.boundary)
            if hit.is_empty:
                continue
            length = Point(corner).distance(hit)
            cut = LineString([corner, corner + (length + OVER) * way])
            if within.contains(LineString([corner + START * way, corner + (length - START) * way])):
                yield length, cut, (i,)
        for j in np.flatnonzero(np.hypot(*(corners[i + 1 :] - corner).T) <= longest) + i + 1:
            cut = LineString([corner, corners[j]])
            if cut.length > 10 * START and within.contains(cut):
                yield settings.two_corners * cut.length, cut, (i, j)


def _cross(one: LineString, other: LineString) -> bool:
    """Return whether two cuts cross, other than at their ends."""
    shared = one.intersection(other)
    if shared.is_empty:
        return False
    ends = [Point(end) for line in (one, other) for end in line.coords]
    return shared.length > OVER or min(shared.distance(end) for end in ends) > 2 * OVER
