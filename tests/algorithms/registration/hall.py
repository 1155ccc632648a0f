"""Lists of points for the tests, and how a scan sees them."""

import numpy as np
from ichnograph.algorithms.registration.lists.point_list import PointList
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.settings import Settings
from scipy.spatial.transform import Rotation

HALL = np.array(
    [
        *([0.0, 0.0, 1.2], [7.9, 0.3, 2.9], [12.4, 5.1, 1.7], [9.2, 9.8, 0.4]),
        *([3.1, 8.7, 2.2], [0.6, 5.5, 3.4], [5.8, 4.2, 4.1], [11.7, 1.6, 0.8]),
    ]
)
"""Places in a hall of 12 by 10 m whose distances differ."""

GRID = np.array([4_500_000.0, 5_800_000.0, 320.0])


def listed(name, xyz, names=None, prefix=""):
    """Return a list of points, named by their rows if no names are given."""
    numbered = tuple(f"{prefix}{row + 1}" for row in range(len(xyz)))
    return PointList(name, tuple(names) if names else numbered, np.asarray(xyz, float), bool(names or prefix))


def scanned(places, heading=40.0, tilt=0.0, station=(3.0, 2.0, 1.6), scale=1.0, noise=0.0, seed=0):
    """Return places as a scanner at `station` has them in its own frame, and the matrix back."""
    matrix = np.eye(4)
    matrix[:3, :3] = scale * Rotation.from_euler("XYZ", [tilt, 0.0, heading], degrees=True).as_matrix()
    matrix[:3, 3] = station
    exact = np.linalg.solve(matrix[:3, :3], (np.asarray(places) - matrix[:3, 3]).T).T
    return exact + np.random.default_rng(seed).normal(0.0, 1.0, exact.shape) * noise / scale, matrix


def labels(scan):
    """Return target to control of what a scan is registered by."""
    return {item.target: item.control for item in scan.correspondences if item.used}


ANNEX = HALL[:6] * [1.1, 0.8, 0.9] + [14.0, 3.0, 0.4]
TOWER = HALL[2:8] * [0.9, 1.2, 1.3] + [26.0, 5.0, 2.0]


def several_scans():
    """Three scans: one of the surveyed hall and the annex, one of annex and tower, one of the tower only."""
    place = {"a": np.concatenate([HALL, ANNEX]), "b": np.concatenate([ANNEX, TOWER]), "c": TOWER}
    return {
        name: scanned(places, heading=50 + 70 * number, noise=0.001, seed=number)
        for number, (name, places) in enumerate(place.items())
    }


def register(control, targets, **chosen):
    """Return the registration of one scan, called scan, to control points P1, P2 and so on."""
    points = listed("control", control, prefix="P")
    (scan,) = register_scans(points, [listed("scan", targets)], Settings(**chosen)).scans
    if not scan.registered:
        assert scan.matrix is None and scan.reason.endswith(".")
        assert "scan" in scan.reason
    return scan
