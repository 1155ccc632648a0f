"""Points at the border of a coloured detail, whose laser spots hit both sides."""

import numpy as np
from scipy.spatial import cKDTree

from ...geometry.triangulation import Links, Mesh
from ...kernels import kernel
from .appearance import Appearance
from .settings import ColourSettings


def divide_at_half(
    mesh: Mesh,
    links: Links,
    looks: Appearance,
    inside: np.ndarray,
    spacing: float,
    colour: float,
    settings: ColourSettings = ColourSettings(),
) -> np.ndarray:
    """Return which points belong to a detail, with each point at its border on the side that it resembles.

    Laser spots at the border hit both sides, and the region that grew first took all of them. A point now
    belongs to the side that fills more than half of its spot, so that neither side gains. Repeating this
    makes the result independent of where the region ended. Intensity decides where the sides differ in it,
    because shadows do not affect it; colour decides elsewhere.

    Parameters
    ----------
    mesh : Mesh
        Of n points.
    links : tuple of ndarray
        The neighbours of its points, as `Mesh.neighbours` returns them.
    looks : Appearance
        Of the n points.
    inside : ndarray of bool, shape (n,)
    spacing : float
        Of the points (m).
    colour : float
        Two sides that differ by less are left as they are.
    settings : ColourSettings
    """
    for _ in range(settings.mixed.rounds):
        divided = _divide_once(mesh, links, looks, inside, spacing, colour, settings)
        if np.array_equal(divided, inside):
            break
        inside = divided
    return inside


def _divide_once(
    mesh: Mesh,
    links: Links,
    looks: Appearance,
    inside: np.ndarray,
    spacing: float,
    colour: float,
    settings: ColourSettings,
) -> np.ndarray:
    mixed, compared = settings.mixed, settings.mixed.compared
    contacts = mesh.points[_contacts(*links, np.flatnonzero(inside), inside)]
    if not len(contacts):
        return inside
    band = max(mixed.band_spacings * spacing, mixed.beam_m)
    reach = band + (mixed.core_spacings - mixed.band_spacings) * spacing
    low, high = contacts.min(axis=0) - reach, contacts.max(axis=0) + reach
    around = np.flatnonzero(((mesh.points > low) & (mesh.points < high)).all(axis=1))
    distances, _ = cKDTree(contacts).query(mesh.points[around], distance_upper_bound=reach)
    near, core = around[distances <= band], around[(distances > band) & np.isfinite(distances)]
    own, other = core[inside[core]], core[~inside[core]]
    if min(len(own), len(other)) < compared:
        return inside
    sides = _nearest(mesh, own, near, compared), _nearest(mesh, other, near, compared)
    divided = inside.copy()
    divided[near] = _share(looks.rgb, near, *sides, colour, inside[near])
    if looks.relative is not None:
        least = settings.intensity.clear * looks.threshold
        divided[near] = _share(looks.relative[:, None], near, *sides, least, divided[near])
    return _largest_piece(*links, np.flatnonzero(divided), divided, inside)


def _nearest(mesh: Mesh, known: np.ndarray, asked: np.ndarray, count: int) -> np.ndarray:
    """Return the known points nearest to those asked for, shape (asked, count)."""
    return known[cKDTree(mesh.points[known]).query(mesh.points[asked], k=count)[1]]


def _share(
    values: np.ndarray,
    near: np.ndarray,
    own: np.ndarray,
    other: np.ndarray,
    least: float,
    otherwise: np.ndarray,
) -> np.ndarray:
    """Return which points resemble their own side more; `otherwise` where the sides are too similar."""
    own, other = values[own].mean(axis=1), values[other].mean(axis=1)
    contrast = own - other
    squared = np.sum(contrast**2, axis=1)
    shares = np.sum((values[near] - other) * contrast, axis=1) / np.maximum(squared, 1e-9)
    return np.where(squared > least**2, shares > 0.5, otherwise)


@kernel
def _contacts(starts: np.ndarray, neighbours: np.ndarray, rows: np.ndarray, inside: np.ndarray) -> np.ndarray:
    """Return the points of either side that have a neighbour on the other one; `rows` are those inside."""
    touching = np.zeros(len(inside), np.bool_)
    for row in rows:
        for link in range(starts[row], starts[row + 1]):
            if not inside[neighbours[link]]:
                touching[row] = touching[neighbours[link]] = True
    return np.flatnonzero(touching)


@kernel
def _largest_piece(
    starts: np.ndarray, neighbours: np.ndarray, rows: np.ndarray, divided: np.ndarray, inside: np.ndarray
) -> np.ndarray:
    """Return the piece of the divided detail, whose `rows` are given, with most points that were inside.

    Specks beyond its border do not belong to it.
    """
    pieces, waiting = np.zeros(len(divided), np.int32), np.empty(len(rows), np.int64)
    piece, best, most = 0, 0, 0
    for row in rows:
        if pieces[row]:
            continue
        piece += 1
        pieces[row], waiting[0] = piece, row
        done, found, held = 0, 1, 0
        while done < found:
            point = waiting[done]
            done += 1
            held += inside[point]
            for link in range(starts[point], starts[point + 1]):
                other = neighbours[link]
                if divided[other] and not pieces[other]:
                    pieces[other], waiting[found] = piece, other
                    found += 1
        if held > most:
            best, most = piece, held
    return divided & (pieces == best)
