"""Settings of the range image of a station."""

from dataclasses import dataclass

from ...settings import judged, physical, statistical


@dataclass(frozen=True)
class RangeImageSettings:
    """How the points of a station become an image of what the scanner saw."""

    step_windows: int = statistical(
        41, "The median step of so many windows is that of the scan, even if a third of them lie on edges."
    )
    window_steps: float = judged(
        15.0, "Half the width of such a window: some hundred points, and little more than one surface."
    )
    neighbours: int = physical(8, "Of a point in a square grid; the farthest lies a diagonal off.")
    jump: float = physical(
        0.1, "Part of the range. Neighbours on a surface that is seen at up to 80 degrees differ by less."
    )
    most_jumps: float = judged(
        0.3,
        "Share of neighbouring pixels with a jump. Single stations have 0.02 to 0.06, a cloud of several "
        "stations had 0.35.",
    )
    azimuth_bins: int = judged(3600, "Sectors of 0.1 degrees, whose longest empty run is where a scan ends.")
    most_pixels_per_point: float = judged(
        60.0, "A cloud that fills less of its image is not seen from its station, or far too sparse."
    )
    nearest_m: float = physical(0.3, "No scanner measures nearer than this; such points are its own parts.")
