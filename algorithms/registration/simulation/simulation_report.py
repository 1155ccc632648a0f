"""What a simulation says to the surveyor: a page, and a table with a row for each trial."""

import csv
from collections import Counter
from pathlib import Path

import numpy as np

from ...files import atomic_output
from ...reporting.charts import histogram
from ...reporting.html import (
    Markup,
    bullets,
    definitions,
    figure,
    join,
    notes,
    number,
    paragraph,
    section,
    table,
    write_page,
)
from ...reporting.maps import Map
from ...reporting.svg import COLOURS, GREY, RED
from ..settings import Model
from .simulation import INCOMPLETE, SUCCESS, WRONG, Confusion, Simulation

FIELDS = ("trial", "points", "outcome", "success", "wrong", "shift_error", "rotation_error", "sigma0")

MEANINGS = {
    "ambiguous": "The targets fit the control points in several ways that are equally good.",
    "chance": "So few targets agree with some control points by accident too.",
    "collinear": "The targets lie on a line, or above each other in a levelled model.",
    "coincident": "Two targets lie at the same place.",
    "mirrored": "The targets lie in one plane and fit other control points as in a mirror.",
    "too few": "The targets leave nothing by which their match could be checked.",
    "no overlap": "The noise hid what the targets are.",
    INCOMPLETE: "The pose is right, but a target was given no control point.",
    WRONG: "A target was given a control point that it is not.",
}

MOST_POINTS = 12
"""Points that are named, where more are concerned."""

MOST_PAIRS = 30
"""Pairs that are listed; the table of trials has what remains."""


def write_trials(simulation: Simulation, path: Path) -> None:
    """Write a row for each trial as csv; errors in metres and degrees, empty where there is no pose.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    with atomic_output(path) as temporary, temporary.open("w", encoding="utf-8", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(FIELDS)
        for row, trial in enumerate(simulation.trials, start=1):
            errors = (trial.shift_error, trial.rotation_error, trial.sigma0)
            written = ("" if np.isnan(value) else f"{value:.6f}" for value in errors)
            success = int(trial.outcome == SUCCESS)
            rows.writerow((row, ";".join(trial.points), trial.outcome, success, trial.wrong, *written))


def write_simulation_report(simulation: Simulation, path: Path) -> None:
    """Write the page.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    write_page(
        path,
        f"Simulated registration with {simulation.control.name}",
        _summary(simulation),
        _failures(simulation),
        _pairs(simulation),
        _errors(simulation),
        _conditions(simulation),
    )


def _summary(simulation: Simulation) -> Markup:
    count, successes = len(simulation.trials), len(simulation.successes)
    wrong = simulation.failures.get(WRONG, 0)
    sentence = (
        f"In {successes} of {count} trials ({simulation.success_rate:.1%}) all "
        f"{simulation.targets_per_scan} targets were given their control points; in {wrong}, a wrong one."
    )
    return join((paragraph(sentence), notes(simulation.warnings), notes(_advice(simulation))))


def _advice(simulation: Simulation) -> list[str]:
    """Say what to do before going out."""
    advice = []
    if simulation.confusions:
        advice.append(
            "Some control points can be taken for each other, because the distances among them repeat: move "
            "targets that are listed below, or put one more where it breaks the symmetry."
        )
    if any(simulation.failures.get(status) for status in ("chance", "too few", "no overlap")):
        advice.append("Some scans had too few targets to be sure: pick one or two more in each scan.")
    if simulation.failures.get("collinear"):
        advice.append("Some scans had all targets in a row: put targets at different heights and sides.")
    return advice


def _failures(simulation: Simulation) -> Markup:
    if not simulation.failures:
        return Markup()
    rows = [
        (outcome, count, f"{count / len(simulation.trials):.1%}", MEANINGS.get(outcome, ""))
        for outcome, count in simulation.failures.items()
    ]
    return section("Failures", table(("outcome", "trials", "share", "meaning"), rows, words=(0, 3)))


def _pairs(simulation: Simulation) -> Markup:
    """Return which control points are taken for each other, as a table and on a map."""
    pairs = simulation.confusions
    shown = pairs[:MOST_PAIRS]
    if not pairs:
        words = paragraph("No control points were taken for each other.")
    else:
        rows = [(*pair.points, f"{_distance(simulation, pair):.3f}", pair.trials) for pair in shown]
        more = f"The first {len(shown)} of {len(pairs)} pairs." if len(pairs) > len(shown) else None
        header = ("point", "taken for", "distance (m)", "trials")
        words = join((_concerned(simulation), table(header, rows, words=(0, 1), caption=more)))
    return section("Points taken for each other", words, _map(simulation, shown))


def _concerned(simulation: Simulation) -> Markup:
    """Return the points that cause most doubt."""
    counts = Counter(
        name for trial in simulation.trials for name in {name for pair in trial.confused for name in pair}
    )
    names = simulation.control.names
    ranked = sorted(counts, key=lambda name: (-counts[name], names.index(name)))
    listed = ", ".join(f"{name} ({counts[name]})" for name in ranked[:MOST_POINTS])
    return paragraph(
        f"{len(counts)} of {len(names)} control points are concerned, most often these, with the number of "
        f"trials: {listed}."
    )


def _distance(simulation: Simulation, pair: Confusion) -> float:
    one, other = (simulation.control.names.index(name) for name in pair.points)
    return float(np.linalg.norm(simulation.control.xyz[one] - simulation.control.xyz[other]))


def _map(simulation: Simulation, pairs: tuple[Confusion, ...]) -> Markup:
    """Return the control points from above, with lines between those of `pairs`."""
    control = simulation.control
    places = control.xyz[:, :2]
    rows = [[control.names.index(name) for name in pair.points] for pair in pairs]
    ends = np.array(rows, dtype=int).reshape(-1, 2)
    doubted = {name for pair in simulation.confusions for name in pair.points}
    confused = np.array([name in doubted for name in control.names])
    order = np.argsort(~confused, kind="stable")
    plan = Map.around(places)
    sheet = plan.sheet(
        plan.lines(places[ends[:, 0]], places[ends[:, 1]], GREY),
        plan.dots(places[~confused], COLOURS[0]),
        plan.dots(places[confused], RED, 8.0),
        plan.names(
            places[order],
            [control.names[row] for row in order],
            ["red" if confused[row] else "" for row in order],
        ),
    )
    return figure(
        sheet,
        "The control points from above; red ones are taken for others, lines join the pairs of the table.",
    )


def _errors(simulation: Simulation) -> Markup:
    successes = simulation.successes
    if not successes:
        return Markup()
    errors = {
        "shift, the scanner's place (mm)": [1000 * trial.shift_error for trial in successes],
        "rotation (0.001 degrees)": [1000 * trial.rotation_error for trial in successes],
        "sigma0": [trial.sigma0 for trial in successes],
    }
    rows = [
        (name, *(number(float(value), 2) for value in (*np.quantile(values, (0.5, 0.95)), max(values))))
        for name, values in errors.items()
    ]
    return section(
        "Errors of the transformations",
        paragraph("Estimated against true, in the trials that succeeded."),
        table(("", "median", "95 %", "largest"), rows),
        *(
            figure(histogram(values, name), f"Distribution of {name.partition(' (')[0]}.")
            for name, values in errors.items()
        ),
    )


def _conditions(simulation: Simulation) -> Markup:
    settings, reach = simulation.settings, simulation.reach
    seen = "from the whole list" if reach is None else f"within {reach:g} m of one of them"
    turned = "about the vertical" if settings.model.levelled else "about any axis"
    scale = ", at a scale from 0.1 to 10" if settings.model is Model.UNKNOWN_SCALE else ""
    return section(
        "What was simulated",
        bullets(
            (
                f"Each trial is a scan of {simulation.targets_per_scan} random control points {seen}, "
                f"of {len(simulation.control.names)} in all.",
                f"The scanner stands among them, turned at random {turned}{scale}.",
                f"Every coordinate has normal noise of {settings.sigma * 1000:g} mm, and distances from the "
                f"centroid of the targets are {simulation.scale_ppm:g} ppm too long.",
                f"MODEL is {settings.model.name.lower().replace('_', ' ')}, SEED {simulation.seed}.",
            )
        ),
        definitions(
            {"References": "Herbig, Mayer, Mortada and Rasztovits 2013, chapter 5: results and simulation."}
        ),
    )
