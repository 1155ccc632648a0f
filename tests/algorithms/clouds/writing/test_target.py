"""A cloud is written only where nothing else is lost."""

from pathlib import Path

import pytest
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.clouds.writing.target import check_target, is_text
from ichnograph.algorithms.errors import InputError


@pytest.fixture
def cloud(tmp_path):
    (tmp_path / "in.xyz").write_text("1 2 3\n")
    return open_cloud([tmp_path / "in.xyz"])


@pytest.mark.parametrize("name", ["out.laz", "out.LAS", "out.xyz", "out.txt", "out.csv"])
def test_files_of_the_written_formats_are_accepted(cloud, tmp_path, name):
    check_target(cloud, tmp_path / name)


@pytest.mark.parametrize("name", ["out", "out.e57", "out.pts", "out.copc.laz", "out.COPC.LAZ"])
def test_others_are_refused_with_the_list(cloud, tmp_path, name):
    with pytest.raises(InputError, match=r"cannot be written; choose LAZ, LAS or text \(XYZ, TXT, CSV\)"):
        check_target(cloud, tmp_path / name)


def test_an_input_is_refused_however_it_is_spelled(cloud, tmp_path):
    (tmp_path / "folder").mkdir()
    with pytest.raises(InputError, match="is an input as well"):
        check_target(cloud, tmp_path / "folder" / ".." / "in.xyz")


@pytest.mark.parametrize(("name", "text"), [("a.csv", True), ("a.TXT", True), ("a.laz", False), ("a", False)])
def test_text_is_recognised_by_the_extension(name, text):
    assert is_text(Path(name)) is text
