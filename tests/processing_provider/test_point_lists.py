"""The spellings of CONTROL and TARGETS: files, layers of the project, and layers of no file."""

from pathlib import Path

import fiona
import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from rasterio.crs import CRS

XYZ = [[1.5, 2.25, 3.0], [4.5, 5.25, 6.5], [-7.5, 8.0, 9.125]]
NAMES = ("T1", "T2", "T3")
UTM = "EPSG:25833"


@pytest.fixture(autouse=True)
def project(plugin):
    from qgis.core import QgsProject

    yield QgsProject.instance()
    QgsProject.instance().clear()


@pytest.fixture
def read(plugin, project):
    """Read the value of CONTROL, or of TARGETS, as an algorithm does."""
    from ichnograph.processing_provider.parameters.point_lists import PointListFile, TargetListFiles
    from qgis.core import QgsProcessingContext

    context = QgsProcessingContext()
    context.setProject(project)

    def read(given, several=False):
        kind = TargetListFiles if several else PointListFile
        name = "TARGETS" if several else "CONTROL"
        value = kind(name, "Points", "Help.").value(None, {name: given}, context)
        return value.lists if several else value

    return read


def write_text(path, count=3):
    lines = [f"{name} {x} {y} {z}\n" for name, (x, y, z) in zip(NAMES, XYZ)]
    path.write_text("".join(lines[:count]))
    return str(path)


def write_layer(path, layer, count=3):
    schema = {"geometry": "3D Point", "properties": {"name": "str"}}
    crs = CRS.from_string(UTM).to_wkt()
    with fiona.open(path, "w", "GPKG", schema, crs_wkt=crs, layer=layer) as features:
        for name, point in list(zip(NAMES, XYZ))[:count]:
            shape = {"type": "Point", "coordinates": point}
            features.write({"geometry": shape, "properties": {"name": name}})
    return f"{path}|layername={layer}"


def memory_layer(definition=f"PointZ?crs={UTM}&field=name:string", count=3):
    from qgis.core import QgsFeature, QgsGeometry, QgsVectorLayer

    layer = QgsVectorLayer(definition, "picked", "memory")
    for name, (x, y, z) in list(zip(NAMES, XYZ))[:count]:
        feature = QgsFeature(layer.fields())
        feature.setGeometry(QgsGeometry.fromWkt(f"PointZ ({x} {y} {z})"))
        feature.setAttributes([name])
        layer.dataProvider().addFeature(feature)
    return layer


def check(points, name, path=None):
    assert (points.name, points.names, points.path) == (name, NAMES, path)
    np.testing.assert_array_equal(points.xyz, XYZ)


def test_a_list_may_be_a_text_file(read, tmp_path):
    path = write_text(tmp_path / "control.txt")
    for given in (path, [path], f" {path} "):
        check(read(given), "control", Path(path))


def test_a_list_may_be_a_layer_of_a_file(read, tmp_path):
    path = tmp_path / "site.gpkg"
    given = write_layer(path, "control")
    check(read(given), "site", path)
    check(read(str(path)), "site", path)
    write_layer(path, "scan1")
    check(read(given), "control", path)
    with pytest.raises(InputError, match="several layers of points"):
        read(str(path))


def test_a_list_may_be_a_layer_of_the_project(read, tmp_path, project):
    from qgis.core import QgsVectorLayer

    path = tmp_path / "site.gpkg"
    source = write_layer(path, "control")
    layer = QgsVectorLayer(source, "my points")
    project.addMapLayer(layer)
    for given in (layer, [layer], layer.id(), "my points"):
        points = read(given)
        check(points, "site", path)
        assert points.crs.to_epsg() == 25833


def test_only_what_a_layer_shows_is_read(read, tmp_path):
    from qgis.core import QgsVectorLayer

    layer = QgsVectorLayer(write_layer(tmp_path / "site.gpkg", "control"), "my points")
    layer.setSubsetString("name <> 'T2'")
    assert read(layer).names == ("T1", "T3")


def test_the_system_that_the_user_gave_a_layer_holds(read, tmp_path):
    from qgis.core import QgsCoordinateReferenceSystem, QgsVectorLayer

    layer = QgsVectorLayer(write_layer(tmp_path / "site.gpkg", "control"), "my points")
    layer.setCrs(QgsCoordinateReferenceSystem("EPSG:25832"))
    assert read(layer).crs.to_epsg() == 25832


def test_a_list_may_be_a_layer_of_no_file(read, project):
    layer = memory_layer()
    project.addMapLayer(layer)
    for given in (layer, layer.id(), layer.source(), "picked"):
        check(read(given), "picked")


def test_a_list_may_be_a_layer_of_delimited_text(read, tmp_path):
    from qgis.core import QgsVectorLayer

    path = tmp_path / "control.csv"
    path.write_text("name,e,n,h\n" + "".join(f"{n},{x},{y},{z}\n" for n, (x, y, z) in zip(NAMES, XYZ)))
    uri = f"file://{path}?delimiter=,&xField=e&yField=n&crs={UTM}"
    for source in (uri, f"{uri}&zField=h"):
        check(read(QgsVectorLayer(source, "my points", "delimitedtext")), "control", path)


def test_layers_that_are_no_list_are_refused(read):
    from qgis.core import QgsVectorLayer

    with pytest.raises(InputError, match="picked is not a layer of points"):
        read(QgsVectorLayer(f"Polygon?crs={UTM}", "picked", "memory"))
    with pytest.raises(InputError, match="the layer picked are in degrees"):
        read(memory_layer("PointZ?crs=EPSG:4326&field=name:string"))
    with pytest.raises(InputError, match="the layer picked holds no points"):
        read(memory_layer(count=0))
    with pytest.raises(InputError, match="Feature 1 of the layer picked has no name"):
        layer = memory_layer()
        layer.dataProvider().changeAttributeValues({1: {0: None}})
        read(layer)
    with pytest.raises(InputError, match="Feature 2 of the layer picked is not a single point"):
        layer = memory_layer()
        layer.startEditing()
        layer.changeGeometry(2, type(next(layer.getFeatures()).geometry())())
        read(layer)


def test_several_lists_may_be_a_list_or_separated(read, tmp_path):
    paths = [write_text(tmp_path / "scan1.txt"), write_layer(tmp_path / "scan2.gpkg", "points")]
    for spell in (list, tuple, ";".join, "\n".join, " ; ".join, lambda paths: [";".join(paths)]):
        assert [points.name for points in read(spell(paths), several=True)] == ["scan1", "scan2"]
    assert [points.name for points in read([*paths, memory_layer()], several=True)][2] == "picked"


def test_lists_may_come_from_an_expression(read, tmp_path):
    from qgis.core import QgsProperty

    path = write_text(tmp_path / "control.txt")
    check(read(QgsProperty.fromExpression(f"'{path}'")), "control", Path(path))


def test_a_semicolon_in_a_file_name_separates_nothing(read, tmp_path):
    check(read(write_text(tmp_path / "a;b.txt")), "a;b", tmp_path / "a;b.txt")


@pytest.mark.parametrize("empty", [None, "", [], " "])
def test_without_a_list_of_control_points_it_is_refused_and_without_targets_there_are_none(read, empty):
    with pytest.raises(InputError, match="CONTROL is empty"):
        read(empty)
    assert read(empty, several=True) == []


def test_control_is_one_list(read, tmp_path):
    paths = [write_text(tmp_path / "a.txt"), write_text(tmp_path / "b.txt")]
    with pytest.raises(InputError, match="CONTROL takes one list of points, not 2"):
        read(paths)


def test_each_scan_has_a_name_of_its_own(read, tmp_path):
    (tmp_path / "more").mkdir()
    paths = [write_text(tmp_path / "scan1.txt"), write_text(tmp_path / "more" / "scan1.xyz")]
    with pytest.raises(InputError, match="TARGETS has two lists called scan1"):
        read(paths, several=True)


def test_a_missing_file_is_named(read, tmp_path):
    with pytest.raises(InputError, match=r"nowhere\.txt cannot be read"):
        read(str(tmp_path / "nowhere.txt"))


@pytest.fixture
def run_with_lists(plugin):
    """Run a throw-away algorithm by the toolbox's own way, which checks the values first."""
    import processing
    from ichnograph.processing_provider.algorithm import Algorithm, Outcome
    from ichnograph.processing_provider.parameters.point_lists import PointListFile, TargetListFiles
    from qgis.core import QgsApplication, QgsProcessingProvider

    class Count(Algorithm):
        key = title = chapter = "count"
        inputs = (PointListFile("CONTROL", "One", "Help."), TargetListFiles("TARGETS", "Many", "Help."))
        numbers = (("SCANS", "Number of scans"), ("POINTS", "Number of control points"))

        def compute(self, values, log):
            return Outcome(
                {}, {"SCANS": len(values["TARGETS"].lists), "POINTS": len(values["CONTROL"].names)}
            )

    class Provider(QgsProcessingProvider):
        def id(self):
            return "lists"

        def name(self):
            return "lists"

        def loadAlgorithms(self):  # noqa: N802 - QGIS's name
            self.addAlgorithm(Count())

    provider = Provider()
    QgsApplication.processingRegistry().addProvider(provider)
    yield lambda **parameters: processing.run("lists:count", parameters)
    QgsApplication.processingRegistry().removeProvider(provider)


def test_text_files_pass_where_qgis_asks_for_layers(run_with_lists, tmp_path):
    control = write_text(tmp_path / "control.txt")
    targets = [write_text(tmp_path / "scan1.txt", 2), memory_layer()]
    assert run_with_lists(CONTROL=control, TARGETS=targets) == {"SCANS": 2, "POINTS": 3}


def test_the_dialog_takes_every_kind_of_file(plugin):
    from ichnograph.processing_provider.parameters.point_lists import PointListFile, TargetListFiles

    for kind in (PointListFile, TargetListFiles):
        definition = kind("CONTROL", "Points", "Help.").definition()
        assert "All files (*" in definition.createFileFilter()
        assert definition.checkValueIsAcceptable("control.txt")
        assert definition.help() == "Help."


@pytest.mark.parametrize(("chosen", "said"), [(UTM, False), ("EPSG:25832", True), (None, True)])
def test_a_system_in_a_remark_is_said_unless_it_is_the_chosen_one(read, tmp_path, chosen, said):
    from ichnograph.processing_provider.parameters.registration import control_of
    from qgis.core import QgsCoordinateReferenceSystem

    path = tmp_path / "control.txt"
    path.write_text(f"# {UTM}\nT1 1.5 2.5 3.5\nT2 4.5 5.5 6.5\n")
    crs = QgsCoordinateReferenceSystem(chosen) if chosen else None
    control = control_of({"CONTROL": read(str(path)), "CRS": crs})
    assert any("names EPSG:25833" in warning for warning in control.warnings) == said
