"""The paper's figure 9: five random points of a list of a hundred, seen from anywhere with 3 mm noise.

make registration-figure, or: python3 -m ichnograph.benchmarks.registration_figure
    [--trials 1000] [--out build/registration_figure.png]
"""

import argparse
from pathlib import Path

import numpy as np
from ichnograph.algorithms.registration.lists.point_list import PointList
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.settings import Settings
from ichnograph.algorithms.registration.simulation.simulation import Simulation, Trial, simulate
from ichnograph.tests.scenes.targets import CORNER, target_scene
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from scipy.spatial.transform import Rotation

POINTS = 100
TARGETS = 5
SCALE_PPM = 10.0
CASES = 3
SETTINGS = Settings(sigma=0.003)
AWAY = np.array([-25.0, 8.0, 4.0])
"""Position of the scanner's own frame in the drawing, from the corner of the building (m)."""

BLUE, MAGENTA, RED = "#3b78a8", "#c050b0", "#b3261e"


def draw_case(axes: Axes, control: PointList, trial: Trial, seed: int) -> None:
    """Draw control points, and the targets of a trial in the frame of the scanner and registered."""
    random = np.random.default_rng(seed)
    rows = [control.names.index(name) for name in trial.points]
    seen = control.xyz[rows] + random.normal(0, SETTINGS.sigma, (TARGETS, 3))
    scanned = (seen - seen.mean(axis=0)) @ Rotation.random(random_state=seed).as_matrix()
    scan = PointList("scan", tuple(map(str, range(TARGETS))), scanned, named=False)
    (found,) = register_scans(control, [scan], SETTINGS).scans
    assert found.matrix is not None
    placed = scanned @ found.matrix[:3, :3].T + found.matrix[:3, 3] - CORNER
    axes.scatter(*(control.xyz - CORNER).T, s=6, color=BLUE, label="control points")
    axes.scatter(*(scanned + AWAY).T, s=22, color=MAGENTA, label="targets in the scanner's frame")
    axes.scatter(*placed.T, s=30, facecolors="none", edgecolors=RED, label="targets, registered")
    for start, end in zip(scanned + AWAY, placed):
        axes.plot(*np.transpose([start, end]), color=MAGENTA, linewidth=0.5, alpha=0.6)
    residual = np.mean([item.length for item in found.correspondences])
    axes.set_title(f"{', '.join(trial.points)}\nmean residual {1000 * residual:.1f} mm", fontsize=9)
    axes.set(xlim=(-35, 32), ylim=(-10, 28), zlim=(-8, 16), xlabel="x (m)", ylabel="y (m)", zlabel="z (m)")
    axes.set_box_aspect((67, 38, 24))
    axes.tick_params(labelsize=7)


def draw_errors(panels: list[Axes], simulation: Simulation) -> None:
    """Draw how the errors of the parameters are distributed over the trials that succeeded."""
    successes = simulation.successes
    errors = {
        "error of the station (mm)": [1000 * trial.shift_error for trial in successes],
        "error of the rotation (degrees)": [trial.rotation_error for trial in successes],
        "sigma0, a posteriori over a priori": [trial.sigma0 for trial in successes],
    }
    for axes, (name, values) in zip(panels, errors.items()):
        # The longest tail would squeeze the rest.
        median, most, last = np.quantile(values, (0.5, 0.95, 0.995))
        axes.hist(values, bins=np.linspace(0, last, 40), color=BLUE)
        axes.axvline(median, color=RED, linewidth=1)
        axes.axvline(most, color=RED, linewidth=1, linestyle="dashed")
        axes.set(xlabel=name, ylabel="trials")
        axes.set_title(f"median {median:.3g}, 95 % {most:.3g}, largest {max(values):.3g}", fontsize=9)
        print(f"{name}: median {median:.3g}, 95 % {most:.3g}, largest {max(values):.3g}")


def main() -> None:
    """Simulate, print and draw."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--trials", type=int, default=1000)
    parser.add_argument("--out", type=Path, default=Path("build/registration_figure.png"))
    arguments = parser.parse_args()
    control = target_scene(POINTS, TARGETS, TARGETS).control
    simulation = simulate(control, SETTINGS, TARGETS, SCALE_PPM, arguments.trials)
    successes, trials = len(simulation.successes), len(simulation.trials)
    headline = (
        f"{successes} of {trials} scans of {TARGETS} of {POINTS} points registered with all labels right"
    )
    print(f"{headline}; failures: {simulation.failures or 'none'}")
    figure = Figure(figsize=(14, 8), layout="constrained")
    figure.suptitle(f"{headline} (noise 3 mm, scale error 10 ppm)")
    upper, lower = figure.subfigures(2, 1, height_ratios=(1.25, 1))
    cases = upper.subplots(1, CASES, subplot_kw={"projection": "3d"})
    for seed, (axes, trial) in enumerate(zip(cases, simulation.successes)):
        draw_case(axes, control, trial, seed)
    upper.legend(*cases[0].get_legend_handles_labels(), loc="lower center", ncols=3, fontsize=9)
    draw_errors(list(lower.subplots(1, 3)), simulation)
    arguments.out.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(arguments.out, dpi=80)


if __name__ == "__main__":
    main()
