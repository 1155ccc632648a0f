"""The settings of the simulation."""

from dataclasses import dataclass

from ...settings import judged


@dataclass(frozen=True)
class SimulationSettings:
    """Scans whose scale is unknown."""

    smallest_scale: float = judged(
        0.1, "The scale of a scan without one is drawn from here, for MODEL = unknown scale."
    )
    largest_scale: float = judged(10.0, "To here, evenly in the logarithm.")
