"""Real scans whose poses are known in part; they lie beside the project, and are not part of it."""

import zipfile
from pathlib import Path

import numpy as np
from ichnograph.algorithms.registration.surfaces.patches import Surfaces, surfaces_of
from scipy.spatial.transform import Rotation

DATA = Path(__file__).resolve().parents[3] / "shared" / "data"

HALL = DATA / "hall_3dtk_three_scans" / "dat.zip"
"""Three scans by a robot, in centimetres and left-handed, with poses counted from its wheels."""

ROOMS = DATA / "rooms_pcl_scan_pair"
"""Two scans of a room and the hall beside it."""

TO_METRES = np.array([[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]) / 100
"""From centimetres in a left-handed frame with y up."""

NO_RETURN = 30.0
"""Points beyond are rays without an echo (m)."""


def hall_scan(file: zipfile.ZipFile, number: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the points of a scan of the hall (m), and the matrix of its pose."""
    points = np.loadtxt(file.open(f"scan00{number}.3d")) @ TO_METRES.T
    position, angles = np.loadtxt(file.open(f"scan00{number}.pose"))
    matrix = np.eye(4)
    turn = TO_METRES * 100
    matrix[:3, :3] = turn @ Rotation.from_euler("XYZ", angles, degrees=True).as_matrix() @ turn.T
    matrix[:3, 3] = TO_METRES @ position
    return points[np.linalg.norm(points, axis=1) < NO_RETURN], matrix


def hall_surfaces() -> tuple[list[Surfaces], list[np.ndarray]]:
    """Return the surfaces of the scans of the hall, and the matrices of their poses."""
    with zipfile.ZipFile(HALL) as file:
        points, matrices = zip(*(hall_scan(file, number) for number in range(3)))
    return [_surfaces(scan) for scan in points], list(matrices)


def room_surfaces() -> list[Surfaces]:
    """Return the surfaces of both scans of the room."""
    return [_surfaces(np.loadtxt(ROOMS / f"room_scan{number}.xyz")[:, :3]) for number in (1, 2)]


def _surfaces(points: np.ndarray) -> Surfaces:
    return surfaces_of([points]).seen_from(np.zeros(3))
