"""The header of a PLY says where its vertices are; one that lies is refused."""

import numpy as np
import pytest
from ichnograph.algorithms.clouds.formats.ply_header import named, read_layout
from ichnograph.algorithms.errors import InputError
from ichnograph.tests.algorithms.clouds.sample_files import write_ply

XYZ = np.arange(9.0).reshape(3, 3)


@pytest.mark.parametrize("encoding", ["ascii", "binary_little_endian", "binary_big_endian"])
def test_vertices_begin_behind_the_header(tmp_path, encoding):
    path = write_ply(tmp_path / "a.ply", XYZ, encoding)
    layout = read_layout(path)

    assert path.read_bytes()[: layout.start].endswith(b"end_header\n")
    assert (layout.count, layout.dtype.names, layout.is_last) == (3, ("x", "y", "z"), True)


def test_remarks_are_kept_and_their_unit_counts(tmp_path):
    layout = read_layout(
        write_ply(tmp_path / "a.ply", XYZ, before="obj_info shift 1 2 3\ncomment units: mm\n")
    )

    assert layout.remarks == ("by hand", "shift 1 2 3", "units: mm")
    assert (layout.unit, layout.metres) == ("mm", 1e-3)


def test_properties_are_known_in_any_letters_and_only_all_together():
    dtype = np.dtype([("X", "f8"), ("y", "f8"), ("red", "u1")])
    assert named(dtype, ("x", "y")) == ("X", "y")
    assert named(dtype, ("red", "green")) is None


def test_more_vertices_than_the_file_has_room_for_are_refused_before_they_are_read(tmp_path):
    path = write_ply(tmp_path / "a.ply", XYZ)
    path.write_bytes(path.read_bytes().replace(b"element vertex 3", b"element vertex 999999999"))
    with pytest.raises(InputError, match="announces 999999999 points and has 3"):
        read_layout(path)
