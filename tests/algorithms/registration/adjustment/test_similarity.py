"""The best similarity beside published solutions."""

import numpy as np
import pytest
from ichnograph.algorithms.registration.adjustment.similarity import (
    Pose,
    fit_pose,
    moved_pose,
    parameter_design,
    rotation_about,
)
from ichnograph.algorithms.registration.settings import Model
from ichnograph.tests.algorithms.registration.hall import HALL, scanned
from scipy.spatial.transform import Rotation

# Seven stations of Baden-Wuerttemberg, local and in WGS 84: Grafarend and Awange (2003), Nonlinear analysis
# of the three-dimensional datum transformation [conformal group C7(3)], Journal of Geodesy 77.
LOCAL = np.array(
    [
        [4157222.543, 664789.307, 4774952.099],
        [4149043.336, 688836.443, 4778632.188],
        [4172803.511, 690340.078, 4758129.701],
        [4177148.376, 642997.635, 4760764.800],
        [4137012.190, 671808.029, 4791128.215],
        [4146292.729, 666952.887, 4783859.856],
        [4138759.902, 702670.738, 4785552.196],
    ]
)
GLOBAL = np.array(
    [
        [4157870.237, 664818.678, 4775416.524],
        [4149691.049, 688865.785, 4779096.588],
        [4173451.354, 690369.375, 4758594.075],
        [4177796.064, 643026.700, 4761228.899],
        [4137659.549, 671837.337, 4791592.531],
        [4146940.228, 666982.151, 4784324.099],
        [4139407.506, 702700.227, 4786016.645],
    ]
)


def test_the_datum_transformation_of_grafarend_and_awange():
    pose = fit_pose(GLOBAL, LOCAL, Model.SIMILARITY)
    squares = ((pose.apply(LOCAL) - GLOBAL) ** 2).sum()

    assert float(pose.scale) == pytest.approx(1.00000558251985, abs=1e-14)
    assert pose.matrix()[:3, 3] == pytest.approx([641.8804, 68.6553, 416.3982], abs=5e-4)
    assert pose.rotation[0, 1] == pytest.approx(4.81462e-6, abs=1e-10), "0.993088 seconds about z"
    assert squares == pytest.approx(0.08351053705, abs=2e-9)


def test_the_plane_example_of_umeyama():
    # Umeyama (1991), Least-squares estimation of transformation parameters between two point patterns, IEEE
    # PAMI 13 (4), figure 1: the triangle and its mirror image, which a rotation must not imitate.
    triangle = np.array([[0.0, 0, 0], [1, 0, 0], [0, 2, 0]])
    mirrored = np.array([[0.0, 0, 0], [-1, 0, 0], [0, 2, 0]])
    pose = fit_pose(mirrored, triangle, Model.LEVELLED_SCALE)

    assert np.round(pose.rotation[:2, :2], 3).tolist() == [[0.832, 0.555], [-0.555, 0.832]]
    assert round(float(pose.scale), 3) == 0.721
    assert np.round(pose.matrix()[:2, 3], 3).tolist() == [-0.800, 0.400]


@pytest.mark.parametrize("flat", [False, True])
def test_the_quaternion_of_horn_agrees_with_the_singular_values_of_kabsch(flat):
    # Horn (1987), Closed-form solution of absolute orientation using unit quaternions, JOSA A 4 (4),
    # minimises what Kabsch (1976) does by singular values.
    random = np.random.default_rng(5)
    places = HALL * [1, 1, 0] if flat else HALL
    targets = scanned(places, tilt=25.0)[0] + random.normal(0, 0.1, HALL.shape)
    rotation = fit_pose(places, targets, Model.RIGID).rotation
    kabsch, _ = Rotation.align_vectors(places - places.mean(axis=0), targets - targets.mean(axis=0))

    assert rotation == pytest.approx(kabsch.as_matrix(), abs=1e-9)
    assert np.linalg.det(rotation) == pytest.approx(1.0)


@pytest.mark.parametrize("model", Model)
def test_exact_targets_come_back_in_every_model(model):
    targets, matrix = scanned(HALL, tilt=0.0 if model.levelled else 12.0, scale=2.5 if model.scaled else 1.0)
    pose = fit_pose(HALL, targets, model)

    assert pose.apply(targets) == pytest.approx(HALL, abs=1e-12)
    assert pose.matrix() == pytest.approx(matrix, abs=1e-12)


def test_a_stack_of_poses_is_fitted_at_once():
    seen = [scanned(HALL, heading=heading)[0] for heading in (10.0, 130.0, 250.0)]
    stack = fit_pose(np.stack([HALL] * 3), np.stack(seen), Model.RIGID)

    for number, targets in enumerate(seen):
        assert stack[number].matrix() == pytest.approx(fit_pose(HALL, targets, Model.RIGID).matrix())


def test_coincident_targets_divide_nothing_by_zero():
    assert np.isfinite(fit_pose(HALL[:3], np.zeros((3, 3)), Model.SIMILARITY).matrix()).all()


@pytest.mark.parametrize("model", Model)
def test_the_design_holds_the_derivatives_by_the_parameters(model):
    targets, _ = scanned(HALL, tilt=0.0 if model.levelled else 12.0)
    pose = fit_pose(HALL, targets, model)
    design = parameter_design(pose.rotated(targets), model)

    assert design.shape == (len(HALL), 3, model.unknowns)
    for unknown in range(model.unknowns):
        step = 1e-6 * np.eye(model.unknowns)[unknown]
        difference = moved_pose(pose, step, model).apply(targets) - moved_pose(pose, -step, model).apply(
            targets
        )
        assert difference / 2e-6 == pytest.approx(design[:, :, unknown], abs=1e-7)


def test_a_rotation_about_a_vector_turns_by_its_length():
    vector = np.array([0.3, -0.2, 0.9])

    assert rotation_about(vector) == pytest.approx(Rotation.from_rotvec(vector).as_matrix())
    assert np.array_equal(rotation_about(np.zeros(3)), np.eye(3))


def test_the_matrix_says_the_same_as_the_pose():
    pose = Pose(Rotation.from_euler("z", 30, degrees=True).as_matrix(), np.array(1.5), HALL[0], HALL[1])

    assert HALL @ pose.matrix()[:3, :3].T + pose.matrix()[:3, 3] == pytest.approx(pose.apply(HALL))
