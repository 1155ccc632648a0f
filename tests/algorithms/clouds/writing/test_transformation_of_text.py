"""A text that is transformed keeps all that it holds, in its own units and letters, or is refused."""

import numpy as np
import pytest
from ichnograph.algorithms.clouds.cloud import open_sources
from ichnograph.algorithms.clouds.writing.transformation import transform_cloud
from ichnograph.algorithms.errors import InputError

QUARTER_TURN = np.array([[0.0, -1, 0, 7_000_000], [1, 0, 0, 5_000_000], [0, 0, 1, 100], [0, 0, 0, 1]])


def transform(path, matrix, target):
    (source,) = open_sources([path])
    return transform_cloud(source, matrix, target)


def test_the_last_row_with_too_few_fields_is_refused_by_its_line(tmp_path):
    (tmp_path / "scan.csv").write_text(
        "x,y,z,nx,ny,nz\n1.5,2.5,3.5,0,0,1\n1.5,2.5,3.5,0,0\n", encoding="utf-8"
    )
    with pytest.raises(InputError, match=r"Line 3 of .* has 5 columns instead of 6"):
        transform(tmp_path / "scan.csv", QUARTER_TURN, tmp_path / "out.csv")
    assert not (tmp_path / "out.csv").exists()


def test_normals_without_names_are_turned(tmp_path):
    (tmp_path / "in.xyz").write_text("1 2 3 1.0 0.0 0.0\n4 5 6 0.6 0.8 0.0\n", encoding="utf-8")
    transform(tmp_path / "in.xyz", QUARTER_TURN, tmp_path / "out.xyz")
    normals = np.loadtxt(tmp_path / "out.xyz")[:, 3:]
    np.testing.assert_allclose(normals, [[0, 1, 0], [-0.8, 0.6, 0]])


def test_a_text_in_millimetres_is_written_in_millimetres(tmp_path):
    (tmp_path / "in.csv").write_text("X [mm],Y [mm],Z [mm]\n1000,2000,3000\n", encoding="utf-8")
    transform(tmp_path / "in.csv", np.diag([1.0, 1, 1, 1]) + np.eye(4, k=3), tmp_path / "out.csv")
    assert (tmp_path / "out.csv").read_text().splitlines()[1] == "2000.00000,2000.00000,3000.00000"


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "cp1252"])
def test_letters_of_any_alphabet_are_written_back(tmp_path, encoding):
    text = "Höhe;x;y;Größe\n# Mauer östlich\n3;1;2;größer\n"
    (tmp_path / "in.csv").write_bytes(text.encode(encoding))
    transform(tmp_path / "in.csv", np.eye(4), tmp_path / "out.csv")
    written = (tmp_path / "out.csv").read_bytes().decode(encoding)
    assert written == text.replace("3;1;2", "3.00000;1.00000;2.00000")
