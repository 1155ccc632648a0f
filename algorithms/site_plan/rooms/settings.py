"""The settings of rooms: what a person may doubt, each with its reason."""

from dataclasses import dataclass, field

from ...geometry.settings import OutlineMeshSettings
from ...settings import judged, physical


@dataclass(frozen=True)
class SpaceSettings:
    """Which spaces between walls are rooms, and which narrow passages are doors."""

    narrowing: float = judged(
        0.8, "A door is narrower than this share of both spaces; a corridor beside its doors is not."
    )
    pocket_m2: float = judged(0.25, "A smaller space behind a narrow gap is a niche of the one before it.")
    least_area_m2: float = physical(1.0, "Less is the core of a wall, or a shaft.")
    least_width_m: float = physical(0.8, "Less is the core of a wall: people need so much to pass.")
    slender: float = judged(6.0, "A space longer than so many mean widths is as narrow as its mean width.")


@dataclass(frozen=True)
class DoorSettings:
    """Where exactly a room ends at a door."""

    deepest_m: float = physical(3.0, "Half the depth of the deepest passage through a wall.")
    loss: float = judged(6.0, "A room may end so much deeper in a passage for each metre that it is wider.")
    wider: float = judged(1.1, "A passage wider than its narrowest width by more belongs to the room.")


@dataclass(frozen=True)
class RoomSettings:
    """The settings of rooms: what the user chooses, and those of the stages."""

    door_width_m: float = physical(
        1.3, "Wider gaps open a room: door leaves are up to 1.25 m wide, corridors seldom below 1.3 m."
    )
    mesh: OutlineMeshSettings = field(default_factory=OutlineMeshSettings)
    spaces: SpaceSettings = SpaceSettings()
    doors: DoorSettings = DoorSettings()
