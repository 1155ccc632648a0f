"""The settings of reading lists of points."""

from dataclasses import dataclass

from ...settings import judged, physical, statistical


@dataclass(frozen=True)
class ListSettings:
    """Lists of points."""

    most_points: int = physical(
        20_000, "More than anybody picks or surveys; a longer list is a cloud that was chosen by mistake."
    )
    largest_local_m: float = judged(
        10_000.0, "Local coordinates are smaller; whole ones of larger systems were rounded."
    )
    coarsest_step_m: float = judged(1.0, "Lists to the centimetre are usual; whole metres are a mistake.")
    fewest_rounded: int = statistical(2, "Four coordinates; all are whole by chance once in 10^12.")
    least_numeric_share: float = judged(
        0.5, "A column with numbers in this share of its rows holds coordinates; the other rows are faulty."
    )
    largest_median_std_m: float = judged(
        0.05,
        "Targets are seen and points surveyed to millimetres; a larger median is probably in another unit.",
    )
