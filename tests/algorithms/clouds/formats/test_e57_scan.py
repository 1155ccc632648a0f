"""What the header of an E57 scan says of its points."""

import numpy as np
import pytest
from ichnograph.algorithms.clouds.formats.e57_scan import describe, plain_name
from ichnograph.algorithms.errors import InputError
from ichnograph.tests.algorithms.clouds.sample_files import write_e57

libe57 = pytest.importorskip("pye57", reason="pye57 is not installed").libe57

XYZ = dict(zip(("cartesianX", "cartesianY", "cartesianZ"), np.arange(9.0).reshape(3, 3)))


@pytest.fixture
def scan(tmp_path):
    """Return the description of a scan with some fields."""

    def scan(**fields):
        path = write_e57(tmp_path / "a.e57", fields)
        image = libe57.ImageFile(str(path), "r")
        try:
            return describe(libe57, path, image.root()["data3D"][0], 0)
        finally:
            image.close()

    return scan


def test_fields_are_sorted_into_those_with_a_meaning_and_further_attributes(scan):
    whole = np.array([1, 2, 300])
    found = scan(**XYZ, intensity=[0.1, 0.2, 0.3], rowIndex=whole, quality=[0.5, 0.5, 0.5])
    assert found.count == 3
    assert set(found.fields) == {*XYZ, "intensity", "rowIndex", "quality"}
    assert found.attributes == {"rowIndex": np.dtype(np.uint16), "quality": np.dtype(np.float64)}


def test_without_a_pose_points_are_not_moved(scan):
    found = scan(**XYZ)
    np.testing.assert_array_equal(found.rotation, np.eye(3))
    np.testing.assert_array_equal(found.shift, np.zeros(3))


def test_the_pose_is_a_rotation_by_a_quaternion_and_a_shift(scan):
    found = scan(**XYZ, pose=((np.sqrt(0.5), 0, 0, np.sqrt(0.5)), (100, 200, 300)))
    np.testing.assert_allclose(found.rotation @ [1, 0, 0], [0, 1, 0], atol=1e-12)
    np.testing.assert_array_equal(found.shift, [100, 200, 300])


def test_limits_are_those_of_the_header_or_else_of_the_type(scan):
    limits = {"intensityLimits/intensityMinimum": 0, "intensityLimits/intensityMaximum": 0.5}
    colour = dict.fromkeys(("colorRed", "colorGreen", "colorBlue"), np.array([0, 1, 255]))
    found = scan(**XYZ, **colour, intensity=[0.1, 0.2, 0.3], limits=limits)
    assert (found.intensity_limits, found.brightest) == ((0, 0.5), 255)


def test_limits_that_nothing_announces_are_unknown(scan):
    assert np.isnan([*scan(**XYZ).intensity_limits, scan(**XYZ).brightest]).all()


@pytest.mark.parametrize(
    ("pose", "problem"),
    [
        (((1, 0, 0, 0), (1e300, 0, 0)), "moves the points by"),
        (((1, 0, 0, 0), (0, 0, -1e12)), "moves the points by"),
    ],
)
def test_a_pose_that_moves_no_points_is_refused(scan, pose, problem):
    with pytest.raises(InputError, match=f"pose of scan 1 of .*a.e57 {problem}"):
        scan(**XYZ, pose=pose)


@pytest.mark.parametrize(
    ("quaternion", "doubt"), [((0, 0, 0, 0), "is all zero"), ((2, 0, 0, 0), "has the length 2 instead of 1")]
)
def test_a_quaternion_that_is_no_rotation_is_said(scan, quaternion, doubt):
    found = scan(**XYZ, pose=(quaternion, (1, 2, 3)))
    np.testing.assert_array_equal(found.rotation, np.eye(3))
    assert doubt in found.warnings[0]


def test_a_scan_without_coordinates_is_refused(scan):
    with pytest.raises(InputError, match=r"a\.e57 has a scan without coordinates"):
        scan(intensity=[0.1, 0.2])


def test_the_prefix_of_an_extension_does_not_belong_to_a_name():
    assert plain_name("nor:normalX") == "normalX"
    assert plain_name("rowIndex") == "rowIndex"
