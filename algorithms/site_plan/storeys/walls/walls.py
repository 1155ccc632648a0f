"""What is known of each wall: its kind, thickness and heights, and how much of it was seen."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Optional

import numpy as np
from shapely.geometry import LinearRing, Polygon

from ....geometry.polygons import box_sides
from ..evidence.levels import Storey, count_levels
from ..evidence.uprights_along import UprightsAlong
from ..settings import CutSettings, LevelSettings, WallSettings
from .wall_pieces import cut_at_junctions


@dataclass(frozen=True)
class Wall:
    """A wall between junctions and openings.

    Attributes
    ----------
    outline : Polygon
        Metres; shares its edges with its neighbours exactly.
    kind : str
        "wall", "column", or "parapet" with a window above it.
    body : int
        Number of the connected body that it is a piece of.
    thickness : float or None
        Usual distance of its two faces, metres; None where only one was seen.
    z_base, z_top : float or None
        Heights of the lowest and the highest surface seen, metres.
    coverage : float
        Share of the outline along which surface was seen.
    """

    outline: Polygon
    kind: str
    body: int
    thickness: Optional[float]
    z_base: Optional[float]
    z_top: Optional[float]
    coverage: float


def describe_walls(
    bodies: Sequence[Polygon],
    parapets: Sequence[Polygon],
    uprights: UprightsAlong,
    storey: Storey,
    settings: WallSettings = WallSettings(),
    cut: CutSettings = CutSettings(),
    levels: LevelSettings = LevelSettings(),
) -> list[Wall]:
    """Cut bodies of walls into pieces and measure them.

    Parameters
    ----------
    bodies : sequence of Polygon
        Not overlapping; free of parapets.
    parapets : sequence of Polygon
    uprights : UprightsAlong
    storey : Storey
    settings, cut, levels : WallSettings, CutSettings, LevelSettings
    """
    measured = partial(_measured, uprights=uprights, storey=storey, settings=settings, cut=cut, levels=levels)
    walls = []
    for number, body in enumerate(bodies, start=1):
        column = measured(body, "column", number)
        if _is_column(column, settings):
            walls.append(column)
        else:
            walls += [measured(piece, "wall", number) for piece in cut_at_junctions(body, settings)]
    return walls + [measured(outline, "parapet", 0) for outline in parapets]


def _is_column(body: Wall, settings: WallSettings) -> bool:
    """Return whether a body is a column: small, compact, seen from most sides, and no strip."""
    outline = body.outline
    if outline.area > settings.column_m2 or body.coverage <= settings.column_coverage:
        return False
    width, length = box_sides(outline)
    is_compact = length <= settings.column_slenderness * width
    is_full = outline.area >= settings.column_fill * width * length
    return is_compact and is_full and not outline.buffer(-0.55 * settings.strip_m).is_empty


def _measured(
    outline: Polygon,
    kind: str,
    body: int,
    uprights: UprightsAlong,
    storey: Storey,
    settings: WallSettings,
    cut: CutSettings,
    levels: LevelSettings,
) -> Wall:
    edges = np.concatenate([_edges(ring) for ring in (outline.exterior, *outline.interiors)])
    length = np.hypot(edges[:, 2] - edges[:, 0], edges[:, 3] - edges[:, 1])
    bits, edge = uprights.stations(edges)
    filled = np.bincount(edge, count_levels(bits), len(edges)) / np.bincount(edge, minlength=len(edges))
    seen = filled >= cut.fewest_levels
    together = int(np.bitwise_or.reduce(bits[seen[edge]])) if seen.any() else 0
    base = top = None
    if together:
        base = storey.floor + levels.level_m * ((together & -together).bit_length() - 1)
        top = storey.floor + levels.level_m * together.bit_length()
    thickness = _thickness(edges[seen], length[seen], settings)
    coverage = float(length[seen].sum() / length.sum())
    return Wall(outline, kind, body, thickness, base, top, coverage)


def _edges(ring: LinearRing) -> np.ndarray:
    xy = np.asarray(ring.coords)
    return np.hstack([xy[:-1], xy[1:]])


def _thickness(edges: np.ndarray, length: np.ndarray, settings: WallSettings) -> Optional[float]:
    """Return the mean distance of parallel edges that face each other, weighted by how far they do."""
    total = weight = 0.0
    least = np.cos(np.radians(settings.opposite_deg))
    for i in range(len(edges)):
        along = (edges[i, 2:] - edges[i, :2]) / max(length[i], 1e-9)
        for j in range(len(edges)):
            other = (edges[j, 2:] - edges[j, :2]) / max(length[j], 1e-9)
            if along @ other > -least:
                continue
            near, far = sorted((edges[j, k : k + 2] - edges[i, :2]) @ along for k in (0, 2))
            overlap = min(far, length[i]) - max(near, 0.0)
            away = ((edges[j, :2] + edges[j, 2:]) / 2 - edges[i, :2]) @ np.array([-along[1], along[0]])
            if overlap > 0 and 1.5 * settings.strip_m < abs(away) <= settings.thickest_m:
                total += overlap * abs(away)
                weight += overlap
    return total / weight if weight else None
