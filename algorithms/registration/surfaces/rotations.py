"""The rotations between two scans that the directions of their surfaces allow."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from .patches import Surfaces
from .settings import SearchSettings

SKEWEST_DEG = 30.0
"""Two directions that are closer to each other, or to opposite ones, do not fix a rotation well."""


@dataclass(frozen=True)
class Directions:
    """What the surfaces of a scan face.

    Attributes
    ----------
    normals : ndarray, shape (k, 3)
        Unit vectors.
    shares : ndarray, shape (k,)
        Of all surface.
    """

    normals: np.ndarray
    shares: np.ndarray


def directions_of(surfaces: Surfaces, settings: SearchSettings = SearchSettings()) -> Directions:
    """Return the directions that most surface faces, the largest first.

    Parameters
    ----------
    surfaces : Surfaces
        Of at least one cell, with normals towards the scanner.
    settings : SearchSettings
    """
    near = np.cos(np.radians(settings.direction_deg))
    areas = surfaces.edges**2
    # Cells of one plane have one normal, so that there are few different ones.
    normals, group = np.unique(surfaces.normals.round(3), axis=0, return_inverse=True)
    areas = np.bincount(group.ravel(), areas)
    total, left = areas.sum(), areas.copy()
    means: list[np.ndarray] = []
    shares: list[float] = []
    while len(means) < settings.most_directions and left.max(initial=0.0) > 0:
        top = normals[left.argmax()]
        for _ in range(2):
            close = (normals @ top > near) & (left > 0)
            top = (left[close, None] * normals[close]).sum(axis=0)
            top /= np.linalg.norm(top)
        close = normals @ top > near
        share = left[close].sum() / total
        if share < settings.least_share:
            break
        means.append(top)
        shares.append(share)
        left[close] = 0.0
    return Directions(np.array(means).reshape(-1, 3), np.array(shares))


def rotations_between(
    one: Directions, other: Directions, levelled: bool, settings: SearchSettings = SearchSettings()
) -> list[np.ndarray]:
    """Return the rotations from the other scan to the first at which some of their directions agree.

    Parameters
    ----------
    one, other : Directions
    levelled : bool
        Whether both scans are upright, so that one direction of either fixes the heading.
    settings : SearchSettings

    Returns
    -------
    list of ndarray, shape (3, 3)
        Those at which most surface faces the same way first.
    """
    pairs = _headings(one, other) if levelled else _pairs(one, other, settings)
    same = 2 * np.sin(np.radians(settings.same_rotation_deg) / 2) * np.sqrt(2)
    scored = []
    for rotation in pairs:
        better, score = _settled(rotation, one, other, levelled, settings)
        scored.append((score, better))
    found: list[np.ndarray] = []
    for _, rotation in sorted(scored, key=lambda item: -item[0]):
        if all(np.linalg.norm(rotation - known) > same for known in found):
            found.append(rotation)
    return found


def _headings(one: Directions, other: Directions) -> list[np.ndarray]:
    turns = []
    for normal in one.normals:
        for their in other.normals:
            if np.hypot(*normal[:2]) > 0.5 and np.hypot(*their[:2]) > 0.5:
                turn = np.arctan2(normal[1], normal[0]) - np.arctan2(their[1], their[0])
                turns.append(Rotation.from_euler("Z", turn).as_matrix())
    return turns


def _pairs(one: Directions, other: Directions, settings: SearchSettings) -> list[np.ndarray]:
    skew = np.cos(np.radians(SKEWEST_DEG))
    near = np.radians(settings.same_rotation_deg)
    turns = []
    firsts, seconds = (
        [
            (first, second, np.arccos(np.clip(first @ second, -1, 1)))
            for first in each.normals
            for second in each.normals
            if abs(first @ second) < skew
        ]
        for each in (one, other)
    )
    for a, b, angle in firsts:
        for c, d, theirs in seconds:
            if abs(angle - theirs) < near:
                turns.append(_frame(a, b) @ _frame(c, d).T)
    return turns


def _frame(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    across = np.cross(first, second)
    across /= np.linalg.norm(across)
    return np.column_stack([first, across, np.cross(first, across)])


def _settled(
    rotation: np.ndarray, one: Directions, other: Directions, levelled: bool, settings: SearchSettings
) -> tuple[np.ndarray, float]:
    """Return a rotation at which the directions that agree do so best, and how much surface faces them."""
    near = np.cos(np.radians(settings.direction_deg))
    cosines = one.normals @ rotation @ other.normals.T
    mine, theirs = np.nonzero((cosines > near) & (cosines == cosines.max(axis=0)))
    weights = np.minimum(one.shares[mine], other.shares[theirs])
    products = (other.normals[theirs] * weights[:, None]).T @ one.normals[mine]
    if levelled:
        turn = np.arctan2(products[0, 1] - products[1, 0], products[0, 0] + products[1, 1])
        return Rotation.from_euler("Z", turn).as_matrix(), float(weights.sum())
    left, _, right = np.linalg.svd(products)
    sign = np.diag([1.0, 1.0, np.linalg.det(left @ right)])
    return (left @ sign @ right).T, float(weights.sum())
