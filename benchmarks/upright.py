"""Print which tilt is found of clouds that are tilted on purpose, and whether another axis is up.

python3 -m ichnograph.benchmarks.upright scan.laz ...
"""

import argparse

import numpy as np
from scipy.spatial.transform import Rotation

from ..algorithms.clouds.cloud import open_cloud
from ..algorithms.clouds.uprightness import Faces, axis_that_is_up, faces_of, hangs, sample, tilt

TILTS_DEG = (0.0, 1.3, 2.0, 5.0)
TURNS = {
    "y up": np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]]),
    "x up": np.array([[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]]),
    "on its head": np.diag([1.0, -1, -1]),
}


def main() -> None:
    """Print a row for each cloud."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("clouds", nargs="+", metavar="cloud")
    print("|".join(["", "cloud", *(f"{angle:g}" for angle in TILTS_DEG), *TURNS, ""]))
    for path in parser.parse_args().clouds:
        faces = faces_of(sample(open_cloud([path])))
        angles = [tilt(_turned(faces, _leaning(angle)))[0] for angle in TILTS_DEG]
        found = [_answer(_turned(faces, turn)) for turn in TURNS.values()]
        print("|".join(["", path, *(f"{angle:.2f}" if angle else "-" for angle in angles), *found, ""]))


def _leaning(degrees: float) -> np.ndarray:
    return Rotation.from_euler("xyz", [0.8 * degrees, 0.6 * degrees, 20], degrees=True).as_matrix()


def _turned(faces: Faces, turn: np.ndarray) -> Faces:
    return Faces(faces.centres @ turn.T, faces.normals @ turn.T)


def _answer(faces: Faces) -> str:
    return axis_that_is_up(faces) or ("head" if hangs(faces) else "-")


if __name__ == "__main__":
    main()
