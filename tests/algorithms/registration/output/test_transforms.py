"""The TRANSFORMS file: what was found comes back exactly, and what cannot be used is named."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.registration.output.transforms import (
    match_clouds,
    read_transforms,
    write_transforms,
)
from ichnograph.algorithms.registration.results import (
    Correspondence,
    Estimate,
    GlobalTest,
    Registration,
    ScaleTest,
    ScanRegistration,
    SharedSurfaces,
    SurfaceChange,
)
from ichnograph.algorithms.registration.settings import Model, Settings
from rasterio.crs import CRS
from scipy.spatial.transform import Rotation

NOWHERE = np.full(3, np.nan)
MATRIX = np.eye(4)
MATRIX[:3, :3] = 1.0001 * Rotation.from_euler("xyz", [1, 2, 130], degrees=True).as_matrix()
MATRIX[:3, 3] = [412345.6789012345, 5812345.1234567891, 1 / 3]


@pytest.fixture
def registration():
    correspondence = Correspondence(
        target="1",
        control="tower",
        surveyed=True,
        used=False,
        position=np.array([1.0, 2, 3]),
        residual=np.array([0.001, -0.002, 0.1 + 0.2]),
        redundancy=NOWHERE,
        normalized=np.array([0.5, 0.6, 9.7]),
        studentized=NOWHERE,
        detectable=NOWHERE,
        covariance=np.eye(3),
    )
    good = ScanRegistration(
        name="Hall",
        status="registered",
        reason="",
        targets=5,
        matrix=MATRIX,
        scale=1.0001,
        estimates=(Estimate("scale", 1.0001, 0.00002),),
        correlations=np.eye(1),
        correspondences=(correspondence,),
        unmatched=("4", "5"),
        test=GlobalTest(1.5, 0.0, float("nan"), float("nan")),
        scale_test=ScaleTest(100.0, 20.0, True, "The scale differs from 1."),
        chance=np.float64(1e-9),
        round=1,
    )
    bad = ScanRegistration("Gärten", "ambiguous", "Two solutions.", 3, rivals=({"1": "a"}, {"1": "b"}))
    return Registration(
        settings=Settings(model=Model.SIMILARITY),
        tolerance=0.006,
        scans=(good, bad),
        points=(),
        test=GlobalTest(1.5, 4.0, 0.9, 0.6),
        crs=CRS.from_epsg(25833),
        warnings=("Look out.",),
    )


@pytest.fixture
def written(registration, tmp_path):
    write_transforms(registration, tmp_path / "transforms.json")
    return tmp_path / "transforms.json"


def by_hand(tmp_path, **changes):
    scan = {"name": "Hall", "matrix": MATRIX.tolist(), **changes}
    path = tmp_path / "by_hand.json"
    path.write_text(json.dumps({"scans": [scan]}))
    return path


def test_matrices_states_and_reference_system_come_back_exactly(written):
    transforms = read_transforms(written)
    good, bad = transforms.scans
    np.testing.assert_array_equal(good.matrix, MATRIX)
    assert (good.name, good.status, good.reason) == ("Hall", "registered", "")
    assert (bad.name, bad.status, bad.reason, bad.matrix) == ("Gärten", "ambiguous", "Two solutions.", None)
    assert transforms.crs == CRS.from_epsg(25833)


def test_the_file_says_all_that_the_contract_promises(written):
    document = json.loads(written.read_text(encoding="utf-8"))
    good, bad = document["scans"]
    assert good["parameters"] == {"scale": {"value": 1.0001, "std": 0.00002}}
    (correspondence,) = good["correspondences"]
    assert [correspondence[key] for key in ("target", "control", "used")] == ["1", "tower", False]
    assert [correspondence[key] for key in ("vx", "vy", "vz")] == [0.001, -0.002, 0.1 + 0.2]
    assert (good["scale"], good["unmatched"], good["chance"]) == (1.0001, ["4", "5"], 1e-9)
    assert (bad["rivals"], bad["matrix"], bad["scale"]) == ([{"1": "a"}, {"1": "b"}], None, None)
    assert (document["model"], document["sigma0"], document["warnings"]) == ("similarity", 0.9, ["Look out."])


def test_what_cannot_be_known_is_null(written):
    (good, _) = json.loads(written.read_text(encoding="utf-8"))["scans"]
    assert good["sigma0"] is None
    assert good["correspondences"][0]["detectable"] == [None, None, None]


def test_the_same_registration_gives_the_same_bytes(registration, written, tmp_path):
    write_transforms(registration, tmp_path / "again.json")
    assert (tmp_path / "again.json").read_bytes() == written.read_bytes()


def test_a_name_and_a_matrix_are_enough(tmp_path):
    (scan,) = read_transforms(by_hand(tmp_path)).scans
    assert (scan.name, scan.status) == ("Hall", "registered")
    np.testing.assert_array_equal(scan.matrix, MATRIX)


def test_six_decimals_of_a_rotation_are_enough(tmp_path):
    for rotation in Rotation.random(200, random_state=0):
        matrix = np.eye(4)
        matrix[:3, :3] = rotation.as_matrix().round(6)
        read_transforms(by_hand(tmp_path, matrix=matrix.tolist()))


@pytest.mark.parametrize(
    ("changed", "problem"),
    [
        ({"matrix": (np.diag([1e-90, 1e-90, 1e-90, 1])).tolist()}, "has a scale of"),
        ({"matrix": (np.diag([1e60, 1e60, 1e60, 1])).tolist()}, "has a scale of"),
        (
            {"matrix": [[1, 0, 0, 1e300], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]},
            r"moves the scan by 1e\+300 m",
        ),
        ({"matrix": [[10**400, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}, "is not four rows"),
    ],
)
def test_absurd_numbers_are_refused(tmp_path, changed, problem):
    with pytest.raises(InputError, match=problem):
        read_transforms(by_hand(tmp_path, **changed))


@pytest.mark.parametrize("opening", ["[", '{"a":'])
def test_absurd_depth_is_refused(tmp_path, opening):
    (tmp_path / "a.json").write_text(opening * 100_000)
    with pytest.raises(InputError, match="is not json"):
        read_transforms(tmp_path / "a.json")


@pytest.mark.parametrize(
    ("crs", "problem"),
    [
        ("EPSG:4326", "are in degrees"),
        ("EPSG:2263", "are in US survey foot"),
        ("EPSG:7837", "are heights only"),
        ("EPSG:32632+6360", "The heights of .* are in US survey foot"),
        ("nonsense", "cannot be understood"),
        (7, "cannot be understood"),
        ({"type": "x"}, "cannot be understood"),
    ],
)
def test_systems_that_are_not_in_metres_are_refused(tmp_path, crs, problem):
    document = {"crs": crs, "scans": [{"name": "a", "matrix": MATRIX.tolist()}]}
    (tmp_path / "a.json").write_text(json.dumps(document))
    with pytest.raises(InputError, match=problem):
        read_transforms(tmp_path / "a.json")


def test_a_code_names_a_reference_system_too(tmp_path):
    (tmp_path / "a.json").write_text(
        json.dumps({"crs": "EPSG:25833", "scans": [{"name": "a", "matrix": MATRIX.tolist()}]})
    )
    assert read_transforms(tmp_path / "a.json").crs == CRS.from_epsg(25833)


def changed(row, column, value):
    matrix = MATRIX.tolist()
    matrix[row][column] = value
    return matrix


@pytest.mark.parametrize(
    ("matrix", "problem"),
    [
        (None, "is not four rows of four numbers"),
        ("eye", "is not four rows of four numbers"),
        (MATRIX[:3].tolist(), "is not four rows of four numbers"),
        ([[1, 0], [0]], "is not four rows of four numbers"),
        (changed(0, 3, float("nan")), "holds something that is not a number"),
        (changed(0, 3, None), "holds something that is not a number"),
        (changed(3, 0, 1.0), "does not end in the row 0 0 0 1"),
        (np.diag([1.0, 1, -1, 1]).tolist(), "mirrors the scan"),
        (np.diag([1.0, 1, 1.00001, 1]).tolist(), "distorts the scan because its rotation is not orthogonal"),
        (np.diag([0.0, 0, 0, 1]).tolist(), "distorts the scan because its rotation is not orthogonal"),
    ],
)
def test_a_matrix_that_is_no_similarity_is_named_with_its_scan(tmp_path, matrix, problem):
    path = by_hand(tmp_path, matrix=matrix)
    with pytest.raises(InputError) as caught:
        read_transforms(path)
    assert str(caught.value) == f"The matrix of the scan Hall in {path} {problem}; register the scan again."


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("{", "is not json"),
        ("[]", "lists no scans"),
        ("{}", "lists no scans"),
        ('{"scans": []}', "lists no scans"),
        ('{"scans": [7]}', "Scan number 1 in"),
        ('{"scans": [{"matrix": []}]}', "has no name"),
        (
            '{"scans": [{"name": "a", "status": "units"}, {"name": "a", "status": "units"}]}',
            "the scan a twice",
        ),
        ('{"crs": "Mars", "scans": [{"name": "a", "status": "units"}]}', "cannot be understood"),
        (b"\xff\xfe\x00", "is not json"),
    ],
)
def test_another_file_is_refused_in_one_sentence(tmp_path, text, sentence):
    path = tmp_path / "other.json"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(InputError, match=sentence) as caught:
        read_transforms(path)
    assert str(path) in str(caught.value)


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(InputError, match=r"missing\.json cannot be read"):
        read_transforms(tmp_path / "missing.json")


@pytest.mark.parametrize("name", ["Hall.laz", "hall.xyz", "HALL.COPC.LAZ", "Hall.copc.laz"])
def test_a_cloud_has_the_scan_of_its_name(written, name):
    (scan,), warnings = match_clouds(read_transforms(written), [Path("clouds", name)])
    assert (scan.name, warnings) == ("Hall", ())


def test_capitals_matter_where_names_differ_in_nothing_else(tmp_path):
    scans = [{"name": name, "matrix": MATRIX.tolist()} for name in ("A", "a")]
    (tmp_path / "t.json").write_text(json.dumps({"scans": scans}))
    matched, _ = match_clouds(read_transforms(tmp_path / "t.json"), [Path("a.las"), Path("A.las")])
    assert [scan.name for scan in matched] == ["a", "A"]


def test_one_cloud_and_one_scan_belong_together_but_it_is_said(tmp_path):
    path = by_hand(tmp_path)
    (scan,), warnings = match_clouds(read_transforms(path), [Path("export 7.laz")])
    assert scan.name == "Hall"
    assert warnings == (f"The only scan in {path}, Hall, is used for export 7.laz.",)


def test_a_cloud_without_a_scan_is_refused_with_the_names_there_are(written):
    with pytest.raises(InputError, match=r"no scan for attic\.laz in .*, only Hall, Gärten; name the cloud"):
        match_clouds(read_transforms(written), [Path("attic.laz")])


def test_a_cloud_whose_scan_is_not_registered_is_refused_with_the_reason(written):
    told = r"Gärten\.laz is left out because .* not registered in .* \(ambiguous: Two solutions\)\."
    with pytest.raises(InputError, match=told):
        match_clouds(read_transforms(written), [Path("Gärten.laz")])


def test_a_cloud_whose_scan_is_not_registered_does_not_stop_the_others(written):
    scans, warnings = match_clouds(read_transforms(written), [Path("Gärten.laz"), Path("Hall.laz")])
    assert [scan and scan.name for scan in scans] == [None, "Hall"]
    assert len(warnings) == 1 and "Gärten.laz is left out" in warnings[0]


@pytest.mark.parametrize("unit", ["mm", "feet", "US survey feet", "foot_us", 0.3048])
def test_shifts_in_another_unit_are_refused(tmp_path, unit):
    path = by_hand(tmp_path)
    path.write_text(json.dumps({"unit": unit, **json.loads(path.read_text())}))
    with pytest.raises(InputError, match=f"gives matrices in {unit}; write shifts in metres"):
        read_transforms(path)


@pytest.mark.parametrize("unit", ["m", "metres", "Meter"])
def test_the_metre_may_be_stated(tmp_path, unit):
    path = by_hand(tmp_path)
    path.write_text(json.dumps({"unit": unit, **json.loads(path.read_text())}))
    assert read_transforms(path).scans


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16"])
def test_the_encoding_does_not_matter(written, tmp_path, encoding):
    (tmp_path / "again.json").write_text(written.read_text(encoding="utf-8"), encoding=encoding)
    again = read_transforms(tmp_path / "again.json")
    assert [scan.name for scan in again.scans] == [scan.name for scan in read_transforms(written).scans]


def test_shared_surfaces_and_what_they_changed_are_in_the_file(registration, tmp_path):
    first, *others = registration.scans
    tied = replace(first, surfaces=SurfaceChange(shift=0.01, sigmas=1.5, std=0.02, used=True))
    shared = SharedSurfaces(("a", "b"), 0.25, 80, 0.0012, np.array([[1.0, 0.0, 0.0]]))
    write_transforms(replace(registration, scans=(tied, *others), surfaces=(shared,)), tmp_path / "tied.json")
    document = json.loads((tmp_path / "tied.json").read_text(encoding="utf-8"))

    (pair,) = document["surfaces"]
    assert pair == {
        "scans": ["a", "b"],
        "overlap": 0.25,
        "patches": 80,
        "rms": 0.0012,
        "free": [[1.0, 0.0, 0.0]],
    }
    assert document["scans"][0]["surfaces"] == {"shift": 0.01, "sigmas": 1.5, "std": 0.02, "used": True}
    assert all(scan["surfaces"] is None for scan in document["scans"][1:])
