"""The styles: beside the files, and on the layers that Processing loads."""

import pytest
import rasterio

OUTPUTS = {"DENSITY": "density.tif", "PLAN": "plan.tif", "WALLS": "walls.gpkg"}


@pytest.fixture
def paths(tmp_path):
    return {name: str(tmp_path / file) for name, file in OUTPUTS.items()}


@pytest.fixture
def open_layers(run, room, paths):
    """Write the outputs, and open them as a user does."""
    from qgis.core import QgsRasterLayer, QgsVectorLayer

    def open_layers():
        run("siteplan", INPUT=room, **paths)
        kinds = {"DENSITY": QgsRasterLayer, "PLAN": QgsRasterLayer, "WALLS": QgsVectorLayer}
        return {name: kind(paths[name], name) for name, kind in kinds.items()}

    return open_layers


def assert_is_styled(layers, path):
    with rasterio.open(path) as raster:
        values = raster.read(1, masked=True)
    stretch = layers["DENSITY"].renderer().contrastEnhancement()
    low, high = values.mean() - 2 * values.std(), values.mean() + 2 * values.std()
    assert stretch.minimumValue() == pytest.approx(max(values.min(), low), rel=1e-3)
    assert stretch.maximumValue() == pytest.approx(min(values.max(), high), rel=1e-3)
    classes = {entry.value: entry.color.alpha() for entry in layers["PLAN"].renderer().classes()}
    assert classes == {0: 0, 1: 255}
    renderer = layers["WALLS"].renderer()
    assert renderer.classAttribute() == "kind"
    kinds = [entry.value() for entry in renderer.categories()]
    assert kinds == ["straight", "curved", "column", "wall", "parapet", ""]
    assert all(entry.symbol().color().alpha() < 255 for entry in renderer.categories())


def test_a_file_opened_by_hand_has_its_style(open_layers, paths):
    assert_is_styled(open_layers(), paths["DENSITY"])


@pytest.mark.parametrize("loading_order", [["DENSITY", "PLAN", "WALLS"], ["WALLS", "PLAN", "DENSITY"]])
def test_layers_that_processing_loads_are_styled_with_the_walls_on_top(provider, room, paths, loading_order):
    from qgis.core import (
        QgsLayerTreeLayer,
        QgsProcessingContext,
        QgsProcessingFeedback,
        QgsProcessingOutputLayerDefinition,
        QgsProcessingUtils,
        QgsProject,
    )

    context, project, feedback = QgsProcessingContext(), QgsProject(), QgsProcessingFeedback(False)
    context.setProject(project)
    outputs = {name: QgsProcessingOutputLayerDefinition(path, project) for name, path in paths.items()}
    _, succeeded = provider.algorithm("siteplan").run({"INPUT": room, **outputs}, context, feedback)
    assert succeeded

    tree, layers = project.layerTreeRoot(), {}
    for name in loading_order:
        layer = QgsProcessingUtils.mapLayerFromString(paths[name], context)
        layers[name] = context.temporaryLayerStore().takeMapLayer(layer)
        project.addMapLayer(layers[name], False)
        tree.insertChildNode(0, QgsLayerTreeLayer(layers[name]))
        details = context.layerToLoadOnCompletionDetails(paths[name])
        details.postProcessor().postProcessLayer(layers[name], context, feedback)
    assert_is_styled(layers, paths["DENSITY"])
    assert [node.layerId() for node in tree.children()] == [
        layers[name].id() for name in ("WALLS", "PLAN", "DENSITY")
    ]


def test_the_style_of_another_layer_is_not_overwritten(open_layers, tmp_path):
    (tmp_path / "walls.qml").write_text("of walls.kml")
    open_layers()

    assert (tmp_path / "walls.qml").read_text() == "of walls.kml"


def test_the_style_follows_a_layer_that_is_written_anew(open_layers, tmp_path):
    open_layers()
    (tmp_path / "density.qml").write_text("<!-- made by Ichnograph --> older")
    open_layers()

    assert "singlebandgray" in (tmp_path / "density.qml").read_text()


def test_a_style_of_the_user_is_kept_when_the_layer_is_written_anew(open_layers, tmp_path):
    open_layers()
    (tmp_path / "walls.qml").write_text("mine")
    open_layers()

    assert (tmp_path / "walls.qml").read_text() == "mine"


def test_layers_that_differ_in_their_extension_only_get_no_style_beside_them(run, room, tmp_path):
    run("siteplan", INPUT=room, DENSITY=str(tmp_path / "site.tif"), WALLS=str(tmp_path / "site.shp"))

    assert not (tmp_path / "site.qml").exists()
