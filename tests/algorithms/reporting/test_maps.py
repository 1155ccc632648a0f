"""Maps: to one scale, north up, with names as far as there is room."""

import re

import numpy as np
import pytest
from ichnograph.algorithms.reporting.figures import WIDTH
from ichnograph.algorithms.reporting.maps import Map
from ichnograph.tests.algorithms.reporting.reading import of_colour, parsed, texts
from shapely.geometry import box

CORNER = np.array([412_300.0, 5_812_300.0])
DIAGONAL = np.array([[0.0, 0.0], [100.0, 50.0]]) + CORNER


def numbers(text):
    return np.array(re.findall(r"-?[\d.]+", text), dtype=float)


def test_a_map_has_equal_scales_and_north_up():
    with Map.around(DIAGONAL) as sheet:
        (left, bottom), (right, top) = sheet.place(DIAGONAL)

        assert right - left == pytest.approx(100 * sheet.scale)
        assert bottom - top == pytest.approx(50 * sheet.scale)
        assert 0 < left < right < WIDTH
        assert 0 < top < bottom < sheet.height
        assert sheet.shows(DIAGONAL).all()
        assert not sheet.shows(DIAGONAL + 200).any()


def test_signs_and_lines_are_where_the_map_places_them():
    with Map.around(DIAGONAL) as sheet:
        sheet.dots(DIAGONAL, "#010203")
        sheet.lines(DIAGONAL[:1], DIAGONAL[1:], "#040506")
        places, drawn = sheet.place(DIAGONAL), sheet.svg()

    dots = [(float(node.get("x")), float(node.get("y"))) for node in of_colour(drawn, "#010203", "use")]
    np.testing.assert_allclose(dots, places, atol=0.01)
    (line,) = of_colour(drawn, "#040506")
    np.testing.assert_allclose(numbers(line.get("d")), places.ravel(), atol=0.01)


def test_an_arrow_points_where_it_should():
    with Map.around(DIAGONAL) as sheet:
        sheet.arrows(DIAGONAL[:1], DIAGONAL[1:], "#010203")
        places, drawn = sheet.place(DIAGONAL), sheet.svg()

    (arrow,) = of_colour(drawn, "#010203")
    corners = numbers(arrow.get("d")).reshape(-1, 2)
    tip = corners[np.argmax(np.linalg.norm(corners - places[0], axis=1))]
    np.testing.assert_allclose(tip, places[1], atol=0.5)


@pytest.mark.parametrize("points", [[[5.0, 5.0]], [[0.0, 0.0], [0.0, 30.0]], [[0.0, 0.0], [3000.0, 0.0]]])
def test_a_map_can_be_drawn_of_points_in_a_line_or_one(points):
    points = np.array(points)
    with Map.around(points) as sheet:
        assert sheet.shows(points).all()
        sheet.dots(points, "#000000")
        sheet.names(points, ["P"] * len(points), [""] * len(points))
        drawn = sheet.svg()
    assert texts(drawn).count("P") == len(points)


def test_a_map_can_be_drawn_of_nothing_but_its_frame():
    with Map.around(DIAGONAL) as sheet:
        for draw in (sheet.dots, sheet.triangles, sheet.crosses):
            draw(np.empty((0, 2)), "#000000")
        sheet.lines(np.empty((0, 2)), np.empty((0, 2)), "#000000")
        sheet.arrows(np.empty((0, 2)), np.empty((0, 2)), "#000000")
        sheet.areas([], "#000000", 0.5)
        drawn = sheet.svg()
    assert not of_colour(drawn, "#000000")


def test_the_bar_of_scale_is_as_long_as_it_says():
    with Map.around(DIAGONAL) as sheet:
        scale, drawn = sheet.scale, sheet.svg()
    (metres,) = (float(text[:-2]) for text in texts(drawn) if text.endswith(" m"))
    (bar, _north) = of_colour(drawn, "#607d8b")

    assert metres in (1, 2, 5, 10, 20, 50)
    assert np.ptp(numbers(bar.get("d"))[::2]) == pytest.approx(metres * scale)
    assert "N" in texts(drawn)


def test_an_ellipse_points_along_its_largest_variance():
    with Map.around(DIAGONAL) as sheet:
        sheet.ellipse(DIAGONAL.mean(axis=0), np.array([[2.0, 1.0], [1.0, 2.0]]), 1.0, "#010203")
        scale, drawn, centre = sheet.scale, sheet.svg(), sheet.place(DIAGONAL.mean(axis=0))[0]
    (ellipse,) = of_colour(drawn, "#010203")
    away = numbers(ellipse.get("d")).reshape(-1, 2) - centre
    along, across = (np.abs(away @ axis).max() for axis in np.array([[1, -1], [1, 1]]) / 2**0.5)

    assert along == pytest.approx(3**0.5 * scale, rel=0.01)
    assert across == pytest.approx(scale, rel=0.01)


def test_holes_of_areas_stay_empty():
    ring = box(10, 10, 40, 40).difference(box(20, 20, 30, 30))
    with Map.around(np.array([[0.0, 0.0], [50.0, 50.0]])) as sheet:
        sheet.areas([ring], "#010203", 0.5)
        drawn = sheet.svg()
    (filling,) = of_colour(drawn, "fill: #010203")
    rings = [numbers(part).reshape(-1, 2) for part in filling.get("d").split("M")[1:]]
    areas = [np.linalg.det(np.stack([ring, np.roll(ring, -1, axis=0)], axis=1)).sum() for ring in rings]

    assert "opacity: 0.5" in filling.get("style")
    assert areas[0] * areas[1] < 0
    assert abs(areas[0] / areas[1]) == pytest.approx(9, rel=1e-3)


def test_names_have_their_kind():
    with Map.around(DIAGONAL) as sheet:
        sheet.names(DIAGONAL, ["S1", "P1"], ["strong", "red"])
        drawn = sheet.svg()
    styles = {node.text: node.get("style") for node in parsed(drawn).iter("text")}

    assert "600" in styles["S1"]
    assert "#b3261e" in styles["P1"]
