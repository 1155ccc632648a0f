"""The models that the provider lists: valid, described, and they run."""

import fiona
import numpy as np
import pytest
from ichnograph.tests.processing_provider.room import CORNER, covered_points, write_las
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
