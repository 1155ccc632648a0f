"""Print which scans surfaces place without any target, and how far that is from where they stood.

Rooms alike: furnished rooms of one size in a row, with doors, two stations in each. Apart: two stations in
rooms alike that share nothing. Symmetric: two stations in an empty room. Of these, the first are to be placed
or refused, the others refused; none may be placed wrong. Real scans are left out if they are not here.

    python -m ichnograph.benchmarks.placement --seeds 4
"""

import argparse
from collections import Counter
from collections.abc import Iterable, Sequence
from typing import Optional

import numpy as np
from ichnograph.algorithms.registration.lists.point_list import PointList
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.results import Registration, ScanRegistration
from ichnograph.algorithms.registration.settings import Model, Settings
from ichnograph.algorithms.registration.surfaces.patches import Surfaces
from ichnograph.algorithms.reporting.numbers import number
from ichnograph.tests.scenes.real_scans import HALL, ROOMS, hall_surfaces, room_surfaces
from ichnograph.tests.scenes.scanned_rooms import EMPTY, matrix_of, rooms_alike, surfaces_from
from ichnograph.tests.scenes.surface_rooms import Face
from scipy.spatial.transform import Rotation

RIGHT_M = 0.02
"""A scan that is farther from where it stood is placed wrong."""


def registered(surfaces: dict[str, Surfaces], model: Model) -> Registration:
    """Return the registration of scans without targets, in the frame of the first."""
    nothing = np.zeros((0, 3))
    lists = [PointList(name, (), nothing) for name in surfaces]
    return register_scans(PointList("control", (), nothing), lists, Settings(model=model), surfaces=surfaces)


def main(arguments: Optional[Sequence[str]] = None) -> None:
    """Run the benchmark."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", type=int, default=4, help="of each kind of simulated scans")
    parser.add_argument("--first", type=int, default=0, help="the first of them")
    given = parser.parse_args(arguments)
    real()
    simulated(range(given.first, given.first + given.seeds))


def real() -> None:
    """Print how real scans are placed."""
    print("| scan | model | agree | contradict | at the next pose | off (m) | off (degrees) |")
    print("|---|---|---|---|---|---|---|")
    if HALL.exists():
        surfaces, matrices = hall_surfaces()
        _print_real(_named("hall", surfaces), matrices)
    else:
        print(f"left out, because {HALL} is not here")
    if ROOMS.exists():
        _print_real(_named("room", room_surfaces()), None)
    else:
        print(f"left out, because {ROOMS} is not here")


def _named(name: str, surfaces: list[Surfaces]) -> dict[str, Surfaces]:
    return {f"{name} {place}": own for place, own in enumerate(surfaces)}


def _print_real(surfaces: dict[str, Surfaces], matrices: Optional[list[np.ndarray]]) -> None:
    for model in (Model.RIGID, Model.LEVELLED):
        for place, scan in enumerate(registered(surfaces, model).scans[1:], start=1):
            off = None if matrices is None else np.linalg.inv(matrices[0]) @ matrices[place]
            print(f"| {scan.name} | {model.name.lower()} | {_row(scan, off)} |")


def _row(scan: ScanRegistration, known: Optional[np.ndarray]) -> str:
    placement = scan.placement
    if scan.matrix is None or placement is None:
        return f"refused: {scan.status} | | | | "
    following = f"{placement.next_agreeing} / {placement.next_contradicting}"
    evidence = f"{placement.agreeing} | {placement.contradicting} | {following}"
    if known is None:
        return f"{evidence} | - | -"
    motion = np.linalg.inv(known) @ scan.matrix
    turn = np.degrees(Rotation.from_matrix(motion[:3, :3]).magnitude())
    return f"{evidence} | {np.linalg.norm(motion[:3, 3]):.3f} | {turn:.2f}"


def simulated(seeds: Iterable[int]) -> None:
    """Print how many simulated scans are placed right, refused, and placed wrong."""
    print("\n| scans | placed | refused | wrong | largest error (mm) |")
    print("|---|---|---|---|---|")
    kinds: dict[str, list[tuple[str, float]]] = {"rooms alike": [], "apart": [], "symmetric": []}
    for seed in seeds:
        faces, stations = rooms_alike(3, seed)
        kinds["rooms alike"] += _errors(faces, stations)
        kinds["apart"] += _errors(faces, [stations[0], stations[4]], reach=8.0)
        random = np.random.default_rng(seed)
        kinds["symmetric"] += _errors(EMPTY, list(random.uniform((1, 1, 1.5), (7, 4, 1.8), (2, 3))))
    for kind, results in kinds.items():
        count = Counter(result for result, _ in results)
        largest = max((error for result, error in results if result == "placed"), default=np.nan)
        print(
            f"| {kind} | {count['placed']} | {count['refused']} | {count['wrong']} | "
            f"{number(1000 * largest, 1)} |"
        )


def _errors(faces: list[Face], stations: list[np.ndarray], **chosen: float) -> list[tuple[str, float]]:
    """Return of each scan but the first what became of it, and how far it is from where it stood (m)."""
    surfaces = {
        f"s{row}": surfaces_from(faces, station, row, step_deg=0.9, **chosen)
        for row, station in enumerate(stations)
    }
    first, *others = registered(surfaces, Model.LEVELLED).scans
    results = []
    for row, scan in enumerate(others, start=1):
        if scan.matrix is None or first.matrix is None:
            results.append(("refused", float("nan")))
            continue
        true = np.linalg.inv(matrix_of(stations[0])) @ matrix_of(stations[row], row)
        error = float(np.linalg.norm((np.linalg.inv(true) @ scan.matrix)[:3, 3]))
        results.append(("placed" if error < RIGHT_M else "wrong", error))
    return results


if __name__ == "__main__":
    main()
