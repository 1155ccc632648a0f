"""Lists of points: surveyed control points, and targets picked in a scan."""

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Optional, Union

import numpy as np
from rasterio.crs import CRS

from ...clouds.formats import format_of
from ...clouds.formats.coordinate_steps import rounding_warning, step_warning, unit_warning
from ...clouds.settings import PrecisionSettings
from ...clouds.source import unreadable
from ...errors import InputError
from .point_layer import LOWEST_M, SUFFIXES, Feature, list_name, read_features, read_layer
from .point_rows import Rows
from .point_text import read_text
from .settings import ListSettings


@dataclass(frozen=True)
class PointList:
    """Named points.

    Attributes
    ----------
    name : str
        Of the list; for a scan, the stem of its file.
    names : tuple of str
        Of the points, each once; the 1-based row where the file has no names.
    xyz : ndarray of float64, shape (n, 3)
        Metres.
    named : bool
        Whether the names are the file's own.
    crs : CRS or None
        That of the file.
    warnings : tuple of str
        What the user should know about the file, in sentences.
    path : Path or None
        The file it was read from, if any.
    origins : tuple of str
        The scan that each point comes from, if an earlier registration appended it; empty if surveyed. Empty
        for lists that do not say so.
    stds : ndarray of float64, shape (n,), or None
        Standard deviations of a coordinate, metres, where the list has them, else nan.
    covariances : ndarray of float64, shape (n, 3, 3), or None
        Of the coordinates of targets, square metres, where the list has them, else nan.
    """

    name: str
    names: tuple[str, ...]
    xyz: np.ndarray
    named: bool = True
    crs: Optional[CRS] = None
    warnings: tuple[str, ...] = ()
    path: Optional[Path] = None
    origins: tuple[str, ...] = ()
    stds: Optional[np.ndarray] = None
    covariances: Optional[np.ndarray] = None

    @property
    def has_covariances(self) -> bool:
        """Whether any point has a covariance of its own."""
        return self.covariances is not None and bool(np.isfinite(self.covariances).any())

    def covariances_of(self, rows: np.ndarray) -> Optional[np.ndarray]:
        """Return the covariances of some points, shape (k, 3, 3); None if the list has none."""
        return None if self.covariances is None else self.covariances[rows]


def read_point_list(
    path: Union[str, Path], layer: Optional[str] = None, settings: ListSettings = ListSettings()
) -> PointList:
    """Read a list of points from a text file or a vector layer, by extension.

    Parameters
    ----------
    path : str or Path
        A shapefile, GeoPackage, GeoJSON or FlatGeobuf of points with heights; anything else is text with
        the columns x y z or name x y z, or with a header.
    layer : str, optional
        Which layer of a GeoPackage.
    settings : ListSettings

    Raises
    ------
    InputError
        If the file cannot be read, holds no points or can be read in more than one way, if its coordinates
        are not metres, or if two points have the same name.
    """
    path = Path(path)
    try:
        is_layer = path.suffix.lower() in SUFFIXES
        rows = read_layer(path, layer, settings) if is_layer else read_text(path, settings)
        name = list_name(path, layer) if is_layer else path.stem
    except OSError as error:
        raise unreadable(path, error) from error
    return _point_list(name, rows, path, settings)


def is_cloud(path: Union[str, Path], settings: ListSettings = ListSettings()) -> bool:
    """Return whether a file is a point cloud and not a list: by its extension, or by its number of lines.

    A file that cannot be opened is not a cloud; reading it as a list says why.
    """
    path = Path(path)
    known = format_of(path)
    if known is None or not known.is_text:
        return known is not None
    try:
        with path.open("rb") as lines:
            return sum(1 for _ in islice(lines, settings.most_points + 1)) > settings.most_points
    except OSError:
        return False


def points_of_features(
    name: str,
    source: str,
    features: Iterable[Feature],
    wkt: str,
    path: Optional[Path] = None,
    settings: ListSettings = ListSettings(),
) -> PointList:
    """Make a list of the features of a layer that a program has open.

    Parameters
    ----------
    name : str
        Of the list.
    source : str
        What messages call the layer.
    features : iterable of (tuple of float or None, dict)
        For each feature its coordinates, two or three, None if it is not a single point; and its
        attributes by field, None for null.
    wkt : str
        The coordinate reference system; empty if unknown.
    path : Path, optional
        The file of the layer.
    settings : ListSettings

    Raises
    ------
    InputError
        As `read_point_list`.
    """
    return _point_list(name, read_features(source, features, wkt, settings), path, settings)


def _point_list(name: str, rows: Rows, path: Optional[Path], settings: ListSettings) -> PointList:
    kept, merged = _distinct(rows)
    names = tuple(str(row) for row in range(1, len(rows.xyz) + 1)) if rows.names is None else rows.names
    return PointList(
        name=name,
        names=tuple(names[row] for row in kept),
        xyz=rows.xyz[kept],
        named=rows.names is not None,
        crs=rows.crs,
        warnings=(
            *rows.warnings,
            *merged,
            *step_warning(Path(rows.source), rows.xyz),
            *(
                unit_warning(Path(rows.source), rows.xyz, rows.unit_stated)
                or (() if rows.unit_stated else _rounded(Path(rows.source), rows.xyz[:, :2], settings))
            ),
            *_unknown_heights(rows.source, [names[row] for row in kept], rows.xyz[kept, 2]),
        ),
        path=path,
        origins=tuple(rows.origins[row] for row in kept) if rows.origins else (),
        stds=None if rows.stds is None else rows.stds[kept],
        covariances=None if rows.covariances is None else rows.covariances[kept],
    )


def _rounded(source: Path, xy: np.ndarray, settings: ListSettings) -> tuple[str, ...]:
    """Return a sentence on national coordinates without decimals, as a spreadsheet writes 5.81E+06.

    Heights alone are often known to the metre only, and one coordinate may be whole by chance.
    """
    steps = xy / settings.coarsest_step_m
    if np.abs(xy).max() < settings.largest_local_m or not np.allclose(steps, np.rint(steps), 0, 1e-6):
        return ()
    coarse = PrecisionSettings(
        fewest_rounded=settings.fewest_rounded,
        fewest_steps=settings.fewest_rounded,
        coarsest_scale_m=settings.coarsest_step_m,
    )
    return rounding_warning(source, xy, settings=coarse)


def _unknown_heights(source: str, names: list[str], heights: np.ndarray) -> tuple[str, ...]:
    """Return a sentence if heights stand for ones that are not known."""
    unknown = [name for name, height in zip(names, heights) if height < LOWEST_M]
    if not unknown:
        return ()
    return (
        f"The height of {', '.join(unknown[:3])} in {source} is below {LOWEST_M:.0f} m, as of a point "
        "whose height is not known; correct it, or leave the point out.",
    )


def _distinct(rows: Rows) -> tuple[list[int], tuple[str, ...]]:
    """Return the rows to keep, and a warning if a point is listed more than once."""
    if rows.names is None:
        return list(range(len(rows.xyz))), ()
    seen: dict[str, int] = {}
    repeated: dict[str, None] = {}
    for row, name in enumerate(rows.names):
        first = seen.setdefault(name, row)
        if not np.array_equal(rows.xyz[first], rows.xyz[row]):
            raise InputError(
                f"Two points of {rows.source} are called {name}, in {rows.places[first]} and "
                f"{rows.places[row]}; rename or remove one of them."
            )
        if first != row:
            repeated[name] = None
    if not repeated:
        return list(seen.values()), ()
    listed = ", ".join(repeated)
    return list(seen.values()), (f"Points of {rows.source} that are listed repeatedly count once: {listed}.",)
