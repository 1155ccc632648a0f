"""The printed sheet: true to scale on paper, and nothing but a layout in the project."""

import re
from pathlib import Path

import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.processing_provider.layouts.sheet import SIZES, choose_sheet, grid_interval
from ichnograph.tests.processing_provider.pdf import size_of
from ichnograph.tests.processing_provider.sheets import (
    HEIGHT,
    WIDTH,
    error_of_scale_bar,
    errors_of_outline,
    write_building,
)
from shapely.geometry import box


@pytest.fixture
def walls(tmp_path):
    """Write the walls of a building, in UTM."""
    return write_building(tmp_path / "walls.gpkg")


@pytest.fixture
def project(plugin):
    from qgis.core import QgsProject

    project = QgsProject()
    yield project
    project.clear()


@pytest.fixture
def make_sheet(provider, project, tmp_path):
    from qgis.core import QgsProcessingContext, QgsProcessingFeedback

    def make_sheet(**parameters):
        context = QgsProcessingContext()
        context.setProject(project)
        algorithm = provider.algorithm("planlayout").create()
        given = {"PDF": str(tmp_path / "sheet.pdf"), **parameters}
        acceptable, reason = algorithm.checkParameterValues(given, context)
        assert acceptable, reason
        return algorithm.run(given, context, QgsProcessingFeedback(False))

    return make_sheet


@pytest.mark.parametrize(("scale", "sheet", "name"), [(50, 0, "A3"), (100, 1, "A4"), (20, 3, "A1")])
def test_lengths_on_paper_are_exact_to_a_tenth_of_a_millimetre(
    make_sheet, walls, tmp_path, scale, sheet, name
):
    _, succeeded = make_sheet(WALLS=walls, SCALE=scale, SHEET=sheet)
    assert succeeded

    pdf = tmp_path / "sheet.pdf"
    assert size_of(pdf) == pytest.approx(SIZES[name], abs=0.2)
    assert np.abs(errors_of_outline(pdf, scale)).max() < 0.1


def test_the_scale_bar_is_as_exact(make_sheet, walls, tmp_path):
    make_sheet(WALLS=walls, SCALE=50)

    # Two segments of a metre each are 20 mm wide.
    assert abs(error_of_scale_bar(tmp_path / "sheet.pdf", 20)) < 0.1


def test_the_layout_joins_the_project_and_nothing_else_does(make_sheet, walls, project):
    from qgis.core import QgsVectorLayer

    project.addMapLayer(QgsVectorLayer(walls, "My walls", "ogr"))
    project.setTitle("North wing")
    for _ in range(2):
        make_sheet(WALLS="My walls", SCALE=100)

    names = [layout.name() for layout in project.layoutManager().printLayouts()]
    assert names == ["North wing 1:100", "North wing 1:100 (2)"]
    assert len(project.mapLayers()) == 1


def texts_of(layout):
    from qgis.core import QgsLayoutItemLabel

    return [item.text() for item in layout.items() if isinstance(item, QgsLayoutItemLabel)]


def test_the_title_block_has_title_author_scale_and_system(make_sheet, walls, project):
    metadata = project.metadata()
    metadata.setAuthor("A. Surveyor")
    project.setMetadata(metadata)
    make_sheet(WALLS=walls, TITLE="Ground floor")

    (layout,) = project.layoutManager().printLayouts()
    assert {"Ground floor", "A. Surveyor", "1:50 on A3", "EPSG:25833"} <= {*texts_of(layout)}


@pytest.mark.parametrize(("kind", "pictures"), [(0, 1), (1, 0)])
def test_a_plan_has_a_north_arrow_and_an_elevation_has_none(make_sheet, walls, project, kind, pictures):
    from qgis.core import QgsLayoutItemLegend, QgsLayoutItemMap, QgsLayoutItemPicture, QgsLayoutItemScaleBar

    make_sheet(WALLS=walls, KIND=kind)

    items = project.layoutManager().printLayouts()[0].items()
    assert sum(isinstance(item, QgsLayoutItemPicture) for item in items) == pictures
    for needed in (QgsLayoutItemLegend, QgsLayoutItemScaleBar):
        assert sum(isinstance(item, needed) for item in items) == 1
    (shown,) = (item for item in items if isinstance(item, QgsLayoutItemMap))
    assert shown.grid().intervalX() == 5
    assert shown.grid().annotationEnabled()


def test_an_elevation_without_a_system_is_drawn_without_a_complaint(make_sheet, tmp_path):
    from ichnograph.algorithms.vector import write_vector
    from qgis.core import QgsApplication

    messages = []
    QgsApplication.messageLog().messageReceived.connect(lambda text, *_: messages.append(text))
    path = tmp_path / "elevation.gpkg"
    write_vector(path, "Polygon", {"id": "int"}, [(box(0, 0, WIDTH, HEIGHT), {"id": 1})], None)
    make_sheet(WALLS=str(path), KIND=1)

    assert np.abs(errors_of_outline(tmp_path / "sheet.pdf", 50)).max() < 0.1
    assert not [text for text in messages if "transform" in text]


def test_the_layer_of_a_file_is_drawn_in_the_style_that_is_saved_beside_it(make_sheet, walls, tmp_path):
    from ichnograph.processing_provider.styles import style_of

    outline = "#8c2814"
    drawn = []
    for style in ("", style_of("walls", Path(walls), {})):
        Path(walls).with_suffix(".qml").write_text(style, encoding="utf-8")
        make_sheet(WALLS=walls, SVG=str(tmp_path / "sheet.svg"))
        drawn.append(outline in (tmp_path / "sheet.svg").read_text(encoding="utf-8"))
    assert drawn == [False, True]


def test_the_sheet_can_be_written_as_svg(make_sheet, walls, tmp_path):
    make_sheet(WALLS=walls, SVG=str(tmp_path / "sheet.svg"))
    text = (tmp_path / "sheet.svg").read_text(encoding="utf-8")
    assert float(re.search(r'width="([\d.]+)mm"', text)[1]) == pytest.approx(420, abs=0.2)


def test_a_plan_that_is_too_large_for_the_sheet_is_refused_with_both_sizes():
    with pytest.raises(InputError, match=r"At 1:50 the drawing needs 600 x 200 mm, and A3 has 324 x 263 mm"):
        choose_sheet("A3", 50, 30, 10)


def test_a_drawing_that_only_fits_upright_gets_an_upright_sheet():
    sheet = choose_sheet("A3", 50, 9, 18)
    assert (sheet.width, sheet.height) == pytest.approx((297, 420), abs=0.2)


@pytest.mark.parametrize(("scale", "interval"), [(50, 5), (100, 10), (20, 2), (75, 5), (1000, 100)])
def test_lines_of_the_grid_are_at_most_ten_centimetres_apart(scale, interval):
    assert grid_interval(scale) == interval
