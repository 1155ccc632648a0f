"""Whether a cloud stands upright: floors level, walls plumb, z up.

Small cubes of the cloud that are planes have normals. In a building most of them are level or plumb about one
direction, its vertical. A direction is judged by how many normals are within a degree or so of it (floors and
ceilings) and of the plane across it (walls), as in the detection of Manhattan frames, but with walls in any
direction.
"""

from dataclasses import dataclass

import numpy as np

from ..progress import Progress
from .cloud import Cloud, names_of
from .settings import UprightSettings

FARTHEST_CELL = 2**20
"""Cubes on either side of the middle; three numbers of them fit into one of 64 bits."""


@dataclass(frozen=True)
class Faces:
    """Cubes of a cloud that hold a piece of a plane.

    Attributes
    ----------
    centres : ndarray of float64, shape (n, 3)
        Metres.
    normals : ndarray of float64, shape (n, 3)
    """

    centres: np.ndarray
    normals: np.ndarray


def upright_warnings(
    cloud: Cloud, progress: Progress = Progress(), settings: UprightSettings = UprightSettings()
) -> tuple[str, ...]:
    """Return a sentence, with the angle and the remedy, if a cloud does not stand upright.

    Parameters
    ----------
    cloud : Cloud
    progress : Progress
    settings : UprightSettings

    Raises
    ------
    InputError
        If a file is damaged.
    """
    faces = faces_of(sample(cloud, progress, settings), settings)
    if len(faces.normals) < settings.fewest_faces:
        return ()
    names = names_of(cloud.sources)
    axis = axis_that_is_up(faces, settings)
    if axis:
        return (
            f"{names}: {axis} seems to be up, because floors and ceilings lie across it; turn the cloud so "
            f"that z is up, for instance by 90 degrees about {'x' if axis == 'y' else 'y'}, because walls "
            "are looked for along z.",
        )
    if hangs(faces, settings):
        return (
            f"{names}: the cloud seems to stand on its head, because its ground lies above its walls; change "
            "the sign of z and of one of x and y, which turns it over without mirroring it.",
        )
    angle, azimuth = tilt(faces, settings)
    if angle < settings.largest_tilt_deg:
        return ()
    return (
        f"{names}: floors and walls are tilted by {angle:.1f} degrees towards the azimuth {azimuth:.0f} "
        "degrees, which costs walls; level the cloud first, for instance by registering it with MODEL rigid.",
    )


def sample(
    cloud: Cloud, progress: Progress = Progress(), settings: UprightSettings = UprightSettings()
) -> np.ndarray:
    """Return points of the beginning of several files, shape (n, 3)."""
    numbers = np.unique(np.linspace(0, len(cloud.sources) - 1, settings.most_files).astype(int))
    found = [np.empty((0, 3))]
    for number in numbers:
        chunks = cloud.sources[number].chunks(cloud.origin, progress.part(0, 0), settings.chunk_points)
        xyz = next((chunk.xyz for chunk in chunks if len(chunk.xyz)), found[0])
        found.append(xyz[:: max(len(xyz) * len(numbers) // settings.most_points, 1)])
    return np.concatenate(found)


def faces_of(xyz: np.ndarray, settings: UprightSettings = UprightSettings()) -> Faces:
    """Return the planes in the cubes of points, shape (n, 3), at the size of cubes that shows most."""
    best = Faces(np.empty((0, 3)), np.empty((0, 3)))
    for edge in settings.edges_m:
        found = _planes(xyz, edge, settings)
        if len(found.normals) >= settings.enough_faces:
            return found
        best = max(best, found, key=lambda faces: len(faces.normals))
    return best


def _planes(xyz: np.ndarray, edge: float, settings: UprightSettings) -> Faces:
    cells = np.floor((xyz - np.median(xyz, axis=0)) / edge) if len(xyz) else xyz
    near = (np.abs(cells) < FARTHEST_CELL).all(axis=1)
    xyz, cells = xyz[near], cells[near].astype(np.int64) + FARTHEST_CELL
    keys = (cells[:, 0] * 2 * FARTHEST_CELL + cells[:, 1]) * 2 * FARTHEST_CELL + cells[:, 2]
    _, member, counts = np.unique(keys, return_inverse=True, return_counts=True)
    means = np.stack([np.bincount(member, column) for column in xyz.T], axis=1) / counts[:, None]
    apart = xyz - means[member]
    moments = np.empty((len(counts), 3, 3))
    for row in range(3):
        for column in range(row + 1):
            moments[:, row, column] = np.bincount(member, apart[:, row] * apart[:, column]) / counts
            moments[:, column, row] = moments[:, row, column]
    enough = counts >= settings.fewest_points
    values, vectors = np.linalg.eigh(moments[enough])
    values = np.sqrt(np.maximum(values, 0))
    flat = (values[:, 0] < settings.thickest * values[:, 1]) & (values[:, 1] > settings.widest * edge)
    return Faces(means[enough][flat], vectors[flat, :, 0])


def _votes(normals: np.ndarray, directions: np.ndarray, width_deg: float) -> tuple[np.ndarray, np.ndarray]:
    """Return how many normals are along each of the directions, and how many across it, by their nearness."""
    angles = np.degrees(np.arccos(np.clip(np.abs(directions @ normals.T), 0, 1)))
    along = np.exp(-((angles / width_deg) ** 2)).sum(axis=1)
    across = np.exp(-(((90 - angles) / width_deg) ** 2)).sum(axis=1)
    return along, across


def tilt(faces: Faces, settings: UprightSettings = UprightSettings()) -> tuple[float, float]:
    """Return by how many degrees the vertical of a building differs from z, and the azimuth it leans to.

    Returns
    -------
    angle, azimuth : float
        Degrees; 0 and 0 if z is as good a vertical as any other direction near it.
    """
    step = max(len(faces.normals) // settings.most_normals, 1)
    normals = faces.normals[::step]
    best = np.zeros(2)
    for reach, spacing in settings.search_deg:
        offsets = np.arange(-reach, reach + spacing / 2, spacing)
        tilts = best + np.stack(np.meshgrid(offsets, offsets), axis=-1).reshape(-1, 2)
        along, across = _votes(normals, _directions(tilts), settings.width_deg)
        best = tilts[np.argmax(along + across)]
    along, across = _votes(normals, _directions(np.array([best, [0, 0]])), settings.width_deg)
    clear = along[0] + across[0] >= settings.clearer * (along[1] + across[1])
    # A sloping ground alone agrees with a leaning vertical, but then walls agree with z.
    plumb = across[0] >= max(across[1], settings.fewest_walls * len(normals))
    if not (clear and plumb):
        return 0.0, 0.0
    return float(np.hypot(*best)), float(np.degrees(np.arctan2(best[0], best[1])) % 360)


def _directions(tilts: np.ndarray) -> np.ndarray:
    """Return unit vectors that lean from z by so many degrees towards x and y; shape (n, 3)."""
    slopes = np.radians(tilts)
    angle = np.hypot(*slopes.T)
    scale = np.divide(np.sin(angle), angle, out=np.ones_like(angle), where=angle > 0)
    return np.column_stack([slopes * scale[:, None], np.cos(angle)])


def axis_that_is_up(faces: Faces, settings: UprightSettings = UprightSettings()) -> str:
    """Return x or y if floors and ceilings lie across it rather than across z; otherwise nothing.

    Floors and ceilings cover more than walls of one direction, at both ends of the shortest extent.
    """
    extents = np.ptp(np.percentile(faces.centres, [2, 98], axis=0), axis=0)
    cosine = np.cos(np.radians(settings.facing_deg))
    facing = np.abs(faces.normals) > cosine
    areas = facing.sum(axis=0)
    for axis, name in enumerate("xy"):
        others = [other for other in range(3) if other != axis]
        ratio = extents[axis] / max(extents[others].min(), 1e-9)
        flat = extents[axis] >= settings.lowest_m and ratio < 1
        more = settings.more_floor if ratio < settings.flat else settings.much_more_floor
        if (
            flat
            and areas[axis] > more * areas[others].max()
            and _at_both_ends(faces.centres[facing[:, axis], axis], faces.centres[:, axis], settings)
        ):
            return name
    return ""


def _at_both_ends(positions: np.ndarray, everything: np.ndarray, settings: UprightSettings) -> bool:
    low, high = np.percentile(everything, [2, 98])
    reach = settings.end * (high - low)
    ends = np.mean(positions < low + reach), np.mean(positions > high - reach)
    return min(ends) > settings.least_end


def hangs(faces: Faces, settings: UprightSettings = UprightSettings()) -> bool:
    """Whether nearly all that is level lies above the walls, as in a cloud that stands on its head."""
    level = np.abs(faces.normals[:, 2]) > np.cos(np.radians(settings.facing_deg))
    plumb = np.abs(faces.normals[:, 2]) < np.sin(np.radians(settings.facing_deg))
    count = len(faces.normals)
    if level.sum() < settings.fewest_floors * count or plumb.sum() < settings.fewest_walls * count:
        return False
    heights = faces.centres[:, 2]
    low, high = np.percentile(heights, [2, 98])
    middle = (low + high) / 2
    return bool(
        np.mean(heights[level] > middle) > settings.hanging
        and np.mean(heights[plumb] < middle) > settings.below
    )
