"""Whether targets get their true control points, compared with other tools on the same scenes.

make registration, or: python3 -m ichnograph.benchmarks.registration [--trials 1000] [--peer-trials 20]

A scene is control points on a building and the targets picked in one scan of it, some of which are control
points; the noise is 2 mm. An answer is

right
    if every common target has its true control point, even if it is rejected as an outlier, and no other
    target has one;
partial
    if a common target has no control point, and everything else is right;
wrong
    if any target has a control point that is not its own;
refused
    if the tool gives no answer.

Without overlap, every answer is false. Time is the median, and the 95 % quantile, of a whole scan.

The other tools give a pose. A target's control point is then the one within 2 cm, and the pose counts as
refused if fewer than four targets have one, because none of them distinguishes accidental from true matches.
Their settings are in `registration_peers`. A pose error is the mean distance between the common targets,
moved by this pose and by the true one; of the right answers, the median is printed.
"""

import argparse
import time
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Callable, Optional

import numpy as np
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.settings import Settings
from ichnograph.tests.scenes.targets import TargetScene, target_scene
from scipy.spatial import cKDTree

from .registration_peers import PEERS, Peer

SETTINGS = ((12, 8, 5), (30, 12, 6), (50, 15, 8), (100, 20, 8), (200, 20, 8), (200, 20, 4))
"""Control points, targets picked, and how many of them are common."""

NOISE = 0.002
NEAR = 0.02
FEWEST = 4


@dataclass(frozen=True)
class Answer:
    """The answer of a tool for a scene.

    Attributes
    ----------
    labels : dict of str to str
        Targets and their control points; empty if refused.
    rejected : dict of str to str
        The same of outliers, which are listed but not used.
    reason : str
        Why it was refused, in a word.
    matrix : ndarray, shape (4, 4), or None
    """

    labels: dict[str, str]
    rejected: dict[str, str] = field(default_factory=dict)
    reason: str = ""
    matrix: Optional[np.ndarray] = None


Tool = Callable[[TargetScene], Answer]


@dataclass(frozen=True)
class Tally:
    """The verdicts on a tool over all scenes of a setting.

    Attributes
    ----------
    verdicts : Counter
        Numbers of scenes by verdict: right, partial, wrong, or the reason of a refusal.
    seconds, errors : ndarray
        Of every scene, and of every right answer (m).
    """

    verdicts: Counter[str]
    seconds: np.ndarray
    errors: np.ndarray

    @property
    def refused(self) -> int:
        """The number of scenes without an answer."""
        return sum(self.verdicts.values()) - self.answered

    @property
    def answered(self) -> int:
        """The number of scenes with an answer, right or not."""
        return sum(self.verdicts[verdict] for verdict in ("right", "partial", "wrong"))


def ours(scene: TargetScene) -> Answer:
    """Register with the true noise as SIGMA, and defaults."""
    return registered(scene, Settings(sigma=NOISE))


def registered(scene: TargetScene, settings: Settings) -> Answer:
    """Register with settings."""
    (scan,) = register_scans(scene.control, [scene.targets], settings).scans
    if not scan.registered:
        return Answer({}, reason=scan.status)
    labels, rejected = (
        {item.target: item.control for item in scan.correspondences if item.used is used}
        for used in (True, False)
    )
    return Answer(labels, rejected, matrix=scan.matrix)


def by_peer(peer: Peer) -> Tool:
    """Return a function like `ours` that runs another tool."""

    def answer(scene: TargetScene) -> Answer:
        control, targets = scene.control.xyz, scene.targets.xyz
        about, here = control.mean(axis=0), targets.mean(axis=0)
        pose = peer(control - about, targets - here, NOISE)
        if pose is None:
            return Answer({}, reason="no pose")
        matrix = pose.copy()
        matrix[:3, 3] += about - pose[:3, :3] @ here
        reach, nearest = cKDTree(control).query(targets @ matrix[:3, :3].T + matrix[:3, 3])
        pairs = zip(scene.targets.names, nearest, reach)
        labels = {target: scene.control.names[point] for target, point, gap in pairs if gap < NEAR}
        return Answer(labels, matrix=matrix) if len(labels) >= FEWEST else Answer({}, reason="few targets")

    return answer


def run(tool: Tool, setting: tuple[int, int, int], seeds: Iterable[int]) -> Tally:
    """Run a tool on the scenes of a setting."""
    verdicts: Counter[str] = Counter()
    seconds, errors = [], []
    for seed in seeds:
        scene = target_scene(*setting, NOISE, seed)
        started = time.perf_counter()
        answer = tool(scene)
        seconds.append(time.perf_counter() - started)
        verdicts[verdict(answer, scene)] += 1
        if answer.matrix is not None and verdict(answer, scene) == "right":
            errors.append(pose_error(answer.matrix, scene))
    return Tally(verdicts, np.array(seconds), np.array(errors))


def verdict(answer: Answer, scene: TargetScene) -> str:
    """Return right, partial or wrong, or why the scene was refused."""
    if not answer.labels:
        return answer.reason
    if any(scene.truth[target] != point for target, point in answer.labels.items()):
        return "wrong"
    listed = {**answer.rejected, **answer.labels}
    common = {target: point for target, point in scene.truth.items() if point is not None}
    return "right" if all(listed.get(target) == point for target, point in common.items()) else "partial"


def pose_error(matrix: np.ndarray, scene: TargetScene) -> float:
    """Return the mean distance of the common targets from where they truly are (m)."""
    common = [point is not None for point in scene.truth.values()]
    difference = matrix - scene.matrix
    moved = scene.targets.xyz[common] @ difference[:3, :3].T + difference[:3, 3]
    return float(np.linalg.norm(moved, axis=1).mean())


def row(name: str, setting: tuple[int, int, int], trials: int, tool: Tool) -> str:
    """Return a row of the table: the scenes of a setting, and as many without overlap."""
    found = run(tool, setting, range(trials))
    alone = run(tool, (*setting[:2], 0), range(trials))
    refusals = {
        why: count for why, count in found.verdicts.items() if why not in ("right", "partial", "wrong")
    }
    reasons = ", ".join(f"{why} {count}" for why, count in sorted(refusals.items()))
    error = f"{np.median(found.errors) * 1000:.1f}" if len(found.errors) else "-"
    cells = (
        "/".join(map(str, setting)),
        name,
        f"{found.verdicts['right'] / trials:.1%}",
        found.verdicts["partial"],
        found.verdicts["wrong"],
        f"{found.refused}{f' ({reasons})' if reasons else ''}",
        f"{alone.answered}",
        error,
        f"{np.median(found.seconds) * 1000:.1f} / {np.quantile(found.seconds, 0.95) * 1000:.1f}",
    )
    return f"| {' | '.join(map(str, cells))} |"


HEADER = """\
| control/picked/common | tool | right | partial | wrong | refused | false without overlap | pose error (mm) \
| time, median / 95 % (ms) |
|---|---|---|---|---|---|---|---|---|"""


def main() -> None:
    """Print the table, ours first and then that of all tools."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--trials", type=int, default=1000, help="scenes of a setting")
    parser.add_argument("--peer-trials", type=int, default=20, help="the first of them, by all tools")
    arguments = parser.parse_args()
    # The first call compiles and imports what all others share.
    run(ours, SETTINGS[0], range(1))
    print(f"{arguments.trials} scenes of each setting, and as many without overlap\n\n{HEADER}")
    for setting in SETTINGS:
        print(row("Ichnograph", setting, arguments.trials, ours), flush=True)
    if arguments.peer_trials:
        compare(arguments.peer_trials)


def compare(trials: int) -> None:
    """Print the table of all tools."""
    print(f"\nThe first {trials} of these scenes\n\n{HEADER}")
    tools = {"Ichnograph": ours, **{name: by_peer(peer) for name, peer in PEERS.items()}}
    installed = {name: tool for name, tool in tools.items() if is_installed(tool)}
    for setting in SETTINGS:
        for name, tool in installed.items():
            print(row(name, setting, trials, tool), flush=True)
    for name in tools.keys() - installed.keys():
        print(f"\n{name}: not installed; run make peers.")


def is_installed(tool: Tool) -> bool:
    """Try a tool on a scene."""
    try:
        run(tool, SETTINGS[0], range(1))
    except ImportError:
        return False
    return True


if __name__ == "__main__":
    main()
