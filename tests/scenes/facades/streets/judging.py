"""Comparison of an elevation with the openings of the street that was scanned."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from ichnograph.algorithms.facade.elevation import COLOURED, PROJECTION, Detail, Elevation
from shapely.geometry import Polygon

from ..caster import cast, flatten
from ..judging import ALIKE, Judgement, Pair, in_scene, iou
from ..scene import FacadeScene
from .openings import TrueOpening

LEFT, BOTTOM, RIGHT, TOP = range(4)
BESIDE, STEP = 0.015, 0.03
"""Samples of the wall around an opening: how far from its edge, and from each other (m)."""

SAME = 0.06
"""A ray that ends within this distance of the wall has met it, or what is flat on it (m)."""

REQUIRED = 0.6
"""An opening counts as one to be found if as much of the wall around it was seen."""

OFF_WALL = 0.3
"""What is drawn on a tower farther from the plane of a side is not on that side (m)."""

TOUCHES = 0.2
"""What overlaps a true opening by as much is that opening, drawn well or badly (intersection over union)."""


@dataclass(frozen=True)
class SeenPair(Pair):
    """An opening that was found.

    Attributes
    ----------
    true : TrueOpening
    seen : tuple of 4 float
        Shares of the wall along the left, bottom, right and top edge that a station saw; nan along the
        ground.
    """

    true: TrueOpening
    seen: tuple[float, float, float, float]

    @property
    def edges(self) -> np.ndarray:
        """Found minus true position of the left, bottom, right and top edge on its wall (m)."""
        return np.array(self.outline.bounds) - self.true.built.bounds


@dataclass(frozen=True)
class StreetJudgement(Judgement):
    """The openings of an elevation compared with the true ones.

    Attributes
    ----------
    pairs : tuple of SeenPair
    missed : tuple of TrueOpening
    invented : tuple of Detail
    hidden : tuple of TrueOpening
        Not found, and mostly not seen.
    right_side : bool
        Whether the facade is drawn from outside.
    """

    pairs: tuple[SeenPair, ...]
    missed: tuple[TrueOpening, ...]
    invented: tuple[Detail, ...]
    hidden: tuple[TrueOpening, ...]
    right_side: bool


def judge_street(elevation: Elevation, scene: FacadeScene) -> StreetJudgement:
    """Return the openings of an elevation paired with those of the scene that it can show.

    These are the ones parallel to it, or all if it is rolled out. They are compared on their own walls.
    """
    found = [detail for detail in elevation.details if detail.kind not in (COLOURED, PROJECTION)]
    left = set(range(len(found)))
    pairs, missed, hidden = [], [], []
    for true in scene.details:
        if true.turned and elevation.curve is None:
            continue
        outlines = {number: _on_wall_of(true, found[number], elevation, scene) for number in left}
        shares = {number: iou(outline, true.built) for number, outline in outlines.items()}
        best = max(shares, key=shares.get, default=None)
        around = np.array(list(_samples(true.built)))
        met = seen(scene, true.places(around[:, :2])) if len(around) else np.zeros(0, bool)
        if best is not None and shares[best] >= ALIKE:
            left.remove(best)
            sides = tuple(_share(met[around[:, 2] == side]) for side in range(4))
            pairs.append(SeenPair(true, found[best], outlines[best], shares[best], sides))
        elif met.mean() >= REQUIRED:
            missed.append(true)
        else:
            hidden.append(true)
    shown = {number: in_scene(found[number].outline, elevation, scene) for number in left}
    invented = [
        found[number]
        for number in sorted(left)
        if all(iou(shown[number], true.outline) < TOUCHES for true in scene.details)
    ]
    turned = (elevation.frame.azimuth - scene.frame.azimuth + 180) % 360 - 180
    return StreetJudgement(tuple(pairs), tuple(missed), tuple(invented), tuple(hidden), abs(turned) < 90)


def _on_wall_of(true: TrueOpening, found: Detail, elevation: Elevation, scene: FacadeScene) -> Polygon:
    """Return an outline on the wall of a true opening, in a, v; empty on another side of a tower."""
    corners = np.array(found.outline.exterior.coords)[:, :2]
    site = elevation.world(np.column_stack([corners, np.zeros(len(corners))]))
    places = (scene.frame.local(site, np.zeros(3)) - true.places(np.zeros((1, 2)))) @ true.axes.T
    if elevation.curve is not None and np.abs(places[:, 2]).max() > OFF_WALL:
        return Polygon()
    return Polygon(places[:, :2]).buffer(0)


def nothing_found(scene: FacadeScene) -> StreetJudgement:
    """Return the judgement of a street in which no facade was found."""
    return StreetJudgement((), tuple(true for true in scene.details if not true.turned), (), (), False)


def seen(scene: FacadeScene, places: np.ndarray) -> np.ndarray:
    """Return whether a station sees each place of a wall.

    Parameters
    ----------
    places : ndarray, shape (n, 3)
        u, v, w.
    """
    things = flatten(scene.panels, scene.leaves)
    met = np.zeros(len(places), bool)
    for station in scene.stations:
        rays = places - station
        lengths = np.linalg.norm(rays, axis=1)
        reach, _ = cast(station, rays / lengths[:, None], things, 0)
        met |= np.abs(reach - lengths) < SAME
    return met


def _samples(outline: Polygon) -> Iterator[tuple[float, float, int]]:
    """Yield places on the wall around an opening, above the ground, and the side they belong to."""
    corners = np.array(_open_ring(outline))
    for start, stop in zip(corners, np.roll(corners, -1, axis=0)):
        along = stop - start
        length = np.linalg.norm(along)
        if length < 1e-9:
            continue
        # The ring runs anticlockwise, so the wall is to its right.
        right, up = along[1] / length, -along[0] / length
        across, along_v = (RIGHT if right > 0 else LEFT), (TOP if up > 0 else BOTTOM)
        side = across if abs(right) > abs(up) else along_v
        count = max(int(length / STEP), 1)
        for share in (np.arange(count) + 0.5) / count:
            u, v = start + share * along + BESIDE * np.array([right, up])
            if v > 0:
                yield u, v, side


def _open_ring(outline: Polygon) -> list:
    ring = outline.exterior
    return list(ring.coords if ring.is_ccw else ring.coords[::-1])[:-1]


def _share(met: np.ndarray) -> float:
    return float(met.mean()) if len(met) else np.nan
