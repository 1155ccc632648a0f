"""The paper's own experiment (chapter 5): whether random parts of a control list are identified.

So a surveyor checks before fieldwork whether the control points can be identified unambiguously.
"""

from collections import Counter
from dataclasses import dataclass, replace
from typing import Optional

import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

from ...errors import InputError
from ...progress import Progress
from ..lists.point_list import PointList
from ..registration import register_scans
from ..results import ScanRegistration
from ..settings import Matching, Model, Settings

SUCCESS = "success"
WRONG = "wrong labels"
INCOMPLETE = "incomplete"


@dataclass(frozen=True)
class Trial:
    """A simulated scan of some control points, and its registration.

    Attributes
    ----------
    points : tuple of str
        The control points that were seen.
    outcome : str
        `SUCCESS` if every target was matched with its control point, even if then rejected as an outlier;
        `WRONG` if one was matched with another, else `INCOMPLETE`; of a refused scan, the status of its
        registration.
    wrong : int
        Number of targets that were matched with another control point.
    shift_error : float
        Distance between the computed and the true station, metres; of a refused scan nan, like the errors
        below.
    rotation_error : float
        Angle, degrees.
    sigma0 : float
        A posteriori over a priori standard deviation.
    confused : frozenset of (str, str)
        Pairs of control points, each in the order of the list, that were or could be confused.
    """

    points: tuple[str, ...]
    outcome: str
    wrong: int
    shift_error: float
    rotation_error: float
    sigma0: float
    confused: frozenset[tuple[str, str]]


@dataclass(frozen=True)
class Confusion:
    """Two control points that are confused.

    Attributes
    ----------
    points : tuple of str
        Their names.
    trials : int
        In how many trials.
    """

    points: tuple[str, str]
    trials: int


@dataclass(frozen=True)
class Simulation:
    """All trials.

    Attributes
    ----------
    control : PointList
    settings : Settings
    targets_per_scan : int
    scale_ppm : float
    seed : int
    reach : float or None
        Metres.
    trials : tuple of Trial
    warnings : tuple of str
    """

    control: PointList
    settings: Settings
    targets_per_scan: int
    scale_ppm: float
    seed: int
    reach: Optional[float]
    trials: tuple[Trial, ...]
    warnings: tuple[str, ...]

    @property
    def successes(self) -> tuple[Trial, ...]:
        """The trials in which every target was matched with its control point."""
        return tuple(trial for trial in self.trials if trial.outcome == SUCCESS)

    @property
    def success_rate(self) -> float:
        """Share of trials that succeeded, 0..1."""
        return len(self.successes) / len(self.trials)

    @property
    def failures(self) -> dict[str, int]:
        """Numbers of all other trials by their outcome, the most frequent first."""
        counts = Counter(trial.outcome for trial in self.trials if trial.outcome != SUCCESS)
        return dict(sorted(counts.items(), key=lambda item: (-item[1], item[0])))

    @property
    def confusions(self) -> tuple[Confusion, ...]:
        """The pairs of control points that are confused, the most frequent first."""
        counts = Counter(pair for trial in self.trials for pair in trial.confused)
        order = {name: row for row, name in enumerate(self.control.names)}
        ranked = sorted(counts.items(), key=lambda item: (-item[1], *(order[name] for name in item[0])))
        return tuple(Confusion(pair, count) for pair, count in ranked)


def simulate(
    control: PointList,
    settings: Settings = Settings(),
    targets_per_scan: int = 5,
    scale_ppm: float = 10.0,
    trials: int = 1000,
    seed: int = 1,
    reach: Optional[float] = None,
    progress: Progress = Progress(),
) -> Simulation:
    """Register random parts of a control list, seen from random stations with noise.

    Parameters
    ----------
    control : PointList
    settings : Settings
        Of the registration, which is by distances whatever they say; the noise is theirs.
    targets_per_scan : int
    scale_ppm : float
        A scale error of the scan, about the centroid of its targets; parts per million.
    trials : int
    seed : int
        The same seed gives the same trials, and fewer of them the first ones.
    reach : float, optional
        All targets of a scan lie within this distance of one control point (m), because a scanner sees only
        what is near; by default they come from the whole list.
    progress : Progress

    Raises
    ------
    InputError
        If the control list has too few points, or the model needs more targets.
    CancelledError
        If the caller asked to stop.
    """
    settings = replace(settings, matching=Matching.DISTANCES)
    _check(control, settings.model, targets_per_scan)
    groups, warnings = _groups(control, targets_per_scan, reach)
    done = []
    for number in range(trials):
        progress.update(number / trials, f"Registering {trials} simulated scans")
        generator = np.random.default_rng([seed, number])
        group = groups[generator.integers(len(groups))]
        seen = generator.permutation(group)[:targets_per_scan]
        done.append(_trial(control, seen, settings, scale_ppm, generator))
    progress.update(1.0)
    return Simulation(
        control, settings, targets_per_scan, scale_ppm, seed, reach, tuple(done), control.warnings + warnings
    )


def _check(control: PointList, model: Model, targets_per_scan: int) -> None:
    if targets_per_scan < model.least_targets:
        raise InputError(
            f"TARGETS_PER_SCAN is {targets_per_scan}, but MODEL needs at least {model.least_targets}; "
            "raise it."
        )
    if targets_per_scan > len(control.names):
        raise InputError(
            f"{control.path or control.name} has {len(control.names)} points, but TARGETS_PER_SCAN is "
            f"{targets_per_scan}; lower it, or survey more control points."
        )


def _groups(
    control: PointList, size: int, reach: Optional[float]
) -> tuple[list[np.ndarray], tuple[str, ...]]:
    """Return the rows of control points that can be seen together, and a warning about the others."""
    if reach is None:
        return [np.arange(len(control.names))], ()
    near = cKDTree(control.xyz).query_ball_point(control.xyz, reach, return_sorted=True)
    groups = [np.array(rows) for rows in near if len(rows) >= size]
    if not groups:
        raise InputError(
            f"No control point of {control.path or control.name} has {size - 1} others within REACH, "
            f"{reach:g} m; raise it, or lower TARGETS_PER_SCAN."
        )
    seen = set(np.concatenate(groups))
    lonely = [name for row, name in enumerate(control.names) if row not in seen]
    if not lonely:
        return groups, ()
    return groups, (
        f"These control points are in no trial because too few others are within REACH: {', '.join(lonely)}.",
    )


def _trial(
    control: PointList, seen: np.ndarray, settings: Settings, scale_ppm: float, generator: np.random.Generator
) -> Trial:
    places = control.xyz[seen]
    true = _pose(places, settings, generator)
    # It includes the error of the surveyed points: only the difference of both matters.
    noise = generator.normal(0, np.hypot(settings.sigma, settings.control_sigma), places.shape)
    measured = places + scale_ppm * 1e-6 * (places - places.mean(axis=0)) + noise
    scanned = np.linalg.solve(true[:3, :3], (measured - true[:3, 3]).T).T
    names = tuple(str(row) for row in range(1, len(seen) + 1))
    scan = PointList("scan", names, np.ascontiguousarray(scanned), named=False)
    (found,) = register_scans(control, [scan], settings).scans
    return _compared(found, true, dict(zip(names, seen)), control.names)


def _pose(places: np.ndarray, settings: Settings, generator: np.random.Generator) -> np.ndarray:
    """Return the pose of a scanner among the places, rotated at random; from its frame to theirs."""
    if settings.model.levelled:
        rotation = Rotation.from_euler("z", generator.uniform(0, 2 * np.pi))
    else:
        rotation = Rotation.from_quat(generator.normal(size=4))
    scale = 1.0
    if settings.model is Model.UNKNOWN_SCALE:
        limits = settings.simulation.smallest_scale, settings.simulation.largest_scale
        scale = np.exp(generator.uniform(*np.log(limits)))
    pose = np.eye(4)
    pose[:3, :3] = scale * rotation.as_matrix()
    pose[:3, 3] = generator.uniform(places.min(axis=0), places.max(axis=0))
    return pose


def _compared(
    found: ScanRegistration, true: np.ndarray, rows: dict[str, int], names: tuple[str, ...]
) -> Trial:
    """Compare a registration with the true pose, and with the true rows of the targets."""
    row_of = {name: row for row, name in enumerate(names)}
    right = sum(row_of[item.control] == rows[item.target] for item in found.correspondences)
    given = {item.target: row_of[item.control] for item in found.correspondences if item.used}
    wrong = sum(row != rows[target] for target, row in given.items())
    if not found.registered:
        outcome = found.status
    elif wrong:
        outcome = WRONG
    else:
        outcome = SUCCESS if right == len(rows) else INCOMPLETE
    shift, rotation = _errors(found.matrix, true) if found.matrix is not None else (np.nan, np.nan)
    rivals = [{target: row_of[point] for target, point in rival.items()} for rival in found.rivals]
    pairs = {
        tuple(sorted((row, rows[target])))
        for labels in (given, *rivals)
        for target, row in labels.items()
        if row != rows[target]
    }
    return Trial(
        points=tuple(names[row] for row in rows.values()),
        outcome=outcome,
        wrong=wrong,
        shift_error=shift,
        rotation_error=rotation,
        sigma0=found.test.sigma0 if found.test else np.nan,
        confused=frozenset((names[one], names[other]) for one, other in pairs),
    )


def _errors(matrix: np.ndarray, true: np.ndarray) -> tuple[float, float]:
    """Return the errors of a matrix: metres, degrees."""
    difference = matrix[:3, :3] @ true[:3, :3].T / np.cbrt(np.linalg.det(matrix[:3, :3] @ true[:3, :3].T))
    angle = Rotation.from_matrix(difference).magnitude()
    return float(np.linalg.norm(matrix[:3, 3] - true[:3, 3])), float(np.degrees(angle))
