"""The settings of reading lists of points."""

from dataclasses import dataclass

from ...settings import judged, physical


@dataclass(frozen=True)
class ListSettings:
    """Lists of points."""

    most_points: int = physical(
        20_000, "More than anybody picks or surveys; a longer list is a cloud that was chosen by mistake."
    )
    least_numeric_share: float = judged(
        0.5, "A column with numbers in this share of its rows holds coordinates; the other rows are faulty."
    )
    largest_median_std_m: float = judged(
        0.05,
        "Targets are seen and points surveyed to millimetres; a larger median is probably in another unit.",
    )
