"""Which scan a cloud is named after."""

from pathlib import Path

import pytest
from ichnograph.algorithms.registration.lists.scan_names import (
    has_list,
    lists_beside,
    scan_name,
    scan_of_cloud,
)


@pytest.mark.parametrize(
    ("names", "cloud", "number"),
    [
        (("hall", "yard"), "yard.laz", 1),
        (("Hall",), "hall.laz", 0),
        (("hall", "Hall"), "Hall.laz", 1),
        (("yard",), "yard.copc.laz", 0),
        (("hall",), "hall_1.laz", None),
        (("HALL", "Hall"), "hall.laz", None),
    ],
)
def test_a_cloud_is_named_after_its_scan(names, cloud, number):
    assert scan_of_cloud(names, Path(cloud)) == number


@pytest.mark.parametrize("cloud", ["yard.laz", "yard.copc.laz", "yard.COPC.laz", "folder/yard.e57"])
def test_a_scan_without_a_list_has_the_name_of_its_cloud(cloud):
    assert scan_name(Path(cloud)) == "yard"


def test_a_file_of_several_scans_has_numbered_lists():
    assert has_list(["site_1", "site_2"], Path("site.e57"))
    assert not has_list(["site_1"], Path("site.laz"))


def test_lists_that_lie_beside_the_clouds_of_a_folder_are_theirs(tmp_path):
    for name in ("hall.laz", "hall.txt", "notes.txt", "yard.ptx", "yard_1.csv"):
        (tmp_path / name).touch()
    found = lists_beside([str(tmp_path / "hall.laz"), str(tmp_path / "yard.ptx")])

    assert [Path(path).name for path in found] == ["hall.txt", "yard_1.csv"]
