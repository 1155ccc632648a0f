"""The layer of a comparison of plans."""

import fiona
import pytest
from ichnograph.algorithms.evaluation.plan import compare_plan
from ichnograph.algorithms.evaluation.plan_layer import write_errors
from rasterio.crs import CRS
from shapely.geometry import Polygon, box, shape

WALL = box(0, 0, 10, 0.5)


@pytest.mark.parametrize("name", ["errors.gpkg", "errors.shp"])
def test_the_layer_holds_every_stretch(tmp_path, name):
    agreement = compare_plan(box(0, 0, 5, 0.5), WALL, 0.05)
    write_errors(tmp_path / name, agreement, CRS.from_epsg(25833))
    with fiona.open(tmp_path / name) as layer:
        rows = [(shape(item["geometry"]), item["properties"]) for item in layer]
        assert CRS.from_wkt(layer.crs_wkt) == CRS.from_epsg(25833)
    assert len(rows) == len(list(agreement.stretches()))
    assert {row["state"] for _, row in rows} == {"agrees", "wrong", "missing"}
    for line, row in rows:
        assert row["length"] == pytest.approx(line.length, abs=1e-3)
        assert (row["state"] == "agrees") == (row["max_offset"] <= 0.05)


def test_offsets_from_nothing_are_null(tmp_path):
    write_errors(tmp_path / "errors.gpkg", compare_plan(Polygon(), WALL, 0.05), None)
    with fiona.open(tmp_path / "errors.gpkg") as layer:
        assert [dict(item["properties"]) for item in layer] == [
            {"side": "reference", "state": "missing", "offset": None, "max_offset": None, "length": 21.0}
        ]
