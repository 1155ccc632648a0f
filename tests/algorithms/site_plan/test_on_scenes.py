"""The chain with its defaults, on simulated scans whose walls are known."""

from functools import lru_cache

import numpy as np
import pytest
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.evaluation.plan import compare_plan
from ichnograph.algorithms.site_plan.density.density_image import density_image
from ichnograph.algorithms.site_plan.density.density_raster import DensityRaster
from ichnograph.algorithms.site_plan.site_plan import extract_walls, make_site_plan
from ichnograph.algorithms.site_plan.walls.extraction import WallParameters
from ichnograph.tests.scenes import SCENES
from ichnograph.tests.scenes.__main__ import write_laz
from shapely.ops import unary_union

PLACE = (12.0, (412_345.67, 5_812_345.71, 71.3))


@lru_cache(maxsize=1)
def scanned(name):
    scene = SCENES[name](0).moved(*PLACE)
    return scene, scene.scan(angular_step=0.4)


def plan_of(image, **parameters):
    return extract_walls(DensityRaster.of(image), WallParameters(**parameters))


# Completeness and correctness of the boundary at 10 cm; the docs tell the values at a finer angular step.
@pytest.mark.parametrize(
    ("name", "complete", "correct"),
    [
        ("interior", 0.90, 0.90),
        ("yard", 0.80, 0.88),
        ("ruins", 0.85, 0.85),
        ("rooms", 0.90, 0.85),
        ("columns", 0.90, 0.85),
    ],
)
def test_defaults_find_the_walls_of_a_scene_and_the_gate_gains(tmp_path, name, complete, correct):
    scene, scan = scanned(name)
    write_laz(tmp_path / "scan.laz", scan, slice(None), "EPSG:25833")
    image = density_image(open_cloud([tmp_path / "scan.laz"]))
    found, plain = (
        compare_plan(
            unary_union([wall.outline for wall in plan_of(image, **parameters).walls]),
            scene.truth,
            0.10,
            scan.seen_boundary,
        )
        for parameters in ({}, {"min_height": 0.0})
    )
    assert found.completeness > complete
    assert found.correctness > correct
    assert found.median_offset < 0.08
    assert found.correctness > plain.correctness


# Completeness and correctness at 5 cm of outlines on the faces; those of pixels reach less than half of it.
@pytest.mark.parametrize(
    ("name", "complete", "correct"),
    [
        ("interior", 0.95, 0.93),
        ("columns", 0.95, 0.95),
        ("ruins", 0.90, 0.90),
        ("rooms", 0.85, 0.85),
        ("terraces", 0.90, 0.90),
    ],
)
def test_outlines_lie_on_the_faces_of_a_scene(tmp_path, name, complete, correct):
    scene, scan = scanned(name)
    write_laz(tmp_path / "scan.laz", scan, slice(None), "EPSG:25833")
    plan = make_site_plan(open_cloud([tmp_path / "scan.laz"]))
    outlines = [wall.outline for wall in plan.walls]
    found = compare_plan(unary_union(outlines), scene.truth, 0.05, scan.seen_boundary)
    assert found.completeness > complete
    assert found.correctness > correct
    assert found.median_offset < 0.01
    assert found.p95_offset < 0.02
    assert all(outline.is_valid and outline.geom_type == "Polygon" for outline in outlines)
    assert sum(outline.area for outline in outlines) == pytest.approx(unary_union(outlines).area)


def test_a_site_in_files_by_station_gives_the_image_of_the_whole(tmp_path):
    _scene, scan = scanned("ruins")
    write_laz(tmp_path / "whole.laz", scan, slice(None), None)
    parts = []
    for station in np.unique(scan.station):
        parts.append(tmp_path / f"part{station}.laz")
        write_laz(parts[-1], scan, scan.station == station, None)
    whole = density_image(open_cloud([tmp_path / "whole.laz"]))
    joined = density_image(open_cloud(parts))
    assert whole.transform == joined.transform
    for band in ("density", "occupied", "base", "top", "ground", "spread", "hanging"):
        np.testing.assert_array_equal(getattr(whole, band), getattr(joined, band))


def test_footings_of_a_few_centimetres_are_no_walls(tmp_path):
    scene, scan = scanned("ruins")
    write_laz(tmp_path / "scan.laz", scan, slice(None), None)
    plan = plan_of(density_image(open_cloud([tmp_path / "scan.laz"])))
    walls = unary_union([wall.outline for wall in plan.walls])
    assert walls.intersection(scene.footings).area < 0.05 * scene.footings.area


def test_walls_carry_the_heights_of_the_cloud(tmp_path):
    scene, scan = scanned("interior")
    write_laz(tmp_path / "scan.laz", scan, slice(None), None)
    plan = plan_of(density_image(open_cloud([tmp_path / "scan.laz"])))
    longest = max(plan.walls, key=lambda wall: wall.length)
    assert longest.z_base == pytest.approx(71.3, abs=0.05)
    # The outer faces reach up to the roof.
    assert longest.z_top == pytest.approx(71.3 + max(prism.top for prism in scene.prisms), abs=0.05)
