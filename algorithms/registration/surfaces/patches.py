"""The plane surfaces of a scan, in small cells."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product
from typing import Optional

import numpy as np
from scipy.spatial import cKDTree

from ...clouds.settings import ReadingSettings
from ...clouds.source import Source
from ...geometry.linked_parts import label_linked
from ...geometry.packed_cells import packed, unpacked
from ...progress import Progress
from .cells import Cells, cells_of
from .settings import PatchSettings, StationSettings, SurfaceSettings
from .visibility import hidden_share

NEIGHBOURS = np.array([(x, y, z) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)])
NEIGHBOURS = NEIGHBOURS[len(NEIGHBOURS) // 2 + 1 :]
"""One of each two opposite neighbours of a cell."""

OF_CELLS = ("edges", "centres", "normals", "variances", "bordered")
"""What `Surfaces` has of each cell."""


@dataclass(frozen=True)
class Surfaces:
    """The plane cells of a scan.

    Attributes
    ----------
    edges : ndarray, shape (n,)
        Of the cells, metres.
    centres : ndarray, shape (n, 3)
        Means of their points, in the scan.
    normals : ndarray, shape (n, 3)
        Unit vectors, towards the scanner if its position is known, or else of either sign.
    variances : ndarray, shape (n,)
        Of a centre along its normal, square metres.
    bordered : ndarray of bool, shape (n,)
        Whether a cell beside it holds something out of its plane, which moves its middle by some millimetres:
        exact enough to find where a scan stood, but not to tie scans.
    station : ndarray, shape (3,), or None
        Where the scanner stood; None if that is not known.
    """

    edges: np.ndarray
    centres: np.ndarray
    normals: np.ndarray
    variances: np.ndarray
    bordered: np.ndarray
    station: Optional[np.ndarray] = None

    @property
    def facing(self) -> bool:
        """Whether the position of the scanner is known."""
        return self.station is not None

    def __len__(self) -> int:
        return len(self.centres)

    @cached_property
    def tree(self) -> cKDTree:
        """The centres, to search near a point."""
        return cKDTree(self.centres)

    def rows(self, wanted: np.ndarray) -> "Surfaces":
        """Return some of the cells."""
        return replace(self, **{name: getattr(self, name)[wanted] for name in OF_CELLS})

    @cached_property
    def exact(self) -> "Surfaces":
        """The cells that tie scans."""
        return self.rows(~self.bordered)

    def shifted(self, vector: np.ndarray) -> "Surfaces":
        """Return the surfaces after a shift."""
        station = None if self.station is None else self.station + vector
        return replace(self, centres=self.centres + vector, station=station)

    def mirrored(self) -> "Surfaces":
        """Return the surfaces as in a mirror across y."""
        flip = np.array([1.0, -1.0, 1.0])
        station = None if self.station is None else self.station * flip
        return replace(self, centres=self.centres * flip, normals=self.normals * flip, station=station)

    @cached_property
    def box(self) -> tuple[np.ndarray, np.ndarray]:
        """The lower and the upper corner around all centres, shape (3,) each."""
        return self.centres.min(axis=0), self.centres.max(axis=0)

    def corners(self) -> np.ndarray:
        """Return the corners of the box, shape (8, 3)."""
        return np.array(list(product(*zip(*self.box))))

    def seen_from(self, station: np.ndarray) -> "Surfaces":
        """Return the surfaces with normals towards a scanner."""
        towards = np.einsum("ij,ij->i", self.normals, station - self.centres)
        normals = np.where(towards < 0, -1.0, 1.0)[:, None] * self.normals
        return replace(self, normals=normals, station=np.asarray(station, float))

    def can_be_seen_from(self, station: np.ndarray, settings: StationSettings = StationSettings()) -> bool:
        """Return whether a position may be that of the scanner.

        The origin of a cloud that was moved before lies far from it, or behind its walls.
        """
        own = self.exact
        if not len(own):
            return False
        low, high = own.box
        if np.linalg.norm(np.maximum(low - station, station - high).clip(min=0)) > np.linalg.norm(high - low):
            return False
        hidden = hidden_share(station, own.centres, own.normals, own.edges, settings)
        return hidden <= settings.most_hidden


def read_surfaces(
    source: Source, settings: SurfaceSettings = SurfaceSettings(), progress: Progress = Progress()
) -> Surfaces:
    """Find the plane cells of a scan, in the coordinates of its file.

    The scanner is where the file states it, or else at the origin, if all can be seen from there.

    Parameters
    ----------
    source : Source
    settings : SurfaceSettings
    progress : Progress

    Raises
    ------
    InputError
        If the file is damaged.
    CancelledError
        If the caller asked to stop.
    """
    # Whole metres near the points, because cells are counted from the origin.
    origin = np.floor(source.middle)
    stations = []

    def points() -> Iterator[np.ndarray]:
        for chunk in source.chunks(origin, progress, ReadingSettings.chunk_points):
            stations.append(chunk.station)
            yield chunk.xyz

    surfaces = surfaces_of(points(), settings.patches)
    (stated, *others) = {None if each is None else tuple(each) for each in stations}
    if not others and stated is not None:
        surfaces = surfaces.seen_from(np.array(stated))
    elif not others and surfaces.can_be_seen_from(-origin, settings.stations):
        surfaces = surfaces.seen_from(-origin)
    return surfaces.shifted(origin)


def surfaces_of(chunks: Iterable[np.ndarray], settings: PatchSettings = PatchSettings()) -> Surfaces:
    """Return the plane cells of points: small ones, and larger ones where no small one within is plane.

    Parameters
    ----------
    chunks : iterable of ndarray, shape (n, 3)
        Metres, near the origin.
    settings : PatchSettings
    """
    cells = cells_of(chunks, settings.edges_m[0])
    found, covered = [], np.zeros(0, np.int64)
    for _ in settings.edges_m:
        level, keys = _plane_cells(cells, covered, settings)
        found.append(level)
        covered = np.unique(packed(unpacked(np.union1d(keys, covered)) >> 1))
        cells = cells.doubled()
    return joined(found)


def _plane_cells(every: Cells, covered: np.ndarray, settings: PatchSettings) -> tuple[Surfaces, np.ndarray]:
    """Return the plane cells that are not `covered` by smaller ones, and the keys of all plane ones."""
    cells = every.rows((every.counts >= settings.fewest_points) & ~np.isin(every.keys, covered))
    values, vectors = np.linalg.eigh(cells.covariances())
    widths = np.sqrt(np.maximum(values, 0.0))
    plane = widths[:, 0] < settings.thickest * widths[:, 1]
    plane &= widths[:, 1] > settings.narrowest * cells.edge
    cells, normals = cells.rows(plane), vectors[plane][:, :, 0]
    free = _free_standing(cells, normals, every, settings) if len(cells.keys) else np.zeros(0, bool)
    found = [
        _surfaces(cells.rows(kind), normals[kind], every, bordered, settings)
        for kind, bordered in ((free, False), (~free, True))
    ]
    return joined(found), cells.keys


def _surfaces(
    cells: Cells, normals: np.ndarray, every: Cells, bordered: bool, settings: PatchSettings
) -> Surfaces:
    if len(cells.keys):
        cells = _whole(cells, normals, every, settings)
    values, vectors = np.linalg.eigh(cells.covariances())
    return Surfaces(
        edges=np.full(len(cells.keys), cells.edge),
        centres=cells.centres(),
        normals=_of_planes(cells, vectors[:, :, 0], settings),
        variances=np.maximum(values[:, 0], 0.0) / cells.counts,
        bordered=np.full(len(cells.keys), bordered),
    )


def joined(parts: Sequence[Surfaces]) -> Surfaces:
    """Return the cells of one scan together, without the position of the scanner."""
    return Surfaces(*(np.concatenate([getattr(part, name) for part in parts]) for name in OF_CELLS))


def _free_standing(cells: Cells, normals: np.ndarray, every: Cells, settings: PatchSettings) -> np.ndarray:
    """Return which cells have only neighbours in their plane.

    Beside a corner or furniture, a few points of the other surface lie in a cell and move its middle towards
    the room, too little to be seen in it, but in all cells alike.
    """
    free = np.ones(len(normals), bool)
    for step in (*NEIGHBOURS, *-NEIGHBOURS):
        there, level = _beside(cells, normals, every, step, settings)[1:]
        free &= ~there | level
    return free


def _whole(cells: Cells, normals: np.ndarray, every: Cells, settings: PatchSettings) -> Cells:
    """Return the cells with the points of their plane beyond the faces that it nearly lies in.

    There, the noise puts some points into the next cell: those that remain lie on one side of the plane.
    """
    across = np.eye(3, dtype=np.int64)[np.abs(normals).argmax(axis=1)]
    whole = cells
    for steps in (across, -across):
        rows, there, level = _beside(cells, normals, every, steps, settings)
        others = every.rows(rows)
        whole = whole.joined(Cells(every.edge, others.keys, others.moments * (there & level)[:, None]), steps)
    return whole


def _beside(
    cells: Cells, normals: np.ndarray, every: Cells, steps: np.ndarray, settings: PatchSettings
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the rows of neighbours, which cells have them, and which of them lie in the cell's plane."""
    rows, there = every.neighbours(cells, steps)
    others = every.rows(rows)
    off = np.einsum("ij,ij->i", others.centres() - cells.centres(), normals)
    thick = np.einsum("ij,ijk,ik->i", normals, others.covariances(), normals)
    limit = np.sin(np.radians(settings.bend_deg)) * cells.edge
    return rows, there, off**2 + thick < limit**2


def _of_planes(cells: Cells, normals: np.ndarray, settings: PatchSettings) -> np.ndarray:
    """Return the normals of the planes that cells are part of.

    Normals of single cells lean by a degree or so through noise. In a corridor, that would look as if the
    walls fixed a scan along them. Cells of curved surfaces keep their own.
    """
    centres = cells.centres()
    part = label_linked(*_linked(cells, centres, normals, settings), len(centres))
    count = part.max(initial=-1) + 1
    size = np.bincount(part, minlength=count)
    means = np.column_stack([np.bincount(part, centres[:, axis], count) for axis in range(3)]) / size[:, None]
    arms = centres - means[part]
    scatter = np.zeros((count, 3, 3))
    np.add.at(scatter, part, arms[:, :, None] * arms[:, None, :])
    values, vectors = np.linalg.eigh(scatter)
    # Fewer cells, or cells along a line, have a plane of their own only by their points.
    wide = (size >= 4) & (np.sqrt(np.maximum(values[:, 1], 0.0) / size) > 0.5 * cells.edge)
    common = vectors[part][:, :, 0]
    cosine = np.einsum("ij,ij->i", common, normals)
    agree = wide[part] & (np.abs(cosine) > np.cos(np.radians(settings.bend_deg)))
    return np.where(agree[:, None], common, normals)


def _linked(
    cells: Cells, centres: np.ndarray, normals: np.ndarray, settings: PatchSettings
) -> tuple[np.ndarray, np.ndarray]:
    """Return which neighbouring cells lie in one plane, in pairs."""
    ones, others = [np.zeros(0, int)], [np.zeros(0, int)]
    for step in NEIGHBOURS if len(centres) else ():
        rows, there = cells.neighbours(cells, step)
        ones.append(np.flatnonzero(there))
        others.append(rows[there])
    one, other = np.concatenate(ones), np.concatenate(others)
    apart = centres[other] - centres[one]
    bend = np.sin(np.radians(settings.bend_deg))
    level = np.abs(np.einsum("ij,ij->i", normals[one], normals[other])) > np.cos(
        np.radians(settings.bend_deg)
    )
    for normal in (normals[one], normals[other]):
        level &= np.abs(np.einsum("ij,ij->i", apart, normal)) < bend * cells.edge
    return one[level], other[level]
