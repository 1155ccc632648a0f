"""What each constant of the settings costs if it is 30 % smaller or larger, one at a time.

make sensitivity, or: python3 -m ichnograph.benchmarks.sensitivity [site_plan facade registration]
    [--change 0.3] [--match faces] [--scenes columns rooms] [--clouds FOLDER --references FOLDER]

Scores are shares between 0 and 1: of the site plan, the mean of completeness and correctness at 5 cm and the
share of rooms with the right area; of facades, the share of details found, less those invented, and of sizes
within 1 cm; of the registration, the share of scenes with the right answer, where a refusal or a part of the
answer counts half and a wrong one nothing. Printed are the changes of the
mean score in percent, and the largest change on a single scene. "no effect" means that every result is the
same to the last digit; such a constant is a candidate for deletion, unless it guards against what no scene
holds. All scenes take hours: choose some. Real clouds join the site plan where drawn plans of them are given.
"""

import argparse
import os
import pickle
import re
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from multiprocessing import get_context
from pathlib import Path
from typing import Any, Callable, Optional

import numpy as np
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.errors import IchnographError
from ichnograph.algorithms.evaluation.drawn_plan import (
    DrawnPlan,
    compare_rooms,
    compare_with_drawn,
    read_drawn_plan,
)
from ichnograph.algorithms.evaluation.plan import compare_plan
from ichnograph.algorithms.facade.development.development import FLAT
from ichnograph.algorithms.facade.elevation import Elevation
from ichnograph.algorithms.facade.every_facade import measure_selection
from ichnograph.algorithms.facade.measurement import measure_facade
from ichnograph.algorithms.facade.selection import select_facade
from ichnograph.algorithms.facade.settings import FacadeSettings
from ichnograph.algorithms.registration.settings import Model
from ichnograph.algorithms.registration.settings import Settings as RegistrationSettings
from ichnograph.algorithms.settings import Constant, constants, with_constant
from ichnograph.algorithms.site_plan.results import SitePlan
from ichnograph.algorithms.site_plan.settings import SitePlanSettings
from ichnograph.algorithms.site_plan.site_plan import make_site_plan
from ichnograph.tests.scenes import SCENES
from ichnograph.tests.scenes.__main__ import write_laz
from ichnograph.tests.scenes.facades import FACADES
from ichnograph.tests.scenes.facades.judging import judge
from ichnograph.tests.scenes.facades.streets import STREETS
from ichnograph.tests.scenes.facades.streets.judging import judge_street
from ichnograph.tests.scenes.judging import room_errors
from ichnograph.tests.scenes.lived_in import LIVED_IN
from ichnograph.tests.scenes.targets import target_scene
from shapely.ops import unary_union

from .facade import points_of
from .registration import NOISE, registered, verdict
from .streets import TURNING

TOLERANCE = 0.05
ROOM_ERROR = 0.02
SIZE_ERROR = 0.01
TRIALS = 15
PLACE = (12.0, (412_345.67, 5_812_345.71, 71.3))
STREET_NOISE = 0.0035
SITES = {**SCENES, **LIVED_IN}


@dataclass(frozen=True)
class Outcome:
    """What a run gave on one scene: a score from 0 to 1, and the result as bytes."""

    score: float
    result: bytes


Scene = Callable[[Any], Outcome]
"""Runs the settings of its chapter on a scene."""


def plan_scene(name: str, folder: Path, angular_step: float) -> Scene:
    """Return a scene for site plans; its scan is written to a folder."""
    scene = SITES[name](0).moved(*PLACE)
    scan = scene.scan(angular_step, seed=0)
    path = folder / f"{name}.laz"
    write_laz(path, scan, np.ones(len(scan.points), bool), "EPSG:25833")
    return partial(_plan, path, scene.truth, scan.seen_boundary)


def _plan(path: Path, truth: Any, seen: Any, settings: SitePlanSettings) -> Outcome:
    plan = make_site_plan(open_cloud([path]), settings)
    walls = unary_union([wall.outline for wall in plan.walls])
    agreement = compare_plan(walls, truth, TOLERANCE, seen)
    scores = [agreement.completeness, agreement.correctness]
    errors = room_errors(walls, truth, seen)
    if errors:
        scores.append(float(np.mean(np.array(errors) < ROOM_ERROR)))
    return Outcome(float(np.mean(scores)), _drawn(plan))


def _drawn(plan: SitePlan) -> bytes:
    """Return all that the layers of a plan show, as bytes."""
    of_storey = (plan.storey.limits, plan.storey.left_out) if plan.storey else ()
    return pickle.dumps((plan.walls, plan.axes, plan.rooms, *of_storey, plan.warnings))


def real_scene(path: Path, reference: Path) -> Scene:
    """Return a real cloud for site plans, and the drawn plan that it is compared with."""
    return partial(_real_plan, path, read_drawn_plan(reference))


def _real_plan(path: Path, drawn: DrawnPlan, settings: SitePlanSettings) -> Outcome:
    plan = make_site_plan(open_cloud([path]), settings)
    outlines = [wall.outline for wall in plan.walls]
    agreement = compare_with_drawn(outlines, drawn, TOLERANCE)
    scores = [agreement.completeness, agreement.correctness]
    if drawn.rooms:
        rooms = compare_rooms([room.outline for room in plan.rooms or ()], drawn)
        scores.append(max(rooms.found - rooms.invented, 0) / len(drawn.rooms))
    return Outcome(float(np.mean(scores)), _drawn(plan))


def facade_scene(name: str, spacing: float) -> Scene:
    """Return a scene for facades."""
    scene = FACADES[name](0).moved(*PLACE)
    return partial(_elevation, scene, points_of(scene.scan(spacing, seed=0)))


def _elevation(scene: Any, points: Any, settings: FacadeSettings) -> Outcome:
    elevation = measure_facade(points, settings)
    return _measured(elevation, judge(elevation, scene))


def street_scene(name: str, spacing: float) -> Scene:
    """Return a street, of which the facade is looked for; a tower is rolled out."""
    scene = STREETS[name](0).moved(*PLACE)
    points = points_of(scene.scan(spacing, STREET_NOISE, seed=0))
    return partial(_street, scene, points, TURNING.get(name, FLAT))


def _street(scene: Any, points: Any, unroll: int, settings: FacadeSettings) -> Outcome:
    settings = replace(settings, unroll=unroll)
    elevation = measure_selection(select_facade(points, settings), settings).elevation
    return _measured(elevation, judge_street(elevation, scene))


def _measured(elevation: Elevation, found: Any) -> Outcome:
    right = [np.nanmax(np.abs(pair.size)) <= SIZE_ERROR for pair in found.pairs]
    details = len(found.pairs) + len(found.missed)
    scores = [max(len(found.pairs) - len(found.invented), 0) / details, sum(right) / details]
    shown = elevation.wall, elevation.details, elevation.unseen, elevation.left_out, elevation.side
    return Outcome(float(np.mean(scores)), pickle.dumps((*shown, elevation.parts, elevation.warnings)))


@dataclass(frozen=True)
class TargetLayout:
    """Scenes of one kind for the registration.

    Attributes
    ----------
    control, picked, common : int
        Numbers of control points, of targets picked, and of targets that are control points.
    noise_factor : float
        The noise of the scenes in units of SIGMA.
    model : Model
    scale : float
        Metres of the grid in a unit of the scanner's frame.
    """

    control: int
    picked: int
    common: int
    noise_factor: float = 1.0
    model: Model = Model.RIGID
    scale: float = 1.0


LAYOUTS = {
    "clear": TargetLayout(30, 12, 6),
    "few common": TargetLayout(12, 6, 3),
    "many control points": TargetLayout(200, 12, 4, noise_factor=1.5),
    "many picked": TargetLayout(30, 60, 5),
    "noisy": TargetLayout(30, 12, 5, noise_factor=3.0),
    "levelled": TargetLayout(30, 8, 3, noise_factor=1.5, model=Model.LEVELLED),
    "similarity": TargetLayout(60, 12, 4, noise_factor=2.0, model=Model.SIMILARITY, scale=1.0003),
    "unknown scale": TargetLayout(30, 16, 4, model=Model.UNKNOWN_SCALE, scale=1.37),
}


def target_scenes(layout: TargetLayout) -> Scene:
    """Return scenes of one layout for the registration."""
    tilt = 0.0 if layout.model.levelled else None
    numbers = layout.control, layout.picked, layout.common
    noise = layout.noise_factor * NOISE
    scenes = [target_scene(*numbers, noise, seed, tilt, layout.scale) for seed in range(TRIALS)]
    return partial(_registered, scenes, layout.model)


def _registered(scenes: Sequence[Any], model: Model, settings: RegistrationSettings) -> Outcome:
    answers = [registered(scene, replace(settings, model=model)) for scene in scenes]
    verdicts = [verdict(answer, scene) for scene, answer in zip(scenes, answers)]
    scores = [{"right": 1.0, "wrong": 0.0}.get(word, 0.5) for word in verdicts]
    return Outcome(float(np.mean(scores)), pickle.dumps(answers))


@dataclass(frozen=True)
class Chapter:
    """A chapter: its settings, and its scenes by name."""

    settings: Any
    scenes: dict[str, Scene]


def chapters(arguments: argparse.Namespace, folder: Path) -> Iterator[tuple[str, Chapter]]:
    """Yield the chosen chapters with their scenes."""

    def chosen(names: Iterable[str]) -> list[str]:
        return [name for name in names if not arguments.scenes or name in arguments.scenes]

    if "site_plan" in arguments.chapters:
        settings = SitePlanSettings(with_axes=True, with_rooms=True)
        scenes = {name: plan_scene(name, folder, arguments.angular_step) for name in chosen(SITES)}
        yield "site_plan", Chapter(settings, {**scenes, **_real_scenes(arguments)})
    if "facade" in arguments.chapters:
        facades = {name: facade_scene(name, arguments.spacing) for name in chosen(FACADES)}
        streets = {name: street_scene(name, arguments.spacing) for name in chosen(STREETS)}
        yield "facade", Chapter(FacadeSettings(), {**facades, **streets})
    if "registration" in arguments.chapters:
        layouts = {name: target_scenes(LAYOUTS[name]) for name in chosen(LAYOUTS)}
        yield "registration", Chapter(RegistrationSettings(sigma=NOISE), layouts)


def _real_scenes(arguments: argparse.Namespace) -> dict[str, Scene]:
    """Return the clouds of a folder that have a drawn plan of their name."""
    if not (arguments.clouds and arguments.references):
        return {}
    paths = sorted(arguments.clouds.glob("*.la[sz]"))
    pairs = ((path, arguments.references / f"{path.stem}.geojson") for path in paths)
    return {path.stem: real_scene(path, reference) for path, reference in pairs if reference.exists()}


def varied(value: Any, factor: float) -> Optional[Any]:
    """Return numbers times a factor, whole ones changed by 1 at least; None if there is no number."""
    if isinstance(value, bool) or value is None or isinstance(value, str):
        return None
    if isinstance(value, tuple):
        parts = [varied(part, factor) for part in value]
        return None if None in parts else tuple(parts)
    if isinstance(value, int):
        step = max(1, round(abs(factor - 1) * value))
        return max(value + (step if factor > 1 else -step), 0)
    return value * factor if isinstance(value, float) and np.isfinite(value) else None


def outcome(scene: Scene, settings: Any) -> Outcome:
    """Run a scene; where nothing can be found, or settings are refused, the score is 0."""
    with suppress(IchnographError, ValueError, ZeroDivisionError, IndexError):
        return scene(settings)
    return Outcome(0.0, b"")


def effect(
    chapter: Chapter, base: dict[str, Outcome], constant: Constant, factor: float
) -> Optional[list[float]]:
    """Return the changes of the scores on all scenes; None if no result changed at all."""
    value = varied(constant.value, factor)
    if value is None or value == constant.value:
        return None
    settings = with_constant(chapter.settings, constant.path, value)
    after = {name: outcome(scene, settings) for name, scene in chapter.scenes.items()}
    if all(after[name].result == base[name].result for name in after):
        return None
    return [after[name].score - base[name].score for name in after]


def _words(changes: Optional[list[float]]) -> str:
    if changes is None:
        return "no effect"
    largest = max(changes, key=abs)
    return f"{100 * float(np.mean(changes)):+.2f} ({100 * largest:+.1f})"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments that choose chapters, constants and scenes."""
    parser.add_argument("chapters", nargs="*", default=["site_plan", "facade", "registration"])
    parser.add_argument("--change", type=float, default=0.3, help="share by which constants are varied")
    parser.add_argument("--match", default="", help="only constants whose path holds this regular expression")
    parser.add_argument("--scenes", nargs="+", help="names of simulated scenes; all if not given")
    parser.add_argument("--angular-step", type=float, default=0.5, help="of the scanner, degrees")
    parser.add_argument("--spacing", type=float, default=0.02, help="of the points of facades, metres")
    parser.add_argument("--clouds", type=Path, help="folder of real clouds")
    parser.add_argument("--references", type=Path, help="folder of drawn plans, <cloud>.geojson")


def main() -> None:
    """Print a row for each constant."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    add_arguments(parser)
    parser.add_argument("--processes", type=int, default=os.cpu_count())
    arguments = parser.parse_args()
    # A forked process would wait for ever for the threads that decode LAZ.
    pool = ProcessPoolExecutor(arguments.processes, get_context("spawn"))
    with tempfile.TemporaryDirectory() as folder, pool:
        for name, chapter in chapters(arguments, Path(folder)):
            base = {scene: outcome(run, chapter.settings) for scene, run in chapter.scenes.items()}
            scores = ", ".join(f"{scene} {found.score:.3f}" for scene, found in base.items())
            print(f"\n{name}: {scores}\n", flush=True)
            print("| constant | value | kind | smaller: mean (largest) % | larger: mean (largest) % |")
            print("|---|---|---|---|---|", flush=True)
            every = constants(chapter.settings)
            chosen = [item for item in every if re.search(arguments.match, ".".join(item.path))]
            runs = [
                [pool.submit(effect, chapter, base, item, factor) for factor in _factors(arguments.change)]
                for item in chosen
            ]
            for item, pair in zip(chosen, runs):
                cells = " | ".join(_words(run.result()) for run in pair)
                print(f"| {'.'.join(item.path)} | {item.value} | {item.kind} | {cells} |", flush=True)


def _factors(change: float) -> tuple[float, float]:
    return 1 - change, 1 + change


if __name__ == "__main__":
    main()
