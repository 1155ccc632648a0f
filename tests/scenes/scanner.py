"""A panoramic laser scanner: the first object that each ray meets."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numba import njit

from .things import (
    GROUND_REFLECTANCE,
    PLAN_HEIGHT,
    PLANT_REFLECTANCE,
    REFLECTANCE,
    Ground,
    Plant,
    Prism,
)

PIECE_LENGTH = 0.1
GHOST_RANGE = 500.0
SHORTEST_WAVE, LONGEST_WAVE = 0.25, 1.0
"""Of the relief of masonry, metres."""
WAVES = 24
NOTHING, GROUND, SIDE, LEVEL, FOLIAGE = range(5)


class Bodies(NamedTuple):
    """Prisms as flat arrays; the edges of a prism are contiguous, and so are the pieces of an edge.

    `waves`, (k, 4), are wave vectors and phases, whose sum is the relief of all masonry.
    """

    edges: np.ndarray
    edge_prism: np.ndarray
    first_edge: np.ndarray
    first_piece: np.ndarray
    bottom: np.ndarray
    top: np.ndarray
    follows_ground: np.ndarray
    reflectance: np.ndarray
    relief: np.ndarray
    lean: np.ndarray
    passing: np.ndarray
    waves: np.ndarray


class Surroundings(NamedTuple):
    """The ground (slope in x and y, roughness) and the plants, (k, 7): centre, radii, density."""

    ground: np.ndarray
    plants: np.ndarray


class Optics(NamedTuple):
    """Range and noise of the scanner; `ghosts` is the share of far reflections."""

    max_range: float
    noise: float
    ghosts: float


def flatten(prisms: Sequence[Prism]) -> Bodies:
    """Return `prisms` as arrays, their edges cut into pieces of at most `PIECE_LENGTH`."""
    edges = []
    for prism in prisms:
        rings = [prism.footprint.exterior, *prism.footprint.interiors]
        corners = [np.asarray(ring.coords)[:, :2] for ring in rings]
        edges.append(np.vstack([np.hstack([ring[:-1], ring[1:]]) for ring in corners]))
    counts = [len(block) for block in edges]
    edges = np.vstack(edges)
    lengths = np.hypot(edges[:, 2] - edges[:, 0], edges[:, 3] - edges[:, 1])
    pieces = np.maximum(np.ceil(lengths / PIECE_LENGTH), 1).astype(np.int64)
    return Bodies(
        edges,
        np.repeat(np.arange(len(prisms)), counts),
        np.concatenate([[0], np.cumsum(counts)]),
        np.concatenate([[0], np.cumsum(pieces)]),
        np.array([prism.bottom for prism in prisms], dtype=np.float64),
        np.array([prism.top for prism in prisms], dtype=np.float64),
        np.array([prism.follows_ground for prism in prisms]),
        np.array([REFLECTANCE[prism.material] for prism in prisms]),
        np.array([prism.relief for prism in prisms], dtype=np.float64),
        np.array([prism.lean for prism in prisms], dtype=np.float64),
        np.array([prism.passing for prism in prisms], dtype=np.float64),
        _waves(),
    )


def _waves() -> np.ndarray:
    """Return waves of random directions, lengths and phases, the same for every scene."""
    random = np.random.default_rng(0)
    directions = random.normal(size=(WAVES, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    lengths = random.uniform(SHORTEST_WAVE, LONGEST_WAVE, (WAVES, 1))
    return np.hstack([2 * np.pi * directions / lengths, random.uniform(0, 2 * np.pi, (WAVES, 1))])


def surround(ground: Ground, plants: Sequence[Plant]) -> Surroundings:
    """Return ground and plants as arrays."""
    rows = [(*plant.centre, *plant.radii, plant.density) for plant in plants]
    return Surroundings(
        np.array([ground.slope_x, ground.slope_y, ground.roughness]),
        np.array(rows, dtype=np.float64).reshape(-1, 7),
    )


@njit(cache=True, nogil=True)
def _crossings(origin, east, north, bodies, prism, crossings):
    """Fill `crossings` with (distance, edge, share of the edge) of one footprint, return how many.

    They are sorted by horizontal distance. For a scanner within the footprint, the first has
    distance 0 and edge -1.
    """
    count = 0
    for edge in range(bodies.first_edge[prism], bodies.first_edge[prism + 1]):
        x0, y0 = bodies.edges[edge, 0] - origin[0], bodies.edges[edge, 1] - origin[1]
        x1, y1 = bodies.edges[edge, 2] - origin[0], bodies.edges[edge, 3] - origin[1]
        left0, left1 = east * y0 - north * x0, east * y1 - north * x1
        if (left0 >= 0) == (left1 >= 0):
            continue
        share = left0 / (left0 - left1)
        distance = east * (x0 + share * (x1 - x0)) + north * (y0 + share * (y1 - y0))
        if distance > 0:
            row = crossings[count]
            row[0], row[1], row[2] = distance, edge, share
            count += 1
    if count % 2:
        row = crossings[count]
        row[0], row[1], row[2] = 0.0, -1.0, 0.0
        count += 1
    crossings[:count] = crossings[np.argsort(crossings[:count, 0])]
    return count


@njit(cache=True, nogil=True)
def _spans(origin, east, north, bodies, crossings, spans, entries):
    """Cut the prisms with the vertical plane of a column of rays, return the number of spans.

    `spans` takes (near, far, cosine of incidence, normal of the face: east, north), `entries` (prism,
    piece of the edge where the span begins, or -1 when the scanner stands within the footprint).
    """
    count = 0
    for prism in range(bodies.top.size):
        found = _crossings(origin, east, north, bodies, prism, crossings)
        for crossing in range(0, found, 2):
            span, entry = spans[count], entries[count]
            span[0], span[1] = crossings[crossing, 0], crossings[crossing + 1, 0]
            span[2:] = 0.0
            entry[0], entry[1] = prism, -1
            edge = int(crossings[crossing, 1])
            if edge >= 0:
                first, after = bodies.first_piece[edge], bodies.first_piece[edge + 1]
                piece = first + int(crossings[crossing, 2] * (after - first))
                entry[1] = min(piece, after - 1)
                dx = bodies.edges[edge, 2] - bodies.edges[edge, 0]
                dy = bodies.edges[edge, 3] - bodies.edges[edge, 1]
                length = np.hypot(dx, dy)
                span[2] = abs(east * dy - north * dx) / length
                span[3], span[4] = dy / length, -dx / length
            count += 1
    return count


@njit(cache=True, nogil=True)
def _meet_solids(height, clearance, climbs, slope, bodies, spans, entries, column):
    """End every ray of a column at the first ground or prism.

    `height` and `clearance` are those of the scanner above zero and above the ground, `climbs`
    and `slope` the rise of the rays and of the ground per metre of horizontal distance.
    `column` takes horizontal distance, kind and span of each ray.
    """
    order = np.argsort(spans[:, 0])
    for ray in range(climbs.size):
        climb = climbs[ray]
        best, kind, which = np.inf, NOTHING, -1
        if climb < slope:
            best, kind = clearance / (slope - climb), GROUND
        for span in order:
            near = spans[span, 0]
            if near >= best:
                break
            prism = entries[span, 0]
            if bodies.passing[prism] > 0 and np.random.random() < bodies.passing[prism]:
                continue
            bottom, top = bodies.bottom[prism], bodies.top[prism]
            start, rise = height, climb
            if bodies.follows_ground[prism]:
                start, rise = clearance, climb - slope
            z = start + near * rise
            if bottom <= z <= top:
                best, kind, which = near, SIDE, span
            elif (z > top and rise < 0) or (z < bottom and rise > 0):
                distance = ((top if z > top else bottom) - start) / rise
                if distance <= spans[span, 1] and distance < best:
                    best, kind, which = distance, LEVEL, span
        column[ray, 0], column[ray, 1], column[ray, 2] = best, kind, which


@njit(cache=True, nogil=True)
def _plants_ahead(origin, east, north, plants):
    """Return the plants that the vertical plane of a column of rays may cross."""
    x, y = plants[:, 0] - origin[0], plants[:, 1] - origin[1]
    reach = np.maximum(plants[:, 3], plants[:, 4])
    return plants[(np.abs(east * y - north * x) < reach) & (east * x + north * y > -reach)]


@njit(cache=True, nogil=True)
def _meet_plants(origin, east, north, climbs, plants, column):
    """End every ray of a column at the first leaf before its present end.

    A direction of horizontal length 1 makes distances horizontal, like those in `column`.
    """
    for ray in range(climbs.size):
        direction = (east, north, climbs[ray])
        stretch = np.sqrt(1.0 + climbs[ray] ** 2)
        for plant in plants:
            a, b, c = 0.0, 0.0, -1.0
            for axis in range(3):
                offset = (origin[axis] - plant[axis]) / plant[3 + axis]
                step = direction[axis] / plant[3 + axis]
                a += step * step
                b += offset * step
                c += offset * offset
            root = b * b - a * c
            if root <= 0 or b >= np.sqrt(root):
                continue
            near, far = max((-b - np.sqrt(root)) / a, 0.0), (-b + np.sqrt(root)) / a
            leaf = near + np.random.exponential(1.0 / plant[6]) / stretch
            if leaf < min(far, column[ray, 0]):
                column[ray, 0], column[ray, 1] = leaf, FOLIAGE


@njit(cache=True, nogil=True)
def _deform(point, slope_x, slope_y, bodies, prism, span, is_side):
    """Move a point of a leaning or rough prism; the ray was cast on a plumb and smooth one."""
    relief, lean = bodies.relief[prism], bodies.lean[prism]
    bulge = 0.0
    if is_side and relief > 0:
        for wave in bodies.waves:
            bulge += np.sin(wave[0] * point[0] + wave[1] * point[1] + wave[2] * point[2] + wave[3])
        bulge *= relief * np.sqrt(2.0 / len(bodies.waves))
    above = point[2] - slope_x * point[0] - slope_y * point[1] - PLAN_HEIGHT
    point[0] += lean[0] * above + bulge * span[3]
    point[1] += lean[1] * above + bulge * span[4]


@njit(cache=True, nogil=True)
def panorama(origin, azimuths, elevations, bodies, surroundings, optics, seed):
    """Scan all around from one station.

    Parameters
    ----------
    origin : ndarray, shape (3,)
    azimuths, elevations : ndarray
        Directions of the rays (radians), elevations within -pi/2..pi/2, both exclusive.
    bodies : Bodies
    surroundings : Surroundings
    optics : Optics
    seed : int

    Returns
    -------
    points : ndarray, shape (n, 3)
    intensity : ndarray of uint16, shape (n,)
    hits : ndarray of int64, shape (pieces,)
        Numbers of rays that met each piece of an edge.
    """
    np.random.seed(seed)
    rays = azimuths.size * elevations.size
    points, intensity = np.empty((rays, 3)), np.empty(rays, dtype=np.uint16)
    hits = np.zeros(bodies.first_piece[-1], dtype=np.int64)
    # A scanner within a footprint adds a crossing to those of the edges.
    crossings = np.empty((len(bodies.edges) + 1, 3))
    spans = np.empty((len(bodies.edges), 5))
    entries = np.empty((len(bodies.edges), 2), dtype=np.int64)
    levels, climbs = np.cos(elevations), np.tan(elevations)
    column = np.empty((elevations.size, 3))
    slope_x, slope_y, roughness = surroundings.ground
    clearance = origin[2] - slope_x * origin[0] - slope_y * origin[1]
    count = 0
    for azimuth in azimuths:
        east, north = np.cos(azimuth), np.sin(azimuth)
        slope = slope_x * east + slope_y * north
        crossed = _spans(origin, east, north, bodies, crossings, spans, entries)
        _meet_solids(origin[2], clearance, climbs, slope, bodies, spans[:crossed], entries, column)
        plants = _plants_ahead(origin, east, north, surroundings.plants)
        _meet_plants(origin, east, north, climbs, plants, column)
        for ray in range(climbs.size):
            level, climb = levels[ray], climbs[ray]
            reach, kind, span = column[ray, 0] / level, int(column[ray, 1]), int(column[ray, 2])
            if reach > optics.max_range:
                continue
            if kind == GROUND:
                brightness = GROUND_REFLECTANCE * (slope - climb) * level
            elif kind == FOLIAGE:
                brightness = PLANT_REFLECTANCE * np.random.random()
            else:
                cosine = spans[span, 2] * level if kind == SIDE else abs(climb) * level
                brightness = bodies.reflectance[entries[span, 0]] * cosine
                if bodies.reflectance[entries[span, 0]] == 0:
                    continue
                if optics.ghosts > 0 and np.random.random() < optics.ghosts:
                    reach += np.random.random() * (GHOST_RANGE - reach)
                elif kind == SIDE:
                    hits[entries[span, 1]] += 1
            reach += optics.noise * np.random.normal()
            points[count, 0] = origin[0] + reach * level * east
            points[count, 1] = origin[1] + reach * level * north
            points[count, 2] = origin[2] + reach * level * climb
            if kind == GROUND:
                points[count, 2] += roughness * np.random.normal()
            elif kind != FOLIAGE:
                _deform(points[count], slope_x, slope_y, bodies, entries[span, 0], spans[span], kind == SIDE)
            intensity[count] = int(65535 * min(brightness, 1.0))
            count += 1
    return points[:count].copy(), intensity[:count].copy(), hits
