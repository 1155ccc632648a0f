"""Real scans whose poses are known in part; they lie beside the project, and are not part of it."""

import zipfile
from pathlib import Path

import numpy as np
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


def room_scans() -> list[np.ndarray]:
    """Return the points of both scans of the room (m)."""
    return [np.loadtxt(ROOMS / f"room_scan{number}.xyz")[:, :3] for number in (1, 2)]
