"""The registration of all scans: one after the other as far as the points go, then all in one block."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ..errors import InputError
from ..progress import Progress
from .adjustment.block_adjustment import adjust_block
from .adjustment.control_network import Network
from .adjustment.evaluation import Frames, describe_points, describe_scans
from .adjustment.statistical_tests import global_test
from .lists.point_list import PointList
from .matching.control_points import factor_of
from .matching.scan_matching import doubles
from .results import GlobalTest, Registration
from .sequential_registration import grow
from .settings import Settings


def register_scans(
    control: PointList,
    scans: Sequence[PointList],
    settings: Settings = Settings(),
    progress: Progress = Progress(),
) -> Registration:
    """Find which targets are which control points, and the transformation of every scan.

    Scans are taken in the order that works: those that match surveyed points first; their unmatched targets
    are appended to the control points, on which the next ones may stand. In the end all are adjusted in one
    block. Neither the order of the scans nor that of the rows of a list matters.

    Parameters
    ----------
    control : PointList
    scans : sequence of PointList
    settings : Settings
    progress : Progress

    Raises
    ------
    InputError
        If there are too few control points, or two scans have the same name.
    CancelledError
        If the caller asked to stop.
    """
    _check(control, scans, settings)
    near = {scan.name: reduced(scan) for scan in scans}
    own, origin = reduced(control)
    frames = Frames(origin, {name: start for name, (_, start) in near.items()})
    network = Network.of_surveyed(own.names, own.xyz, settings.control_sigma)
    lists = {name: scan for name, (scan, _) in near.items()}
    growth = grow(lists, network, settings, progress.part(0.0, 0.9))
    factor = factor_of(settings.tolerance, settings.sigma, settings.control_sigma)
    registration = Registration(
        settings=settings,
        tolerance=factor * float(np.sqrt(2 * settings.sigma**2 + 2 * settings.control_sigma**2)),
        scans=(),
        points=(),
        test=GlobalTest(0.0, 0.0, float("nan"), float("nan")),
        crs=control.crs,
        warnings=(*control.warnings, *_doubles(network, settings)),
    )
    if not growth.placed:
        return replace(registration, scans=describe_scans(scans, growth, None, settings, frames))
    progress.update(0.9, "Adjusting all scans in one block")
    adjusted = adjust_block(growth, settings)
    progress.update(1.0)
    return replace(
        registration,
        scans=describe_scans(scans, growth, adjusted, settings, frames),
        points=describe_points(control, growth, adjusted, settings, frames),
        test=global_test(adjusted.block.sum_of_squares, adjusted.block.redundancy),
    )


def _check(control: PointList, scans: Sequence[PointList], settings: Settings) -> None:
    least = settings.model.least_targets
    if len(control.names) < least:
        raise InputError(
            f"{control.name} has {len(control.names)} control points, but at least {least} are needed; add "
            "some."
        )
    names = [scan.name for scan in scans]
    repeated = next((name for name in names if names.count(name) > 1), None)
    if repeated is not None:
        raise InputError(
            f"Two lists of targets are called {repeated}, and scans are known by their names; rename one."
        )
    if not scans:
        raise InputError("No list of targets was given; choose at least one.")


def reduced(points: PointList) -> tuple[PointList, np.ndarray]:
    """Return the list near the origin, in an order of its own, and what was taken off its coordinates."""
    # Whole metres, so that taking them off rounds nothing.
    origin = np.round(points.xyz.mean(axis=0))
    order = np.lexsort(points.xyz.T[::-1])
    names = tuple(points.names[row] for row in order)
    return replace(points, names=names, xyz=points.xyz[order] - origin), origin


def _doubles(network: Network, settings: Settings) -> list[str]:
    """Warn of control points that cannot be told apart."""
    factor = factor_of(settings.tolerance, settings.sigma, settings.control_sigma)
    site = network.site(settings.sigma, factor, 0.0)
    sentences = []
    for row in np.flatnonzero(doubles(site)):
        first = int(site.distances[row, :row].argmin())
        sentences.append(
            f"The control points {network.names[first]} and {network.names[row]} are "
            f"{1000 * site.distances[row, first]:.0f} mm apart and cannot be told from each other; one is "
            "used."
        )
    return sentences
