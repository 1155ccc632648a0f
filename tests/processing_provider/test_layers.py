"""Layers of the project after a run: new data, and no system that cannot be transformed."""

import pytest
from ichnograph.tests.processing_provider.room import room_points, write_las


@pytest.fixture
def bare(tmp_path):
    """Write the room without a reference system."""
    write_las(tmp_path / "bare.las", room_points())
    return str(tmp_path / "bare.las")


@pytest.fixture
def project(plugin):
    from qgis.core import QgsProject

    project = QgsProject.instance()
    project.clear()
    yield project
    project.clear()


@pytest.fixture
def run_and_load(provider, project):
    """Run an algorithm as its dialog does, and load its layers into a project."""
    from processing.gui.Postprocessing import handleAlgorithmResults
    from qgis.core import QgsProcessingContext, QgsProcessingFeedback, QgsProcessingOutputLayerDefinition

    def run_and_load(key, outputs, **inputs):
        context, feedback = QgsProcessingContext(), QgsProcessingFeedback(False)
        context.setProject(project)
        given = {name: QgsProcessingOutputLayerDefinition(path, project) for name, path in outputs.items()}
        algorithm = provider.algorithm(key).create()
        results, succeeded = algorithm.run({**inputs, **given}, context, feedback)
        assert succeeded
        assert handleAlgorithmResults(algorithm, context, feedback)
        return results

    return run_and_load


def test_layers_without_a_system_have_none_in_the_project(run_and_load, project, bare, tmp_path):
    outputs = {"WALLS": str(tmp_path / "walls.gpkg"), "DENSITY": str(tmp_path / "density.tif")}
    run_and_load("siteplan", outputs, INPUT=bare)

    layers = list(project.mapLayers().values())
    assert len(layers) == 2
    assert not any(layer.crs().isValid() for layer in layers)
    assert not project.crs().isValid()


def test_layers_on_earth_keep_their_system(run_and_load, project, room, tmp_path):
    run_and_load("siteplan", {"WALLS": str(tmp_path / "walls.gpkg")}, INPUT=room)

    (walls,) = project.mapLayers().values()
    assert walls.crs().authid() == "EPSG:25833"


def test_a_second_run_into_the_same_file_shows_the_new_walls_in_the_style_of_the_user(
    run_and_load, project, room, tmp_path
):
    outputs = {"WALLS": str(tmp_path / "walls.gpkg"), "DENSITY": str(tmp_path / "density.tif")}
    run_and_load("siteplan", outputs, INPUT=room, REFINE=True)
    before = {layer.name(): layer for layer in project.mapLayers().values()}
    (refined,) = before["Walls"].getFeatures()
    before["Walls"].setOpacity(0.5)
    pixels = before["Density image"].width()
    run_and_load("siteplan", outputs, INPUT=room, REFINE=False, PIXEL_SIZE=0.2)

    after = {layer.name(): layer for layer in project.mapLayers().values()}
    assert after["Walls"] is before["Walls"] and len(after) == 2
    (plain,) = after["Walls"].getFeatures()
    assert after["Walls"].extent().xMaximum() == pytest.approx(
        plain.geometry().boundingBox().xMaximum(), abs=1e-6
    )
    assert plain.geometry().area() > 1.2 * refined.geometry().area()
    assert after["Density image"].width() < 0.7 * pixels
    assert after["Walls"].opacity() == 0.5


def test_what_stands_in_the_project_is_reopened_if_it_is_not_loaded_again(
    run, run_and_load, project, room, tmp_path
):
    walls = str(tmp_path / "walls.gpkg")
    run_and_load("siteplan", {"WALLS": walls}, INPUT=room)
    (layer,) = project.mapLayers().values()
    (refined,) = layer.getFeatures()

    from qgis.core import QgsProcessingContext, QgsProcessingFeedback

    context = QgsProcessingContext()
    context.setProject(project)
    import processing

    given = {"INPUT": room, "REFINE": False, "WALLS": walls}
    processing.run("ichnograph:siteplan", given, context=context, feedback=QgsProcessingFeedback(False))
    (plain,) = layer.getFeatures()
    assert plain.geometry().area() > 1.2 * refined.geometry().area()
