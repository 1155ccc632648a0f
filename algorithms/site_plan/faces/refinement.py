"""Outlines on the faces of the walls, instead of outlines of pixels (beyond the paper)."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import chain

import numpy as np
from affine import Affine
from shapely.affinity import translate
from shapely.geometry import Point, Polygon
from shapely.geometry.polygon import orient
from skimage.measure import points_in_poly

from ...errors import NothingFoundError
from ...geometry.polygons import polygons_between, polygons_of
from ...progress import Progress
from ..density.density_image import DensityImage, SortedPoints
from ..walls.pixel_outlines import overlaps
from ..walls.wall import Wall, band_length
from .face import Face
from .face_outline import redraw
from .face_points import FacePoints, gather_face_points
from .hidden_faces import move_hidden_faces
from .ring_faces import RingFaces, find_faces
from .settings import FaceSettings
from .wall_measures import measure


def refine_on_points(
    walls: Sequence[Wall],
    pixels: np.ndarray,
    points: SortedPoints,
    image: DensityImage,
    progress: Progress = Progress(),
    settings: FaceSettings = FaceSettings(),
) -> tuple[tuple[Wall, ...], int]:
    """Gather the points near the pixels of walls, and move outlines onto the faces as `refine_walls` does."""
    near = gather_face_points(points, image, pixels, progress.part(0.0, 0.5), settings.points)
    return refine_walls(walls, near, image.density, image.transform, progress.part(0.5, 1.0), settings)


def refine_walls(
    walls: Sequence[Wall],
    points: FacePoints,
    density: np.ndarray,
    transform: Affine,
    progress: Progress = Progress(),
    settings: FaceSettings = FaceSettings(),
) -> tuple[tuple[Wall, ...], int]:
    """Move the outlines of walls onto the faces that the points show, and measure the walls by them.

    Parameters
    ----------
    walls : sequence of Wall
        With outlines of pixels.
    points : FacePoints
        Near them, relative to the lower left corner of the image.
    density : ndarray of float, shape (rows, columns)
        Nan where no point contributes.
    transform : Affine
        From (column, row) to world coordinates.
    progress : Progress
        Reports and cancels.
    settings : FaceSettings

    Returns
    -------
    walls : tuple of Wall
    foliage : int
        Number of walls that were left out because their points lie on no face.

    Raises
    ------
    NothingFoundError
        If no wall has a face, although there are points enough for one.
    """
    size, height = transform.a, density.shape[0]
    origin = transform.c, transform.f - height * size
    local = Affine(size, 0.0, 0.0, 0.0, -size, height * size)
    held = np.isfinite(density)
    found: list[Wall] = []
    foliage = 0
    for number, wall in enumerate(walls):
        progress.update(number / len(walls), "Fitting faces")
        pixels = orient(translate(wall.outline, -origin[0], -origin[1]))
        rings = [
            find_faces(np.asarray(ring.coords), points, local.a, settings)
            for ring in (pixels.exterior, *pixels.interiors)
        ]
        refined = _refined(wall, rings, held, local, origin, settings)
        least, fewest = settings.refinement.foliage_coverage, settings.ridges.fewest_voxels
        has_faces = any(part.coverage is None or part.coverage >= least for part in refined)
        if has_faces or not _is_full(rings, pixels, points, fewest):
            found += refined
        else:
            foliage += 1
    if not found:
        raise NothingFoundError(
            "No wall found: no wall face could be fitted; switch REFINE off to keep the outlines of pixels."
        )
    apart = _apart(found)
    return tuple(replace(wall, wall_id=number) for number, wall in enumerate(apart, start=1)), foliage


def _is_full(rings: list[RingFaces], pixels: Polygon, points: FacePoints, fewest: int) -> bool:
    """Return whether an outline encloses points enough for a face all around."""
    stations = np.concatenate([ring.stations.xy for ring in rings])
    near = points.xy[points.near(stations)]
    return bool(points_in_poly(near, np.asarray(pixels.exterior.coords)).sum() >= fewest * len(stations))


def _refined(
    wall: Wall,
    rings: list[RingFaces],
    held: np.ndarray,
    local: Affine,
    origin: tuple[float, float],
    settings: FaceSettings,
) -> list[Wall]:
    """Return the wall with its outline on the faces; if that comes apart, each part is a wall."""
    bias = settings.outline.bias_px * local.a
    if not any(ring.faces for ring in rings):
        return [replace(wall, outline=_unbiased(wall.outline, bias), coverage=0.0)]
    rings = move_hidden_faces(rings, held, local, settings.hidden)
    corners, faces = zip(*(redraw(ring, local.a, settings.outline) for ring in rings))
    within = wall.outline.buffer(settings.refinement.outside_px * local.a, join_style=2)
    parts = polygons_between(corners, origin, within)
    every = [*chain.from_iterable(faces)]
    return [_measured(wall, part, every, origin, settings) for part in parts] or [wall]


def _measured(
    wall: Wall, outline: Polygon, faces: list[Face], origin: tuple[float, float], settings: FaceSettings
) -> Wall:
    """Return a wall with an outline, measured by those of the faces that run along it."""
    own = translate(outline, -origin[0], -origin[1])
    around = own.buffer(settings.refinement.beside_m)
    along = [face for face in faces if around.contains(Point(face.curve.at((face.start + face.stop) / 2)))]
    measures = measure(along, own, settings.measures)
    azimuth = measures.azimuth if wall.kind == "straight" else None
    return replace(
        wall, outline=outline, length=band_length(outline), **{**vars(measures), "azimuth": azimuth}
    )


def _unbiased(outline: Polygon, bias: float) -> Polygon:
    """Return an outline of pixels freed of its bias (m), unless nothing would be left of it."""
    inner = outline.buffer(-bias, join_style=2)
    return inner if inner.geom_type == "Polygon" and not inner.is_empty else outline


def _apart(walls: list[Wall]) -> list[Wall]:
    """Cut from walls what they share with others before them."""
    outlines = {number: wall.outline for number, wall in enumerate(walls)}
    for one, other in overlaps(outlines):
        first, second = sorted((one, other))
        parts = polygons_of(outlines[second].difference(outlines[first]))
        outlines[second] = max(parts, key=lambda part: part.area, default=outlines[second])
    return [replace(wall, outline=outlines[number]) for number, wall in enumerate(walls)]
