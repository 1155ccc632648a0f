"""What the user should look at in the plan of a storey, because it is much."""

from .settings import DoubtSettings, LevelSettings
from .storey_plan import StoreyPlan
from .walls.left_out import HANGS, LOW


def doubts(
    plan: StoreyPlan, settings: DoubtSettings = DoubtSettings(), levels: LevelSettings = LevelSettings()
) -> tuple[str, ...]:
    """Return sentences about what was left out, and where rooms end without a wall."""
    found = []
    seen = sum(sheet.length * sheet.levels * levels.level_m for sheet in plan.sheets)
    high = [item for item in plan.left_out if item.reason not in (HANGS, LOW)]
    area = sum(item.area for item in high)
    if area > settings.much_left_out * seen:
        found.append(
            f"{area:.0f} m² of {seen:.0f} m² of upright surface rise as high as walls, but are left out as "
            "furniture, curtains and door leaves: look through LEFT_OUT, and set STOREY to no if walls are "
            "among them."
        )
    limits = sum(line.length for line in plan.limits)
    around = sum(room.outline.length for room in plan.rooms)
    if limits > settings.many_limits * around:
        found.append(
            f"Rooms end without a wall over {limits:.0f} m of {around:.0f} m: the scan ends there, or the "
            "wall is glass or hidden by furniture; see LIMITS."
        )
    return tuple(found)
