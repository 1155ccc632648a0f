"""Vector layers: by extension, with CRS and nulls."""

import fiona
import pytest
from ichnograph.algorithms import vector
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.vector import write_vector
from rasterio.crs import CRS
from shapely.geometry import box, shape

FIELDS = {"wall_id": "int", "kind": "str:10", "height": "float:12.3"}
WALLS = [
    (box(0, 0, 1, 2), {"wall_id": 1, "kind": "straight", "height": 2.5}),
    (box(3, 0, 4, 2), {"wall_id": 2, "kind": "column", "height": None}),
]


@pytest.mark.parametrize("name", ["walls.shp", "walls.gpkg"])
def test_features_fields_nulls_and_crs_come_back(tmp_path, name):
    write_vector(tmp_path / name, "Polygon", FIELDS, WALLS, CRS.from_epsg(25833))
    with fiona.open(tmp_path / name) as layer:
        assert CRS.from_wkt(layer.crs_wkt) == CRS.from_epsg(25833)
        features = list(layer)
    assert [dict(f["properties"]) for f in features] == [values for _, values in WALLS]
    assert all(shape(f["geometry"]).equals(outline) for f, (outline, _) in zip(features, WALLS))


@pytest.mark.parametrize("name", ["walls.shp", "walls.gpkg"])
def test_lengths_are_rounded_to_the_decimals_of_their_field(tmp_path, name):
    write_vector(
        tmp_path / name, "Polygon", FIELDS, [(box(0, 0, 1, 2), {**WALLS[0][1], "height": 2.49951})], None
    )
    with fiona.open(tmp_path / name) as layer:
        assert [feature["properties"]["height"] for feature in layer] == [2.5]


def test_a_shapefile_has_its_projection_and_its_encoding(tmp_path):
    write_vector(tmp_path / "walls.shp", "Polygon", FIELDS, WALLS, CRS.from_epsg(25833))
    assert {p.suffix for p in tmp_path.iterdir()} >= {".shp", ".shx", ".dbf", ".prj", ".cpg"}


def test_without_a_crs_there_is_no_projection(tmp_path):
    write_vector(tmp_path / "walls.shp", "Polygon", FIELDS, WALLS, None)
    assert not (tmp_path / "walls.prj").exists()


def test_another_extension_is_refused_with_the_remedy(tmp_path):
    with pytest.raises(InputError, match=r"\.shp or \.gpkg"):
        write_vector(tmp_path / "walls.kml", "Polygon", FIELDS, WALLS, None)


def test_a_failed_write_leaves_the_old_layer_untouched(tmp_path):
    path = tmp_path / "walls.shp"
    write_vector(path, "Polygon", FIELDS, WALLS, None)
    before = {p.name: p.read_bytes() for p in tmp_path.iterdir()}
    with pytest.raises(KeyError):
        write_vector(path, "Polygon", FIELDS, [(box(0, 0, 1, 1), {"wall_id": 1})], None)
    assert {p.name: p.read_bytes() for p in tmp_path.iterdir()} == before


def test_the_journal_of_an_older_geopackage_is_removed_with_it(tmp_path):
    for suffix in ("", "-wal", "-shm", "-journal"):
        (tmp_path / f"walls.gpkg{suffix}").write_bytes(b"old")
    write_vector(tmp_path / "walls.gpkg", "Polygon", FIELDS, WALLS, None)
    assert [path.name for path in tmp_path.iterdir()] == ["walls.gpkg"]


def test_a_geopackage_without_a_crs_is_not_in_degrees(tmp_path):
    write_vector(tmp_path / "walls.gpkg", "Polygon", FIELDS, WALLS, None)

    with fiona.open(tmp_path / "walls.gpkg") as layer:
        assert "Cartesian" in layer.crs_wkt


def test_the_same_layer_is_the_same_bytes_twice(tmp_path, monkeypatch):
    for second, name in enumerate(("once", "again")):
        (tmp_path / name).mkdir()
        # The time that GDAL would write.
        monkeypatch.setenv("OGR_CURRENT_DATE", f"2026-01-01T00:00:0{second}.000Z")
        write_vector(tmp_path / name / "walls.gpkg", "Polygon", FIELDS, WALLS, None)

    once, again = ((tmp_path / name / "walls.gpkg").read_bytes() for name in ("once", "again"))
    assert once == again


def test_a_full_disk_is_said_instead_of_what_gdal_says(tmp_path, monkeypatch):
    monkeypatch.setattr(vector, "is_full", lambda folder: True)
    monkeypatch.setattr(fiona.Collection, "writerecords", lambda *_: 1 / len(()))
    monkeypatch.setattr(vector, "FionaError", ZeroDivisionError)
    with pytest.raises(InputError, match="because the disk is full; free some space"):
        write_vector(tmp_path / "walls.gpkg", "Polygon", FIELDS, WALLS, None)
    assert list(tmp_path.iterdir()) == []
