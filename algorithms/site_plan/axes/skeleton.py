"""The skeleton of a wall: chains of chords from face to face, which meet at junctions."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Optional

import numpy as np
from shapely.geometry import Polygon

from ...geometry.linked_parts import label_linked
from ...geometry.outline_triangles import OutlineMesh, triangulate_outlines
from .settings import AxisSettings


@dataclass(frozen=True)
class Chain:
    """A stretch of wall between two junctions or ends.

    Attributes
    ----------
    middles : ndarray, shape (n, 2)
        Middles of the chords, in world coordinates less those of `Skeleton.origin`.
    chords : ndarray, shape (n, 2)
        From face to face.
    start, end : int or None
        Junctions; None where the wall ends.
    """

    middles: np.ndarray
    chords: np.ndarray
    start: Optional[int]
    end: Optional[int]

    @property
    def width(self) -> float:
        """Usual length of a chord in metres."""
        return float(np.median(np.linalg.norm(self.chords, axis=1)))

    @property
    def length(self) -> float:
        """Metres."""
        return float(np.linalg.norm(np.diff(self.middles, axis=0), axis=1).sum())


@dataclass(frozen=True)
class Skeleton:
    """What the chains of a wall join.

    Attributes
    ----------
    origin : ndarray, shape (2,)
    width : float
        Diameter of the largest circle inside the wall, metres.
    chains : tuple of Chain
    junctions : dict of int to ndarray, shape (2,)
        About where the junctions lie, relative to the origin.
    """

    origin: np.ndarray
    width: float
    chains: tuple[Chain, ...]
    junctions: dict[int, np.ndarray]


def skeleton_of(outline: Polygon, settings: AxisSettings = AxisSettings()) -> Skeleton:
    """Return the skeleton of a wall.

    After L. Prasad, Morphological analysis of shapes (1997): chords are sides of Delaunay triangles; a
    triangle with three chords is a junction; a branch that hardly stands out is pruned.
    """
    mesh = triangulate_outlines([outline], settings.mesh)
    graph = _Graph(mesh)
    graph.prune(settings.skeleton.least_protrusion)
    centres = mesh.points[mesh.triangles].mean(axis=1)
    chains = [graph.chain(walk) for walk in graph.walks()]
    return Skeleton(mesh.origin, float(mesh.widths()[mesh.wall].max(initial=0.0)), *_joined(chains, centres))


class _Graph:
    """The triangles inside a wall, linked over their common sides."""

    def __init__(self, mesh: OutlineMesh) -> None:
        sides = mesh.sides(mesh.wall)
        self.ends, self.points, self.triangles = sides.ends, mesh.points, mesh.triangles
        # The side to each neighbour, by triangle; and the triangles pruned, by the junction they joined.
        self.links: dict[int, dict[int, int]] = {}
        self.lost: dict[int, list[int]] = {}
        for side, (a, b) in enumerate(zip(sides.first.tolist(), sides.second.tolist())):
            self.links.setdefault(a, {})[b] = side
            self.links.setdefault(b, {})[a] = side

    def prune(self, protrusion: float) -> None:
        """Remove the branches that stand out less than so many widths, one at each junction at a time."""
        while True:
            least: dict[int, tuple[float, list[int]]] = {}
            for branch in self._branches():
                share = self._protrusion(branch)
                if share < least.get(branch[-1], (protrusion,))[0]:
                    least[branch[-1]] = (share, branch)
            if not least:
                return
            for _, branch in least.values():
                self._remove(branch)

    def _remove(self, branch: list[int]) -> None:
        *triangles, junction = branch
        gone = self.lost.setdefault(junction, [])
        for triangle in triangles:
            gone += [triangle, *self.lost.pop(triangle, [])]
            del self.links[triangle]
        del self.links[junction][triangles[-1]]

    def _branches(self) -> Iterator[list[int]]:
        """Yield the triangles from each end of the wall up to and with a junction."""
        for end in [t for t, linked in self.links.items() if len(linked) == 1]:
            branch = self._walk(end, next(iter(self.links[end])))
            if len(self.links[branch[-1]]) == 3:
                yield branch

    def _walk(self, start: int, towards: int) -> list[int]:
        walk = [start, towards]
        while len(self.links[walk[-1]]) == 2 and walk[-1] != start:
            walk.append(next(other for other in self.links[walk[-1]] if other != walk[-2]))
        return walk

    def _protrusion(self, branch: list[int]) -> float:
        """Return how far a branch stands out from the chord at its root, in lengths of the chord."""
        a, b = self.points[self.ends[self.links[branch[-1]][branch[-2]]]]
        gone = [*branch[:-1], *(t for triangle in branch[:-1] for t in self.lost.get(triangle, []))]
        corners = self.points[self.triangles[gone]].reshape(-1, 2)
        length = np.linalg.norm(b - a)
        along = (b - a) / length
        share = np.clip((corners - a) @ along, 0, length)
        return float(np.linalg.norm(corners - a - share[:, None] * along, axis=1).max() / length)

    def walks(self) -> Iterator[list[int]]:
        """Yield the triangles between junctions or ends, and around rings that have none."""
        left, seen = set(self.links), set()
        for start in [t for t, linked in self.links.items() if len(linked) != 2]:
            left.discard(start)
            for towards in self.links[start]:
                if (start, towards) not in seen:
                    walk = self._walk(start, towards)
                    seen.add((walk[-1], walk[-2]))
                    left.difference_update(walk)
                    yield walk
        while left:
            start = left.pop()
            walk = self._walk(start, next(iter(self.links[start])))
            left.difference_update(walk)
            yield walk

    def chain(self, walk: list[int]) -> Chain:
        """Return the chords between the triangles of a walk; a ring begins at its farthest corner."""
        ring = walk[0] == walk[-1] and len(self.links[walk[0]]) == 2
        if ring:
            centres = self.points[self.triangles[walk[:-1]]].mean(axis=1)
            first = int(np.argmax(np.linalg.norm(centres - centres.mean(axis=0), axis=1)))
            walk = [*walk[first:-1], *walk[:first], walk[first]]
        ends = self.points[self.ends[[self.links[a][b] for a, b in zip(walk, walk[1:])]]]
        middles, chords = ends.mean(axis=1), ends[:, 1] - ends[:, 0]
        start, end = (t if ring or len(self.links[t]) == 3 else None for t in (walk[0], walk[-1]))
        return Chain(middles, chords, start, end)


def _joined(chains: list[Chain], centres: np.ndarray) -> tuple[tuple[Chain, ...], dict[int, np.ndarray]]:
    """Unite junctions that lie nearer to each other than the wall between them is wide."""
    ends = {end for chain in chains for end in (chain.start, chain.end) if end is not None}
    near = [c for c in chains if None not in (c.start, c.end) and c.start != c.end and c.length < c.width]
    number = {end: i for i, end in enumerate(sorted(ends))}
    linked = [(number[c.start], number[c.end]) for c in near if c.start is not None and c.end is not None]
    first, second = np.array(linked, dtype=int).reshape(-1, 2).T
    part = label_linked(first, second, len(number)) if number else []
    name = {end: int(part[i]) for end, i in number.items()}

    def named(end: Optional[int]) -> Optional[int]:
        return None if end is None else name[end]

    kept = tuple(
        replace(c, start=named(c.start), end=named(c.end)) for c in chains if not any(c is n for n in near)
    )
    junctions = {
        one: np.mean([centres[end] for end in ends if name[end] == one], axis=0)
        for one in {name[end] for end in ends}
    }
    return kept, junctions
