"""The parameters of the search for targets."""

from typing import TYPE_CHECKING, Any

from ...algorithms.clouds.formats import readable_formats
from ...algorithms.errors import InputError
from .files import CloudFiles
from .parameter import Choice, Number, Position

if TYPE_CHECKING:
    from ...algorithms.targets.settings import TargetSettings

SCANS = CloudFiles(
    "INPUT",
    "Laser scans",
    f"One or more scans, each of one station: {readable_formats()}; or a folder of them. E57 and PTX files "
    "may hold several. On the command line, repeat INPUT=file or separate the files by semicolons.",
)

KIND = Choice(
    "KIND",
    "Kind of targets",
    "What is searched for. Black and white targets need intensities.",
    options=("Both", "Black and white", "Spheres"),
)

SIZE = Number(
    "SIZE",
    "Size of the targets",
    "Width of the black and white pattern, or diameter of the spheres. If not set, patterns of 75 to 300 mm "
    "and spheres of 76, 100, 139, 145, 150 and 200 mm are found. Set it for other spheres, or where a "
    "diameter is doubtful.",
    unit="m",
    minimum=0.02,
    maximum=2,
    decimals=4,
)

STATION = Position(
    "STATION",
    "Position of the scanner",
    "Where the scanner stood, x y z in the coordinates of the scan. If not set, the position that E57 and "
    "PTX files state is used; other files are in the scanner's own frame, with the scanner at the origin.",
)


def settings_of(values: dict[str, Any]) -> "TargetSettings":
    """Return the settings that the user chose."""
    from ...algorithms.targets.settings import TargetSettings, Wanted

    if values["STATION"] is not None and len(values["INPUT"]) > 1:
        raise InputError("STATION belongs to one scan, and there are several; choose one, or leave it empty.")
    return TargetSettings(wanted=Wanted(values["KIND"]), size=values["SIZE"], station=values["STATION"])
