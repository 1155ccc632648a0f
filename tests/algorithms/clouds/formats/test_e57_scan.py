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


@pytest.mark.parametrize(
    ("low", "high", "scale"),
    [(0, 1, (0, 65535)), (0, 0.4, (0, 65535)), (-2048, 2047, (2048, 65535 / 4095)), (5, 5, (0, 1))],
)
def test_announced_limits_of_intensity_decide_its_scale(scan, low, high, scale):
    limits = {"intensityLimits/intensityMinimum": low, "intensityLimits/intensityMaximum": high}
    assert scan(**XYZ, intensity=[0.1, 0.2, 0.3], limits=limits).intensity == pytest.approx(scale)


@pytest.mark.parametrize(("brightest", "factor"), [(255, 257), (4095, 1)])
def test_the_type_of_a_colour_decides_its_factor(scan, brightest, factor):
    colour = dict.fromkeys(("colorRed", "colorGreen", "colorBlue"), np.array([0, 1, brightest]))
    assert scan(**XYZ, **colour).rgb_factor == factor


def test_a_scan_without_coordinates_is_refused(scan):
    with pytest.raises(InputError, match=r"a\.e57 has a scan without coordinates"):
        scan(intensity=[0.1, 0.2])


def test_the_prefix_of_an_extension_does_not_belong_to_a_name():
    assert plain_name("nor:normalX") == "normalX"
    assert plain_name("rowIndex") == "rowIndex"
