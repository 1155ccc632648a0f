"""Comparison of an elevation with the facade that was scanned."""

from dataclasses import dataclass

import numpy as np
from ichnograph.algorithms.facade.elevation import Detail, Elevation
from shapely.geometry import Polygon

from .scene import FacadeScene, TrueDetail

ALIKE = 0.5
"""Least intersection over union of two outlines of the same detail."""


@dataclass(frozen=True)
class Pair:
    """A detail that was found.

    Attributes
    ----------
    true : TrueDetail
    found : Detail
    outline : Polygon
        As found, in u, v of the scene.
    iou : float
        Intersection over union.
    """

    true: TrueDetail
    found: Detail
    outline: Polygon
    iou: float

    @property
    def edges(self) -> np.ndarray:
        """Found minus true position of the left, bottom, right and top edge (m)."""
        return np.array(self.outline.bounds) - self.true.outline.bounds

    @property
    def size(self) -> np.ndarray:
        """Found minus true width and height (m)."""
        left, bottom, right, top = self.edges
        return np.array([right - left, top - bottom])


@dataclass(frozen=True)
class Judgement:
    """The details of an elevation compared with the true ones.

    Attributes
    ----------
    pairs : tuple of Pair
    missed : tuple of TrueDetail
    invented : tuple of Detail
    """

    pairs: tuple[Pair, ...]
    missed: tuple[TrueDetail, ...]
    invented: tuple[Detail, ...]


def judge(elevation: Elevation, scene: FacadeScene) -> Judgement:
    """Return the details of an elevation paired with true ones of the same kind."""
    outlines = [in_scene(detail.outline, elevation, scene) for detail in elevation.details]
    left = set(range(len(outlines)))
    pairs, missed = [], []
    for true in scene.details:
        shares = {
            number: iou(outlines[number], true.outline)
            for number in left
            if elevation.details[number].kind == true.kind
        }
        best = max(shares, key=shares.get, default=None)
        if best is None or shares[best] < ALIKE:
            missed.append(true)
            continue
        left.remove(best)
        pairs.append(Pair(true, elevation.details[best], outlines[best], shares[best]))
    return Judgement(tuple(pairs), tuple(missed), tuple(elevation.details[number] for number in sorted(left)))


def in_scene(outline: Polygon, elevation: Elevation, scene: FacadeScene) -> Polygon:
    """Return an outline of the elevation in u, v of the scene."""
    corners = np.array(outline.exterior.coords)[:, :2]
    places = elevation.world(np.column_stack([corners, np.zeros(len(corners))]))
    return Polygon(scene.frame.local(places, np.zeros(3))[:, :2]).buffer(0)


def iou(first: Polygon, second: Polygon) -> float:
    """Return the intersection over union of two outlines."""
    both = first.intersection(second).area
    return both / (first.area + second.area - both)
