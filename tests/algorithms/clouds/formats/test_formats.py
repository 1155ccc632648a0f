"""The list of formats stands once."""

import subprocess
import sys
from pathlib import Path

import pytest
from ichnograph.algorithms.clouds.formats import FORMATS, format_of, readable_formats, writable_formats

ROOT = Path(__file__).parents[4]


@pytest.mark.parametrize("name", ["scan.laz", "SCAN.LAZ", "scan.copc.laz"])
def test_the_extension_stands_for_the_format_in_any_case(name):
    assert format_of(Path(name)).name == "LAZ"


@pytest.mark.parametrize("name", ["scan", "scan.doc", "scan.laz.zip"])
def test_other_extensions_stand_for_none(name):
    assert format_of(Path(name)) is None


def test_messages_list_text_formats_last():
    assert readable_formats() == "LAZ, LAS, COPC, E57, PTX, PLY or text (XYZ, TXT, CSV, PTS, ASC)"
    assert writable_formats() == "LAZ, LAS or text (XYZ, TXT, CSV)"


@pytest.mark.parametrize("known", FORMATS, ids=lambda known: known.name)
def test_every_format_has_a_reader_that_names_the_file(known, tmp_path):
    path = tmp_path / f"nothing{known.extension}"
    path.write_bytes(b"\0" * 500)
    if known.packages:
        pytest.importorskip(known.packages[0])
    with pytest.raises(Exception, match="nothing") as caught:
        known.open(path)
    assert type(caught.value).__name__ == "InputError"


def test_the_guide_names_every_format():
    text = (ROOT / "docs" / "siteplan.md").read_text(encoding="utf-8")
    assert [known.name for known in FORMATS if known.name not in text] == []


def test_the_list_loads_no_reader():
    code = (
        "import sys, conftest, ichnograph.algorithms.clouds.formats as formats\n"
        "sys.exit(bool({'numpy', 'laspy', 'rasterio'} & sys.modules.keys()))"
    )
    # The package is known in the new process because conftest loads it.
    assert subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=False).returncode == 0
