"""Files of points for the tests, and how reading them is refused."""

import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.registration.lists.point_list import read_point_list

XYZ = [[1.5, 2.25, 3.0], [4.5, 5.25, 6.5], [-7.5, 8.0, 9.125]]


def write(tmp_path, content, name="scan1.txt"):
    path = tmp_path / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return path


def refuse(path, sentence, **options):
    with pytest.raises(InputError, match=sentence) as error:
        read_point_list(path, **options)
    assert str(path) in str(error.value)
    assert "\n" not in str(error.value)
