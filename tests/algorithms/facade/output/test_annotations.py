"""Dimensions and levels of a drawing."""

from dataclasses import replace

import pytest
from ichnograph.algorithms.drawing import write_drawing
from ichnograph.algorithms.facade.output.annotations import add_dimensions, add_levels
from ichnograph.algorithms.facade.output.settings import DrawingSettings
from ichnograph.tests.algorithms.facade.samples import small_elevation
from shapely.affinity import translate
from shapely.geometry import box

LAYERS = {"DIMENSIONS": 4, "LEVELS": 2}


@pytest.fixture
def annotate(tmp_path):
    ezdxf = pytest.importorskip("ezdxf", reason="ezdxf is not installed")

    def drawn(elevation):
        with write_drawing(tmp_path / "drawing.dxf", LAYERS) as drawing:
            add_dimensions(drawing, elevation, DrawingSettings())
            add_levels(drawing, elevation, DrawingSettings())
        return ezdxf.readfile(tmp_path / "drawing.dxf").modelspace()

    return drawn


def sizes(model):
    return sorted((round(line.get_measurement(), 3), line.dxf.text) for line in model.query("DIMENSION"))


def levels(model):
    return sorted(text.dxf.text for text in model.query("TEXT"))


def test_the_wall_and_its_details_are_dimensioned_and_unseen_edges_are_in_brackets(annotate):
    model = annotate(small_elevation())
    assert sizes(model) == [(1.0, "(<>)"), (1.5, "<>"), (3.0, "<>"), (4.0, "<>")]
    assert {line.dxf.layer for line in model.query("DIMENSION")} == {"DIMENSIONS"}


def test_levels_are_above_the_foot_of_the_wall_with_its_height_in_the_site(annotate):
    assert levels(annotate(small_elevation())) == sorted(["%%p0.00 = 71.23", "+1.00", "+2.50", "+3.00"])


def test_levels_too_near_to_be_read_share_a_mark(annotate):
    elevation = small_elevation()
    (first,) = elevation.details
    second = replace(first, number=2, outline=translate(first.outline, 1.5, 0.05))
    assert len(levels(annotate(replace(elevation, details=(first, second))))) == 4


def test_narrow_details_are_not_dimensioned(annotate):
    elevation = small_elevation()
    slit = replace(elevation.details[0], outline=box(1, 1, 1.2, 2))
    assert len(sizes(annotate(replace(elevation, details=(slit,))))) == 2
