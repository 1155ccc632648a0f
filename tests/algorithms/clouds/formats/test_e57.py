"""E57: scans with poses, limits and marks of what is invalid."""

import gzip
import pickle
import sys
from pathlib import Path

import numpy as np
import pytest
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.clouds.formats.e57 import E57Source
from ichnograph.algorithms.clouds.formats.ptx import PtxSource
from ichnograph.algorithms.clouds.settings import ReadingSettings
from ichnograph.algorithms.errors import InputError, MissingPackageError
from ichnograph.algorithms.progress import Progress
from ichnograph.tests.algorithms.clouds.sample_files import write_e57
from ichnograph.tests.fuzz.mutations import with_checksums
from rasterio.crs import CRS

DATA = Path(__file__).parents[5] / "shared" / "data"

XYZ = np.array([[1.5, 2.25, 3.0], [4.5, 5.25, 6.5], [-7.5, 8.0, 9.125]])
QUARTER_TURN = ((np.sqrt(0.5), 0, 0, np.sqrt(0.5)), (100, 200, 300))
"""A pose: about the vertical, then the shift."""


def fields(**others):
    return {**dict(zip(("cartesianX", "cartesianY", "cartesianZ"), XYZ.T)), **others}


def read(path, size=1000):
    chunks = list(E57Source.open(path).chunks(np.zeros(3), Progress(), size))
    return (
        np.concatenate([chunk.xyz for chunk in chunks]),
        None if chunks[0].intensity is None else np.concatenate([c.intensity for c in chunks]),
        None if chunks[0].rgb is None else np.concatenate([c.rgb for c in chunks]),
        {name: np.concatenate([c.attributes[name] for c in chunks]) for name in chunks[0].attributes},
    )


def test_coordinates_alone(tmp_path):
    xyz, intensity, rgb, attributes = read(write_e57(tmp_path / "a.e57", XYZ))
    np.testing.assert_array_equal(xyz, XYZ)
    assert (intensity, rgb, attributes) == (None, None, {})


def test_each_scan_is_moved_by_its_pose(tmp_path):
    xyz, *_ = read(write_e57(tmp_path / "a.e57", fields(pose=QUARTER_TURN), XYZ))
    np.testing.assert_allclose(xyz[:3], np.column_stack([-XYZ[:, 1], XYZ[:, 0], XYZ[:, 2]]) + (100, 200, 300))
    np.testing.assert_array_equal(xyz[3:], XYZ)


def test_a_chunk_says_where_its_scanner_stood_if_the_scan_has_a_pose(tmp_path):
    source = E57Source.open(write_e57(tmp_path / "a.e57", fields(pose=QUARTER_TURN), XYZ))
    posed, without = source.chunks(np.array([100.0, 0, 0]), Progress(), 1000)
    assert posed.station.tolist() == [0, 200, 300]
    assert without.station is None


def test_polar_coordinates_become_cartesian(tmp_path):
    distance = np.linalg.norm(XYZ, axis=1)
    polar = {
        "sphericalRange": distance,
        "sphericalAzimuth": np.arctan2(XYZ[:, 1], XYZ[:, 0]),
        "sphericalElevation": np.arcsin(XYZ[:, 2] / distance),
    }
    np.testing.assert_allclose(read(write_e57(tmp_path / "a.e57", polar))[0], XYZ, atol=1e-12)


@pytest.mark.parametrize("state", [1, 2])
def test_points_that_are_marked_invalid_are_left_out(tmp_path, state):
    scan = fields(cartesianInvalidState=[0, state, 0], intensity=[0.0, 0.5, 1.0])
    xyz, intensity, _, attributes = read(write_e57(tmp_path / "a.e57", scan))
    np.testing.assert_array_equal(xyz, XYZ[[0, 2]])
    np.testing.assert_array_equal(intensity, [0, 65535])
    assert attributes == {}


@pytest.mark.parametrize(
    ("values", "limits", "expected"),
    [
        ([0.0, 0.5, 1.0], None, [0, 32768, 65535]),
        ([0.1, 0.2, 0.5], (0.1, 0.5), [6554, 13107, 32768]),
        ([-2048, 0, 2047], (-2048, 2047), [0, 32776, 65535]),
        ([0, 51, 255], (0, 255), [0, 13107, 65535]),
        ([0, 51, 255], None, [0, 13107, 65535]),
        ([0.0, 0.0, 0.0], (0, 0), [0, 0, 0]),
    ],
)
def test_intensity_is_brought_to_16_bits_by_its_limits(tmp_path, values, limits, expected):
    scan = fields(intensity=values)
    if limits:
        scan["limits"] = dict(
            zip(("intensityLimits/intensityMinimum", "intensityLimits/intensityMaximum"), limits)
        )
    np.testing.assert_array_equal(read(write_e57(tmp_path / "a.e57", scan))[1], expected)


@pytest.mark.parametrize("brightest", [255, 65535])
def test_colour_is_brought_to_16_bits_by_its_values_whatever_is_announced(tmp_path, brightest):
    names = ("colorRed", "colorGreen", "colorBlue")
    limits = {
        f"colorLimits/{name}{end}": value
        for name in names
        for end, value in (("Minimum", 0), ("Maximum", brightest))
    }
    scan = fields(colorRed=[200, 0, 1], colorGreen=[0, 100, 1], colorBlue=[0, 0, 50], limits=limits)
    expected = np.array([[200, 0, 0], [0, 100, 0], [1, 1, 50]]) * 257
    np.testing.assert_array_equal(read(write_e57(tmp_path / "a.e57", scan))[2], expected)


@pytest.mark.parametrize(("values", "factor"), [([0.0, 0.5, 1.0], 65535), ([0.0, 7.0, 255.0], 257)])
def test_colour_in_floating_point_without_limits_is_brought_to_16_bits(tmp_path, values, factor):
    scan = fields(**dict.fromkeys(("colorRed", "colorGreen", "colorBlue"), np.array(values)))
    expected = np.rint(np.array([values] * 3).T * factor)
    np.testing.assert_array_equal(read(write_e57(tmp_path / "a.e57", scan))[2], expected)


def test_what_else_the_points_have_is_kept_and_normals_turn_with_the_pose(tmp_path):
    normals = {f"nor:normal{axis}": values for axis, values in zip("XYZ", np.eye(3))}
    scan = fields(rowIndex=[0, 300, 2], columnIndex=[1, 1, 1], timeStamp=[0.5, 1.5, 2.5], **normals)
    *_, attributes = read(write_e57(tmp_path / "a.e57", {**scan, "pose": QUARTER_TURN}))
    assert (attributes["rowIndex"].dtype, attributes["columnIndex"].dtype) == (np.uint16, np.uint8)
    np.testing.assert_array_equal(attributes["rowIndex"], [0, 300, 2])
    np.testing.assert_array_equal(attributes["timeStamp"], [0.5, 1.5, 2.5])
    turned = np.stack([attributes[f"normal{axis}"] for axis in "XYZ"], axis=1)
    np.testing.assert_allclose(turned, [[0, 1, 0], [-1, 0, 0], [0, 0, 1]], atol=1e-12)


def test_what_one_scan_lacks_is_zero_there(tmp_path):
    first, second = fields(intensity=[0.5, 0.5, 1.0], rowIndex=[1, 2, 3]), fields(rowIndex=[400, 1, 1])
    _, intensity, _, attributes = read(write_e57(tmp_path / "a.e57", first, second))
    np.testing.assert_array_equal(intensity, [32768, 32768, 65535, 0, 0, 0])
    np.testing.assert_array_equal(attributes["rowIndex"], [1, 2, 3, 400, 1, 1])


def test_the_reference_system_is_read(tmp_path):
    path = write_e57(tmp_path / "a.e57", XYZ, wkt=CRS.from_epsg(25833).to_wkt())
    assert E57Source.open(path).crs == CRS.from_epsg(25833)


def test_a_broken_reference_system_is_a_warning(tmp_path):
    source = E57Source.open(write_e57(tmp_path / "a.e57", XYZ, wkt="somewhere"))
    assert source.crs is None
    assert "cannot be understood" in source.warnings[0]


@pytest.mark.parametrize("size", [1, 2, 3, 4])
def test_chunks_do_not_change_a_bit(tmp_path, size):
    path = write_e57(tmp_path / "a.e57", fields(pose=QUARTER_TURN, rowIndex=[1, 2, 3]), XYZ)
    np.testing.assert_array_equal(read(path, size)[0], read(path)[0])
    reported = []
    progress = Progress(report=lambda fraction, message: reported.append(fraction))
    list(E57Source.open(path).chunks(np.zeros(3), progress, size))
    assert reported == sorted(reported) and reported[-1] == 1.0


def test_a_file_can_be_sent_to_another_process(tmp_path):
    source = pickle.loads(pickle.dumps(E57Source.open(write_e57(tmp_path / "a.e57", XYZ))))
    assert sum(len(chunk.xyz) for chunk in source.chunks(np.zeros(3), Progress(), 2)) == 3


def test_another_content_is_refused(tmp_path):
    pytest.importorskip("pye57", reason="pye57 is not installed")
    (tmp_path / "a.e57").write_text("1 2 3\n")
    with pytest.raises(InputError, match=r"a\.e57 is not an E57 file"):
        E57Source.open(tmp_path / "a.e57")


@pytest.mark.parametrize("left", [20, 100, -100])
def test_a_truncated_file_is_an_input_error(tmp_path, left):
    path = write_e57(tmp_path / "a.e57", XYZ)
    path.write_bytes(path.read_bytes()[:left])
    with pytest.raises(InputError, match=r"a\.e57 is truncated or damaged"):
        E57Source.open(path)


def test_damage_within_the_points_is_an_input_error(tmp_path):
    rng = np.random.default_rng(1)
    path = write_e57(tmp_path / "a.e57", rng.uniform(-9, 9, (50_000, 3)))
    content = bytearray(path.read_bytes())
    content[len(content) // 2] ^= 255
    path.write_bytes(content)
    with pytest.raises(InputError, match="truncated or damaged"):
        read(path)


def test_a_file_without_valid_points_is_refused(tmp_path):
    path = write_e57(tmp_path / "a.e57", fields(cartesianInvalidState=[2, 2, 2]))
    with pytest.raises(InputError, match="holds no points"):
        E57Source.open(path)


def test_without_the_package_only_e57_is_refused(tmp_path, monkeypatch):
    path = write_e57(tmp_path / "a.e57", XYZ)
    monkeypatch.setitem(sys.modules, "pye57", None)
    with pytest.raises(
        MissingPackageError, match=r"a\.e57 cannot be read without pye57 and pyquaternion; install"
    ):
        open_cloud([path])


@pytest.mark.parametrize(
    ("name", "count"),
    [
        ("e57_pump_room/pumpAVisualReferenceImage.e57", 155201),
        ("format_ptx_pts_pdal/A4.e57", 4),
        ("format_ptx_pts_pdal/A_B.e57", 6),
    ],
)
def test_files_of_other_programs(name, count):
    pytest.importorskip("pye57", reason="pye57 is not installed")
    if not (DATA / name).exists():
        pytest.skip("the shared data are not here")
    assert len(read(DATA / name)[0]) == count


def test_a_real_scan_has_the_points_of_its_ptx(tmp_path):
    pytest.importorskip("pye57", reason="pye57 is not installed")
    folder = DATA / "e57_pump_room"
    if not folder.exists():
        pytest.skip("the shared data are not here")
    (tmp_path / "pump.ptx").write_bytes(gzip.decompress((folder / "pump_derived.ptx.gz").read_bytes()))
    chunks = list(PtxSource.open(tmp_path / "pump.ptx").chunks(np.zeros(3), Progress(), 1_000_000))
    xyz, _, rgb, _ = read(folder / "pumpAVisualReferenceImage.e57", 1_000_000)
    np.testing.assert_allclose(xyz, np.concatenate([chunk.xyz for chunk in chunks]), atol=1e-9)
    np.testing.assert_array_equal(rgb, np.concatenate([chunk.rgb for chunk in chunks]))


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="memory is read as Linux has it")
def test_files_that_are_opened_again_and_again_take_no_more_memory(tmp_path):
    path = write_e57(tmp_path / "a.e57", np.random.default_rng(0).uniform(0, 9, (3000, 3)))

    def pages():
        return int(Path("/proc/self/statm").read_text().split()[1])

    for _ in range(5):
        E57Source.open(path)
    before = pages()
    for _ in range(20):
        E57Source.open(path)

    assert pages() - before < 2500, "10 MB; an open reader keeps 2 MB"


def limited(fields, **limits):
    """Return a scan that announces ranges of its colours and intensity."""
    return {
        **fields,
        "limits": {
            f"{group}Limits/{name}{end}": value
            for group, names in (
                ("color", ("colorRed", "colorGreen", "colorBlue")),
                ("intensity", ("intensity",)),
            )
            for name in names
            for end, value in zip(("Minimum", "Maximum"), limits.get(group, ()))
        },
    }


def test_of_a_large_scan_the_range_that_occurs_counts_and_not_the_one_that_is_announced(tmp_path):
    count = 200
    colour = np.zeros(count, int)
    colour[-1] = 200
    intensity = np.linspace(0.01, 0.02, count)
    intensity[-1] = 0.5
    scan = {name: np.arange(count) / 8 for name in ("cartesianX", "cartesianY", "cartesianZ")}
    scan.update(dict.fromkeys(("colorRed", "colorGreen", "colorBlue"), colour), intensity=intensity)
    path = write_e57(tmp_path / "a.e57", limited(scan, color=(0, 65535), intensity=(0, 65535)))
    source = E57Source.open(path, ReadingSettings(whole_points=50, sample_points=50, chunk_points=60))
    (chunk,) = source.chunks(np.zeros(3), Progress(), 1000)
    assert chunk.rgb[-1].tolist() == [200 * 257] * 3
    assert chunk.intensity[-1] == 32768


def test_an_announced_range_of_which_little_occurs_does_not_darken_the_intensity(tmp_path):
    scan = limited(fields(intensity=[0.0, 0.5, 1.0]), intensity=(0, 65535))
    np.testing.assert_array_equal(read(write_e57(tmp_path / "a.e57", scan))[1], [0, 32768, 65535])


def test_values_that_are_marked_invalid_are_0_and_decide_no_range(tmp_path):
    names = ("colorRed", "colorGreen", "colorBlue")
    scan = fields(
        **{name: [200, 60_000, 1] for name in names},
        intensity=[0.5, 900.0, 1.0],
        isColorInvalid=[0, 1, 0],
        isIntensityInvalid=[0, 1, 0],
    )
    _, intensity, rgb, _ = read(write_e57(tmp_path / "a.e57", scan))
    np.testing.assert_array_equal(intensity, [32768, 0, 65535])
    np.testing.assert_array_equal(rgb[:, 0], np.array([200, 0, 1]) * 257)


def test_scans_without_the_colour_of_others_are_said(tmp_path):
    path = write_e57(tmp_path / "a.e57", fields(intensity=[0.0, 0.5, 1.0]), fields())
    assert "Some scans of" in E57Source.open(path).warnings[0]
    assert "have no intensity" in E57Source.open(path).warnings[0]


def test_polar_coordinates_in_degrees_are_refused(tmp_path):
    polar = {
        "sphericalRange": [1.0, 2, 3],
        "sphericalAzimuth": [0.0, 90, 180],
        "sphericalElevation": [0.0, 45, 1],
    }
    with pytest.raises(InputError, match="has angles of up to 180, though E57 prescribes radians"):
        read(write_e57(tmp_path / "a.e57", polar))


def test_an_error_of_the_library_without_a_text_is_one_sentence(tmp_path):
    path = write_e57(tmp_path / "a.e57", fields(intensity=[0.0, 0.5, 1.0]))
    data = bytearray(path.read_bytes())
    # The position of the data, in the header of the points.
    data[80] = 197
    path.write_bytes(with_checksums(bytes(data)))
    with pytest.raises(InputError, match=r"truncated or damaged \(its parts contradict each other\)"):
        read(path)


def test_a_scan_without_pose_among_others_is_said(tmp_path):
    points = np.random.default_rng(0).random((9, 3))
    fields = dict(zip(("cartesianX", "cartesianY", "cartesianZ"), points.T))
    posed = {**fields, "pose": ((1, 0, 0, 0), (5, 0, 0))}

    assert "Scan 2 of" in E57Source.open(write_e57(tmp_path / "a.e57", posed, points)).warnings[0]
    assert E57Source.open(write_e57(tmp_path / "b.e57", points, points)).warnings == ()
    assert E57Source.open(write_e57(tmp_path / "c.e57", posed, posed)).warnings == ()
