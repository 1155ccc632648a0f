"""Settings of the files of a facade."""

from dataclasses import dataclass

from ...settings import judged


@dataclass(frozen=True)
class OrthoimageSettings:
    """The orthoimage."""

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
