"""Outlines on the faces of the walls, in place of outlines of pixels (beyond the paper)."""

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
from .face_outline import INSIDE, redraw
from .face_points import FacePoints, gather_face_points
from .hidden_faces import tell_backs
from .ridges import FEWEST
from .ring_faces import find_sides
from .wall_measures import measure

OUTSIDE = 0.75
"""No face is looked for so many pixels outside an outline of pixels; what a ring encloses there is none."""

BESIDE = 0.03
"""A side whose middle is no farther than this (m) from an outline runs along it."""

NO_FACE = 0.1
"""Where less than this share of an outline has a face, though there are enough points for one all around, the
points lie in no surface: they are foliage."""


def refine_on_points(
    walls: Sequence[Wall],
    pixels: np.ndarray,
    points: SortedPoints,
    image: DensityImage,
    progress: Progress = Progress(),
) -> tuple[tuple[Wall, ...], int]:
    """Gather the points near the pixels of walls, and move outlines onto the faces as `refine_walls` does."""
    near = gather_face_points(points, image, pixels, progress.part(0.0, 0.5))
    return refine_walls(walls, near, image.density, image.transform, progress.part(0.5, 1.0))


def refine_walls(
    walls: Sequence[Wall],
    points: FacePoints,
    density: np.ndarray,
    transform: Affine,
    progress: Progress = Progress(),
) -> tuple[tuple[Wall, ...], int]:
    """Move the outlines of walls onto the faces that the points show, and measure the walls by them.

    Parameters
    ----------
    walls : sequence of Wall
        With outlines of pixels.
    points : FacePoints
        Near them, relative to the lower left corner of the image.
    density : ndarray of float, shape (rows, columns)
        Nan where there is none.
    transform : Affine
        From (column, row) to world coordinates.
    progress : Progress
        Reports and cancels.

    Returns
    -------
    walls : tuple of Wall
    foliage : int
        Number of walls that were left out because their points lie on no face.

    Raises
    ------
    NothingFoundError
        If no wall has a face, where there are points enough for one.
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
            find_sides(np.asarray(ring.coords), points, local.a)
            for ring in (pixels.exterior, *pixels.interiors)
        ]
        refined = _refined(wall, rings, held, local, origin)
        if any(part.coverage is None or part.coverage >= NO_FACE for part in refined) or not _is_full(
            rings, pixels, points
        ):
            found += refined
        else:
            foliage += 1
    if not found:
        raise NothingFoundError(
            "No wall found: none of what stands there has a face; REFINE=no gives the outlines of the pixels."
        )
    apart = _apart(found)
    return tuple(replace(wall, wall_id=number) for number, wall in enumerate(apart, start=1)), foliage


def _is_full(rings: list, pixels: Polygon, points: FacePoints) -> bool:
    """Tell whether there are so many points within an outline that there would be a face all around."""
    places = np.concatenate([ring.places.xy for ring in rings])
    near = points.xy[points.near(places)]
    return bool(points_in_poly(near, np.asarray(pixels.exterior.coords)).sum() >= FEWEST * len(places))


def _refined(wall: Wall, rings: list, held: np.ndarray, local: Affine, origin: tuple) -> list:
    """Return the wall with its outline on the faces; where that comes apart, each part is a wall."""
    if not any(ring.sides for ring in rings):
        return [replace(wall, outline=_unbiased(wall.outline, local.a), coverage=0.0)]
    rings = tell_backs(rings, held, local)
    corners, sides = zip(*(redraw(ring, local.a) for ring in rings))
    within = wall.outline.buffer(OUTSIDE * local.a, join_style=2)
    parts = polygons_between(corners, origin, within)
    return [_measured(wall, part, [*chain.from_iterable(sides)], origin) for part in parts] or [wall]


def _measured(wall: Wall, outline: Polygon, sides: list, origin: tuple) -> Wall:
    """Return a wall with an outline, measured by those of the sides that run along it."""
    own = translate(outline, -origin[0], -origin[1])
    around = own.buffer(BESIDE)
    along = [side for side in sides if around.contains(Point(side.curve.at((side.start + side.stop) / 2)))]
    measures = measure(along, own)
    azimuth = measures.azimuth if wall.kind == "straight" else None
    return replace(
        wall, outline=outline, length=band_length(outline), **{**vars(measures), "azimuth": azimuth}
    )


def _unbiased(outline: Polygon, pixel_size: float) -> Polygon:
    """Return an outline of pixels freed of its bias, unless nothing would be left of it."""
    inner = outline.buffer(-INSIDE * pixel_size, join_style=2)
    return inner if inner.geom_type == "Polygon" and not inner.is_empty else outline


def _apart(walls: list) -> list:
    """Cut from walls what they share with others before them."""
    outlines = {number: wall.outline for number, wall in enumerate(walls)}
    for one, other in overlaps(outlines):
        first, second = sorted((one, other))
        parts = polygons_of(outlines[second].difference(outlines[first]))
        outlines[second] = max(parts, key=lambda part: part.area, default=outlines[second])
    return [replace(wall, outline=outlines[number]) for number, wall in enumerate(walls)]
