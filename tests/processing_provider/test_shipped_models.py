"""The models that the provider lists: valid, described, and they run."""

import fiona
import numpy as np
import pytest
from ichnograph.tests.processing_provider.room import CORNER, covered_points, write_las
from ichnograph.tests.scenes.stations.caster import CROSSED, Panel, Scanner, Window, cast
from qgis.core import QgsProcessingContext
from rasterio.crs import CRS

MODELS = ("Control points and scans to site plan", "Facade to drawing", "Storeys one by one")


@pytest.fixture
def model(provider):
    def model(name):
        kept.append(provider.algorithm(name).create())
        return kept[-1]

    kept = []
    return model


@pytest.mark.parametrize("name", MODELS)
def test_a_model_is_valid_and_says_what_it_does(model, name):
    assert model(name).validate() == (True, [])
    assert len(model(name).shortHelpString()) > 50
    assert model(name).group() == "Models"


@pytest.mark.parametrize("name", MODELS)
def test_a_model_gives_values_for_parameters_that_exist(model, name):
    for child in model(name).childAlgorithms().values():
        known = {item.name() for item in child.algorithm().parameterDefinitions()}
        assert {*child.parameterSources()} <= known


@pytest.mark.parametrize("name", MODELS)
def test_a_model_has_a_help_for_every_parameter_and_a_page(model, name):
    assert all(item.help() for item in model(name).parameterDefinitions())
    assert "<" not in model(name).shortHelpString(), "headless it is plain"
    assert model(name).helpUrl().endswith("models.md")


@pytest.mark.parametrize("name", MODELS)
def test_the_scans_of_a_model_are_chosen_by_their_endings_and_kept_in_the_history(model, name):
    scans = model(name).parameterDefinition("SCANS")
    assert "*.e57" in scans.createFileFilter()
    command = model(name).asPythonCommand({"SCANS": ["/scans/a.laz"]}, QgsProcessingContext())
    assert command == f"processing.run(\"ichnograph:{name}\", {{'SCANS':['/scans/a.laz']}})"


def test_the_inputs_of_a_model_are_in_the_order_of_the_work(model):
    inputs = [item.name() for item in model(MODELS[0]).parameterDefinitions() if not item.isDestination()]
    assert inputs == ["CONTROL", "SCANS", "TARGETS", "SYSTEM"]


def test_models_are_listed(provider):
    assert {item.displayName() for item in provider.algorithms() if item.group() == "Models"} == {*MODELS}


def test_two_storeys_are_drawn_from_the_same_scans(run, model, tmp_path):
    below = covered_points()
    write_las(tmp_path / "house.laz", np.concatenate([below, below + (0, 0, 2.8)]), CRS.from_epsg(25833))
    slabs = {f"SLAB_{number + 1}": float(CORNER[2]) - 0.15 + 2.8 * number for number in range(3)}
    outputs = {
        item.name(): str(tmp_path / f"{number}.gpkg")
        for number, item in enumerate(model("Storeys one by one").destinationParameterDefinitions())
    }
    run("Storeys one by one", SCANS=[str(tmp_path / "house.laz")], **slabs, **outputs)

    floors = set()
    for path in outputs.values():
        with fiona.open(path) as layer:
            floors |= {
                round(row["properties"]["z_floor"], 1) for row in layer if "z_floor" in row["properties"]
            }
    assert floors == {70.0, 72.8}


LOW, HIGH = np.array([-2.5, -1.8, -1.5]), np.array([3.5, 2.2, 1.0])
"""Corners of a room about the scanner."""

BOARDS = (
    *((0, 3.5, (0.8, 0.4)), (0, -2.5, (-0.9, -0.2)), (1, 2.2, (-1.2, 0.5)), (1, -1.8, (1.9, -0.5))),
    *((0, 3.5, (-1.3, -0.4)), (1, 2.2, (1.6, -0.1))),
)
"""The wall of each target, by its axis and coordinate, and where the target is on it."""


def scanned_room():
    """Return a scan of a room with targets on its walls, and their centres, relative to the scanner."""
    middle, half = (LOW + HIGH) / 2, (HIGH - LOW) / 2
    axes, panels, centres = np.eye(3), [], []
    for axis in range(3):
        others = [other for other in range(3) if other != axis]
        for end in (LOW, HIGH):
            centre = middle.copy()
            centre[axis] = end[axis]
            panels.append(Panel(centre, axes[others], tuple(half[others])))
    for axis, wall, (along, up) in BOARDS:
        centre = np.array([along, along, up])
        centre[axis] = wall * 0.999
        centres.append(centre)
        panels.append(Panel(centre, axes[[1 - axis, 2]], (0.15, 0.15), CROSSED, (0.1, 0.8)))
    window = Window(0.0, -0.05, (np.pi - 0.002, 0.7), tuple(panels))
    return cast(Scanner(step=0.004), window, np.random.default_rng(3)), np.array(centres)


def test_a_site_plan_is_drawn_from_control_points_and_a_raw_scan(run, model, tmp_path):
    (xyz, intensity), centres = scanned_room()
    columns = np.column_stack([xyz, intensity])
    np.savetxt(tmp_path / "room.xyz", columns, "%.4f %.4f %.4f %d", header="x y z intensity", comments="")
    control = centres[:, [1, 0, 2]] * [-1, 1, 1] + CORNER
    np.savetxt(tmp_path / "control.csv", control, "%.4f", delimiter=",")
    name = "Control points and scans to site plan"
    outputs = {
        item.name(): str(tmp_path / f"{number}.{'html' if 'Report' in item.name() else 'gpkg'}")
        for number, item in enumerate(model(name).destinationParameterDefinitions())
    }
    given = {"CONTROL": str(tmp_path / "control.csv"), "SCANS": [str(tmp_path / "room.xyz")]}
    run(name, **given, TARGETS=None, SYSTEM="EPSG:25833", **outputs)

    with fiona.open(next(path for name, path in outputs.items() if name.endswith("Walls"))) as walls:
        west, south, east, north = walls.bounds
    assert (west, south) == pytest.approx((CORNER[0] - HIGH[1], CORNER[1] + LOW[0]), abs=0.3)
    assert (east, north) == pytest.approx((CORNER[0] - LOW[1], CORNER[1] + HIGH[0]), abs=0.3)
