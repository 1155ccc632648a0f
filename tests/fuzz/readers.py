"""The readers, each with small sound files to damage."""

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import fiona
import numpy as np
from affine import Affine
from rasterio.crs import CRS

from ...algorithms.clouds.cloud import open_sources
from ...algorithms.clouds.writing.transformation import transform_cloud, transformed_names
from ...algorithms.evaluation.length_lists import read_reference, read_schedule
from ...algorithms.raster import write_raster
from ...algorithms.registration.lists.point_list import read_point_list
from ...algorithms.registration.output.transforms import read_transforms
from ...algorithms.site_plan.density.density_raster import BANDS, read_density
from ..algorithms.clouds.sample_files import (
    las_records,
    write_copc,
    write_e57,
    write_las,
    write_ply,
    write_ptx,
)

UTM = CRS.from_epsg(25833)
QUARTER_TURN = np.array([[0.0, -1, 0, 100], [1, 0, 0, 200], [0, 0, 1, 300], [0, 0, 0, 1]])


@dataclass(frozen=True)
class Reader:
    """What is run on damaged files.

    Attributes
    ----------
    write : callable(Path) -> list of Path
        Writes sound files to a folder; the first of each list entry is damaged.
    read : callable(Path)
        Raises an `IchnographError` if a file cannot be used.
    is_text : bool
    """

    write: Callable[[Path], list[Path]]
    read: Callable[[Path], None]
    is_text: bool = False


def _read_cloud(path: Path) -> None:
    """Stream a cloud, and move it, which copies all that it holds."""
    (source,) = open_sources([path])
    (name,) = transformed_names([source])
    transform_cloud(source, QUARTER_TURN, path.parent / f"moved_{name}", UTM)


def _points(count: int = 60) -> np.ndarray:
    return np.random.default_rng(0).random((count, 7)) * [10, 10, 3, 1, 255, 255, 255]


def _las(folder: Path) -> list[Path]:
    return [write_las(folder / f"a{number}.las", *las_records(60, number)) for number in (0, 3, 6, 8)]


def _laz(folder: Path) -> list[Path]:
    return [write_las(folder / f"a{number}.laz", *las_records(300, number)) for number in (0, 3, 6, 8)]


def _copc(folder: Path) -> list[Path]:
    header, points = las_records(300, 6)
    return [write_copc(folder / "a.copc.laz", header, points, 3)]


def _e57(folder: Path) -> list[Path]:
    points = _points()
    fields = dict(zip(("cartesianX", "cartesianY", "cartesianZ", "intensity"), points.T))
    colour = dict.fromkeys(("colorRed", "colorGreen", "colorBlue"), points[:, 4].astype(int))
    pose = ((1.0, 0, 0, 0), (100.0, 200, 300))
    return [
        write_e57(folder / "a.e57", {**fields, **colour, "pose": pose}),
        write_e57(folder / "b.e57", dict(list(fields.items())[:3]), points[:, :3], wkt=UTM.to_wkt()),
    ]


def _ptx(folder: Path) -> list[Path]:
    points = _points().round(3)
    return [write_ptx(folder / "a.ptx", (points, QUARTER_TURN), points[:, :4])]


def _ply(folder: Path) -> list[Path]:
    columns = np.rec.fromarrays(_points().T, names="x,y,z,intensity,red,green,blue")
    return [
        write_ply(folder / f"{encoding}.ply", columns, encoding, types=["double"] * 3 + ["float"] * 4)
        for encoding in ("ascii", "binary_little_endian", "binary_big_endian")
    ]


def _text(folder: Path) -> list[Path]:
    rows = [" ".join(f"{value:.3f}" for value in row) for row in _points()]
    contents = {
        "plain.xyz": "\n".join(rows) + "\n",
        "named.csv": "x,y,z,intensity,R,G,B\n" + "\n".join(row.replace(" ", ",") for row in rows) + "\n",
        "comma.txt": "\n".join(row.replace(".", ",").replace(" ", ";") for row in rows) + "\n",
        "scan.pts": f"{len(rows)}\n" + "\n".join(rows) + "\n",
    }
    wide = folder / "wide.asc"
    wide.write_bytes(contents["plain.xyz"].encode("utf-16"))
    return [*(_written(folder / name, content) for name, content in contents.items()), wide]


def _written(path: Path, content: str) -> Path:
    path.write_text(content, encoding="utf-8")
    return path


def _lists(folder: Path) -> list[Path]:
    return [
        _written(folder / "a.txt", "".join(f"T{n} {n}.125 {2 * n}.25 {n % 3}.5\n" for n in range(20))),
        _written(
            folder / "b.csv",
            "Punkt;X [m];Y [m];Z [m]\n" + "".join(f"{n};{n},5;{n},25;1,5\n" for n in range(20)),
        ),
    ]


def _layers(folder: Path) -> list[Path]:
    drivers = {"shp": "ESRI Shapefile", "gpkg": "GPKG", "geojson": "GeoJSON", "fgb": "FlatGeobuf"}
    schema = {"geometry": "3D Point", "properties": {"name": "str", "z": "float"}}
    paths = []
    for suffix, driver in drivers.items():
        path = folder / f"a.{suffix}"
        options = {"SPATIAL_INDEX": "NO"} if suffix == "fgb" else {}
        with fiona.open(path, "w", driver, schema, crs_wkt=UTM.to_wkt(), **options) as layer:
            for number in range(12):
                shape = {"type": "Point", "coordinates": (number + 0.5, number, 1.5)}
                layer.write({"geometry": shape, "properties": {"name": f"T{number}", "z": 1.5}})
        paths.append(path)
    return paths


def _lengths(folder: Path) -> list[Path]:
    return [
        _written(
            folder / "wide.csv", "id,width,height\n" + "".join(f"{n},1.{n},2.{n}\n" for n in range(10, 20))
        ),
        _written(
            folder / "long.csv",
            "id;dimension;length\n" + "".join(f"{n};width;1,{n}\n" for n in range(10, 20)),
        ),
    ]


def _read_lengths(path: Path) -> None:
    (read_reference if path.stem == "long" else read_schedule)(path)


def _transforms(folder: Path) -> list[Path]:
    scans = [{"name": name, "status": "registered", "matrix": QUARTER_TURN.tolist()} for name in "ab"]
    return [_written(folder / "a.json", json.dumps({"crs": "EPSG:25833", "scans": scans}, indent=1))]


def _raster(folder: Path) -> list[Path]:
    bands = {name: np.full((40, 50), number, np.float32) for number, name in enumerate(BANDS, start=1)}
    write_raster(folder / "a.tif", bands, Affine(0.1, 0, 412300, 0, -0.1, 5812700), UTM)
    return [folder / "a.tif"]


READERS = {
    "las": Reader(_las, _read_cloud),
    "laz": Reader(_laz, _read_cloud),
    "copc": Reader(_copc, _read_cloud),
    "e57": Reader(_e57, _read_cloud),
    "ptx": Reader(_ptx, _read_cloud, is_text=True),
    "ply": Reader(_ply, _read_cloud),
    "text": Reader(_text, _read_cloud, is_text=True),
    "lists": Reader(_lists, lambda path: void(read_point_list(path)), is_text=True),
    "layers": Reader(_layers, lambda path: void(read_point_list(path))),
    "lengths": Reader(_lengths, _read_lengths, is_text=True),
    "json": Reader(_transforms, lambda path: void(read_transforms(path)), is_text=True),
    "rasters": Reader(_raster, lambda path: void(read_density(path))),
}


def void(_: object) -> None:
    """Return nothing, of a reader whose result does not matter."""
