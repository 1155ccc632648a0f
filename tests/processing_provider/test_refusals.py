"""Every algorithm refuses every kind of bad input in one sentence, and leaves what was there as it was."""

import json
import struct

import fiona
import numpy as np
import pytest
import rasterio
from affine import Affine
from ichnograph.tests.algorithms.clouds.sample_files import las_records, write_las, write_ptx
from laspy.vlrs.known import WktCoordinateSystemVlr
from rasterio.crs import CRS

TRANSFORM = {"scans": [{"name": "cloud", "matrix": np.eye(4).tolist()}]}
POINTS = "".join(f"T{n} {n}.125 {n * n}.25 {n % 3}.5\n" for n in range(9))
ROWS = "".join(f"{n}.125 {n}.25 {n}.5\n" for n in range(9))


def text(content, encoding="utf-8"):
    return lambda path: path.write_bytes(content.encode(encoding) if isinstance(content, str) else content)


def las(epsg=None, scale=0.001, change=None):
    """Return a writer of a LAS or LAZ, with bytes changed after the fact: position, format, value."""

    def write(path):
        header, points = las_records(300, 6 if epsg else 3)
        header.scales = np.full(3, scale)
        if epsg:
            header.vlrs.append(WktCoordinateSystemVlr(CRS.from_epsg(epsg).to_wkt()))
        write_las(path, header, points)
        if change:
            data = bytearray(path.read_bytes())
            position, code, value = change
            offset = data.index(b"laszip encoded") + 52 if path.suffix == ".laz" else 0
            struct.pack_into(code, data, offset + position, value)
            path.write_bytes(data)

    return write


def cut(write, share):
    def shortened(path):
        write(path)
        data = path.read_bytes()
        path.write_bytes(data[: int(len(data) * share)])

    return shortened


def ptx(pose):
    return lambda path: write_ptx(path, (np.arange(12.0).reshape(3, 4) + 1, pose))


PLY = "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\n{}end_header\n0 0 0\n"

CLOUDS = {
    "missing": ("none.las", lambda path: None),
    "empty": ("cloud.laz", text("")),
    "unknown extension": ("cloud.doc", text(ROWS)),
    "text with the extension of LAS": ("cloud.las", text(ROWS)),
    "another kind of text": ("cloud.txt", text("Dear reader,\n")),
    "LAS cut off": ("cloud.las", cut(las(), 0.7)),
    "LAZ cut off": ("cloud.laz", cut(las(), 0.7)),
    "LAS of an unknown version": ("cloud.las", las(change=(24, "<B", 9))),
    "LAS whose scale is not a number": ("cloud.las", las(change=(131, "<d", float("nan")))),
    "LAS that is mirrored": ("cloud.las", las(change=(131, "<d", -0.001))),
    "LAZ whose items lie": ("cloud.laz", las(change=(36, "<H", 65300))),
    "LAZ of an unknown compression": ("cloud.laz", las(change=(0, "<H", 9))),
    "feet": ("cloud.las", las(2994)),
    "degrees": ("cloud.las", las(4326)),
    "E57 that is none": ("cloud.e57", text("ASTM")),
    "PTX whose pose is zero": ("cloud.ptx", ptx(np.zeros((4, 4)))),
    "PTX whose pose is not a number": ("cloud.ptx", ptx(np.full((4, 4), np.nan))),
    "PTX cut off": ("cloud.ptx", cut(ptx(np.eye(4)), 0.9)),
    "PLY with a property without name": ("cloud.ply", text(PLY.format(1, "property\n"))),
    "PLY without z": ("cloud.ply", text(PLY.format(1, ""))),
    "PLY of absurdly many": ("cloud.ply", text(PLY.format("9" * 30, "property float z\n"))),
    "UTF-16 cut off": ("cloud.xyz", text(ROWS.encode("utf-16")[:-1])),
    "a zero among numbers": ("cloud.xyz", text(ROWS * 900 + "1.\x005 2 3\n")),
    "a number cut off": ("cloud.xyz", text("9.125 9.25 9.500\n" * 9 + "9.125 9.25 9.5")),
    "a row with a field less": ("cloud.csv", text("x,y,z,a\n1,2,3,4\n1,2,3\n")),
    "a row with a field more": ("cloud.csv", text("x,y,z\n1,2,3\n1,2,3,4\n")),
    "feet in the header": ("cloud.csv", text("X [ft],Y [ft],Z [ft]\n1,2,3\n4,5,6\n")),
    "degrees in the header": ("cloud.csv", text("lon,lat,h\n1,2,3\n4,5,6\n")),
    "nothing but nan": ("cloud.xyz", text("nan nan nan\n" * 5)),
}


def layer(change):
    """Return a writer of a shapefile of points of which one part is damaged."""

    def write(path):
        schema = {"geometry": "3D Point", "properties": {"name": "str"}}
        with fiona.open(path, "w", "ESRI Shapefile", schema, crs="EPSG:25833") as layer:
            for number in range(6):
                shape = {"type": "Point", "coordinates": (number, number**2, 1.0)}
                layer.write({"geometry": shape, "properties": {"name": f"T{number}"}})
        change(path)

    return write


LISTS = {
    "missing": ("none.txt", lambda path: None),
    "empty": ("list.txt", text("")),
    "binary": ("list.txt", text(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR")),
    "UTF-16 cut off": ("list.txt", text(POINTS.encode("utf-16")[:-1])),
    "a number cut off": ("list.txt", text(POINTS + "T10 1.125 2.25 3.5\nT11 1.1 2.2 3")),
    "degrees": ("list.txt", text("name lat lon h\nT1 48.1 11.5 500\n")),
    "feet": ("list.csv", text("name;x [ft];y [ft];z [ft]\nT1;1;2;3\n")),
    "not a number": ("list.txt", text(POINTS + "T10 1 nan 3\n")),
    "a row with a field less": ("list.csv", text("name,x,y,z\nA,1,2,3\nB,1,2\n")),
    "one name twice": ("list.txt", text("A 1 2 3\nA 4 5 6\nB 7 8 9\n")),
    "a cloud": ("list.xyz", text("1.5 2.5 3.5\n" * 41_000)),
    "a layer that is none": ("list.gpkg", text("SQLite format 3\0" + "x" * 100)),
    "a layer with a damaged system": (
        "list.shp", layer(lambda path: path.with_suffix(".prj").write_text("PROJCS[x,"))
    ),
    "a layer cut off": ("list.shp", layer(lambda path: path.write_bytes(path.read_bytes()[:150]))),
}  # fmt: skip

TABLES = {
    "missing": ("none.csv", lambda path: None),
    "empty": ("table.csv", text("")),
    "binary": ("table.csv", text(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR")),
    "without a column": ("table.csv", text("colour,size\n1,2\n")),
    "decimal commas between commas": ("table.csv", text("id,width,height\n1,0,9,1,6\n")),
    "a row with a field less": ("table.csv", text("id,width,height\n1,0.9\n")),
    "feet": ("table.csv", text("id,width [ft],height [ft]\n1,3,6\n")),
    "not a number": ("table.csv", text("id,width,height\n1,wide,2\n")),
}


SQUARE = Affine(0.1, 0, 0, 0, -0.1, 0)


def raster(change=None, **profile):
    shape = profile.pop("shape", (20, 20))

    def write(path):
        given = {
            "count": 1,
            "dtype": "float32",
            "crs": "EPSG:25833",
            "transform": Affine(0.1, 0, 0, 0, -0.1, 0),
        }
        with rasterio.open(path, "w", "GTiff", shape[1], shape[0], **{**given, **profile}) as target:
            if change is not None:
                target.write(np.full(shape, change, np.float32), 1)

    return write


RASTERS = {
    "missing": ("none.tif", lambda path: None),
    "empty": ("raster.tif", text("")),
    "text": ("raster.tif", text("Dear reader,\n")),
    "infinite": ("raster.tif", raster(np.inf)),
    "without density": ("raster.tif", raster(0)),
    "degrees": ("raster.tif", raster(1, crs="EPSG:4326")),
    "oblong pixels": ("raster.tif", raster(1, transform=Affine(0.1, 0, 0, 0, -0.2, 0))),
    "too many pixels": ("raster.tif", raster(shape=(20_000, 20_000), sparse_ok=True, tiled=True)),
    "cut off": ("raster.tif", cut(raster(1), 0.4)),
}

JSONS = {
    "missing": ("none.json", lambda path: None),
    "empty": ("a.json", text("")),
    "absurd depth": ("a.json", text("[" * 100_000)),
    "no scans": ("a.json", text("{}")),
    "an absurd number": ("a.json", text(json.dumps(TRANSFORM).replace("1.0", "1" + "0" * 400))),
    "an absurd shift": ("a.json", text(json.dumps(TRANSFORM).replace("0.0], [", "1e300], [", 1))),
    "an absurd scale": ("a.json", text(json.dumps(TRANSFORM).replace("1.0", "1e-90", 3))),
    "mirrored": ("a.json", text(json.dumps(TRANSFORM).replace("1.0", "-1.0", 1))),
    "degrees": ("a.json", text(json.dumps({"crs": "EPSG:4326", **TRANSFORM}))),
    "feet": ("a.json", text(json.dumps({"crs": "EPSG:2263", **TRANSFORM}))),
    "heights": ("a.json", text(json.dumps({"crs": "EPSG:7837", **TRANSFORM}))),
    "no system": ("a.json", text(json.dumps({"crs": "nonsense", **TRANSFORM}))),
}


def walls(size=4.0, crs="EPSG:25833"):
    """Return a writer of one square wall."""

    def write(path):
        square = [(0, 0), (size, 0), (size, size), (0, size), (0, 0)]
        with fiona.open(path, "w", "GPKG", {"geometry": "Polygon", "properties": {}}, crs=crs) as target:
            target.write({"geometry": {"type": "Polygon", "coordinates": [square]}, "properties": {}})

    return write


SHOWN = {
    "missing": ("none.shp", lambda path: None),
    "empty": ("walls.gpkg", text("")),
    "text": ("walls.shp", text("Dear reader,\n")),
    "cut off": ("walls.gpkg", cut(walls(), 0.3)),
}

OUTLINES = {
    **SHOWN,
    "points": ("walls.shp", layer(lambda path: None)),
    "degrees": ("walls.gpkg", walls(crs="EPSG:4326")),
    "feet": ("walls.gpkg", walls(crs="EPSG:2263")),
    "a country": ("walls.gpkg", walls(1e7)),
    "not a number": ("walls.gpkg", walls(float("nan"))),
}

PICTURES = {kind: RASTERS[kind] for kind in ("missing", "empty", "text")}
"""What is shown below a plan may be any raster."""

DRAWN = {**SHOWN, "points": OUTLINES["points"], "not a number": OUTLINES["not a number"]}

GOOD = {
    "cloud.xyz": text(ROWS),
    "list.txt": text(POINTS),
    "cloud.txt": text(POINTS),
    "list.xyz": text(ROWS),
    "table.csv": text("id,width,height\n1,0.9,1.6\n"),
    "a.json": text(json.dumps(TRANSFORM)),
    "walls.gpkg": walls(),
}
"""Sound files for the parameters that are not under test."""

ALGORITHMS = {
    ("thincloud", "INPUT"): (CLOUDS, {"OUTPUT": "out.las"}, {}),
    ("densityimage", "INPUT"): (CLOUDS, {"DENSITY": "out.tif"}, {}),
    ("siteplan", "INPUT"): (CLOUDS, {"WALLS": "out.shp", "DENSITY": "out.tif"}, {}),
    ("facadeplanes", "INPUT"): (CLOUDS, {"PLANES": "out.shp"}, {}),
    ("facadedetails", "INPUT"): (CLOUDS, {"ELEVATION": "out.shp"}, {}),
    ("transformcloud", "INPUT"): (CLOUDS, {"OUTPUT_FOLDER": "out"}, {"TRANSFORMS": "a.json"}),
    ("findtargets", "INPUT"): (CLOUDS, {"OUTPUT_FOLDER": "out"}, {}),
    ("transformcloud", "TRANSFORMS"): (JSONS, {"OUTPUT_FOLDER": "out"}, {"INPUT": "cloud.xyz"}),
    ("registerscans", "CONTROL"): (LISTS, {"TRANSFORMS": "out.json"}, {"TARGETS": "list.txt"}),
    ("registerscans", "TARGETS"): (LISTS, {"TRANSFORMS": "out.json"}, {"CONTROL": "list.txt"}),
    ("simulateregistration", "CONTROL"): (LISTS, {"TABLE": "out.csv"}, {}),
    ("extractwalls", "INPUT"): (RASTERS, {"PLAN": "out.tif", "WALLS": "out.shp"}, {}),
    ("comparelengths", "SCHEDULE"): (TABLES, {"TABLE": "out.csv"}, {"REFERENCE": "table.csv"}),
    ("comparelengths", "REFERENCE"): (TABLES, {"TABLE": "out.csv"}, {"SCHEDULE": "table.csv"}),
    ("compareplan", "WALLS"): (OUTLINES, {"ERRORS": "out.gpkg"}, {"REFERENCE": "walls.gpkg"}),
    ("compareplan", "REFERENCE"): (OUTLINES, {"ERRORS": "out.gpkg"}, {"WALLS": "walls.gpkg"}),
    ("compareplan", "ROOMS"): (
        {kind: bad for kind, bad in OUTLINES.items() if kind != "a country"},
        {"ERRORS": "out.gpkg"},
        {"WALLS": "walls.gpkg", "REFERENCE": "walls.gpkg"},
    ),
    ("planlayout", "WALLS"): (SHOWN, {"PDF": "out.pdf"}, {}),
    ("planlayout", "ROOMS"): (SHOWN, {"PDF": "out.pdf"}, {"WALLS": "walls.gpkg"}),
    ("planlayout", "AXES"): (SHOWN, {"PDF": "out.pdf"}, {"WALLS": "walls.gpkg"}),
    ("planlayout", "IMAGE"): (PICTURES, {"PDF": "out.pdf"}, {"WALLS": "walls.gpkg"}),
    ("facadedetails", "FACADE_ALONG"): (DRAWN, {"ELEVATION": "out.shp"}, {"INPUT": "cloud.xyz"}),
    ("registerscans", "SCANS"): (
        CLOUDS,
        {"TRANSFORMS": "out.json"},
        {"CONTROL": "list.txt", "TARGETS": "list.txt;cloud.txt", "REFINE": True, "SCANS": "list.xyz"},
    ),
}  # fmt: skip
"""For each parameter that is a file: bad ones, the outputs, and the other inputs, also in the parameter."""

CASES = [
    pytest.param(algorithm, parameter, kind, id=f"{algorithm}-{parameter}-{kind}")
    for (algorithm, parameter), (kinds, *_) in ALGORITHMS.items()
    for kind in kinds
]


def test_every_parameter_that_is_a_file_is_tried(provider):
    from ichnograph.processing_provider.algorithm import Algorithm
    from ichnograph.processing_provider.parameters.parameter import Parameter

    own = [algorithm for algorithm in provider.algorithms() if isinstance(algorithm, Algorithm)]
    files = {
        (algorithm.name(), item.name)
        for algorithm in own
        for item in algorithm.inputs
        if type(item).sources is not Parameter.sources
    }
    assert files == set(ALGORITHMS)


def located(names, folder):
    return ";".join(str(folder / name) for name in names.split(";"))


@pytest.mark.parametrize(("algorithm", "parameter", "kind"), CASES)
def test_bad_input_is_one_sentence_and_changes_nothing(run, tmp_path, algorithm, parameter, kind):
    from qgis.core import QgsProcessingException

    if kind.startswith("E57"):
        pytest.importorskip("pye57", reason="pye57 is not installed")
    kinds, outputs, others = ALGORITHMS[algorithm, parameter]
    bad, good, target = (tmp_path / name for name in ("bad", "good", "target"))
    for folder in (bad, good, target):
        folder.mkdir()
    for name, write in GOOD.items():
        write(good / name)
    name, write = kinds[kind]
    with np.errstate(invalid="ignore"):
        write(bad / name)
    paths = {output: target / name for output, name in outputs.items()}
    for path in paths.values():
        if path.suffix:
            path.write_bytes(b"an older output")
    before = {path.name: path.read_bytes() for path in target.iterdir()}
    given = {item: value if value is True else located(value, good) for item, value in others.items()}
    given[parameter] = ";".join(filter(None, [str(bad / name), given.get(parameter)]))
    given.update((item, str(path)) for item, path in paths.items())

    with pytest.raises(QgsProcessingException) as caught:
        run(algorithm, **given)

    sentence = str(caught.value).split("Unable to execute algorithm\n")[-1]
    assert sentence.endswith((".", "?")) and "\n" not in sentence
    assert {path.name: path.read_bytes() for path in target.iterdir()} == before
