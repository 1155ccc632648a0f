"""The spellings of INPUT and of empty values."""

import pytest
from ichnograph.tests.processing_provider.room import room_points, write_las


@pytest.fixture(scope="module")
def halves(tmp_path_factory):
    folder = tmp_path_factory.mktemp("halves")
    points = room_points()
    write_las(folder / "west.las", points[::2])
    write_las(folder / "east.las", points[1::2])
    return [str(folder / "west.las"), str(folder / "east.las")]


@pytest.fixture
def count(run, tmp_path):
    def count(given):
        return run("thincloud", INPUT=given, SPACING=0.5, OUTPUT=str(tmp_path / "thin.las"))["POINTS_IN"]

    return count


SPELLINGS = [list, tuple, ";".join, "\n".join, " ; ".join, lambda paths: [";".join(paths)]]


@pytest.mark.parametrize("spell", SPELLINGS)
def test_several_clouds_may_be_a_list_or_separated(count, halves, spell):
    assert count(spell(halves)) == len(room_points())


def test_a_single_cloud_needs_no_list(count, room):
    assert count(room) == len(room_points())


def test_a_semicolon_in_a_file_name_separates_nothing(count, tmp_path):
    write_las(tmp_path / "a;b.las", room_points())

    assert count(str(tmp_path / "a;b.las")) == len(room_points())


def test_clouds_may_come_from_an_expression(count, halves):
    from qgis.core import QgsProperty

    assert count(QgsProperty.fromExpression(f"array('{halves[0]}', '{halves[1]}')")) == len(room_points())


def test_a_loaded_layer_stands_for_its_file(run, count, room, tmp_path):
    from qgis.core import QgsProject, QgsRasterLayer

    class Layer(QgsRasterLayer):
        """Stands for the point cloud layer that not every build of QGIS has."""

        def source(self):
            return room

    density = run("densityimage", INPUT=room, DENSITY=str(tmp_path / "density.tif"))
    layer = Layer(density["DENSITY"], "loaded cloud")
    QgsProject.instance().addMapLayer(layer)

    for given in (layer, [layer], layer.id(), [layer.id()], "loaded cloud"):
        assert count(given) == len(room_points())


@pytest.mark.parametrize("empty", [None, ""])
def test_an_empty_number_is_derived_or_the_default(run, room, tmp_path, empty):
    paths = {"INPUT": room, "WALLS": str(tmp_path / "walls.shp")}
    plain = run("siteplan", **paths)
    numbers = ("THRESHOLD", "MIN_AREA", "CLOSING", "THRESHOLD_MAX", "SPACING", "MIN_HEIGHT")

    assert run("siteplan", **paths, **dict.fromkeys(numbers, empty)) == plain
