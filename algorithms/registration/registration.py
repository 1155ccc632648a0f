"""The registration of all scans: one after the other as far as the points reach, then in one block."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import Optional

import numpy as np

from ..errors import InputError
from ..progress import Progress
from .adjustment.control_network import ControlNetwork
from .adjustment.evaluation import Evaluation, Frames, refused_scan
from .lists.point_list import PointList
from .matching.control_points import ControlPoints
from .matching.matching_task import coincident
from .results import GlobalTest, Registration
from .sequential_registration import in_frame_of_first, register_in_sequence
from .settings import Settings
from .surfaces.adjustment import adjust_with_surfaces
from .surfaces.patches import Surfaces


def register_scans(
    control: PointList,
    scans: Sequence[PointList],
    settings: Settings = Settings(),
    progress: Progress = Progress(),
    surfaces: Mapping[str, Surfaces] = MappingProxyType({}),
) -> Registration:
    """Identify the control points behind the targets, and compute the transformation of every scan.

    Scans that match surveyed points are registered first. Their unmatched targets are appended to the control
    points, to which further scans may be registered. Finally all are adjusted in one block, with the surfaces
    that they share. Neither the order of the scans nor that of the rows of a list matters.

    Parameters
    ----------
    control : PointList
        Without any, the frame of the first scan is that of all, and surfaces place the others.
    scans : sequence of PointList
        Lists may be empty if surfaces place the scans.
    settings : Settings
    progress : Progress
    surfaces : mapping of str to Surfaces
        By the names of the scans, in their frames; empty to adjust by the targets alone.

    Raises
    ------
    InputError
        If there are too few control points, or two scans have the same name.
    CancelledError
        If the caller asked to stop.
    """
    _check(control, scans, settings, surfaces)
    settings, of_survey = _with_survey(scans, settings)
    near = {scan.name: _near(scan, surfaces.get(scan.name)) for scan in scans}
    moved = {name: item.shifted(-near[name][1]) for name, item in surfaces.items() if name in near}
    own, origin = reduced(control) if control.names else (control, near[scans[0].name][1])
    frames = Frames(origin, {name: start for name, (_, start) in near.items()})
    network = ControlNetwork.of_list(own, settings.control_sigma)
    lists = {name: scan for name, (scan, _) in near.items()}
    ready = 0.5 if surfaces else 0.9
    if control.names:
        sequence = register_in_sequence(lists, network, settings, progress.part(0.0, ready))
    else:
        sequence = in_frame_of_first(lists, network)
    registration = Registration(
        settings=settings,
        tolerance=settings.distance_tolerance,
        scans=(),
        points=(),
        test=GlobalTest(0.0, 0.0, float("nan"), float("nan")),
        crs=control.crs,
        warnings=(
            *control.warnings,
            *of_survey,
            *_appended_before(network),
            *_coincident(network, settings),
        ),
    )
    if not sequence.placed:
        return replace(registration, scans=tuple(refused_scan(scan, sequence) for scan in scans))
    progress.update(ready, "Adjusting all scans in one block")
    refined = adjust_with_surfaces(sequence, lists, moved, settings, progress.part(ready, 1.0))
    if not refined.sequence.placed:
        return replace(registration, scans=tuple(refused_scan(scan, refined.sequence) for scan in scans))
    evaluation = Evaluation(refined.sequence, refined.adjusted, settings, frames)
    progress.update(1.0)
    return replace(
        registration,
        scans=tuple(
            replace(scan, surfaces=refined.changes.get(scan.name)) for scan in evaluation.scans(scans)
        ),
        points=evaluation.points(control),
        test=evaluation.test,
        warnings=(*registration.warnings, *refined.warnings),
        surfaces=refined.shared,
    )


def _check(
    control: PointList, scans: Sequence[PointList], settings: Settings, surfaces: Mapping[str, Surfaces]
) -> None:
    least = settings.model.least_targets
    if not surfaces or any(len(scan.names) for scan in scans):
        _check_control(control, least)
    names = [scan.name for scan in scans]
    repeated = next((name for name in names if names.count(name) > 1), None)
    if repeated is not None:
        raise InputError(
            f"Two lists of targets are called {repeated}; rename one, because their names identify the scans."
        )
    if not scans:
        raise InputError("No list of targets was given; choose at least one.")


def _check_control(control: PointList, least: int) -> None:
    if len(control.names) < least:
        raise InputError(
            f"{control.name} has {len(control.names)} control points, but at least {least} are needed; add "
            "some."
        )


def _with_survey(scans: Sequence[PointList], settings: Settings) -> tuple[Settings, list[str]]:
    """Return settings in which control points have a standard deviation if targets have their own.

    Beside centres that are exact to a tenth of a millimetre, the errors of the survey are not small: held
    fixed, it would lead to the rejection of right targets.
    """
    own = any(scan.has_covariances for scan in scans)
    if settings.control_sigma or not own:
        return settings, []
    sentence = (
        "Targets have standard deviations of their own, so control points are not held fixed but count with "
        f"SIGMA, {1000 * settings.sigma:g} mm; set CONTROL_SIGMA to the standard deviation of the survey."
    )
    return replace(settings, control_sigma=settings.sigma), [sentence]


def _near(scan: PointList, surfaces: Optional[Surfaces]) -> tuple[PointList, np.ndarray]:
    """Return the targets of a scan near the origin, sorted, and what was subtracted from its coordinates."""
    if len(scan.xyz) or surfaces is None or not len(surfaces):
        return reduced(scan)
    return scan, np.round(surfaces.centres.mean(axis=0))


def reduced(points: PointList) -> tuple[PointList, np.ndarray]:
    """Return the list near the origin, sorted, and what was subtracted from its coordinates."""
    # Whole metres, whose subtraction is exact.
    origin = np.round(points.xyz.mean(axis=0)) if len(points.xyz) else np.zeros(3)
    order = np.lexsort(points.xyz.T[::-1])
    names = tuple(points.names[row] for row in order)
    return replace(
        points,
        names=names,
        xyz=points.xyz[order] - origin,
        origins=tuple(points.origins[row] for row in order) if points.origins else (),
        stds=None if points.stds is None else points.stds[order],
        covariances=points.covariances_of(order),
    ), origin


def _appended_before(network: ControlNetwork) -> list[str]:
    """Say which control points were not surveyed."""
    scans = sorted({source for source in network.sources if source})
    if not scans:
        return []
    count = sum(bool(source) for source in network.sources)
    return [
        f"{count} control points were appended by an earlier registration ({', '.join(scans)}); they count "
        "with their standard deviations, as if these were independent."
    ]


def _coincident(network: ControlNetwork, settings: Settings) -> list[str]:
    """Warn of control points that are too close to distinguish them."""
    points = ControlPoints.of_network(network, settings)
    sentences = []
    for row in np.flatnonzero(coincident(points)):
        first = int(points.distances[row, :row].argmin())
        sentences.append(
            f"The control points {network.names[first]} and {network.names[row]} are "
            f"{1000 * points.distances[row, first]:.0f} mm apart, too close to distinguish them; only one is "
            "used."
        )
    return sentences
