"""The planes of a facade as a layer in space."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any, Optional

import numpy as np
from rasterio.crs import CRS
from shapely.geometry import MultiPolygon

from ...geometry.triangulation import triangulate
from ...vector import write_vector
from ..elevation import Frame, Plane, Points, Segmentation, frame_of
from ..outlines.alpha_shape import alpha_shape
from ..planes.voxels import square_means
from .elevation_layers import in_space

PLANE_FIELDS = {
    "plane": "int",
    "nx": "float:18.15",
    "ny": "float:18.15",
    "nz": "float:18.15",
    "distance": "float:24.10",
    "azimuth": "float:18.12",
    "tilt": "float:18.12",
    "rms": "float:12.5",
    "points": "int",
    "area": "float:14.4",
}
"""Fields of the layer; nx x + ny y + nz z + distance = 0 in the coordinates of the site."""


def write_planes(
    path: Path, points: Points, segmentation: Segmentation, spacing: float, crs: Optional[CRS]
) -> None:
    """Write the outline of each plane in space.

    Parameters
    ----------
    path : Path
    points : Points
    segmentation : Segmentation
    spacing : float
        Of the averaged points through which the outlines run (m).
    crs : CRS or None

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    write_vector(path, "3D MultiPolygon", PLANE_FIELDS, _features(points, segmentation, spacing), crs)


def _features(
    points: Points, segmentation: Segmentation, spacing: float
) -> Iterator[tuple[MultiPolygon, dict[str, Any]]]:
    for number, plane in enumerate(segmentation.planes, start=1):
        frame = frame_of(plane, points.origin)
        uvw = frame.local(points.xyz[segmentation.labels == number], points.origin)
        outline = alpha_shape(triangulate(square_means(uvw[:, :2], spacing)))
        yield in_space(outline, frame), _values(number, plane, points.origin, outline, frame)


def _values(
    number: int, plane: Plane, origin: np.ndarray, outline: MultiPolygon, frame: Frame
) -> dict[str, Any]:
    nx, ny, nz = (float(value) for value in plane.normal)
    return {
        "plane": number,
        "nx": nx,
        "ny": ny,
        "nz": nz,
        "distance": -float(plane.normal @ (plane.centre + origin)),
        "azimuth": frame.azimuth,
        "tilt": frame.tilt,
        "rms": plane.rms,
        "points": plane.points,
        "area": outline.area,
    }
