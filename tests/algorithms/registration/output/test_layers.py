"""The residuals and the control points as layers."""

from dataclasses import replace

import fiona
import numpy as np
import pytest
from ichnograph.algorithms.registration.lists.point_list import read_point_list
from ichnograph.algorithms.registration.output.layers import (
    RESIDUAL_FIELDS,
    semi_axes,
    write_control,
    write_residuals,
)
from ichnograph.algorithms.registration.registration import register_scans
from ichnograph.algorithms.registration.results import ControlPoint
from ichnograph.algorithms.registration.settings import Matching, Settings
from ichnograph.tests.algorithms.registration.hall import ANNEX, HALL, labels, listed, scanned, several_scans
from ichnograph.tests.algorithms.registration.made_registrations import (
    CORNER,
    correspondence,
    refused,
    registration,
    rejected,
    scan,
)
from rasterio.crs import CRS
from shapely.geometry import shape

POSITION = CORNER + (1.0, 2.0, 3.0)

layers = pytest.mark.parametrize("name", ["layer.shp", "layer.gpkg"])


def read(path):
    # QGIS, where other tests have started it, tells GDAL not to decode shapefiles.
    encoding = "utf-8" if path.suffix == ".shp" else None
    with fiona.open(path, encoding=encoding) as layer:
        assert layer.schema["geometry"] in ("3D Point", "Point")
        return [(shape(item["geometry"]), dict(item["properties"])) for item in layer], layer.crs_wkt


def of_one_scan(*correspondences):
    return replace(registration(1), scans=(scan("S01", correspondences, CORNER),))


@layers
def test_a_residual_stands_at_its_control_point_with_all_its_values(tmp_path, name):
    item = correspondence("T1", "P101", POSITION, residual=(0.002, -0.003, 0.006))
    write_residuals(of_one_scan(item), tmp_path / name)
    [(point, values)], crs = read(tmp_path / name)

    assert (point.x, point.y, point.z) == pytest.approx(tuple(POSITION), abs=1e-6)
    assert CRS.from_wkt(crs) == CRS.from_epsg(25833)
    assert list(values) == list(RESIDUAL_FIELDS)
    assert (values["scan"], values["target"], values["control"]) == ("S01", "T1", "P101")
    assert (values["surveyed"], values["used"]) == (1, 1)
    assert [values[key] for key in ("vx", "vy", "vz", "v")] == pytest.approx([0.002, -0.003, 0.006, 0.007])
    assert [values[key] for key in ("rx", "ry", "rz")] == pytest.approx([0.6, 0.7, 0.65])
    assert [values[key] for key in ("wx", "wy", "wz")] == pytest.approx(item.normalized, abs=1e-3)
    assert [values[key] for key in ("tx", "ty", "tz")] == pytest.approx(item.studentized, abs=1e-3)
    assert [values[key] for key in ("mdbx", "mdby", "mdbz")] == pytest.approx(item.detectable, abs=1e-5)
    ellipsoid = [values[key] for key in ("ell_a", "ell_b", "ell_c")]
    assert ellipsoid == pytest.approx([2.7955 * s for s in (0.003, 0.002, 0.001)], abs=1e-5)


@layers
def test_what_is_not_known_of_a_rejected_target_is_null(tmp_path, name):
    write_residuals(of_one_scan(rejected("T1", "P101", POSITION, (0.3, 0.0, 0.0))), tmp_path / name)
    [(_, values)], _ = read(tmp_path / name)

    assert values["used"] == 0
    assert values["v"] == pytest.approx(0.3)
    assert {key for key, value in values.items() if value is None} == {
        *("rx", "ry", "rz", "tx", "ty", "tz", "mdbx", "mdby", "mdbz")
    }


def test_scans_that_are_not_registered_have_no_residuals(tmp_path):
    write_residuals(registration(2, more=[refused("S99")]), tmp_path / "residuals.gpkg")
    features, _ = read(tmp_path / "residuals.gpkg")

    assert {values["scan"] for _, values in features} == {"S01", "S02"}


@layers
def test_control_points_have_origin_precision_and_the_scans_that_saw_them(tmp_path, name):
    points = (
        ControlPoint("P1", POSITION, np.zeros((3, 3)), "surveyed", ("S01", "S02")),
        ControlPoint("P2", POSITION, np.zeros((3, 3)), "surveyed", ()),
        ControlPoint("S01:7", POSITION, np.diag([4e-6, 9e-6, 1e-6]), "S01", ("S01",)),
    )
    write_control(replace(registration(), points=points), tmp_path / name)
    features, _ = read(tmp_path / name)

    assert [list(values.values())[:2] for _, values in features] == [
        ["P1", "surveyed"],
        ["P2", "surveyed"],
        ["S01:7", "S01"],
    ]
    assert [list(values.values())[2:] for _, values in features[:2]] == [
        [0, 0, 0, 2, "S01, S02"],
        [0, 0, 0, 0, features[1][1]["seen_by"]],
    ]
    assert list(features[2][1].values())[2:5] == pytest.approx([0.002, 0.003, 0.001])
    assert not features[1][1]["seen_by"]
    assert features[0][0].z == pytest.approx(POSITION[2])


@layers
def test_names_in_any_script_come_back(tmp_path, name):
    write_residuals(of_one_scan(correspondence("Süd-Ost", "点7", POSITION)), tmp_path / name)
    [(_, values)], _ = read(tmp_path / name)

    assert (values["target"], values["control"]) == ("Süd-Ost", "点7")


@layers
def test_a_name_that_is_too_long_ends_in_an_ellipsis_after_a_whole_letter(tmp_path, name):
    write_residuals(of_one_scan(correspondence("ü" * 60, "P1", POSITION)), tmp_path / name)
    [(_, values)], _ = read(tmp_path / name)

    assert values["target"] == "ü" * 38 + "…"


@layers
def test_a_point_that_many_scans_saw_lists_whole_names(tmp_path, name):
    scans = tuple(f"scan_{number:03d}" for number in range(100))
    points = (ControlPoint("P1", POSITION, np.zeros((3, 3)), "surveyed", scans),)
    write_control(replace(registration(), points=points), tmp_path / name)
    [(_, values)], _ = read(tmp_path / name)

    shown = values["seen_by"].split(", ")
    assert shown[:-1] == list(scans[: len(shown) - 1])
    assert shown[-1] == "…"
    assert values["scans"] == 100


@layers
def test_without_a_reference_system_the_layers_have_none(tmp_path, name):
    write_control(replace(registration(), crs=None), tmp_path / name)
    _, crs = read(tmp_path / name)

    assert "25833" not in crs


def test_an_ellipsoid_holds_the_stated_share_of_errors():
    random = np.random.default_rng(0)
    covariance = np.array([[4.0, 1.0, 0.0], [1.0, 2.0, 0.5], [0.0, 0.5, 1.0]])
    errors = random.multivariate_normal(np.zeros(3), covariance, 20_000)
    axes = np.linalg.eigh(covariance)[1]
    inside = np.sum((errors @ axes / semi_axes(covariance)[::-1]) ** 2, axis=1) <= 1

    assert inside.mean() == pytest.approx(0.95, abs=0.01)
    assert np.isnan(semi_axes(np.full((3, 3), np.nan))).all()


@pytest.mark.parametrize("suffix", [".gpkg", ".shp"])
def test_control_out_given_again_as_control_knows_its_appended_points(tmp_path, suffix):
    scans = {name: listed(name, xyz) for name, (xyz, _) in several_scans().items()}
    first = register_scans(listed("control", HALL, prefix="P"), [scans["a"]])
    write_control(first, tmp_path / f"control{suffix}")
    control = read_point_list(tmp_path / f"control{suffix}")
    again = register_scans(control, [scans["b"]])

    assert control.names == tuple(point.name for point in first.points)
    assert [point.origin for point in again.points[: len(control.names)]] == [
        point.origin for point in first.points
    ]
    (scan,) = again.scans
    used = [item for item in scan.correspondences if item.used]
    assert used and not any(item.surveyed for item in used)
    assert all(np.trace(point.covariance) > 0 for point in again.points if point.origin == "a")
    assert any("appended by an earlier registration (a)" in warning for warning in again.warnings)
    fixed = register_scans(replace(control, origins=(), stds=None), [scans["b"]]).scans[0]
    assert scan.std > fixed.std, "the points count with their standard deviations"


def test_by_names_an_appended_point_has_the_name_of_its_target(tmp_path):
    (xyz, _), named = several_scans()["a"], Settings(matching=Matching.NAMES)
    names = [f"P{row}" for row in range(1, 9)] + [f"T{row}" for row in range(1, len(ANNEX) + 1)]
    first = register_scans(listed("control", HALL, prefix="P"), [listed("a", xyz, names)], named)
    write_control(first, tmp_path / "control.gpkg")
    later = listed("b", scanned(ANNEX)[0], names[8:])
    (scan,) = register_scans(read_point_list(tmp_path / "control.gpkg"), [later], named).scans

    assert labels(scan) == {name: f"a:{name}" for name in names[8:]}
