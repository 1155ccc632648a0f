"""A transformed cloud is where exact arithmetic puts it, and loses nothing on the way."""

from fractions import Fraction

import laspy
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.clouds.cloud import open_cloud, open_sources
from ichnograph.algorithms.clouds.settings import WritingSettings
from ichnograph.algorithms.clouds.writing.transformation import (
    refuse_other_units,
    rounding_warnings,
    transform_cloud,
    transformed_names,
)
from ichnograph.algorithms.errors import CancelledError, InputError
from ichnograph.algorithms.geometry.motion import Motion
from ichnograph.algorithms.progress import Progress
from ichnograph.tests.algorithms.clouds.sample_files import write_e57, write_ply, write_ptx
from laspy.vlrs.known import WktCoordinateSystemVlr
from laspy.vlrs.vlrlist import VLRList
from rasterio.crs import CRS
from scipy.spatial.transform import Rotation

TENTH_OF_A_MILLIMETRE = 1e-4
UTM = CRS.from_epsg(25833)


def similarity(angles, shift, scale=1.0):
    matrix = np.eye(4)
    matrix[:3, :3] = scale * Rotation.from_euler("xyz", angles, degrees=True).as_matrix()
    matrix[:3, 3] = shift
    return matrix


MATRIX = similarity([1, -2, 130], [412345.678, 5812345.789, 71.234], 1.0001)
QUARTER_TURN = np.array([[0.0, -1, 0, 7_000_000], [1, 0, 0, 5_000_000], [0, 0, 1, 100], [0, 0, 0, 1]])
X, Y, Z = "6999998.00000", "5000001.00000", "103.00000"
"""Where the quarter turn puts the point 1, 2, 3."""


def exactly(matrix, xyz):
    """Return the transformed points by rational arithmetic, rounded once."""
    rows = [[Fraction(value) for value in row] for row in matrix[:3].tolist()]
    points = [[Fraction(value) for value in point] + [1] for point in xyz.tolist()]
    return np.array([[float(sum(a * b for a, b in zip(row, point))) for row in rows] for point in points])


def transform(path, matrix, target, crs=UTM, progress=Progress()):
    (source,) = open_sources([path])
    return transform_cloud(source, matrix, target, crs, progress)


def las(path, xyz, point_format=7, version="1.4", scale=1e-4, extra=(), epsg=None):
    """Write points with random attributes, a record of their own and the extra dimensions `extra`."""
    rng = np.random.default_rng(len(xyz))
    header = laspy.LasHeader(version=version, point_format=point_format)
    header.scales, header.offsets = np.full(3, scale), np.floor(np.min(xyz, axis=0))
    header.vlrs.append(laspy.VLR("surveyor", 7, "note", b"kept"))
    for name, values, options in extra:
        header.add_extra_dim(laspy.ExtraBytesParams(name, values.dtype, **options))
    if epsg:
        header.vlrs.append(WktCoordinateSystemVlr(CRS.from_epsg(epsg).to_wkt()))
    points = laspy.ScaleAwarePointRecord.zeros(len(xyz), header=header)
    for name in points.array.dtype.names:
        points.array[name] = rng.integers(1, 200, len(xyz))
    for name, values, _ in extra:
        points.array[name] = values
    points.x, points.y, points.z = np.transpose(xyz)
    with laspy.open(path, "w", header=header) as writer:
        writer.write_points(points)
    return path


@pytest.fixture
def xyz():
    return np.random.default_rng(1).uniform(-30, 30, (40, 3)).round(4)


coordinates = st.floats(-50, 50)
places = st.tuples(st.floats(-8e6, 8e6), st.floats(-8e6, 8e6), st.floats(-5000, 5000))


@settings(max_examples=100)
@given(
    points=st.lists(st.tuples(coordinates, coordinates, coordinates), min_size=1, max_size=5),
    angles=st.tuples(*[st.floats(-180, 180)] * 3),
    before=places,
    after=places,
    scale=st.floats(0.3, 3),
)
def test_a_motion_is_exact_wherever_the_points_lie_before_and_after(points, angles, before, after, scale):
    matrix = similarity(angles, after, scale)
    origin = np.floor(before)
    xyz = np.array(points) + origin
    motion = Motion.about(matrix, xyz[0])
    moved = motion.positions(xyz - motion.origin) + motion.offset
    np.testing.assert_allclose(moved, exactly(matrix, xyz), rtol=0, atol=2e-8)


@pytest.mark.parametrize("place", [0.0, 7_000_000.0])
@pytest.mark.parametrize("name", ["scan.las", "scan.laz", "scan.xyz"])
def test_a_file_is_exact_to_a_tenth_of_a_millimetre(tmp_path, xyz, place, name):
    xyz = xyz + [place, place, 0]
    if name.endswith(".xyz"):
        np.savetxt(tmp_path / name, xyz, "%.4f")
    else:
        las(tmp_path / name, xyz)
    stored = open_cloud([tmp_path / name])
    before = np.concatenate([chunk.xyz for chunk in stored.chunks()]) + stored.origin
    (tmp_path / "out").mkdir()
    assert transform(tmp_path / name, MATRIX, tmp_path / "out" / name) == len(xyz)
    moved = open_cloud([tmp_path / "out" / name])
    after = np.concatenate([chunk.xyz for chunk in moved.chunks()]) + moved.origin
    np.testing.assert_allclose(after, exactly(MATRIX, before), rtol=0, atol=TENTH_OF_A_MILLIMETRE / 2 + 2e-9)


@pytest.mark.parametrize("point_format", [0, 1, 2, 3, 6, 7, 8])
@pytest.mark.parametrize("name", ["out.las", "out.laz"])
def test_las_keeps_its_point_format_every_attribute_and_record(tmp_path, xyz, name, point_format):
    extra = [
        ("deviation", np.arange(40, dtype=np.uint16), {}),
        ("range", np.arange(40, dtype=np.int32), {"scales": np.array([0.01]), "offsets": np.zeros(1)}),
    ]
    las(tmp_path / "in.laz", xyz, point_format, extra=extra, epsg=25832)
    transform(tmp_path / "in.laz", MATRIX, tmp_path / name)
    before, after = laspy.read(tmp_path / "in.laz"), laspy.read(tmp_path / name)
    assert after.header.point_format == before.header.point_format
    for dimension in set(before.points.array.dtype.names) - {"X", "Y", "Z"}:
        np.testing.assert_array_equal(after.points.array[dimension], before.points.array[dimension])
    np.testing.assert_array_equal(after["range"], before["range"])
    assert after.header.vlrs.get_by_id("surveyor", (7,))[0].record_data == b"kept"
    assert open_cloud([tmp_path / name]).crs == UTM


@pytest.mark.parametrize("version", ["1.2", "1.3"])
def test_an_old_las_keeps_its_points_and_gets_the_reference_system(tmp_path, xyz, version):
    las(tmp_path / "in.las", xyz, 3, version)
    transform(tmp_path / "in.las", MATRIX, tmp_path / "out.las")
    after = laspy.read(tmp_path / "out.las")
    np.testing.assert_array_equal(after.gps_time, laspy.read(tmp_path / "in.las").gps_time)
    assert open_cloud([tmp_path / "out.las"]).crs == UTM


def test_without_a_reference_system_the_former_one_is_gone(tmp_path, xyz):
    las(tmp_path / "in.las", xyz, epsg=25832)
    transform(tmp_path / "in.las", MATRIX, tmp_path / "out.las", crs=None)
    assert open_cloud([tmp_path / "out.las"]).crs is None


def test_records_behind_the_points_are_kept(tmp_path):
    header = laspy.LasHeader(version="1.4", point_format=6)
    with laspy.open(tmp_path / "in.laz", "w", header=header) as writer:
        writer.write_points(laspy.ScaleAwarePointRecord.zeros(3, header=header))
        writer.write_evlrs(VLRList([laspy.VLR("surveyor", 7, "note", b"kept")]))
    transform(tmp_path / "in.laz", MATRIX, tmp_path / "out.laz")
    assert laspy.read(tmp_path / "out.laz").evlrs[0].record_data == b"kept"


@pytest.mark.parametrize(("point_format", "remaining"), [(4, 1), (5, 3)])
def test_waveforms_are_left_out_and_said_to_be(tmp_path, xyz, point_format, remaining):
    las(
        tmp_path / "in.las",
        xyz,
        point_format,
        "1.3",
        extra=[("deviation", np.arange(40, dtype=np.uint16), {})],
    )
    said = []
    progress = Progress(report=lambda fraction, message: said.append(message))
    transform(tmp_path / "in.las", MATRIX, tmp_path / "out.las", progress=progress)
    before, after = laspy.read(tmp_path / "in.las"), laspy.read(tmp_path / "out.las")
    assert after.header.point_format.id == remaining
    for dimension in ("deviation", "gps_time", "intensity"):
        np.testing.assert_array_equal(after[dimension], before[dimension])
    assert "in.las holds waveforms, which are left out." in said


def test_coarse_coordinates_are_stored_finely_enough(tmp_path, xyz):
    las(tmp_path / "in.las", xyz, scale=0.01)
    transform(tmp_path / "in.las", MATRIX, tmp_path / "out.las")
    np.testing.assert_array_equal(laspy.read(tmp_path / "out.las").header.scales, [1e-4] * 3)


@pytest.mark.parametrize(
    ("names", "kind", "options"),
    [
        (("NormalX", "NormalY", "NormalZ"), np.float32, {}),
        (("nx", "ny", "nz"), np.float64, {}),
        (
            ("normal x", "normal y", "normal z"),
            np.int16,
            {"scales": np.array([1e-4]), "offsets": np.zeros(1)},
        ),
    ],
)
def test_normals_in_extra_dimensions_turn_along(tmp_path, xyz, names, kind, options):
    normals = np.random.default_rng(2).normal(size=(40, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    stored = np.rint(normals / 1e-4) if options else normals
    extra = [(name, stored[:, axis].astype(kind), options) for axis, name in enumerate(names)]
    las(tmp_path / "in.las", xyz, extra=extra)
    transform(tmp_path / "in.las", MATRIX, tmp_path / "out.laz")
    after = laspy.read(tmp_path / "out.laz")
    turned = np.stack([after[name] for name in names], axis=1)
    np.testing.assert_allclose(turned, normals @ MATRIX[:3, :3].T / 1.0001, atol=2e-4)


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("1 2 3\n", f"{X} {Y} {Z}\n"),
        ("x;y;z;note\n1,5;2;3;façade\n", "x;y;z;note\n6999998,00000;5000001,50000;103,00000;façade\n"),
        ("//X Y Z\n# by hand\n1 2 3\n\n# end\n", f"//X Y Z\n# by hand\n{X} {Y} {Z}\n\n# end\n"),
        ("name,z,y,x\na,3.0,2.0,1.0\n", f"name,z,y,x\na,{Z},{Y},{X}\n"),
        ("x, y, z, i\n1.0, 2.0, 3.0, 0.12\n", f"x, y, z, i\n{X}, {Y}, {Z}, 0.12\n"),
        (
            "x\ty\tz\tNx\tNy\tNz\n1\t2\t3\t1\t0\t0\n",
            f"x\ty\tz\tNx\tNy\tNz\n{X}\t{Y}\t{Z}\t0.000000\t1.000000\t0.000000\n",
        ),
        (
            'x,y,z,nx,ny,nz\n"1.0","2.0","3.0","1","0","0"\n',
            f"x,y,z,nx,ny,nz\n{X},{Y},{Z},0.000000,1.000000,0.000000\n",
        ),
        (
            "A;1;2;3\n;1;2;3\nC;1;2;3\n#4;1;2;3\n# end\n",
            f"A;{X};{Y};{Z}\n;{X};{Y};{Z}\nC;{X};{Y};{Z}\n#4;{X};{Y};{Z}\n# end\n",
        ),
        ("x y z nx ny nz\n1 2 3 nan nan nan\n", f"x y z nx ny nz\n{X} {Y} {Z} nan nan nan\n"),
    ],
)
def test_text_is_unchanged_except_for_positions_and_normals(tmp_path, before, after):
    (tmp_path / "in.txt").write_text(before, encoding="utf-8")
    transform(tmp_path / "in.txt", QUARTER_TURN, tmp_path / "out.txt")
    assert (tmp_path / "out.txt").read_text(encoding="utf-8") == after


def test_pts_keeps_its_counts_and_intensities(tmp_path):
    (tmp_path / "in.pts").write_text("2\n1 2 3 -500 1 2 3\n2 2 3 9 1 2 3\n1\n1 2 4 7 3 2 1\n")
    assert transform(tmp_path / "in.pts", QUARTER_TURN, tmp_path / "out.pts") == 3
    lines = (tmp_path / "out.pts").read_text().splitlines()
    assert [line.split(" ", 3)[-1] for line in lines] == ["2", "-500 1 2 3", "9 1 2 3", "1", "7 3 2 1"]


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "latin-1"])
def test_text_keeps_its_encoding(tmp_path, encoding):
    (tmp_path / "in.csv").write_bytes("x,y,z,stuff\n1.0,2.0,3.0,Mörtel\n".encode(encoding))
    transform(tmp_path / "in.csv", QUARTER_TURN, tmp_path / "out.csv")
    expected = "x,y,z,stuff\n6999998.00000,5000001.00000,103.00000,Mörtel\n"
    assert (tmp_path / "out.csv").read_bytes() == expected.encode(encoding)


def test_a_ply_becomes_a_laz_with_all_its_properties(tmp_path, xyz):
    normals = np.random.default_rng(2).normal(size=(40, 3)).astype(np.float32)
    names = ("nx", "ny", "nz", "red", "green", "blue", "intensity", "scalar_Deviation", "classification")
    colour = np.random.default_rng(3).integers(0, 256, (40, 3)).astype(np.uint8)
    others = [np.linspace(0, 1, 40), np.float32(xyz[:, 0]), np.arange(40, dtype=np.uint8)]
    points = np.rec.fromarrays([*xyz.T, *normals.T, *colour.T, *others], names=["x", "y", "z", *names])
    types = ["double"] * 3 + ["float"] * 3 + ["uchar"] * 3 + ["double", "float", "uchar"]
    write_ply(tmp_path / "in.ply", points, types=types)
    assert transform(tmp_path / "in.ply", MATRIX, tmp_path / "out.laz") == 40
    after = laspy.read(tmp_path / "out.laz")
    np.testing.assert_allclose(after.xyz, exactly(MATRIX, xyz), rtol=0, atol=TENTH_OF_A_MILLIMETRE / 2 + 2e-9)
    turned = np.stack([after["nx"], after["ny"], after["nz"]], axis=1)
    np.testing.assert_allclose(turned, normals @ MATRIX[:3, :3].T / 1.0001, atol=1e-6)
    np.testing.assert_array_equal(np.stack([after.red, after.green, after.blue], axis=1), colour * 257.0)
    np.testing.assert_array_equal(after.intensity, np.rint(others[0] * 65535))
    np.testing.assert_array_equal(after["scalar_Deviation"], others[1])
    # LAS has a classification of its own, with another meaning.
    np.testing.assert_array_equal(after["classification_2"], others[2])
    assert open_cloud([tmp_path / "out.laz"]).crs == UTM


def test_a_ptx_becomes_a_laz_with_intensity_and_colour(tmp_path, xyz):
    write_ptx(
        tmp_path / "in.ptx", np.column_stack([xyz, np.linspace(0, 1, 40), np.tile([255, 1, 0], (40, 1))])
    )
    transform(tmp_path / "in.ptx", MATRIX, tmp_path / "out.laz")
    after = laspy.read(tmp_path / "out.laz")
    np.testing.assert_allclose(after.xyz, exactly(MATRIX, xyz), rtol=0, atol=TENTH_OF_A_MILLIMETRE / 2 + 2e-9)
    np.testing.assert_array_equal(after.intensity, np.rint(np.linspace(0, 1, 40) * 65535))
    np.testing.assert_array_equal(after.green, 257)


def test_an_e57_becomes_a_laz_with_rows_columns_and_normals(tmp_path, xyz):
    fields = dict(zip(("cartesianX", "cartesianY", "cartesianZ", "rowIndex"), [*xyz.T, np.arange(40)]))
    normals = {f"nor:normal{axis}": np.full(40, float(axis == "X")) for axis in "XYZ"}
    write_e57(tmp_path / "in.e57", {**fields, **normals})
    transform(tmp_path / "in.e57", QUARTER_TURN, tmp_path / "out.laz")
    after = laspy.read(tmp_path / "out.laz")
    np.testing.assert_array_equal(after["rowIndex"], np.arange(40))
    np.testing.assert_array_equal(after["normalY"], 1.0)
    np.testing.assert_array_equal(after["normalX"], 0.0)


@pytest.mark.parametrize("kind", ["float", "double"])
def test_long_names_of_properties_stay_apart(tmp_path, xyz, kind):
    names = [f"scalar_distance_to_the_reference_{number}" for number in range(12)]
    points = np.rec.fromarrays(
        [*xyz.T, *[np.full(40, float(n)) for n in range(12)]], names=["x", "y", "z", *names]
    )
    write_ply(tmp_path / "in.ply", points, "ascii", types=["double"] * 3 + [kind] * 12)
    transform(tmp_path / "in.ply", MATRIX, tmp_path / "out.laz")
    after = laspy.read(tmp_path / "out.laz")
    extra = list(after.point_format.extra_dimension_names)
    assert len(set(extra)) == 12
    assert [after[name][0] for name in extra] == list(range(12))


@settings(deadline=None, max_examples=10)
@given(size=st.integers(1, 45))
def test_chunks_do_not_change_a_byte(tmp_path_factory, size):
    folder = tmp_path_factory.mktemp("chunks")
    xyz = np.random.default_rng(1).uniform(-30, 30, (40, 3))
    las(folder / "in.las", xyz)
    np.savetxt(folder / "in.xyz", xyz)
    for name in ("in.las", "in.xyz"):
        transform(folder / name, MATRIX, folder / f"whole_{name}")
        (source,) = open_sources([folder / name])
        pieces = WritingSettings(chunk_points=size, text_lines=size)
        transform_cloud(source, MATRIX, folder / f"parts_{name}", UTM, settings=pieces)
        assert (folder / f"whole_{name}").read_bytes() == (folder / f"parts_{name}").read_bytes()


def test_a_copc_becomes_a_laz_and_other_names_are_kept(tmp_path, xyz):
    names = ("Scan.COPC.LAZ", "scan.xyz", "b.las", "c.PLY", "d.ptx")
    las(tmp_path / "Scan.COPC.LAZ", xyz)
    np.savetxt(tmp_path / "scan.xyz", xyz)
    las(tmp_path / "b.las", xyz)
    write_ply(tmp_path / "c.PLY", xyz)
    write_ptx(tmp_path / "d.ptx", xyz)
    sources = open_sources([tmp_path / name for name in names])
    assert transformed_names(sources) == ("Scan.laz", "scan.xyz", "b.las", "c.laz", "d.laz")


def test_two_clouds_that_would_become_one_file_are_refused(tmp_path, xyz):
    (tmp_path / "b").mkdir()
    paths = [las(tmp_path / "a.laz", xyz), las(tmp_path / "b" / "A.laz", xyz)]
    with pytest.raises(InputError, match=r"would both become A\.laz"):
        transformed_names(open_sources(paths))


def test_an_input_is_never_overwritten(tmp_path, xyz):
    before = las(tmp_path / "in.las", xyz).read_bytes()
    with pytest.raises(InputError, match="is an input as well"):
        transform(tmp_path / "in.las", MATRIX, tmp_path / "in.las")
    assert (tmp_path / "in.las").read_bytes() == before


@pytest.mark.parametrize("name", ["in.laz", "in.xyz"])
def test_cancelling_leaves_no_output(tmp_path, xyz, name):
    las(tmp_path / "in.laz", xyz)
    np.savetxt(tmp_path / "in.xyz", xyz)
    with pytest.raises(CancelledError):
        transform(
            tmp_path / name, MATRIX, tmp_path / f"out_{name}", progress=Progress(is_cancelled=lambda: True)
        )
    assert {file.name for file in tmp_path.iterdir()} == {"in.laz", "in.xyz"}


def cloud_in(path, epsg):
    header = laspy.LasHeader(version="1.4", point_format=6)
    header.scales = np.full(3, 1e-3)
    header.vlrs.append(WktCoordinateSystemVlr(CRS.from_epsg(epsg).to_wkt()))
    data = laspy.LasData(header)
    data.x, data.y, data.z = np.full((3, 5), 1000)
    data.write(path)
    return open_sources([path])


@pytest.mark.parametrize(("epsg", "unit"), [(2994, "in foot"), (4326, "in degrees")])
def test_a_cloud_that_is_not_in_metres_is_refused(tmp_path, epsg, unit):
    with pytest.raises(InputError, match=f"scan.las, which transformations .* are {unit}"):
        refuse_other_units(cloud_in(tmp_path / "scan.las", epsg))


def test_a_cloud_in_metres_is_fine(tmp_path):
    refuse_other_units(cloud_in(tmp_path / "scan.las", 25833))


@pytest.mark.parametrize(("decimals", "is_said"), [(4, True), (15, False)])
def test_a_matrix_that_is_rounded_too_much_for_the_distance_of_the_points_is_said(
    tmp_path, decimals, is_said
):
    matrix = np.eye(4)
    matrix[:3, :3] = np.round(Rotation.from_euler("xyz", [10, 20, 30], degrees=True).as_matrix(), decimals)
    (source,) = cloud_in(tmp_path / "scan.las", 25833)
    assert bool(rounding_warnings(source, matrix)) is is_said


def test_a_las_whose_header_has_letters_that_las_does_not_allow_is_written(tmp_path):
    (source,) = cloud_in(tmp_path / "scan.las", 25833)
    data = bytearray((tmp_path / "scan.las").read_bytes())
    data[26:32] = "Müller".encode("latin-1")
    (tmp_path / "scan.las").write_bytes(data)
    assert transform(tmp_path / "scan.las", np.eye(4), tmp_path / "out.las") == source.point_count
