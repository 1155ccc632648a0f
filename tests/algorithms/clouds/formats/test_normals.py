"""Normals are found among the attributes, whatever programs call them."""

from pathlib import Path

import laspy
import numpy as np
import pytest
from ichnograph.algorithms.clouds.cloud import open_sources
from ichnograph.algorithms.clouds.formats.normals import find_normals, unnamed_normals
from ichnograph.tests.algorithms.clouds.sample_files import las_records, write_las, write_ply


@pytest.mark.parametrize(
    ("names", "found"),
    [
        (("nx", "ny", "nz"), (0, 1, 2)),
        (("quality", "NormalZ", "NormalX", "NormalY"), (2, 3, 1)),
        (("Normals:0", "Normals:1", "Normals:2"), (0, 1, 2)),
        (("scalar_Nx", "scalar_Ny", "scalar_Nz"), (0, 1, 2)),
    ],
)
def test_components_are_found_in_any_order_and_convention(names, found):
    assert find_normals(names) == found


@pytest.mark.parametrize("names", [(), ("nx", "ny"), ("x", "y", "z")])
def test_two_components_or_coordinates_are_not_normals(names):
    assert find_normals(names) is None


def made(count=50):
    vectors = np.random.default_rng(0).normal(size=(count, 3))
    return (vectors / np.linalg.norm(vectors, axis=1)[:, None]).T


@pytest.mark.parametrize(
    ("columns", "said"),
    [
        (dict(zip(("ni", "nj", "nk"), made())), True),
        (dict(zip(("time", "ni", "nj", "nk"), (np.arange(50.0), *made()))), True),
        (dict(zip(("nx", "ny", "nz"), made())), False),
        (dict(zip("abc", 2 * made())), False),
        (dict(zip("abc", np.eye(3)[np.arange(50) % 3].T)), False),
        (dict(zip("ab", made()[:2])), False),
    ],
)
def test_vectors_of_length_1_with_other_names_are_said(columns, said):
    sentences = unnamed_normals(Path("scan.ply"), columns)
    assert any("of scan.ply seem to be normals" in sentence for sentence in sentences) == said


def test_each_format_says_normals_of_other_names(tmp_path):
    xyz = np.random.default_rng(1).uniform(0, 9, (50, 3))
    columns = {**dict(zip("xyz", xyz.T)), **dict(zip(("ni", "nj", "nk"), made()))}
    points = np.rec.fromarrays(list(columns.values()), names=list(columns))
    ply = write_ply(tmp_path / "a.ply", points)
    header, records = las_records(50, 6)
    header.add_extra_dims([laspy.ExtraBytesParams(name, np.float64) for name in ("ni", "nj", "nk")])
    records = laspy.ScaleAwarePointRecord.zeros(50, header=header)
    for name, values in zip(("ni", "nj", "nk"), made()):
        records[name] = values
    las = write_las(tmp_path / "a.las", header, records)
    text = tmp_path / "a.csv"
    np.savetxt(text, np.stack(list(columns.values()), 1), "%.6f", ",", header=",".join(columns), comments="")
    for path in (ply, las, text):
        (source,) = open_sources([path])
        assert any("seem to be normals" in sentence for sentence in source.warnings), path
