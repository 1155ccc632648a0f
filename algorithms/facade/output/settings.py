"""Settings of the files of a facade."""

from dataclasses import dataclass

from ...settings import judged, physical


@dataclass(frozen=True)
class OrthoimageSettings:
    """The orthoimage."""

    most_pixels: int = physical(
        100_000_000, "A facade of 100 m by 100 m at a centimetre; it takes about 3 GB of memory."
    )
    layer_m: float = judged(
        0.05,
        "A pixel shows the mean of its points that are no further behind the foremost; the rest is hidden.",
    )
    darkest_percent: float = judged(
        1.0, "This percentile of the intensity becomes black; single dark points would brighten the rest."
    )
    brightest_percent: float = judged(
        99.0, "This percentile of the intensity becomes white; single reflectors would darken the rest."
    )
