"""Measure the details of a facade: from the points of a scan to an elevation."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from shapely.affinity import translate
from shapely.geometry import MultiPolygon

from ..progress import Progress
from .colour.appearance import Appearance
from .colour.coloured_details import Coloured, find_coloured
from .colour.intensity_scale import make_relative
from .elevation import PROJECTION, Detail, Elevation, Frame, Points, Segmentation, frame_of
from .outlines.details import Found, Scene, coloured_details, empty_places, hole_details, projecting_details
from .outlines.holes import NEAR, Hole, classify, find_gaps
from .outlines.regular_outlines import make_outline
from .outlines.surface import Surface, make_surface
from .outlines.wall_extent import complete, parts_of
from .planes.segmentation import find_planes
from .settings import Settings

PARALLEL = 10.0
"""Planes before the wall are turned against it by less (degrees)."""

FARTHEST = 6.0
"""What lies further behind the wall tells nothing of it (m)."""

MILLIMETRES = 3
"""Decimals of the place of u, v = 0, 0 against the wall."""

UNEQUAL = 1.2
"""Levels of intensity whose ratio is larger are said to differ."""

ROW = 0.5
"""Details are numbered row by row, from above, in rows of this height (m)."""


def measure_facade(points: Points, settings: Settings, progress: Progress = Progress()) -> Elevation:
    """Find the planes of a facade, and measure what the main one holds.

    Parameters
    ----------
    points : Points
    settings : Settings
    progress : Progress

    Raises
    ------
    NothingFoundError
        If there is no upright plane.
    """
    segmentation = find_planes(points, settings.distance, progress=progress.part(0.0, 0.2))
    frame = frame_of(segmentation.planes[0], points.origin)
    scene = Scene(frame.local(points.xyz, points.origin), segmentation.labels)
    progress.update(0.2, "Triangulating the wall")
    wall = make_surface(scene.uvw, np.flatnonzero(segmentation.labels == 1), settings)
    progress.update(
        0.45, f"The wall has points {1000 * wall.spacing:.1f} mm apart; alpha is {wall.alpha:.4f} m."
    )
    coloured = _coloured(points, wall, settings, progress)
    progress.update(0.65, "Telling openings from shadows")
    holes = _holes(scene, wall, settings)
    found = [*hole_details(scene, wall, holes, settings)]
    empty = empty_places(holes, wall.spacing)
    found += coloured_details(scene, wall, coloured, empty, settings)
    for label in _before(segmentation, settings):
        surface = make_surface(scene.uvw, np.flatnonzero(segmentation.labels == label), settings)
        found += projecting_details(scene, label, surface, empty, settings)
    progress.update(0.85, "Making outlines")
    return _elevation(points, scene, frame, wall, holes, found, settings)


def _coloured(points: Points, wall: Surface, settings: Settings, progress: Progress) -> Coloured:
    """Return the coloured regions of the wall; one region if the points have no colour."""
    if points.rgb is None:
        return Coloured(np.zeros(len(wall.rows), np.int32), None, 1, 1, np.nan)
    looks = _appearance(points, wall, settings, progress)
    coloured = find_coloured(wall.mesh, wall.linked, wall.sizes, looks, settings)
    progress.update(
        0.65,
        f"{coloured.regions} regions of one colour (SEED_VARIANCE {coloured.variance:.0f}) are "
        f"{coloured.surfaces} surfaces.",
    )
    return coloured


def _appearance(points: Points, wall: Surface, settings: Settings, progress: Progress) -> Appearance:
    """Return the colours of the wall, its relative intensities, and f."""
    rgb = points.rgb[wall.rows]
    if points.intensity is None:
        return Appearance(rgb)
    relative = make_relative(wall.mesh.points, points.intensity[wall.rows], points.scan[wall.rows])
    low, high = relative.levels.min(), relative.levels.max()
    if high > UNEQUAL * low:
        progress.update(
            0.48,
            f"The intensities of {len(relative.levels)} scans differ in level ({low:.0f} to {high:.0f}), so "
            "each is compared with its own.",
        )
    threshold = relative.automatic_threshold if settings.intensity is None else settings.intensity
    progress.update(
        0.5, f"Intensities that differ by less than {threshold:.3f} of the wall's are one surface."
    )
    return Appearance(rgb, relative.values, threshold)


def _holes(scene: Scene, wall: Surface, settings: Settings) -> list[Hole]:
    w = scene.uvw[:, 2]
    behind = scene.uvw[(scene.labels >= 0) & (w < -settings.distance) & (w > -FARTHEST)]
    gaps = find_gaps(wall.outline, settings.smallest_area)
    return [classify(gap, behind, settings.distance, wall.spacing) for gap in gaps]


def _before(segmentation: Segmentation, settings: Settings) -> list[int]:
    """Return the labels of the planes that lie before the wall and along it."""
    main = segmentation.planes[0]
    return [
        label
        for label, plane in enumerate(segmentation.planes[1:], start=2)
        if plane.normal @ main.normal > np.cos(np.radians(PARALLEL))
        and main.distances(plane.centre) > settings.distance
    ]


def _elevation(
    points: Points,
    scene: Scene,
    frame: Frame,
    wall: Surface,
    holes: list[Hole],
    found: list[Found],
    settings: Settings,
) -> Elevation:
    made = [
        (item, make_outline(item.border, settings.regularise)) for item in found if _is_large(item, settings)
    ]
    outlines: dict[str, list] = {}
    for item, outline in made:
        outlines.setdefault(item.kind, []).append(outline.polygon)
    deepest = max((item.depth for item, _ in made if item.kind == PROJECTION), default=0.0)
    whole = complete(wall, holes, outlines, deepest, settings.smallest_area)
    face, unseen = whole.face, whole.unseen
    left, bottom = np.round(np.array(face.bounds[:2]), MILLIMETRES)
    moved = Frame(frame.world([[left, bottom, 0.0]])[0], frame.azimuth, frame.tilt)
    details = [
        _detail(points, item, _moved(outline, -left, -bottom), -left, -bottom) for item, outline in made
    ]
    details.sort(
        key=lambda detail: (-(detail.outline.centroid.y // ROW), detail.outline.centroid.x, detail.kind)
    )
    return Elevation(
        moved,
        MultiPolygon(parts_of(translate(face, -left, -bottom))),
        tuple(replace(detail, number=number) for number, detail in enumerate(details, start=1)),
        tuple(translate(part, -left, -bottom) for part in unseen),
        wall.spacing,
        _shown(scene, settings),
        tuple(_lacking(points)),
    )


def _lacking(points: Points) -> Iterator[str]:
    """Yield what could not be done with the points, in sentences."""
    if points.rgb is None:
        yield "The points have no colour, so only openings, recesses and projections were looked for."
    elif points.intensity is None:
        yield (
            "The points have no intensity, so the edge of a cast shadow cannot be told from that of a "
            "detail; check the coloured details."
        )


def _is_large(item: Found, settings: Settings) -> bool:
    return item.border.ring.area >= settings.smallest_area


def _moved(outline, u: float, v: float):
    """Return an outline, moved."""
    return replace(outline, polygon=translate(outline.polygon, u, v))


def _detail(points: Points, item: Found, outline, u: float, v: float) -> Detail:
    rgb = (
        None if points.rgb is None or not len(item.rows) else points.rgb[item.rows].mean(axis=0, dtype=float)
    )
    intensity = points.intensity
    return Detail(
        number=0,
        kind=item.kind,
        shape=outline.shape,
        outline=outline.polygon,
        raw=translate(item.border.ring, u, v),
        edges=outline.edges,
        rms=outline.rms,
        depth=item.depth,
        points=len(item.rows),
        colour=None if rgb is None else tuple(float(value) for value in rgb),
        intensity=None
        if intensity is None or not len(item.rows)
        else float(intensity[item.rows].mean(dtype=float)),
    )


def _shown(scene: Scene, settings: Settings) -> np.ndarray:
    """Return the rows of the points on the planes of the facade, and not far behind the main one."""
    w = scene.uvw[:, 2]
    return np.flatnonzero((scene.labels > 0) | ((scene.labels == 0) & (w < settings.distance) & (w > -NEAR)))
