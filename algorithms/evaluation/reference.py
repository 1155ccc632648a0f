"""What a plan is compared with: known walls, or a plan drawn by hand with its rules."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Optional

from shapely import wkb
from shapely.geometry.base import BaseGeometry

from .drawn_plan import JUDGED, DrawnPlan, RoomAgreement, compare_rooms, compare_with_drawn, drawn_plan
from .outlines import Outlines, outlines_of
from .plan import PlanAgreement, compare_plan


@dataclass(frozen=True)
class Reference:
    """What a plan is compared with.

    Attributes
    ----------
    outlines : Outlines
        All walls, or their faces.
    drawn : DrawnPlan or None
        The rules of a plan drawn by hand; None for a layer of walls.
    """

    outlines: Outlines
    drawn: Optional[DrawnPlan]


def drawn_reference(
    source: str,
    features: Sequence[tuple[Optional[bytes], Mapping[str, Any]]],
    wkt: str,
    path: Optional[str] = None,
) -> Optional[Reference]:
    """Return the plan drawn by hand that features hold; None if none of them is a judged region.

    Parameters
    ----------
    source : str
        What messages call it.
    features : sequence of (bytes or None, mapping)
        WKB, and the fields `kind` and `note`; see `drawn_plan`.
    wkt : str
        Coordinate reference system; empty if unknown.
    path : str, optional
        The file they came from.

    Raises
    ------
    InputError
        If no face is drawn, a coordinate is not a number, or the system is not in metres.
    """
    if not any(fields.get("kind") == JUDGED for _, fields in features):
        return None
    held = [(wkb.loads(bytes(data)), data, fields) for data, fields in features if data]
    drawn = drawn_plan([(part, fields) for shape, _, fields in held for part in _parts(shape)])
    faces = [data for shape, data, _ in held if shape.geom_type.endswith("LineString")]
    return Reference(outlines_of(source, faces, wkt, path), drawn)


def compare_with_reference(walls: Outlines, reference: Reference, tolerance: float) -> PlanAgreement:
    """Compare the walls of a plan with a reference, by the rules that it has.

    Parameters
    ----------
    walls : Outlines
    reference : Reference
    tolerance : float
        Metres.
    """
    if reference.drawn is None:
        return compare_plan(walls.shape, reference.outlines.shape, tolerance)
    return compare_with_drawn(list(walls.shape.geoms), reference.drawn, tolerance)


def compare_drawn_rooms(rooms: Optional[Outlines], reference: Reference) -> Optional[RoomAgreement]:
    """Compare the rooms of a plan with those of a drawn one; None if either has no rooms."""
    if rooms is None or reference.drawn is None or not reference.drawn.rooms:
        return None
    return compare_rooms(list(rooms.parts), reference.drawn)


def _parts(shape: BaseGeometry) -> list[BaseGeometry]:
    return list(getattr(shape, "geoms", [shape]))
