"""The report: what each criterion did, on one page."""

import base64
import re

import numpy as np
import pytest
from affine import Affine
from ichnograph.algorithms.site_plan.density.density_image import DensityImage
from ichnograph.algorithms.site_plan.density.density_raster import DensityRaster
from ichnograph.algorithms.site_plan.output.plan_pictures import COLOURS, Fate
from ichnograph.algorithms.site_plan.output.plan_report import write_report
from ichnograph.algorithms.site_plan.results import SitePlan
from ichnograph.algorithms.site_plan.rooms.rooms import find_rooms
from ichnograph.algorithms.site_plan.settings import SitePlanSettings
from ichnograph.algorithms.site_plan.site_plan import extract_walls
from ichnograph.algorithms.site_plan.walls.extraction import WallParameters
from rasterio.crs import CRS
from rasterio.io import MemoryFile

GRID = Affine(0.1, 0, 412_300.0, 0, -0.1, 5_812_700.0)


def site():
    """Return a floor with a house and a cupboard, a scrap, a block, a faint wall, a low one, and a bush."""
    shape = (150, 200)
    density = np.full(shape, 3.0)
    occupied, top = np.zeros(shape), np.full(shape, 70.0)
    spread, hanging = np.full(shape, 0.2), np.full(shape, np.nan)

    def build(rows, columns, dense, high):
        density[rows, columns], occupied[rows, columns], top[rows, columns] = dense, high, 70 + high

    for outer, size in ((20, 80), (24, 72)):
        inner = slice(outer + 1, outer + size - 1)
        build(slice(outer, outer + size), slice(outer, outer + size), 60.0, 2.0)
        build(inner, inner, 3.0 if outer == 24 else 0.0, 0.0)
    density[density == 0] = np.nan
    build(slice(120, 122), slice(30, 33), 60.0, 2.0)
    build(slice(40, 52), slice(140, 152), 60.0, 2.0)
    build(slice(130, 132), slice(100, 160), 1.0, 2.0)
    build(slice(110, 112), slice(100, 160), 60.0, 0.3)
    build(slice(70, 84), slice(150, 164), 60.0, 2.0)
    spread[70:84, 150:164] = 0.9
    house = slice(24, 96)
    hanging[house, house] = np.where(occupied[house, house] > 1, 1.0, 0.0)
    build(slice(40, 46), slice(40, 50), 60.0, 2.0)
    ground = np.full(shape, 70.0)
    base = np.where(np.isnan(density), np.nan, ground)
    bands = (band.astype(np.float32) for band in (density, occupied, base, top, ground, spread, hanging))
    return DensityImage(*bands, GRID, CRS.from_epsg(25833), 1_000_000, 50_000, ("A warning of the cloud.",))


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    image = site()
    settings = SitePlanSettings(with_rooms=True, wall_parameters=WallParameters(threshold_steps=5))
    found = extract_walls(DensityRaster.of(image), settings.wall_parameters)
    plan = SitePlan(
        **vars(found),
        settings=settings,
        density=image,
        pixel_walls=found.walls,
        foliage=0,
        axes=None,
        rooms=find_rooms([wall.outline for wall in found.walls]),
    )
    path = tmp_path_factory.mktemp("report") / "report.html"
    write_report(path, plan)
    return path.read_text(encoding="utf-8"), plan


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
def test_every_fate_is_shown_in_its_colour(made):
    page, _plan = made
    _final, fate, *_steps = pictures(page)
    kinds = {Fate(kind): colour for kind, colour in COLOURS.items()}
    first = 20 - round(0.1 * 140)
    places = {
        Fate.WALL: (20, 50),
        Fate.CLOSED: (22, 50),
        Fate.SURFACE: (60, 60),
        Fate.SMALL: (120, 31),
        Fate.MISSHAPEN: (45, 145),
        Fate.FAINT: (130, 120),
        Fate.LOW: (110, 120),
        Fate.FOLIAGE: (77, 157),
        Fate.FURNITURE: (43, 45),
    }
    for kind, (row, column) in places.items():
        assert tuple(fate[row - first, column - first]) == kinds[kind], kind.name


@pytest.mark.filterwarnings("ignore::rasterio.errors.NotGeoreferencedWarning")
def test_the_page_shows_plan_fates_thresholds_and_density_and_stands_alone(made):
    page, _plan = made
    assert len(pictures(page)) == 1 + 1 + 5 + 1
    assert not re.search(r"(?i)https?:|<script|<link|src=\"(?!data:)|url\(|@import", page)


def test_counts_values_and_their_origin_are_told(made):
    page, plan = made
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


def test_walls_and_rooms_are_listed(made):
    page, plan = made
    text = plain(page)
    (room,) = plan.rooms
    assert f"1 {room.area:.2f} {room.perimeter:.2f} 0" in text
    assert f"1 curved {plan.walls[0].length:.2f}" in text
