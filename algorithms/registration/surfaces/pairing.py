"""The patches that two scans see both, at given poses."""

from dataclasses import dataclass, replace
from typing import Optional

import numpy as np

from ...geometry.packed_cells import packed
from ...geometry.robust import sigma_of_residuals
from ..adjustment.similarity import Pose
from ..settings import Model
from .patches import Surfaces
from .settings import PairSettings
from .tie import Tie

NEAREST = 4
"""Cells near a centre among which its partner is searched: those of a corner, and behind it."""


@dataclass(frozen=True)
class Placed:
    """The surfaces of a scan where a pose puts them.

    Attributes
    ----------
    surfaces : Surfaces
    pose : Pose
    """

    surfaces: Surfaces
    pose: Pose

    def into(self, other: "Placed") -> tuple[np.ndarray, np.ndarray]:
        """Return centres and normals in the frame of another scan, shape (n, 3) each."""
        places = self.pose.apply(self.surfaces.centres) - other.pose.position
        turned = self.surfaces.normals @ self.pose.rotation.T
        return (
            places @ other.pose.rotation / other.pose.scale + other.pose.centre,
            turned @ other.pose.rotation,
        )


def paired(
    one: Placed,
    other: Placed,
    scans: tuple[int, int],
    gate: float,
    settings: PairSettings,
    model: Model = Model.RIGID,
) -> Optional[Tie]:
    """Return what ties two scans, or None if they share too little.

    Cells are partners if each is the nearest of the other that faces the same way and lies within `gate` of
    its plane. Within patches of a metre they are averaged.

    Parameters
    ----------
    one, other : Placed
        With normals towards their scanners.
    scans : tuple of int
    gate : float
        Metres.
    settings : PairSettings
    model : Model
        Of the transformation of both.
    """
    forth = nearest_partners(one, other, gate, settings)
    rows = np.flatnonzero(forth >= 0)
    if len(rows) < settings.fewest_patches:
        return None
    back = nearest_partners(other, one, gate, settings)
    rows = rows[back[forth[rows]] == rows]
    partners = forth[rows]
    if len(rows) < settings.fewest_patches:
        return None
    tie = _averaged(one, other, rows, partners, scans, settings)
    kept = _trimmed(tie, one.pose, other.pose, settings, model)
    return kept if len(kept) >= settings.fewest_patches else None


def nearest_partners(one: Placed, other: Placed, gate: float, settings: PairSettings) -> np.ndarray:
    """Return the row of the partner of each cell of one scan in the other, -1 without any."""
    partners = np.full(len(one.surfaces), -1)
    centres, normals = one.into(other)
    theirs = other.surfaces
    reach = float(np.hypot(max(one.surfaces.edges.max(), theirs.edges.max()), gate))
    low, high = theirs.box
    inside = np.flatnonzero(((centres > low - reach) & (centres < high + reach)).all(axis=1))
    if not len(inside):
        return partners
    centres, normals = centres[inside], normals[inside]
    distances, rows = theirs.tree.query(centres, range(1, NEAREST + 1), distance_upper_bound=reach)
    known = np.isfinite(distances)
    rows = np.where(known, rows, 0)
    # Partners overlap, or touch: the middles of cells that are filled in part lie anywhere in them.
    known &= distances < np.hypot((one.surfaces.edges[inside, None] + theirs.edges[rows]) / 2, gate)
    facing = np.einsum("ij,ikj->ik", normals, theirs.normals[rows])
    both = normals[:, None, :] + theirs.normals[rows]
    # Only of cells that face away from each other, which are no partners, is the sum shorter than 1.
    both /= np.maximum(np.linalg.norm(both, axis=2, keepdims=True), 1.0)
    off = np.abs(np.einsum("ikj,ikj->ik", both, centres[:, None, :] - theirs.centres[rows]))
    known &= (facing > np.cos(np.radians(settings.facing_deg))) & (off < gate)
    distances = np.where(known, distances, np.inf)
    best = distances.argmin(axis=1)
    every = np.arange(len(inside))
    found = np.isfinite(distances[every, best])
    partners[inside[found]] = rows[every, best][found]
    return partners


def _averaged(
    one: Placed,
    other: Placed,
    rows: np.ndarray,
    partners: np.ndarray,
    scans: tuple[int, int],
    settings: PairSettings,
) -> Tie:
    """Return the patches of pairs of cells, before they are trimmed."""
    first, second = one.surfaces, other.surfaces
    turned = first.normals[rows] @ one.pose.rotation.T
    theirs = second.normals[partners] @ other.pose.rotation.T
    # All normals of a patch point the same way in both scans.
    axis = np.abs(turned).argmax(axis=1)
    every = np.arange(len(rows))
    flip_one, flip_other = np.sign(turned[every, axis]), np.sign(theirs[every, axis])
    tiles = np.floor(first.centres[rows] / settings.patch_m).astype(np.int64)
    _, group = np.unique(3 * packed(tiles) + axis, return_inverse=True)
    count = np.bincount(group)

    def mean(values: np.ndarray) -> np.ndarray:
        sums = [np.bincount(group, column) for column in values.T]
        return np.asarray(np.column_stack(sums) / count[:, None])

    own = (first.variances[rows] + second.variances[partners])[:, None]
    return Tie(
        scans=scans,
        centres=(mean(first.centres[rows]), mean(second.centres[partners])),
        normals=(
            _unit(mean(first.normals[rows] * flip_one[:, None])),
            _unit(mean(second.normals[partners] * flip_other[:, None])),
        ),
        variances=mean(own)[:, 0] / count,
        common_std=settings.common_std_m,
        overlap=len(rows) / min(len(first), len(second)),
    )


def _unit(vectors: np.ndarray) -> np.ndarray:
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


def _trimmed(tie: Tie, one: Pose, other: Pose, settings: PairSettings, model: Model) -> Tie:
    """Return the tie without patches that are far off, with the scatter of the others in the variances.

    Both are measured after the motion of one scan that brings the patches together best: otherwise an error
    of the poses would look like scatter, and surfaces would yield to it.
    """
    distances, motions = tie.distances(one, other), tie.motions(one, other, model)
    kept = np.ones(len(tie), bool)
    for _ in range(settings.trimming_rounds):
        motion = np.linalg.lstsq(motions[kept], distances[kept], rcond=None)[0]
        left = distances - motions @ motion
        scatter = max(sigma_of_residuals(left[kept]), settings.least_std_m)
        before, kept = kept, np.abs(left) < settings.trim * np.sqrt(scatter**2 + tie.variances)
        if np.array_equal(before, kept) or kept.sum() < settings.fewest_patches:
            break
    return replace(
        tie,
        centres=(tie.centres[0][kept], tie.centres[1][kept]),
        normals=(tie.normals[0][kept], tie.normals[1][kept]),
        variances=tie.variances[kept] + scatter**2,
    )
