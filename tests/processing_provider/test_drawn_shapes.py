"""Lines and polygons from layers, whatever their kind, and the files that no output may replace."""

import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.vector import write_vector
from shapely.geometry import LineString


@pytest.fixture
def read(provider):
    """Read FACADE_ALONG as facadedetails does."""
    from ichnograph.processing_provider.parameters.facade import FACADE_ALONG
    from qgis.core import QgsProcessingContext

    def read(given):
        algorithm, context = provider.algorithm("facadedetails").create(), QgsProcessingContext()
        value = FACADE_ALONG.value(algorithm, {"FACADE_ALONG": given}, context)
        return value, FACADE_ALONG.sources(value)

    return read


@pytest.fixture
def layer(plugin):
    """Make a layer of the texts of shapes, None for a feature without one."""
    from qgis.core import QgsFeature, QgsGeometry, QgsVectorLayer

    def layer(kind, *texts):
        made = QgsVectorLayer(kind, "drawn", "memory")
        features = [QgsFeature() for _ in texts]
        for feature, text in zip(features, texts):
            if text:
                feature.setGeometry(QgsGeometry.fromWkt(text))
        made.dataProvider().addFeatures(features)
        return made

    return layer


@pytest.mark.parametrize(
    ("kind", "text", "length"),
    [
        ("CompoundCurve", "CompoundCurve((0 0, 4 0), CircularString(4 0, 5 1, 4 2))", 4 + 3.1416),
        ("CurvePolygon", "CurvePolygon(CircularString(0 0, 1 1, 2 0, 1 -1, 0 0))", 2 * 3.1416),
        ("LineString", "LineString(0 0, 4 0)", 4),
    ],
)
def test_arcs_become_lines_and_features_without_a_shape_are_passed_over(read, layer, kind, text, length):
    value, sources = read(layer(kind, None, text))
    assert [shape.length for shape in value.shapes] == pytest.approx([length], rel=1e-3)
    assert sources == []


def test_a_layer_of_empty_features_is_refused(read, layer):
    with pytest.raises(InputError, match="FACADE_ALONG has no lines or polygons"):
        read(layer("LineString", None, "LineString EMPTY"))


def test_a_shape_that_is_no_line_is_refused(read, layer):
    with pytest.raises(InputError, match="FACADE_ALONG has a shape that cannot be read"):
        read(layer("LineString", "LineString(0 0)"))


def test_the_file_of_the_layer_is_an_input_that_no_output_may_replace(read, tmp_path):
    from qgis.core import QgsProcessingFeatureSourceDefinition

    path = str(tmp_path / "lines.gpkg")
    line = (LineString([(0, 0), (4, 0)]), {"name": "a"})
    write_vector(tmp_path / "lines.gpkg", "LineString", {"name": "str:8"}, [line], None)
    for given in (path, f"{path}|layername=lines", QgsProcessingFeatureSourceDefinition(path)):
        value, sources = read(given)
        assert (len(value.shapes), sources) == (1, [path])


def test_without_a_layer_there_are_no_shapes_and_no_files(read):
    value, sources = read(None)
    assert (value.shapes, sources) == ((), [])
