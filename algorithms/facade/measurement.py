"""The measurement of a facade: from the points of a scan to an elevation."""

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import Optional

import numpy as np
from shapely.affinity import translate
from shapely.geometry import MultiPolygon, Polygon

from ..errors import NothingFoundError
from ..progress import Progress
from .colour.appearance import Appearance
from .colour.coloured_details import Coloured, find_coloured
from .colour.intensity_scale import make_relative
from .completion import complete_edges
from .elevation import (
    PROJECTION,
    Detail,
    Elevation,
    Frame,
    LeftOut,
    Plane,
    Points,
    Segmentation,
    WallPart,
    frame_of,
)
from .left_out import reason_against, surfaces_left_out
from .openings.content import Opening, fill_regions
from .openings.floors import divide_at_floors
from .openings.niches import with_niches
from .openings.parts import part_outlines
from .openings.regions import find_regions
from .openings.states import States, make_states
from .outlines.details import (
    Scene,
    TracedDetail,
    coloured_details,
    opening_details,
    projecting_details,
    stand_ins,
)
from .outlines.regular_outlines import Outline, make_outline
from .outlines.surface import Surface, make_surface
from .outlines.wall_extent import complete, parts_of
from .planes.front import EAST, WEST, Side
from .planes.segmentation import find_planes
from .settings import NO_REGIONS, FacadeSettings

MILLIMETRES = 3
"""Decimals of the position of u, v = 0, 0 on the wall."""


def measure_facade(
    points: Points,
    settings: FacadeSettings = FacadeSettings(),
    progress: Progress = Progress(),
    wanted: Optional[Plane] = None,
) -> Elevation:
    """Find the planes of a facade, and measure the details of the main one.

    Parameters
    ----------
    points : Points
    settings : FacadeSettings
    progress : Progress
    wanted : Plane, optional
        About the main plane of the facade; the largest upright plane is taken if not given.

    Raises
    ------
    NothingFoundError
        If there is no upright plane.
    """
    segmentation = find_planes(
        points, settings.distance_m, settings.planes, progress.part(0.0, 0.2), settings.side, wanted
    )
    frame = frame_of(segmentation.planes[0], points.origin)
    scene = Scene(frame.local(points.xyz, points.origin), segmentation.labels)
    side = segmentation.side
    progress.update(0.2, _facing(frame, side))
    with ThreadPoolExecutor(1) as pool:
        # The wall takes longest, most of it without the lock of Python, and is not needed before the borders
        # of the openings are traced.
        rows = np.flatnonzero(segmentation.labels == 1)
        found = pool.submit(make_surface, scene.uvw, rows, settings, progress)
        states = make_states(
            scene.uvw, segmentation.labels == 1, settings.distance_m, side.inner, settings.openings
        )
        regions = divide_at_floors(find_regions(states, settings.openings), states, settings.openings.floors)
        openings = fill_regions(states, regions, settings.openings.content)
        openings = with_niches(states, openings, points, settings.openings.niches)
        progress.update(0.25, "Tracing borders")
        traced = []
        for item in opening_details(scene, states, openings, settings):
            traced.append(item)
            progress.update(0.25 + 0.1 * len(traced) / len(openings))
        progress.update(0.35, "Triangulating the wall")
        wall = found.result()
    progress.update(
        0.6, f"The wall has points {1000 * wall.spacing:.1f} mm apart; alpha is {wall.alpha:.4f} m."
    )
    coloured = _coloured(points, wall, settings, progress)
    progress.update(0.75)
    empty = stand_ins(openings, wall.spacing)
    traced += coloured_details(scene, wall, coloured, empty, settings)
    projections = _projections(segmentation, settings)
    for label in projections:
        surface = make_surface(scene.uvw, np.flatnonzero(segmentation.labels == label), settings)
        traced += projecting_details(scene, label, surface, empty, settings)
    progress.update(0.85, "Making outlines")
    explained = _explained(states, openings)
    surfaces = surfaces_left_out(points, segmentation, projections, explained, frame, wall.spacing, settings)
    looks = coloured.looks
    return _elevation(
        points, scene, frame, wall, segmentation.side, states, traced, looks, tuple(surfaces), settings
    )


def _facing(frame: Frame, side: Side) -> str:
    number = EAST if frame.azimuth < 180 else WEST
    return (
        f"The facade faces azimuth {frame.azimuth:.1f} degrees, SIDE {number}, with a "
        f"certainty of {100 * side.sure:.0f} %, because {side.reason}."
    )


def _coloured(points: Points, wall: Surface, settings: FacadeSettings, progress: Progress) -> Coloured:
    """Return the coloured regions of the wall; without colour there is one."""
    if points.rgb is None or settings.coloured == NO_REGIONS:
        return Coloured(np.zeros(len(wall.rows), np.int32), None, 1, 1, np.nan)
    looks = _appearance(points, points.rgb[wall.rows], wall, settings, progress)
    coloured = find_coloured(wall.mesh, wall.linked, wall.sizes, looks, settings)
    progress.update(
        0.7,
        f"{coloured.regions} regions of one colour (SEED_VARIANCE {coloured.variance:.0f}) are "
        f"{coloured.surfaces} surfaces.",
    )
    return coloured


def _appearance(
    points: Points, rgb: np.ndarray, wall: Surface, settings: FacadeSettings, progress: Progress
) -> Appearance:
    """Return the colours of the wall, its relative intensities, and f."""
    if points.intensity is None:
        return Appearance(rgb)
    limits = settings.colour.intensity
    relative = make_relative(wall.mesh.points, points.intensity[wall.rows], points.scan[wall.rows], limits)
    low, high = relative.levels.min(), relative.levels.max()
    if high > limits.unequal * low:
        progress.update(
            0.62,
            f"The intensities of the {len(relative.levels)} scans have different levels ({low:.0f} to "
            f"{high:.0f}), so each scan is scaled by its own.",
        )
    threshold = relative.threshold if settings.intensity is None else settings.intensity
    progress.update(
        0.65, f"Intensities that differ by less than {threshold:.3f} of the wall's are one surface."
    )
    return Appearance(rgb, relative.values, threshold)


def _projections(segmentation: Segmentation, settings: FacadeSettings) -> list[int]:
    """Return the labels of the planes that lie in front of the wall and parallel to it."""
    main = segmentation.planes[0]
    return [
        label
        for label, plane in enumerate(segmentation.planes[1:], start=2)
        if plane.normal @ main.normal > np.cos(np.radians(settings.outlines.parallel_deg))
        and main.distances(plane.centre) > settings.distance_m
    ]


def _elevation(
    points: Points,
    scene: Scene,
    frame: Frame,
    wall: Surface,
    side: Side,
    states: States,
    traced: list[TracedDetail],
    looks: Optional[Appearance],
    surfaces: tuple[LeftOut, ...],
    settings: FacadeSettings,
) -> Elevation:
    large = [item for item in traced if _area(item) >= settings.smallest_m2]
    every = [(item, _outline(item, settings)) for item in large]
    reasons = [reason_against(item, outline, wall, looks, settings) for item, outline in every]
    made = [pair for pair, reason in zip(every, reasons) if reason is None]
    made = complete_edges(made, settings.completion)
    left_out = [
        *surfaces,
        *(
            LeftOut(outline.polygon, item.kind, reason, _area(item))
            for (item, outline), reason in zip(every, reasons)
            if reason is not None
        ),
    ]
    outlines: dict[str, list[Polygon]] = {}
    for item, outline in made:
        outlines.setdefault(item.kind, []).append(outline.polygon)
    deepest = max((item.depth for item in large if item.kind == PROJECTION), default=0.0)
    parts = part_outlines(states)
    whole = complete(wall, outlines, deepest, settings.smallest_m2, settings.outlines.wall, parts)
    face, unseen = whole.face, whole.unseen
    if face.is_empty:
        raise NothingFoundError(
            f"No part of the wall is as large as {settings.smallest_m2:g} m²; decrease MIN_AREA, or increase "
            "ALPHA."
        )
    left, bottom = np.round(np.array(face.bounds[:2]), MILLIMETRES)
    moved = Frame(frame.world([[left, bottom, 0.0]])[0], frame.azimuth, frame.tilt)
    details = [
        _detail(points, states, item, _moved(outline, -left, -bottom), -left, -bottom)
        for item, outline in made
    ]
    details.sort(key=lambda detail: _rank(detail, settings.row_m))
    return Elevation(
        moved,
        MultiPolygon(parts_of(translate(face, -left, -bottom))),
        tuple(replace(detail, number=number) for number, detail in enumerate(details, start=1)),
        tuple(translate(part, -left, -bottom) for part in unseen),
        wall.spacing,
        _shown(scene, settings),
        (*_doubts(side, frame, settings), *_limits(points, settings)),
        tuple(
            replace(item, shape=translate(item.shape, -left, -bottom))
            for item in sorted(left_out, key=lambda item: -item.area)
        ),
        side,
        tuple(
            WallPart(layer.depth, float(layer.image.sum()) * states.grid.size**2) for layer in states.layers
        ),
    )


def _explained(states: States, openings: list[Opening]) -> np.ndarray:
    """Return which points lie on the wall or in an opening."""
    explained = states.on_wall.copy()
    for opening in openings:
        explained[opening.inside] = True
    return explained


def _area(item: TracedDetail) -> float:
    return float(item.border.ring.area if item.opening is None else item.opening.polygon.area)


def _raw(item: TracedDetail) -> Polygon:
    """Return the border as traced; at the ground or the edge of a wall it is not closed, but the hole is."""
    ring = item.border.ring
    if item.opening is not None and ring.area < 0.5 * item.opening.polygon.area:
        return item.opening.polygon
    return ring


def _outline(item: TracedDetail, settings: FacadeSettings) -> Outline:
    region = None if item.opening is None else item.opening.polygon
    return make_outline(item.border, settings.regularise, settings.outlines, region)


def _rank(detail: Detail, row: float) -> tuple[float, float, str]:
    """Return what details are numbered by: row by row from above, then from the left."""
    centre = detail.outline.centroid
    return -(centre.y // row), centre.x, detail.kind


def _doubts(side: Side, frame: Frame, settings: FacadeSettings) -> Iterator[str]:
    """Yield a warning if the facade may be drawn mirrored, as it is seen from inside."""
    if side.sure < settings.planes.side.doubtful:
        yield (
            f"It is uncertain from which side the facade is seen: azimuth {frame.azimuth:.0f} degrees was "
            f"taken, because {side.reason}. If the elevation is mirrored, set SIDE to "
            f"{WEST if frame.azimuth < 180 else EAST}."
        )


def _limits(points: Points, settings: FacadeSettings) -> Iterator[str]:
    """Yield what could not be done with the points, in sentences."""
    if settings.coloured == NO_REGIONS:
        return
    if points.rgb is None:
        yield "The points have no colour, so only openings, recesses and projections are found."
    elif points.intensity is None:
        yield (
            "The points have no intensity, so a cast shadow can appear as a coloured detail; check the "
            "coloured details."
        )


def _moved(outline: Outline, u: float, v: float) -> Outline:
    return replace(outline, polygon=translate(outline.polygon, u, v))


def _detail(
    points: Points, states: States, item: TracedDetail, outline: Outline, u: float, v: float
) -> Detail:
    return Detail(
        number=0,
        kind=item.kind,
        shape=outline.shape,
        outline=outline.polygon,
        raw=translate(_raw(item), u, v),
        edges=outline.edges,
        rms=outline.rms,
        depth=item.depth,
        points=len(item.rows),
        colour=_mean_colour(points.rgb, item.rows),
        intensity=_mean_intensity(points.intensity, item.rows),
        head=outline.head,
        use=None if item.opening is None else item.opening.use,
        open_sides=() if item.opening is None else item.opening.open_sides,
        completed=outline.completed,
        layer=0.0 if item.opening is None else states.layers[item.opening.layer].depth,
    )


def _mean_colour(rgb: Optional[np.ndarray], rows: np.ndarray) -> Optional[tuple[float, float, float]]:
    if rgb is None or not len(rows):
        return None
    red, green, blue = (float(value) for value in rgb[rows].mean(axis=0, dtype=float))
    return red, green, blue


def _mean_intensity(intensity: Optional[np.ndarray], rows: np.ndarray) -> Optional[float]:
    if intensity is None or not len(rows):
        return None
    return float(intensity[rows].mean(dtype=float))


def _shown(scene: Scene, settings: FacadeSettings) -> np.ndarray:
    """Return the rows of the points on the planes of the facade, and of those at most its depth behind."""
    w, labels = scene.uvw[:, 2], scene.labels
    near = (w < settings.distance_m) & (w > -settings.planes.depth_m)
    return np.flatnonzero((labels > 0) | ((labels == 0) & near))
