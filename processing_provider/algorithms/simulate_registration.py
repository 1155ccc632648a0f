"""The algorithm `simulateregistration`."""

from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from ..algorithm import Algorithm, Outcome
from ..dependencies import FOR_LAYERS
from ..log import Log
from ..parameters.destinations import HtmlDestination, TableDestination
from ..parameters.parameter import Number
from ..parameters.registration import CONTROL, MODEL, SIGMA

if TYPE_CHECKING:
    from ...algorithms.registration.simulation.simulation import Simulation

TARGETS_PER_SCAN = Number(
    "TARGETS_PER_SCAN",
    "Targets seen in each scan",
    "Number of control points that a scan sees. Fewer than 5 rarely give an unambiguous match.",
    unit="count",
    default=5,
    minimum=2,
    maximum=1000,
    whole=True,
)

SCALE_PPM = Number(
    "SCALE_PPM",
    "Scale error",
    "Relative excess of all distances from the centroid of the targets of a scan.",
    unit="ppm",
    default=10,
    minimum=-100000,
    maximum=100000,
)

TRIALS = Number(
    "TRIALS",
    "Number of simulated scans",
    "1000 determine the success rate to about one per cent, in a minute.",
    unit="count",
    default=1000,
    minimum=1,
    maximum=1000000,
    whole=True,
)

SEED = Number(
    "SEED",
    "Seed of the random numbers",
    "The same seed gives the same result; change it to see how much results vary.",
    unit="any number",
    default=1,
    minimum=0,
    maximum=2**31 - 1,
    whole=True,
)

REACH = Number(
    "REACH",
    "Reach of a scan",
    "All targets of a scan lie within this distance of one control point, because a scanner sees only what "
    "is near. If not set, they come from the whole list.",
    unit="m",
    minimum=0.001,
)


class SimulateRegistrationAlgorithm(Algorithm):
    """Check whether the control points can be identified unambiguously."""

    key = "simulateregistration"
    title = "Simulate the registration of scans"
    chapter = "Registration"
    summary = "Checks before fieldwork whether the control points can be identified unambiguously."
    about = (
        "Random parts of the control list are seen from random stations, with noise and a scale error, and "
        "are registered as scans. The report states how many were identified, which control points are "
        "confused, and how accurate the transformations are (Herbig, Mayer, Mortada and Rasztovits 2013)."
    )
    words = (
        "simulation",
        "registration",
        "planning",
        "targets",
        "control points",
        "network design",
        "monte carlo",
        "laser scan",
        "tls",
    )
    needs = FOR_LAYERS
    inputs = (replace(CONTROL, planned=True), TARGETS_PER_SCAN, SIGMA, SCALE_PPM, TRIALS, SEED, MODEL, REACH)
    destinations = (
        TableDestination(
            "TABLE",
            "Trials",
            "CSV file with a row for each simulated scan: its points, its result, and its errors.",
            optional=True,
        ),
        HtmlDestination(
            "REPORT",
            "Report of the simulation",
            "HTML page with failures, ambiguous points and errors; see the results viewer.",
            optional=True,
        ),
    )
    numbers = (("SUCCESS_RATE", "Share of scans that were registered with all targets right (0 to 1)"),)

    def compute(self, values: dict[str, Any], log: Log) -> Outcome:
        """Run the trials."""
        from ...algorithms.registration.settings import Model, Settings
        from ...algorithms.registration.simulation.simulation import simulate
        from ...algorithms.registration.simulation.trials import write_trials

        simulation = simulate(
            values["CONTROL"],
            Settings(model=Model(values["MODEL"]), sigma=values["SIGMA"]),
            targets_per_scan=values["TARGETS_PER_SCAN"],
            scale_ppm=values["SCALE_PPM"],
            trials=values["TRIALS"],
            seed=values["SEED"],
            reach=values["REACH"],
            progress=log.progress,
        )
        _log(simulation, log)
        writers = {"TABLE": partial(write_trials, simulation)}
        if values["REPORT"]:
            from ...algorithms.registration.simulation.simulation_report import write_simulation_report

            writers["REPORT"] = partial(write_simulation_report, simulation)
        return Outcome(writers, {"SUCCESS_RATE": simulation.success_rate})


def _log(simulation: "Simulation", log: Log) -> None:
    log.warn(simulation.warnings)
    log.info(f"All targets right in {len(simulation.successes)} of {len(simulation.trials)} scans.")
    for outcome, count in simulation.failures.items():
        log.info(f"{outcome}: {count}")
    if simulation.confusions:
        pairs = "; ".join(" and ".join(pair.points) for pair in simulation.confusions[:10])
        log.warn([f"Control points that are confused, the most frequent first: {pairs}."])
