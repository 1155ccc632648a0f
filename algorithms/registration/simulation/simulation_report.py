"""REPORT: a simulation as a page that says what to change before the fieldwork."""

from collections import Counter
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from ...reporting.charts import histogram
from ...reporting.figures import COLOURS, GREY, RED
from ...reporting.maps import Map
from ...reporting.numbers import number
from ...reporting.page import write_page
from ..settings import Model
from .simulation import INCOMPLETE, WRONG, Confusion, Simulation

TEMPLATE = Path(__file__).parent / "templates" / "simulation.html"

MEANINGS = {
    "ambiguous": "The targets fit the control points in several ways that are equally good.",
    "chance": "So few targets agree with some control points by accident too.",
    "collinear": "The targets lie on a line, or above each other in a levelled model.",
    "coincident": "Two targets have the same position.",
    "mirrored": "The targets lie in one plane and fit other control points as in a mirror.",
    "too few": "The targets leave no redundancy to check their match.",
    "no overlap": "The noise hid which targets are which.",
    INCOMPLETE: "The pose is right, but a target was given no control point.",
    WRONG: "A target was given another control point than its own.",
}

MOST_POINTS = 12
"""Points that are named, where more are concerned."""

MOST_PAIRS = 30
"""Pairs that are listed; the table of trials has all."""


def write_simulation_report(simulation: Simulation, path: Path) -> None:
    """Write the page.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    shown = simulation.confusions[:MOST_PAIRS]
    counts = _trials_by_point(simulation)
    errors = _errors(simulation)
    write_page(
        path,
        TEMPLATE,
        simulation=simulation,
        settings=simulation.settings,
        model=simulation.settings.model.name.lower().replace("_", " "),
        scale_unknown=simulation.settings.model is Model.UNKNOWN_SCALE,
        wrong=simulation.failures.get(WRONG, 0),
        advice=_advice(simulation),
        failures=_failures(simulation),
        confused_count=len(counts),
        confused=[f"{name} ({count})" for name, count in counts[:MOST_POINTS]],
        pairs=[(*pair.points, f"{_distance(simulation, pair):.3f}", pair.trials) for pair in shown],
        map=_map(simulation, shown),
        errors=[_quantiles(name, values) for name, values in errors.items()],
        histograms={name.partition(" (")[0]: histogram(values, name) for name, values in errors.items()},
    )


def _advice(simulation: Simulation) -> list[str]:
    """Return what to do before the fieldwork."""
    advice = []
    if simulation.confusions:
        advice.append(
            "Some control points can be confused with each other, because the distances among them repeat: "
            "move targets that are listed below, or add one that breaks the symmetry."
        )
    if any(simulation.failures.get(status) for status in ("chance", "too few", "no overlap")):
        advice.append("Some scans had too few targets to be sure: pick one or two more in each scan.")
    if simulation.failures.get("collinear"):
        advice.append("Some scans had all targets in a row: put targets at different heights and sides.")
    return advice


def _failures(simulation: Simulation) -> list[tuple[str, str, str, str]]:
    trials = len(simulation.trials)
    return [
        (outcome, str(count), f"{count / trials:.1%}", MEANINGS.get(outcome, ""))
        for outcome, count in simulation.failures.items()
    ]


def _trials_by_point(simulation: Simulation) -> list[tuple[str, int]]:
    """Return the points that were confused with others and in how many trials, most often first."""
    counts = Counter(
        name for trial in simulation.trials for name in {name for pair in trial.confused for name in pair}
    )
    names = simulation.control.names
    return sorted(counts.items(), key=lambda item: (-item[1], names.index(item[0])))


def _distance(simulation: Simulation, pair: Confusion) -> float:
    one, other = (simulation.control.names.index(name) for name in pair.points)
    return float(np.linalg.norm(simulation.control.xyz[one] - simulation.control.xyz[other]))


def _map(simulation: Simulation, pairs: Sequence[Confusion]) -> str:
    """Return the control points from above, with lines between those of `pairs`."""
    control = simulation.control
    places = control.xyz[:, :2]
    rows = [[control.names.index(name) for name in pair.points] for pair in pairs]
    ends = np.array(rows, dtype=int).reshape(-1, 2)
    doubted = {name for pair in simulation.confusions for name in pair.points}
    confused = np.array([name in doubted for name in control.names])
    order = np.argsort(~confused, kind="stable")
    with Map.around(places) as plan:
        plan.lines(places[ends[:, 0]], places[ends[:, 1]], GREY)
        plan.dots(places[~confused], COLOURS[0])
        plan.dots(places[confused], RED, 8.0)
        plan.names(
            places[order],
            [control.names[row] for row in order],
            ["red" if confused[row] else "" for row in order],
        )
        return plan.svg()


def _errors(simulation: Simulation) -> dict[str, list[float]]:
    """Return the errors of the trials that succeeded, by their name and unit; empty if none did."""
    successes = simulation.successes
    if not successes:
        return {}
    return {
        "shift, the scanner's position (mm)": [1000 * trial.shift_error for trial in successes],
        "rotation (0.001 degrees)": [1000 * trial.rotation_error for trial in successes],
        "sigma0": [trial.sigma0 for trial in successes],
    }


def _quantiles(name: str, values: Sequence[float]) -> tuple[str, ...]:
    median, most = np.quantile(values, (0.5, 0.95))
    return name, *(number(float(value), 2) for value in (median, most, max(values)))
