"""Lists of points as vector layers: points with Z, or with a field of heights."""

import codecs
import sqlite3
from collections.abc import Iterable, Iterator
from contextlib import closing, contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any, Optional

import fiona
import numpy as np

from ...errors import CancelledError, InputError
from ...reference_systems import parse_layer_wkt
from ...shapefile import lacks_table, refuse_damaged
from ...tables.column_names import POINTS, recognised, simplified
from ...tables.header import metres_of
from ...tables.units import unit_of
from .covariances import CORRELATIONS, STDS, covariances_of, warnings_on
from .point_rows import Rows
from .settings import ListSettings

Attributes = dict[str, Any]
Feature = tuple[Optional[tuple[float, ...]], Attributes]
"""Coordinates, None if they are not those of a single point, and attributes by field, None for null."""

CONTROL_OUT = {"name", "origin", "seen_by", *STDS}
"""Fields by which the control points of an earlier registration are known."""

SURVEYED = "surveyed"

LOWEST_M = -1000.0
"""No surveyed point is lower; what is, stands for a height that is not known."""

SUFFIXES = (".shp", ".gpkg", ".geojson", ".json", ".fgb")


def read_layer(path: Path, layer: Optional[str], settings: ListSettings = ListSettings()) -> Rows:
    """Read a list of points from a file of vector layers.

    Raises
    ------
    InputError
        If the file holds no such layers, if it has several layers of points and `layer` names none of
        them, or if the features are not points with heights in metres.
    OSError
        If the system refuses to read it.
    """
    with _opened(path, layer) as features:
        rows = read_features(str(path), map(_point_and_attributes, features), features.crs_wkt, settings)
    if not lacks_table(path):
        return rows
    said = f"{path} has no table (.dbf) beside it, so its points have no names; copy all its parts."
    return replace(rows, warnings=(*rows.warnings, said))


def list_name(path: Path, layer: Optional[str]) -> str:
    """Return the stem of the file, or the layer's name if the file has several layers of points."""
    with _gdal_errors_named(path):
        return layer if layer and len(_point_layers(path)) > 1 else path.stem


def read_features(
    source: str, features: Iterable[Feature], wkt: str, settings: ListSettings = ListSettings()
) -> Rows:
    """Make rows of features; see `point_list.points_of_features`.

    Raises
    ------
    InputError
        If they are not points with heights in metres, or more than a list has.
    """
    points: list[tuple[float, ...]] = []
    attributes: list[Attributes] = []
    for number, (point, values) in enumerate(features, start=1):
        if point is None:
            raise InputError(f"Feature {number} of {source} is not a single point; remove it or split it up.")
        if number > settings.most_points:
            raise InputError(
                f"{source} has more than {settings.most_points} points, too many for a list; choose the "
                "list, not a cloud."
            )
        points.append(point)
        attributes.append(values)
    if not points:
        raise InputError(f"{source} holds no points; choose another layer.")
    xyz, warnings = _positions(source, points, attributes)
    lost = np.flatnonzero(~np.isfinite(xyz).all(axis=1))
    if len(lost):
        raise InputError(
            f"Feature {lost[0] + 1} of {source} has a coordinate that is not a number; correct or remove it."
        )
    names = _names(source, attributes)
    places = tuple(f"feature {number}" for number in range(1, len(points) + 1))
    origins, stds = _appended(attributes)
    covariances, doubts = _covariances(source, attributes, settings)
    crs = parse_layer_wkt(wkt, source)
    return Rows(
        source=source,
        places=places,
        names=names,
        xyz=xyz,
        unit_stated=crs is not None,
        crs=crs,
        warnings=(*warnings, *doubts),
        origins=origins,
        stds=stds,
        covariances=covariances,
    )


def _covariances(
    source: str, attributes: list[Attributes], settings: ListSettings
) -> tuple[Optional[np.ndarray], tuple[str, ...]]:
    """Return the covariances of the points, None if the layer has no standard deviations, and warnings."""
    fields = list(attributes[0])
    columns = {role: fields[column] for role, column in recognised(fields, POINTS).items()}
    if not set(STDS) <= columns.keys():
        return None, ()
    stds, correlations = (
        np.array([[_number(values.get(columns.get(role, ""))) for role in roles] for values in attributes])
        for roles in (STDS, CORRELATIONS)
    )
    stds = stds * [metres_of(Path(source), unit_of(columns[role])) for role in STDS]
    covariances = covariances_of(stds, correlations)
    # Surveyed points that an earlier registration held fixed have standard deviations of 0.
    doubts = () if CONTROL_OUT.issubset(fields) else warnings_on(source, stds, covariances, settings)
    return covariances, doubts


def _appended(attributes: list[Attributes]) -> tuple[tuple[str, ...], Optional[np.ndarray]]:
    """Return origins and standard deviations of points, if the layer is a CONTROL_OUT of a registration."""
    if not CONTROL_OUT.issubset(attributes[0]):
        return (), None
    origins = tuple(_text(values["origin"]) for values in attributes)
    squares = np.array([[_number(values[field]) ** 2 for field in STDS] for values in attributes])
    return tuple("" if origin == SURVEYED else origin for origin in origins), np.sqrt(squares.mean(axis=1))


@contextmanager
def _opened(path: Path, layer: Optional[str]) -> Iterator[fiona.Collection]:
    # GDAL does not distinguish a missing file from one that is not a layer.
    path.stat()
    with (
        _gdal_errors_named(path),
        fiona.open(path, layer=_chosen(path, layer), encoding=_encoding(path)) as features,
    ):
        yield features


def _encoding(path: Path) -> Optional[str]:
    """Return the encoding that a shapefile states; None leaves it to GDAL.

    Once QGIS has opened a shapefile, GDAL decodes the texts of none.
    """
    stated = path.with_suffix(".cpg")
    if path.suffix.lower() != ".shp" or not stated.is_file():
        return None
    try:
        return codecs.lookup(stated.read_text(encoding="ascii", errors="replace").strip()).name
    except LookupError:
        return None


def _chosen(path: Path, layer: Optional[str]) -> str:
    layers = _point_layers(path)
    if layer in layers:
        return layer
    listed = ", ".join(layers)
    if layer:
        raise InputError(f"{path} has no layer {layer} of points; choose among: {listed or 'none'}.")
    if not layers:
        raise InputError(f"{path} has no layer of points; choose another file.")
    if len(layers) > 1:
        raise InputError(
            f"{path} has several layers of points ({listed}); write {path.name}|layername={layers[0]}."
        )
    return layers[0]


def _point_layers(path: Path) -> list[str]:
    layers = []
    for name in fiona.listlayers(path):
        with fiona.open(path, layer=name) as features:
            kind = features.schema["geometry"]
        # The kind of a text format is unknown until it is read.
        if "Point" in kind or kind == "Unknown":
            layers.append(name)
    return layers


@contextmanager
def _gdal_errors_named(path: Path) -> Iterator[None]:
    try:
        _check_tables(path)
        refuse_damaged(path)
        yield
    except (InputError, CancelledError):
        raise
    except OSError as error:
        if error.errno:
            raise
        raise _unreadable(path, error) from error
    # Damaged files raise errors of the driver, of texts and of geometries, which have no common base.
    except Exception as error:
        raise _unreadable(path, error) from error


def _check_tables(path: Path) -> None:
    """Raise an error if the tables of a GeoPackage are damaged; on some, GDAL 3.10 ends the process."""
    if path.suffix.lower() != ".gpkg":
        return
    with closing(sqlite3.connect(f"{path.resolve().as_uri()}?immutable=1", uri=True)) as database:
        try:
            database.execute("SELECT count(*) FROM sqlite_master").fetchone()
        except UnicodeDecodeError as error:
            raise ValueError("its tables are damaged") from error


def _unreadable(path: Path, error: Exception) -> InputError:
    reason = " ".join(str(error).split())
    return InputError(f"{path} cannot be read as a layer ({reason}); save it again.")


def _point_and_attributes(feature: fiona.Feature) -> Feature:
    geometry = feature["geometry"]
    kind = geometry["type"] if geometry else None
    coordinates: tuple[Any, ...] = geometry["coordinates"] if geometry else ()
    if kind == "MultiPoint" and len(coordinates) == 1:
        kind, coordinates = "Point", coordinates[0]
    return coordinates if kind == "Point" else None, dict(feature["properties"])


def _positions(
    source: str, points: list[tuple[float, ...]], attributes: list[Attributes]
) -> tuple[np.ndarray, tuple[str, ...]]:
    """Return the positions, and a warning if their heights are those of a field although they have Z."""
    field = next(iter(_fields(attributes, "z")), None)
    plane = np.array([point[:2] for point in points], dtype=np.float64)
    heights = np.array([point[2] if len(point) == 3 else np.nan for point in points], dtype=np.float64)
    if field is None and any(len(point) < 3 for point in points):
        raise InputError(
            f"The points of {source} have no heights; give them Z values, or a field of numbers called z."
        )
    if field is None:
        return np.column_stack([plane, heights]), ()
    numbers = np.array([_number(values[field]) for values in attributes]) * metres_of(
        Path(source), unit_of(field)
    )
    if all(len(point) < 3 for point in points):
        return np.column_stack([plane, numbers]), ()
    empty = (heights == 0) | (heights < LOWEST_M) | np.isnan(heights)
    lost = empty & np.isfinite(numbers) & (numbers != 0)
    if not lost.any():
        return np.column_stack([plane, heights]), ()
    if empty.all() and np.isfinite(numbers).all():
        said = f"Z is {_what(heights)} everywhere in {source}, so the heights are those of its field {field}."
        return np.column_stack([plane, numbers]), (said,)
    said = (
        f"Z is {_what(heights[empty])} at {empty.sum()} points of {source}, though its field {field} holds "
        "heights of some of them; correct Z, or fill in the field."
    )
    return np.column_stack([plane, heights]), (said,)


def _what(heights: np.ndarray) -> str:
    """Return what stands instead of heights, in words."""
    return "0" if not heights.any() else "0 or no height"


def _number(value: Any) -> float:
    """Return a number, also one that is text with a decimal comma; nan for anything else."""
    try:
        return float(value.replace(",", ".") if isinstance(value, str) else value)
    except (TypeError, ValueError):
        return np.nan


def _fields(attributes: list[Attributes], role: str) -> list[str]:
    """Return the fields with a name of a role, the most specific name first."""
    found: dict[str, str] = {}
    for field in attributes[0]:
        found.setdefault(simplified(field), field)
    return [found[alias] for alias in POINTS[role] if alias in found]


def _names(source: str, attributes: list[Attributes]) -> Optional[tuple[str, ...]]:
    """Return the names of the points, None if no field has names."""
    columns = [[_text(values[field]) for values in attributes] for field in _fields(attributes, "name")]
    columns = [names for names in columns if any(names)]
    if not columns:
        return None
    # QGIS gives a new shapefile a field called id, which few fill in.
    best = next((names for names in columns if all(names) and len(set(names)) == len(names)), columns[0])
    if "" in best:
        raise InputError(f"Feature {best.index('') + 1} of {source} has no name; give it one.")
    return tuple(best)


def _text(value: object) -> str:
    if value is None:
        return ""
    if isinstance(value, float) and value.is_integer():
        return str(int(value))
    return str(value).strip()
