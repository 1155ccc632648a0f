"""Voxels of a cloud: one mean point each, with the normal of the surface around it."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from ....geometry.linked_parts import label_near
from ....geometry.packed_cells import BITS, HALF_RANGE, packed, summed, unpacked
from ....kernels import kernel
from ....parallel import in_order, in_parts
from ..settings import VoxelSettings

PART = 1 << 14
"""Voxels whose normals one thread finds at a time."""

WAITING = 1 << 21
"""Voxels that wait at least before they are sorted, at 64 bytes each."""

SHARE = 2.0**40
"""Steps in a metre of the integers that are summed up, and of the finer ones in each such step."""


@dataclass(frozen=True)
class Voxels:
    """Occupied voxels of a cloud.

    Attributes
    ----------
    xyz : ndarray of float64, shape (n, 3)
        Mean of the points inside, metres, relative to the local origin.
    normal : ndarray of float32, shape (n, 3)
        Unit normal of the surface, its sign is arbitrary; zero where there is no surface.
    edge_m : float
        Edge of a voxel, metres.
    spacing_m : float
        Usual distance between neighbouring points, not less than the voxel's edge.
    noise_m : float
        Usual standard deviation of the points across upright surfaces.
    """

    xyz: np.ndarray
    normal: np.ndarray
    edge_m: float
    spacing_m: float
    noise_m: float


def make_voxels(chunks: Iterable[np.ndarray], settings: VoxelSettings = VoxelSettings()) -> Voxels:
    """Reduce points to voxels and find the normals.

    Parameters
    ----------
    chunks : iterable of ndarray of float64, shape (n, 3)
        Points, metres, relative to a local origin.
    settings : VoxelSettings
    """
    xyz = _without_strays(_means(chunks, settings.edge_m), settings)
    if len(xyz) < settings.neighbours + 1:
        return Voxels(xyz, np.zeros(xyz.shape, np.float32), settings.edge_m, settings.edge_m, 0.0)
    spacing = max(_spacing(xyz, settings), settings.edge_m)
    widest = settings.widest_normal_radius_m
    radius = min(max(settings.normal_radius_m, settings.normal_radius_spacings * spacing), widest)
    fewest = settings.fewest_neighbours
    normal, thickness = _normals(xyz, radius, fewest)
    noise = _noise(normal, thickness, settings.upright)
    wider = min(settings.normal_radius_noises * noise, widest)
    if wider > settings.refit_growth * radius:
        radius = wider
        normal, thickness = _normals(xyz, radius, fewest)
        noise = _noise(normal, thickness, settings.upright)
    surface = thickness <= settings.flatness * radius
    lonely = np.isinf(thickness)
    mixed = ~surface & (settings.normal_radius_spacings * spacing > settings.mixing_radius_m)
    if lonely.mean() > settings.lonely_share or mixed.any():
        band = settings.agreeing_noises * max(noise, settings.least_noise_m)
        band = min(band, settings.agreeing_share * radius)
        rows = np.flatnonzero(lonely | mixed)
        normal[rows], count, around = _agreeing_normals(xyz, rows, 2 * radius, band, settings)
        # Where fewer points are around, all of them must agree.
        surface[rows] = count >= np.clip(around, fewest, settings.fewest_agreeing)
    normal[~surface] = 0.0
    return Voxels(xyz, normal, settings.edge_m, spacing, noise)


def _means(chunks: Iterable[np.ndarray], edge: float) -> np.ndarray:
    """Return the mean of the points in each voxel, shape (n, 3)."""
    keys, sums = np.zeros(0, np.int64), np.zeros((0, 7), np.int64)
    added: list[tuple[np.ndarray, np.ndarray]] = []
    count = 0
    for more in in_order(lambda chunk: _summed(chunk, edge, SHARE), chunks):
        added.append(more)
        count += len(more[0])
        # Adding only as much as there is already sorts every voxel a few times, not once a chunk.
        if count > max(len(keys), WAITING):
            keys, sums = _added(keys, sums, added)
            added.clear()
            count = 0
    keys, sums = _added(keys, sums, added)
    left = ((sums[:, :3] + sums[:, 3:6] / SHARE) / SHARE).astype(np.float32).astype(float)
    return unpacked(keys) * edge + left / np.maximum(sums[:, 6:], 1)


@kernel
def _summed(xyz: np.ndarray, edge: float, share: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the keys of the voxels of a chunk, and the sums of what is left of their corners.

    What is left is rounded to four bytes. The sums are integers, coarse ones and what these leave, so that
    they do not depend on the order of the points, and have a count beside them.
    """
    size = 16
    while size < 2 * len(xyz):
        size *= 2
    mask = np.uint64(size - 1)
    row_of = np.full(size, -1, np.int32)
    keys = np.empty(len(xyz), np.int64)
    sums = np.zeros((len(xyz), 7), np.int64)
    count = 0
    for i in range(len(xyz)):
        x, y, z = np.floor(xyz[i, 0] / edge), np.floor(xyz[i, 1] / edge), np.floor(xyz[i, 2] / edge)
        key = ((np.int64(x) + HALF_RANGE) << 2 * BITS) | ((np.int64(y) + HALF_RANGE) << BITS)
        key |= np.int64(z) + HALF_RANGE
        slot = np.uint64(key) * np.uint64(0x9E3779B97F4A7C15)
        slot = (slot >> np.uint64(32)) & mask
        while row_of[slot] >= 0 and keys[row_of[slot]] != key:
            slot = (slot + np.uint64(1)) & mask
        row = row_of[slot]
        if row < 0:
            row = row_of[slot] = count
            keys[row] = key
            count += 1
        for axis, corner in enumerate((x, y, z)):
            left = np.float64(np.float32(xyz[i, axis] - corner * edge)) * share
            steps = np.rint(left)
            sums[row, axis] += np.int64(steps)
            sums[row, 3 + axis] += np.int64(np.rint((left - steps) * share))
        sums[row, 6] += 1
    return keys[:count].copy(), sums[:count].copy()


def _added(
    keys: np.ndarray, sums: np.ndarray, added: list[tuple[np.ndarray, np.ndarray]]
) -> tuple[np.ndarray, np.ndarray]:
    """Add keys and their sums to those that there are; the keys ascend."""
    keys = np.concatenate([keys, *(more for more, _ in added)])
    sums = np.concatenate([sums, *(more for _, more in added)])
    return summed(keys, sums)


def _without_strays(xyz: np.ndarray, settings: VoxelSettings) -> np.ndarray:
    """Drop the small parts that lie far from the rest: reflections put points a kilometre away."""
    if not len(xyz):
        return xyz
    column, row = np.floor(xyz[:, :2] / settings.apart_m).astype(np.int64).T
    blocks, member = np.unique((column << 32) + row, return_inverse=True)
    row = blocks.astype(np.int32).astype(np.int64)
    part = label_near(np.column_stack([(blocks - row) >> 32, row]), 1)[member]
    return xyz[np.bincount(part)[part] >= settings.stray_share * len(xyz)]


def _spacing(xyz: np.ndarray, settings: VoxelSettings) -> float:
    """Return the usual distance of neighbours, measured in columns of a metre all over the cloud."""
    columns = np.floor(xyz[:, :2]).astype(np.int64) + HALF_RANGE
    number = (columns[:, 0] << BITS) | columns[:, 1]
    every = max(len(xyz) // settings.sampled_points, 1)
    chosen = xyz[number % every == 0] if every > 1 else xyz
    if len(chosen) < settings.fewest_sampled_points:
        chosen = xyz
    queried = chosen[:: max(len(chosen) // settings.queried_points, 1)]
    # Splits in the middle cost less than balanced ones, to build and to ask.
    distance = cKDTree(chosen, balanced_tree=False).query(queried, settings.neighbours + 1)[0][:, -1]
    return float(np.median(distance) / np.sqrt(2.0))


def _noise(normal: np.ndarray, thickness: np.ndarray, most: float) -> float:
    """Return the median thickness of upright surfaces, metres."""
    upright = np.isfinite(thickness) & (np.abs(normal[:, 2]) < most)
    return float(np.median(thickness[upright])) if upright.any() else 0.0


def _normals(xyz: np.ndarray, radius: float, fewest: int) -> tuple[np.ndarray, np.ndarray]:
    """Return normals (n, 3) and thicknesses (n,), infinite where too few points lie within the radius."""
    buckets = packed(np.floor(xyz / radius))
    order = np.argsort(buckets, kind="stable")
    normal = np.zeros((len(xyz), 3), np.float32)
    thickness = np.full(len(xyz), np.inf, np.float32)
    arrays = xyz[order], buckets[order]

    def fit(part: slice) -> None:
        _fit_planes(*arrays, normal[part], thickness[part], part.start, radius, fewest)

    in_parts(fit, len(xyz), PART)
    back = np.empty_like(order)
    back[order] = np.arange(len(order))
    return normal[back], thickness[back]


def _agreeing_normals(
    xyz: np.ndarray, rows: np.ndarray, radius: float, band: float, settings: VoxelSettings
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return normals (n, 3) of the planes on which most points around one lie, how many do, and how many are.

    Where points are as far apart as the two faces of a partition, those around one lie on both faces.
    """
    tree = cKDTree(xyz)
    distance, near = tree.query(xyz[rows], settings.tried_points, distance_upper_bound=radius, workers=-1)
    near[np.isinf(distance)] = -1
    normal = np.zeros((len(rows), 3), np.float32)
    count = np.zeros(len(rows), np.int64)

    def fit(part: slice) -> None:
        _fit_agreeing(xyz, rows[part], near[part], band, settings.tried_sine, normal[part], count[part])

    in_parts(fit, len(rows), PART)
    return normal, count, (near >= 0).sum(axis=1)


@kernel
def _fit_agreeing(
    xyz: np.ndarray,
    rows: np.ndarray,
    near: np.ndarray,
    band: float,
    least_sine: float,
    normal: np.ndarray,
    count: np.ndarray,
) -> None:
    """Write for each row the normal of the plane through its point and most near ones, and their number."""
    away, squared = np.empty((near.shape[1], 3)), np.empty(near.shape[1])
    for row in range(len(rows)):
        n = 0
        for k in range(near.shape[1]):
            if near[row, k] >= 0 and near[row, k] != rows[row]:
                for axis in range(3):
                    away[n, axis] = xyz[near[row, k], axis] - xyz[rows[row], axis]
                squared[n] = away[n, 0] ** 2 + away[n, 1] ** 2 + away[n, 2] ** 2
                n += 1
        least = np.inf
        for i in range(n):
            for j in range(i):
                x = away[i, 1] * away[j, 2] - away[i, 2] * away[j, 1]
                y = away[i, 2] * away[j, 0] - away[i, 0] * away[j, 2]
                z = away[i, 0] * away[j, 1] - away[i, 1] * away[j, 0]
                size = np.sqrt(x * x + y * y + z * z)
                if size < least_sine * np.sqrt(squared[i] * squared[j]):
                    continue
                on, off = 1, 0.0
                for k in range(n):
                    distance = abs(x * away[k, 0] + y * away[k, 1] + z * away[k, 2]) / size
                    if distance <= band:
                        on += 1
                        off += distance
                    elif on + n - k <= count[row]:
                        # Those that are left cannot make it the best plane any more.
                        break
                if on > count[row] or (on == count[row] and off < least):
                    count[row], least = on, off
                    normal[row, 0], normal[row, 1], normal[row, 2] = x / size, y / size, z / size


@kernel
def _fit_planes(
    xyz: np.ndarray,
    buckets: np.ndarray,
    normal: np.ndarray,
    thickness: np.ndarray,
    start: int,
    radius: float,
    fewest: int,
) -> None:
    """Fit planes to what lies within the radius of points from `start` on, as many as `normal` has rows.

    Buckets are sorted, as wide as the radius.
    """
    reach = radius * radius
    starts, ends = np.zeros(9, np.int64), np.zeros(9, np.int64)
    last = np.int64(-1)
    for row in range(len(normal)):
        i = start + row
        if buckets[i] != last:
            last = buckets[i]
            _find_around(buckets, last, starts, ends)
        n = 0
        sx = sy = sz = sxx = sxy = sxz = syy = syz = szz = 0.0
        for k in range(9):
            for j in range(starts[k], ends[k]):
                x, y, z = xyz[j, 0] - xyz[i, 0], xyz[j, 1] - xyz[i, 1], xyz[j, 2] - xyz[i, 2]
                if x * x + y * y + z * z <= reach:
                    n += 1
                    sx += x
                    sy += y
                    sz += z
                    sxx += x * x
                    sxy += x * y
                    sxz += x * z
                    syy += y * y
                    syz += y * z
                    szz += z * z
        if n < fewest:
            continue
        sx, sy, sz = sx / n, sy / n, sz / n
        sxx, sxy, sxz = sxx / n - sx * sx, sxy / n - sx * sy, sxz / n - sx * sz
        syy, syz, szz = syy / n - sy * sy, syz / n - sy * sz, szz / n - sz * sz
        smallest = _thinnest(sxx, sxy, sxz, syy, syz, szz, normal[row])
        thickness[row] = np.sqrt(max(smallest, 0.0))


@kernel
def _find_around(buckets: np.ndarray, middle: int, starts: np.ndarray, ends: np.ndarray) -> None:
    """Write where the nine columns of three buckets around a bucket start and end."""
    k = 0
    for dx in range(-1, 2):
        for dy in range(-1, 2):
            column = middle + (dx * (np.int64(1) << 42)) + (dy * (np.int64(1) << 21))
            starts[k] = np.searchsorted(buckets, column - 1)
            ends[k] = np.searchsorted(buckets, column + 2)
            k += 1


@kernel
def _thinnest(a: float, b: float, c: float, d: float, e: float, f: float, direction: np.ndarray) -> float:
    """Return the smallest eigenvalue of the matrix (a b c, b d e, c e f); `direction` takes its vector."""
    mean = (a + d + f) / 3.0
    p1 = b * b + c * c + e * e
    p = np.sqrt(((a - mean) ** 2 + (d - mean) ** 2 + (f - mean) ** 2 + 2.0 * p1) / 6.0)
    if p < 1e-12:
        return mean
    u, v, w = (a - mean) / p, (d - mean) / p, (f - mean) / p
    x, y, z = b / p, c / p, e / p
    half = (u * (v * w - z * z) - x * (x * w - z * y) + y * (x * z - v * y)) / 2.0
    angle = np.arccos(min(1.0, max(-1.0, half))) / 3.0
    smallest = mean + 2.0 * p * np.cos(angle + 2.0 * np.pi / 3.0)
    a, d, f = a - smallest, d - smallest, f - smallest
    best = 0.0
    for k in range(3):
        if k == 0:
            x, y, z = b * e - c * d, c * b - a * e, a * d - b * b
        elif k == 1:
            x, y, z = b * f - c * e, c * c - a * f, a * e - b * c
        else:
            x, y, z = d * f - e * e, e * c - b * f, b * e - d * c
        length = x * x + y * y + z * z
        if length > best:
            best = length
            root = np.sqrt(length)
            direction[0], direction[1], direction[2] = x / root, y / root, z / root
    return smallest
