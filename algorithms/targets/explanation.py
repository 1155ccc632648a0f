"""Why a scan has no targets, or few: the nearest misses, and what the angular step allows."""

from collections import Counter

import numpy as np

from .results import Kind, Rejection, StationTargets
from .settings import TargetSettings, Wanted

POINTS_ACROSS = 4.0
"""Points across a target that are four a quadrant."""


def explanation(station: StationTargets, settings: TargetSettings) -> list[str]:
    """Return sentences for the log about a scan without targets that are sure.

    Parameters
    ----------
    station : StationTargets
    settings : TargetSettings
    """
    wanted = {
        Wanted.BOTH: tuple(Kind),
        Wanted.CHECKERBOARDS: (Kind.CHECKERBOARD,),
        Wanted.SPHERES: (Kind.SPHERE,),
    }[settings.wanted]
    sentences = [_misses(station, kind) for kind in wanted if kind is Kind.SPHERE or station.has_intensity]
    return [*sentences, reach_of_step(station, settings)]


def reach_of_step(station: StationTargets, settings: TargetSettings) -> str:
    """Return up to which distance the step of a scan suffices, and which step would do twice as far."""
    size = settings.size or 0.15
    reach = size / POINTS_ACROSS / station.step
    step = 10_000 * station.step
    return (
        f"With a step of {step:.1f} mm at 10 m, a target of {1000 * size:.0f} mm has four points a quadrant "
        f"up to {reach:.0f} m; scan with {step / 2:.1f} mm to find it up to {2 * reach:.0f} m."
    )


def _misses(station: StationTargets, kind: Kind) -> str:
    failed = [item for item in station.rejections if item.kind is kind]
    name = "black and white target" if kind is Kind.CHECKERBOARD else "sphere"
    if not failed:
        return f"Nothing in {station.name} looks like a {name}."
    tests = Counter(item.test for item in failed).most_common(3)
    counts = ", ".join(f"{count} by the {test}" for test, count in tests)
    nearest = max(failed, key=lambda item: (item.passed, -item.miss))
    place = " ".join(f"{value:.2f}" for value in station.position + nearest.xyz)
    return (
        f"{len(failed)} places in {station.name} look like a {name} and failed: {counts}. The nearest miss, "
        f"at {place}, failed by the {nearest.test}: {_amount(nearest, nearest.value)}, where "
        f"{_amount(nearest, nearest.limit)} is the limit."
    )


def _amount(item: Rejection, value: float) -> str:
    if item.unit == "m":
        return f"{1000 * value:.1f} mm"
    text = f"{value:.2f}".rstrip("0").rstrip(".") if np.isfinite(value) else "without end"
    return f"{text} {item.unit}".strip()
