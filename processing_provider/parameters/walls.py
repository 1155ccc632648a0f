"""What the algorithms that extract walls have in common."""

from functools import partial
from typing import TYPE_CHECKING, Any

from ..log import Log
from .destinations import PolygonDestination, RasterDestination, Writer
from .parameter import Number

if TYPE_CHECKING:
    from ...algorithms.site_plan.results import WallPlan
    from ...algorithms.site_plan.walls.extraction import WallParameters

WALL_PARAMETERS = (
    Number(
        "THRESHOLD",
        "Lowest density threshold",
        "Density from which a pixel may be wall. If not set, it is derived from the density of the "
        "horizontal surfaces and written to the log. Raise it if clutter is taken for walls.",
        unit="standard deviations",
        minimum=0,
    ),
    Number(
        "MIN_AREA",
        "Smallest region",
        "Regions with less area are dropped. If not set, it is the area of a metre of wall one pixel thick.",
        unit="m²",
        minimum=0,
        advanced=True,
    ),
    Number(
        "MAX_FILL",
        "Largest fill of connected or curved walls",
        "A region consists of connected or curved walls if its area divided by the area of its bounding "
        "box is not above this.",
        unit="ratio",
        default=0.4,
        minimum=0,
        maximum=1,
        advanced=True,
    ),
    Number(
        "MIN_ELONGATION",
        "Least elongation of a straight wall",
        "A region is a straight wall if the major axis of its best-fit ellipse divided by the minor axis "
        "is not below this.",
        unit="ratio",
        default=3,
        minimum=1,
        advanced=True,
    ),
    Number(
        "CLOSING",
        "Widest gap to close",
        "Joins the two faces of a wall and bridges interruptions. If not set, it is 0.8 m where the heights "
        "show the ground between walls, so that doors are kept open, and 0.4 m where they do not.",
        unit="m",
        minimum=0,
        maximum=100,
    ),
    Number(
        "MIN_HEIGHT",
        "Least occupied height of a wall",
        "Height that the points of a pixel must fill between 0.3 and 2.3 m above the local ground. Removes "
        "floors and beams; also separates vegetation and furniture from walls. Lower it for low ruins; 0 "
        "uses density alone.",
        unit="m",
        default=0.4,
        minimum=0,
        maximum=2,
    ),
    Number(
        "THRESHOLD_STEPS",
        "Number of density thresholds",
        "Walls are looked for at this many thresholds from the lowest to the highest, and combined.",
        unit="count",
        default=10,
        minimum=1,
        maximum=100,
        whole=True,
        advanced=True,
    ),
    Number(
        "THRESHOLD_MAX",
        "Highest density threshold",
        "If not set, it is the median density of the pixels that may be wall.",
        unit="standard deviations",
        minimum=0,
        advanced=True,
    ),
)

WALL_NUMBERS = (
    ("WALL_COUNT", "Number of walls"),
    ("WALL_AREA", "Area of the walls (m²)"),
    ("WALL_LENGTH", "Length of the walls (m)"),
)

WALLS = PolygonDestination(
    "WALLS",
    "Walls",
    "Polygons with kind, length, thickness, base and top height. GeoPackage or shapefile, by extension.",
    style="walls",
    focus=True,
)


def plan_destination(optional: bool) -> RasterDestination:
    """Return the destination PLAN."""
    help_text = "Wall pixels as a GeoTIFF: 1 wall, 0 none."
    return RasterDestination(
        "PLAN", "Plan raster", help_text, style="plan", optional=optional, by_default=not optional
    )


def wall_parameters(values: dict[str, Any]) -> "WallParameters":
    """Return what the user chose."""
    from ...algorithms.site_plan.walls.extraction import WallParameters

    return WallParameters(**{item.name.lower(): values[item.name] for item in WALL_PARAMETERS})


def log_walls(plan: "WallPlan", log: Log) -> None:
    """Write to the log what was derived and found."""
    values = plan.image.thresholds.values
    log.info(f"Thresholds: {len(values)} from {values[0]:.2f} to {values[-1]:.2f} standard deviations.")
    log.info(
        f"Smallest region: {plan.image.criteria.min_area:g} m². Widest gap to close: {plan.image.gap:g} m."
    )
    log.info(f"Walls: {len(plan.walls)}, {plan.area:.2f} m², {plan.length:.1f} m long.")


def wall_writers(plan: "WallPlan") -> dict[str, Writer]:
    """Return what writes PLAN and WALLS."""
    from ...algorithms.site_plan.output.layers import write_plan, write_walls

    return {"PLAN": partial(write_plan, plan=plan), "WALLS": partial(write_walls, plan=plan)}


def wall_numbers(plan: "WallPlan") -> dict[str, float]:
    """Return the values of `WALL_NUMBERS`."""
    return {"WALL_COUNT": len(plan.walls), "WALL_AREA": plan.area, "WALL_LENGTH": plan.length}
