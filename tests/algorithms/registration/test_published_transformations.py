"""Published transformations, to every printed digit."""

from pathlib import Path

import numpy as np
import pytest
from ichnograph.algorithms.registration.lists.point_list import PointList, read_point_list
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.settings import Matching, Model, Settings

DATA = Path(__file__).resolve().parents[4] / "shared" / "data" / "registration"
pytestmark = pytest.mark.skipif(not DATA.is_dir(), reason="the published data sets are not there")

SECOND = 1 / 3600


def transform(name, model, sigma):
    control, targets = (read_point_list(DATA / f"{name}_{end}.txt") for end in ("target", "source"))
    settings = Settings(Matching.NAMES, model, sigma)
    registration = register_scans(control, [targets], settings)
    (scan,) = registration.scans
    assert scan.registered, scan.reason
    return scan, {estimate.name: estimate for estimate in scan.estimates}


def printed(values, digits):
    return [round(float(value), digits) for value in values]


def shifts(estimates):
    return [estimates[f"shift_{axis}"].value for axis in "xyz"]


def test_grafarend_similarity():
    scan, estimates = transform("grafarend", Model.SIMILARITY, 1.0)

    # The last of the printed digits depends on the processor.
    assert round(scan.scale, 15) == round(1.0000055825198515, 15)
    assert printed(shifts(estimates), 7) == printed([641.8804252804, 68.6553454548, 416.3981847838], 7)
    angles = [estimates[f"rotation_{axis}"].value / SECOND for axis in "xyz"]
    assert printed(angles, 6) == [0.998498, -0.893696, -0.993088]
    # Exact arithmetic gives 0.08351053743: further digits drown in those that a double has at 4000 km.
    assert round(scan.test.sum_of_squares, 9) == round(0.08351053705, 9)
    assert round(scan.test.redundancy) == 14
    assert round(scan.test.sigma0, 9) == round(0.077233661, 9)
    stds = [estimates[f"rotation_{axis}"].std / SECOND for axis in "xyz"]
    assert printed(stds, 5) == [0.31346, 0.34944, 0.27899]
    assert round(estimates["scale"].std * 1e6, 5) == 1.11016


def test_grafarend_residuals():
    scan, _ = transform("grafarend", Model.SIMILARITY, 1.0)
    observed_less_computed = {
        "Solitude": [93.989, 135.110, 140.223],
        "BuochZeil": [58.816, -49.699, 13.708],
        "Hohenneuffen": [-39.897, -87.946, -8.063],
        "Kuehlenberg": [20.202, -21.981, -87.419],
        "ExMergelaec": [-91.892, 13.928, -5.490],
        "ExHofAsperg": [-11.817, 6.529, -54.622],
        "ExKaisersbach": [-29.401, 4.059, 1.662],
    }

    assert {item.target: printed(-1000 * item.residual, 3) for item in scan.correspondences} == (
        observed_less_computed
    )


def test_grafarend_rigid():
    scan, estimates = transform("grafarend", Model.RIGID, 1.0)

    assert printed(shifts(estimates), 4) == [665.0703, 72.4260, 443.0612]
    assert round(scan.test.sigma0, 6) == 0.124992
    assert round(scan.test.redundancy) == 15


def test_grafarend_tests_of_outliers():
    scan, _ = transform("grafarend", Model.SIMILARITY, 0.05)
    solitude = scan.correspondences[0]
    largest = max(np.abs(item.normalized).max() for item in scan.correspondences)

    assert round(scan.test.sum_of_squares, 6) == 33.404215
    assert round(scan.test.sigma0, 6) == 1.544673
    assert round(scan.test.probability, 5) == 0.00252
    assert printed(solitude.redundancy, 4) == [0.8218, 0.8309, 0.8185]
    assert round(largest, 3) == 3.100 == round(abs(solitude.normalized[2]), 3)
    assert printed(1000 * solitude.detectable, 2) == [227.91, 226.66, 228.37]


def test_jag3d_third():
    scan, estimates = transform("jag3d_third", Model.SIMILARITY, 1.0)
    angles = [
        1 + 17 / 60 + 33.86 * SECOND,
        -(10 / 60 + 37.07 * SECOND),
        72 + 46 / 60 + 28.72 * SECOND,
    ]

    assert round(scan.scale, 10) == round(1.5282869516, 10)
    assert round(estimates["scale"].std, 8) == 0.00029945
    for axis, angle in zip("xyz", angles):
        assert abs(estimates[f"rotation_{axis}"].value - angle) < 0.0051 * SECOND
    assert printed(shifts(estimates), 5) == [1767.84692, -769.92562, -181.34866]
    assert round(scan.test.sigma0, 8) == 0.09198012
    assert round(scan.test.redundancy) == 5


def test_levelled_plane_coordinates():
    rows = {end: np.loadtxt(DATA / f"levelled_{end}.txt")[:, 1:] for end in ("source", "target")}
    lists = {
        end: PointList(end, ("1", "2", "3", "4"), np.column_stack([each, np.zeros(4)]))
        for end, each in rows.items()
    }
    settings = Settings(Matching.NAMES, Model.LEVELLED_SCALE, 0.05)
    (scan,) = register_scans(lists["target"], [lists["source"]], settings).scans

    assert round(scan.scale, 12) == round(1.000160369835, 12)
    assert round(scan.matrix[0, 0], 12) == round(0.999787994227, 12)
    assert round(scan.matrix[1, 0], 12) == round(-0.027289778074, 12)
    assert round({item.name: item.value for item in scan.estimates}["rotation_z"], 10) == -1.5635324426
    assert printed(scan.matrix[:2, 3], 4) == [82135.4073, 47128.1437]
    assert [printed(item.residual[:2], 4) for item in scan.correspondences] == [
        *([-0.0024, -0.0008], [-0.0165, 0.0132], [0.0318, 0.0160], [-0.0129, -0.0283]),
    ]


@pytest.mark.parametrize(
    "number, inliers",
    [(1, 10), (2, 9), (3, 7), (4, 25), (5, 10)],
    ids=["0 %", "10 %", "30 %", "50 %", "90 %"],
)
def test_teaser_unknown_scale_with_a_share_of_wrong_rows(number, inliers):
    folder = DATA / f"teaser_{number}"
    source, target = (_ply(folder / f"{end}.ply") for end in ("src", "dst"))
    scale = float((folder / "s_ref.csv").read_text())
    rotation = np.loadtxt(folder / "R_ref.csv", delimiter=",")
    shift = np.loadtxt(folder / "t_ref.csv", delimiter=",")
    settings = Settings(Matching.NAMES, Model.UNKNOWN_SCALE, 3e-4 if number == 1 else 1e-5)
    (scan,) = register_scans(target, [source], settings).scans

    assert sum(item.used for item in scan.correspondences) == inliers
    tolerance = 1e-3 if number == 1 else 2e-6
    assert abs(scan.scale - scale) < tolerance
    assert np.abs(scan.matrix[:3, :3] / scan.scale - rotation).max() < tolerance
    assert np.abs(scan.matrix[:3, 3] - shift).max() < tolerance


def _ply(path):
    values = np.array(path.read_text().split("end_header")[1].split(), float).reshape(-1, 3)
    return PointList(path.stem, tuple(str(row + 1) for row in range(len(values))), values, False)
