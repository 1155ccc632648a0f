"""The layer of planes: their outlines in space and their equations in the coordinates of the site."""

import fiona
import numpy as np
import pytest
from ichnograph.algorithms.facade.elevation import Plane, Segmentation
from ichnograph.algorithms.facade.output.plane_layers import PLANE_FIELDS, write_planes
from ichnograph.algorithms.facade.planes.front import Side
from ichnograph.tests.algorithms.facade.samples import bare, upright
from rasterio.crs import CRS
from shapely.geometry import shape

ORIGIN = (412345.0, 5812345.0, 71.0)


@pytest.fixture
def written(tmp_path):
    """Write a wall of 3 x 2 m that faces south, and a tree that is on no plane."""
    wall, tree = upright(3, 2, noise=0.0), np.random.default_rng(0).uniform(-2, -1, (50, 3))
    points = bare(np.concatenate([wall, tree]), ORIGIN)
    labels = np.repeat([1, 0], [len(wall), len(tree)]).astype(np.int16)
    plane = Plane(np.array([0.0, -1.0, 0.0]), wall.mean(axis=0), 0.0, len(wall))
    write_planes(
        tmp_path / "planes.gpkg",
        points,
        Segmentation((plane,), labels, Side(1, 1.0, "")),
        0.05,
        CRS.from_epsg(25833),
    )
    with fiona.open(tmp_path / "planes.gpkg") as layer:
        (feature,) = layer
        return shape(feature["geometry"]), dict(feature["properties"])


def test_corners_of_the_outline_lie_on_the_plane_of_the_equation(written):
    polygon, row = written
    corners = np.array(polygon.geoms[0].exterior.coords)

    assert np.abs(corners @ (row["nx"], row["ny"], row["nz"]) + row["distance"]).max() < 1e-6
    assert corners.min(axis=0) == pytest.approx(ORIGIN, abs=0.05)


def test_a_plane_has_its_direction_its_points_and_its_area(written):
    _, row = written

    assert set(PLANE_FIELDS) <= set(row)
    assert (row["plane"], row["points"], row["azimuth"], row["tilt"]) == (1, 15000, 180, 0)
    assert row["area"] == pytest.approx(6, rel=0.05)
