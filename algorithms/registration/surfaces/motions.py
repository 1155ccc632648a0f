"""The motions between two scans at which much of their surface agrees, without any start value.

At each rotation that the directions of surfaces allow, all shifts are tried at once: the surfaces of both
scans, and the space that either saw to be free, are correlated on a grid. So the best motion is found, and so
are its rivals.
"""

from dataclasses import dataclass, field
from typing import Optional

import numpy as np
from scipy.fft import irfftn, next_fast_len, rfftn
from scipy.ndimage import convolve1d, maximum_filter

from ...progress import Progress
from ..adjustment.similarity import Pose, rotation_about
from ..settings import Model
from .pairing import Placed, nearest_partners
from .patches import Surfaces
from .rotations import Directions, directions_of, rotations_between
from .settings import PairSettings, PlacementSettings, SearchSettings
from .view import View, view_of

BLUR = (0.5, 1.0, 0.5)
"""Of a grid along each axis, so that surfaces that differ by up to a voxel agree in part."""

FREE_VOXELS = 2.0
"""Before what was seen: a rotation that is a few degrees off moves surface by as much."""


@dataclass(frozen=True)
class Grids:
    """A scan on a grid.

    Attributes
    ----------
    vectors : ndarray, shape (3, nx, ny, nz)
        Normals times weights, summed.
    weights : ndarray, shape (nx, ny, nz)
        Of the surface.
    free : ndarray, shape (nx, ny, nz)
        1 where the scanner saw that nothing is, else 0.
    """

    vectors: np.ndarray
    weights: np.ndarray
    free: np.ndarray


@dataclass(frozen=True)
class Anchors:
    """Targets of a scan, and points that they may be; too few for a pose, but one of them fixes its shift.

    Attributes
    ----------
    targets : ndarray, shape (k, 3)
        In the scan that is moved.
    points : ndarray, shape (p, 3)
        In the scan into which it is moved.
    """

    targets: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))
    points: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))


@dataclass(frozen=True)
class Motion:
    """A motion of one scan into another.

    Attributes
    ----------
    pose : Pose
    target, point : ndarray, shape (3,), or None
        What the motion brings together, if it was found so.
    """

    pose: Pose
    target: Optional[np.ndarray] = None
    point: Optional[np.ndarray] = None


@dataclass(frozen=True)
class Searched:
    """A scan that is ready to be compared with others.

    Attributes
    ----------
    surfaces : Surfaces
        With the position of the scanner.
    view : View
    directions : Directions
    patches : ndarray of int, shape (k,)
        Rows of one cell of each patch of a metre.
    weights : ndarray, shape (n,)
        Square metres of each cell, as if surface faced each direction alike.
    """

    surfaces: Surfaces
    view: View
    directions: Directions
    patches: np.ndarray
    weights: np.ndarray


def searched(
    surfaces: Surfaces,
    settings: PlacementSettings = PlacementSettings(),
    pairs: PairSettings = PairSettings(),
) -> Searched:
    """Prepare a scan.

    Parameters
    ----------
    surfaces : Surfaces
        Of at least one cell, with the position of the scanner.
    settings : PlacementSettings
    pairs : PairSettings
    """
    axis = np.abs(surfaces.normals).argmax(axis=1)
    tiles = np.floor(surfaces.centres / pairs.patch_m).astype(np.int64)
    sided = np.column_stack([tiles, 2 * axis + (surfaces.normals[np.arange(len(axis)), axis] > 0)])
    _, patches = np.unique(sided, axis=0, return_index=True)
    return Searched(
        surfaces,
        view_of(surfaces, settings.view),
        directions_of(surfaces, settings.search),
        np.sort(patches),
        balanced(surfaces.normals, surfaces.edges**2),
    )


def balanced(normals: np.ndarray, areas: np.ndarray) -> np.ndarray:
    """Return weights of areas, so that floors do not outvote the few walls that show the place along them."""
    scatter = (areas[:, None] * normals).T @ normals / areas.sum()
    # A direction that hardly any surface faces is not made more of than this.
    inverse = np.linalg.inv(scatter + 0.05 * np.eye(3))
    return np.asarray(areas * np.einsum("ij,jk,ik->i", normals, inverse, normals) / 3)


def likely_motions(
    one: Searched,
    other: Searched,
    model: Model,
    anchors: Anchors = Anchors(),
    settings: SearchSettings = SearchSettings(),
    progress: Progress = Progress(),
) -> list[Motion]:
    """Return the motions of the other scan into the first at which surfaces agree, the best first.

    Parameters
    ----------
    one, other : Searched
    model : Model
        Levelled scans rotate about the vertical only.
    anchors : Anchors
        Motions that bring one of the targets onto a point are tried too: along a corridor, surfaces alone
        show none of them.
    settings : SearchSettings
    progress : Progress

    Raises
    ------
    CancelledError
        If the caller asked to stop.
    """
    rotations = rotations_between(one.directions, other.directions, model.levelled, settings)
    found: list[tuple[float, Motion]] = []
    for number, rotation in enumerate(rotations):
        progress.update(number / len(rotations))
        agreement = _agreement(one, other, rotation, settings)
        found += agreement.peaks(settings.most_peaks)
        found += agreement.at_anchors(anchors, settings.most_peaks)
    found.sort(key=lambda item: -item[0])
    least = settings.least_peak * found[0][0] if found else 0.0
    return [motion for score, motion in found[: settings.most_motions] if score > least]


@dataclass(frozen=True)
class Agreement:
    """How much surface agrees at all shifts of the other scan, at one rotation.

    Attributes
    ----------
    scores : ndarray, shape (nx, ny, nz)
        Square metres, less those that contradict; a shift and the one by the whole grid less are the same.
    rotation : ndarray, shape (3, 3)
    voxel : float
        Metres.
    low : ndarray of int, shape (3,)
        Of the first voxel, in voxels.
    size : ndarray of int, shape (3,)
        Of the first scan, in voxels: larger steps are negative ones.
    """

    scores: np.ndarray
    rotation: np.ndarray
    voxel: float
    low: np.ndarray
    size: np.ndarray

    def _moved(self, shift: np.ndarray) -> Pose:
        return Pose(self.rotation, np.array(1.0), np.zeros(3), shift)

    def peaks(self, most: int) -> list[tuple[float, Motion]]:
        """Return the motions that are better than all beside them, with their scores."""
        top = (self.scores == maximum_filter(self.scores, 3, mode="wrap")) & (self.scores > 0)
        places, values = np.argwhere(top), self.scores[top]
        best = np.argsort(-values, kind="stable")[:most]
        steps = places[best] - np.where(places[best] >= self.size, self.scores.shape, 0)
        return [
            (float(value), Motion(self._moved(shift)))
            for value, shift in zip(values[best], (steps + self.low) * self.voxel)
        ]

    def at_anchors(self, anchors: Anchors, most: int) -> list[tuple[float, Motion]]:
        """Return the best motions that bring a target onto a point, with their scores."""
        turned = anchors.targets @ self.rotation.T
        shifts = (anchors.points[None, :, :] - turned[:, None, :]).reshape(-1, 3)
        steps = np.rint(shifts / self.voxel).astype(int) - self.low
        shape = np.array(self.scores.shape)
        inside = ((steps < self.size) & (steps >= self.size - shape)).all(axis=1)
        values = np.where(inside, self.scores[tuple((steps % shape).T)], 0.0)
        best = [row for row in np.argsort(-values, kind="stable")[:most] if values[row] > 0]
        count = max(len(anchors.points), 1)
        return [
            (
                float(values[row]),
                Motion(self._moved(shifts[row]), anchors.targets[row // count], anchors.points[row % count]),
            )
            for row in best
        ]


def _agreement(one: Searched, other: Searched, rotation: np.ndarray, settings: SearchSettings) -> Agreement:
    turned = other.surfaces.centres @ rotation.T
    corners = [(points.min(axis=0), points.max(axis=0)) for points in (one.surfaces.centres, turned)]
    extent = sum(high - low for low, high in corners) + settings.voxel_m
    voxel = max(settings.voxel_m, float(np.cbrt(np.prod(extent) / settings.most_voxels)))
    lows = [np.floor(low / voxel).astype(int) - 1 for low, _ in corners]
    sizes = [np.ceil(high / voxel).astype(int) + 2 - low for (_, high), low in zip(corners, lows)]
    shape = tuple(next_fast_len(int(size), real=True) for size in sizes[0] + sizes[1])
    mine = _grids(one, np.eye(3), lows[0], sizes[0], voxel)
    theirs = _grids(other, rotation, lows[1], sizes[1], voxel)
    spectrum = -_correlated(mine.free, theirs.weights, shape) - _correlated(mine.weights, theirs.free, shape)
    for normals, vectors in zip(_normals(mine.vectors), theirs.vectors):
        spectrum += _correlated(normals, vectors, shape)
    return Agreement(irfftn(spectrum, shape), rotation, voxel, lows[0] - lows[1], sizes[0])


def _correlated(one: np.ndarray, other: np.ndarray, shape: tuple[int, ...]) -> np.ndarray:
    """Return the spectrum of the sums of products at all shifts of the other grid."""
    return np.asarray(rfftn(one, shape) * np.conj(rfftn(other, shape)))


def _grids(scan: Searched, rotation: np.ndarray, low: np.ndarray, size: np.ndarray, voxel: float) -> Grids:
    """Return the surfaces of a scan and the space that it saw to be free, turned, on a grid from `low` on."""
    surfaces, count = scan.surfaces, int(np.prod(size))
    cells = np.floor(surfaces.centres @ rotation.T / voxel).astype(int) - low
    flat = np.ravel_multi_index(tuple(cells.T), tuple(size))
    columns = (surfaces.normals @ rotation.T * scan.weights[:, None]).T
    vectors = np.array([np.bincount(flat, column, count).reshape(size) for column in columns], np.float32)
    weights = np.bincount(flat, scan.weights, count).reshape(size).astype(np.float32)
    gaps, _ = scan.view.gaps(((np.indices(size).reshape(3, -1).T + low + 0.5) * voxel) @ rotation)
    free = (gaps > FREE_VOXELS * voxel).reshape(size).astype(np.float32)
    return Grids(vectors, weights, free)


def _normals(vectors: np.ndarray) -> np.ndarray:
    """Return unit vectors where there is surface, shorter ones beside it."""
    lengths = np.linalg.norm(vectors, axis=0)
    unit = vectors / np.maximum(lengths, 1e-6)
    for axis in (1, 2, 3):
        unit = convolve1d(unit, BLUR, axis, mode="constant")
    return np.asarray(unit / np.maximum(np.linalg.norm(unit, axis=0), 1.0))


def settled(
    motion: Motion,
    one: Searched,
    other: Searched,
    model: Model,
    settings: SearchSettings = SearchSettings(),
    pairs: PairSettings = PairSettings(),
) -> Pose:
    """Return a motion of the other scan into the first after its patches came as close as they do.

    Parameters
    ----------
    motion : Motion
    one, other : Searched
    model : Model
    settings : SearchSettings
    pairs : PairSettings

    References
    ----------
    Chen and Medioni (1992): Object modelling by registration of multiple range images.
    """
    patches = other.surfaces.rows(other.patches)
    fixed = Placed(one.surfaces, Pose(np.eye(3), np.array(1.0), np.zeros(3), np.zeros(3)))
    pose = motion.pose
    for gate in np.repeat(settings.gates_m, settings.rounds):
        partners = nearest_partners(Placed(patches, pose), fixed, gate, pairs)
        rows = np.flatnonzero(partners >= 0)
        if len(rows) < pairs.fewest_patches:
            break
        planes = one.surfaces.rows(partners[rows])
        centres, wanted = patches.centres[rows], planes.centres
        normals = planes.normals * np.sqrt(balanced(planes.normals, np.ones(len(rows))))[:, None]
        if motion.target is not None and motion.point is not None:
            # Along each axis, as often as there are patches, so that these turn the scan about it.
            times = len(rows)
            centres = np.concatenate([centres, np.tile(motion.target, (3 * times, 1))])
            wanted = np.concatenate([wanted, np.tile(motion.point, (3 * times, 1))])
            normals = np.concatenate([normals, np.tile(np.eye(3), (times, 1))])
        pose = _step(pose, centres, wanted, normals, model)
    return pose


def _step(pose: Pose, centres: np.ndarray, wanted: np.ndarray, normals: np.ndarray, model: Model) -> Pose:
    """Return the pose after the step that brings points closest to planes."""
    places = pose.apply(centres)
    middle = places.mean(axis=0)
    arms = places - middle
    distances = np.einsum("ij,ij->i", normals, wanted - places)
    turns = np.cross(arms, normals)
    design = np.column_stack([normals, turns[:, 2:] if model.levelled else turns])
    # What nothing holds, as along a corridor, does not move.
    matrix = design.T @ design
    matrix += np.diag(1e-3 * np.diag(matrix) + 1e-9)
    step = np.linalg.solve(matrix, design.T @ distances)
    turn = rotation_about(np.r_[0.0, 0.0, step[3]] if model.levelled else step[3:])
    shift = turn @ (pose.position - middle) + middle + step[:3]
    return Pose(turn @ pose.rotation, pose.scale, pose.centre, shift)
