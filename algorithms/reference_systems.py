"""Coordinate reference systems: horizontal and in metres, or refused.

rasterio's CRS is the type that readers return and writers take; pyproj knows what kind of system it is.
"""

from typing import Any, Optional

import numpy as np
import pyproj
from pyproj.exceptions import ProjError
from rasterio.crs import CRS
from rasterio.errors import CRSError

from .errors import InputError

BESIDE = 2.0
"""By how many degrees a site may lie beside the area for which a system is made."""

BESIDE_ZONE = 14.0
"""By how many degrees of longitude, if this area is a zone of transverse Mercator: states use one zone as a
whole, as Norway does zone 33, which ends at 18 degrees, up to 31."""

TRANSVERSE_MERCATOR = ("9807", "9808")
"""The codes that EPSG gives to the projection of zones along meridians, with axes to the north or south."""

UNDEFINED = "Undefined geographic SRS"
"""The system of a GeoPackage that was written without one."""

FARTHEST_EAST_M, NEAREST_NORTH_M = 3_000_000.0, 1_000_000.0
"""No usual system in metres has larger eastings where its northings are smaller: those of UTM are below
1000 km, and where they begin with the number of a zone, northings are larger. Some systems in feet have, as
that of the south of Louisiana."""

MOST_STRETCHED = 0.01
"""By this part lengths may differ from those on the ground: 10 cm over 10 m, a pixel of a plan. Systems for
surveys differ by less within their states."""


def parse_wkt(wkt: str) -> CRS:
    """Return the horizontal part of a coordinate reference system in WKT 1 or 2.

    Raises
    ------
    ValueError
        If the text is not a coordinate reference system.
    """
    try:
        return horizontal(CRS.from_wkt(wkt))
    except (CRSError, ProjError) as error:
        raise ValueError(str(error)) from error


def parse_layer_wkt(wkt: str, owner: str) -> Optional[CRS]:
    """Return the horizontal system of a vector layer; None if it has none, or a local one.

    Parameters
    ----------
    wkt : str
    owner : str
        The layer, as messages call it.

    Raises
    ------
    InputError
        If the text is not a coordinate reference system, or not in metres.
    """
    if not wkt:
        return None
    try:
        crs = parse_wkt(wkt)
    except ValueError as error:
        raise InputError(
            f"The coordinate reference system of {owner} is not understood; assign it again."
        ) from error
    if _definition(crs).name == UNDEFINED:
        return None
    require_metres(crs, owner)
    return None if is_local(crs) else crs


def chosen_system(wkt: str, parameter: str) -> CRS:
    """Return the horizontal part of a system that the user chose.

    Raises
    ------
    InputError
        If it cannot be understood, or its heights are not in metres.
    """
    try:
        return parse_wkt(wkt)
    except ValueError as error:
        raise InputError(
            f"{parameter}: this coordinate reference system is not understood; choose one with an EPSG code."
        ) from error


def horizontal(crs: CRS) -> CRS:
    """Return `crs` without its heights.

    Raises
    ------
    InputError
        If the heights are not in metres.
    """
    definition = _definition(crs)
    units = [axis.unit_name for axis in definition.axis_info[2:] if axis.unit_conversion_factor != 1]
    if units:
        raise InputError(f"The heights of {name_of(crs)} are in {units[0]}; convert them to metres.")
    plane = _plane(definition)
    return _with_all_codes(CRS.from_wkt(plane.to_wkt())) if plane else crs


def _plane(definition: pyproj.CRS) -> Optional[pyproj.CRS]:
    """Return a system without its part or axis of heights; None if it has none to leave out."""
    if definition.sub_crs_list:
        return definition.sub_crs_list[0]
    level = definition.is_projected or definition.is_engineering
    if definition.is_bound or not level or len(definition.axis_info) < 3:
        return None
    parts = definition.to_json_dict()
    _leave_out_heights(parts)
    base = parts.get("base_crs", {})
    if len(base.get("coordinate_system", {}).get("axis", ())) > 2:
        _leave_out_heights(base)
    return pyproj.CRS.from_json_dict(parts)


def _leave_out_heights(parts: dict[str, Any]) -> None:
    """Leave out the third axis of a system in JSON, and the code, which is that of three axes."""
    parts["coordinate_system"]["axis"] = parts["coordinate_system"]["axis"][:2]
    parts.pop("id", None)


def is_local(crs: CRS) -> bool:
    """Whether a system is not tied to the earth, such as a scanner's own."""
    return bool(_definition(crs).is_engineering)


def has_only_heights(crs: CRS) -> bool:
    """Whether a system is vertical, without a horizontal one."""
    definition = _definition(crs)
    return bool(definition.is_vertical and not definition.sub_crs_list)


def position_warning(crs: Optional[CRS], position: np.ndarray, owner: str) -> tuple[str, ...]:
    """Return a sentence if coordinates do not fit their system, or any, or only with swapped axes.

    Parameters
    ----------
    crs : CRS or None
    position : ndarray, shape (2,) or more
        Amid the points.
    owner : str
        What holds them, for the message.
    """
    x, y = position[:2].tolist()
    if crs is None:
        return _seem_swapped(x, y, owner)
    if is_elsewhere(crs, x, y):
        return (
            f"The points of {owner} lie outside the area of {name_of(crs)}; choose the system that "
            "their coordinates have, or none if they are local.",
        )
    if are_swapped(crs, x, y):
        return (
            f"x and y of {owner} seem to be swapped, because they lie in the area of {name_of(crs)} "
            "only the other way round; the plan would be mirrored, so write easting before northing.",
        )
    return (*_other_axes(crs, owner), *_stretched(crs, x, y, owner))


def _other_axes(crs: CRS, owner: str) -> tuple[str, ...]:
    """Return a sentence if the axes of a projected system do not point east and north, in either order."""
    definition = _definition(crs)
    directions = [axis.direction.lower() for axis in definition.axis_info[:2]]
    if not definition.is_projected or ("west" not in directions and "south" not in directions):
        return ()
    return (
        f"The axes of {name_of(crs)}, the system of {owner}, point {directions[0]} and {directions[1]}, but "
        "plans show them to the right and up; reproject the points to a system of easting and northing.",
    )


def _stretched(crs: CRS, x: float, y: float, owner: str) -> tuple[str, ...]:
    """Return a sentence if lengths in a system are not those on the ground, as of Web Mercator."""
    definition = _definition(crs)
    if not definition.is_projected:
        return ()
    try:
        projection = pyproj.Proj(definition)
        factors = projection.get_factors(*projection(x, y, inverse=True))
    except ProjError:
        return ()
    scale = max(factors.meridional_scale, factors.parallel_scale, key=lambda factor: abs(factor - 1))
    if not abs(scale - 1) > MOST_STRETCHED:
        return ()
    return (
        f"Lengths in {name_of(crs)}, the system of {owner}, are {scale:.3g} times those on the ground; "
        "reproject the points to a system such as UTM.",
    )


def _seem_swapped(x: float, y: float, owner: str) -> tuple[str, ...]:
    """Return a sentence if coordinates without a system are like northing and easting of UTM."""
    if x < FARTHEST_EAST_M or not 0 <= y < NEAREST_NORTH_M:
        return ()
    return (
        f"x and y of {owner} seem to be swapped, because, if they are metres, x is a northing of "
        f"{x / 1000:.0f} km and y an easting of {y / 1000:.0f} km; the plan would be mirrored, so write "
        "easting before northing.",
    )


def are_swapped(crs: CRS, x: float, y: float) -> bool:
    """Whether a position lies outside the area of a projected system, but inside it with x and y swapped."""
    return _are_inside(crs, x, y, BESIDE) == [False, True]


def is_elsewhere(crs: CRS, x: float, y: float) -> bool:
    """Whether a position lies far outside the area of a projected system, also with x and y swapped."""
    return _are_inside(crs, x, y, BESIDE_ZONE if _is_zone(crs) else BESIDE) == [False, False]


def _is_zone(crs: CRS) -> bool:
    definition = _definition(crs)
    # The operation of a bound system is the shift of its datum.
    projected = definition.source_crs if definition.is_bound else definition
    operation = projected and projected.coordinate_operation
    return operation is not None and operation.method_code in TRANSVERSE_MERCATOR


def _are_inside(crs: CRS, x: float, y: float, beside: float) -> list[bool]:
    """Return whether a position lies in the area of a projected system, as it is and with x and y swapped.

    The list is empty if that cannot be known.

    Parameters
    ----------
    crs : CRS
    x, y : float
    beside : float
        By how many degrees of longitude it may lie outside.
    """
    definition = _definition(crs)
    code = crs.to_epsg()
    # A text that states the system may leave out its area.
    area = definition.area_of_use or (pyproj.CRS.from_epsg(code).area_of_use if code else None)
    if area is None or not definition.is_projected or area.west > area.east:
        return []
    try:
        degrees = pyproj.Transformer.from_crs(definition, "EPSG:4326", always_xy=True)
        east, north = degrees.transform([x, y], [y, x])
    except ProjError:
        return []
    return [
        area.west - beside <= longitude <= area.east + beside
        and area.south - BESIDE <= latitude <= area.north + BESIDE
        for longitude, latitude in zip(east, north)
    ]


def name_of(crs: CRS) -> str:
    """Return `EPSG:25832`, or the name in the definition if there is no code."""
    code = crs.to_epsg()
    return f"EPSG:{code}" if code else _definition(crs).name


def require_metres(crs: CRS, owner: str) -> None:
    """Refuse a system that is not in metres.

    Parameters
    ----------
    crs : CRS
    owner : str
        Whose system it is, for the message.

    Raises
    ------
    InputError
        If the axes are degrees, feet, heights alone or the metres of an earth-centred system.
    """
    system = unsuitable_axes(crs)
    if system:
        raise InputError(
            f"The coordinates of {owner} are {system} ({name_of(crs)}); "
            "reproject to a projected coordinate reference system in metres."
        )


def unsuitable_axes(crs: CRS) -> str:
    """Return what a system has instead of metres, in words that follow 'are', as 'in foot'; or nothing."""
    definition = _definition(crs)
    if definition.is_geographic:
        return "in degrees"
    if definition.is_geocentric:
        return "earth-centred"
    if has_only_heights(crs):
        return "heights only"
    if len(definition.axis_info) < 2 and not definition.sub_crs_list:
        return "not those of a map"
    units = [axis.unit_name for axis in definition.axis_info if axis.unit_conversion_factor != 1]
    return f"in {units[0]}" if units else ""


def _definition(crs: CRS) -> pyproj.CRS:
    # WKT 1 cannot express every system, such as a local one with three axes.
    return pyproj.CRS.from_wkt(crs.to_wkt(version="WKT2_2019"))


def _with_all_codes(crs: CRS) -> CRS:
    # WKT 2 keeps the code of the whole only; the definition by this code has those of datum and units too.
    code = crs.to_epsg()
    known = CRS.from_epsg(code) if code else crs
    return known if known == crs else crs
