"""The report: what each criterion did, on one page."""

import base64
import re

import numpy as np
import pytest
from ichnograph.algorithms.site_plan.output.plan_pictures import View, coloured, fates
from ichnograph.algorithms.site_plan.output.plan_report import write_report
from rasterio.io import MemoryFile


@pytest.fixture(scope="module")
def page(plan, tmp_path_factory):
    path = tmp_path_factory.mktemp("report") / "report.html"
    write_report(path, plan)
    return path.read_text(encoding="utf-8")


def plain(page):
    """Return what a reader sees, without the drawings."""
    page = re.sub(r"<(style|svg).*?</\1>", " ", page, flags=re.DOTALL)
    return re.sub(r"\s+", " ", re.sub(r"<[^>]*>", " ", page))


def pictures(page):
    """Return the embedded pictures, shape (rows, columns, 3)."""
    found = []
    for content in re.findall(r"data:image/png;base64,([A-Za-z0-9+/=]+)", page):
        with MemoryFile(base64.b64decode(content)) as memory, memory.open() as raster:
            found.append(np.moveaxis(raster.read()[:3], 0, 2))
    return found


@pytest.mark.filterwarnings("ignore::rasterio.errors.NotGeoreferencedWarning")
def test_the_picture_of_fates_is_that_of_the_view(page, plan):
    _final, shown, *_steps = pictures(page)
    view = View.around(plan.image.gated > 0, plan.transform)
    np.testing.assert_array_equal(shown, coloured(fates(plan, view)))


@pytest.mark.filterwarnings("ignore::rasterio.errors.NotGeoreferencedWarning")
def test_the_page_shows_plan_fates_thresholds_and_density_and_stands_alone(page):
    assert len(pictures(page)) == 1 + 1 + 5 + 1
    assert not re.search(r"(?i)https?:|<script|<link|src=\"(?!data:)|url\(|@import", page)


def test_counts_values_and_their_origin_are_listed(page, plan):
    text = plain(page)
    assert "A warning of the cloud." in text
    assert "smaller than MIN_AREA 0.1 m²: 5 of 20 regions" in text
    assert "neither straight nor curved: 5 of 20 regions" in text
    assert re.search(
        r"THRESHOLD \S+ standard deviations = 3 points per pixel derived: the usual density", text
    )
    assert "MIN_AREA 0.1 m² derived" in text
    assert "MAX_FILL 0.4 given" in text
    assert "SPACING 0.05 m given" in text
    assert "DOOR_WIDTH 1.3 m given" in text
    for name in ("THRESHOLD", "MIN_AREA", "MAX_FILL", "MIN_ELONGATION", "CLOSING", "MIN_HEIGHT"):
        assert re.search(rf"{name} [\d.]*\s?(up|down)", text), name
    assert f"{plan.area:.2f} m² in plan" in text


def test_walls_and_rooms_are_listed(page, plan):
    text = plain(page)
    (room,) = plan.rooms
    assert f"1 {room.area:.2f} {room.perimeter:.2f} 0" in text
    assert f"1 curved {plan.walls[0].length:.2f}" in text
