"""PTX: grids of cells, each with its pose."""

import gzip
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ichnograph.algorithms.clouds.formats.ptx import PtxSource
from ichnograph.algorithms.clouds.formats.text import TextSource
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.progress import Progress
from ichnograph.tests.algorithms.clouds.sample_files import write_ptx

DATA = Path(__file__).parents[5] / "shared" / "data"

CELLS = np.array([[1.5, 2.25, 3, 0.25], [0, 0, 0, 0.5], [4, 5, 6, 1]])
QUARTER_TURN = np.array([[0.0, -1, 0, 100], [1, 0, 0, 200], [0, 0, 1, 300], [0, 0, 0, 1]])


def read(path, size=1000):
    chunks = list(PtxSource.open(path).chunks(np.zeros(3), Progress(), size))
    return (
        np.concatenate([chunk.xyz for chunk in chunks]),
        None if chunks[0].intensity is None else np.concatenate([c.intensity for c in chunks]),
        None if chunks[0].rgb is None else np.concatenate([c.rgb for c in chunks]),
    )


def test_empty_cells_are_no_points_and_intensity_is_brought_to_16_bits(tmp_path):
    xyz, intensity, rgb = read(write_ptx(tmp_path / "a.ptx", CELLS))
    np.testing.assert_array_equal(xyz, [[1.5, 2.25, 3], [4, 5, 6]])
    np.testing.assert_array_equal(intensity, [16384, 65535])
    assert rgb is None


def test_each_scan_is_moved_by_its_pose(tmp_path):
    xyz, _, _ = read(write_ptx(tmp_path / "a.ptx", (CELLS, QUARTER_TURN), CELLS[2:]))
    np.testing.assert_allclose(xyz, [[97.75, 201.5, 303], [95, 204, 306], [4, 5, 6]], atol=1e-12)


def test_every_chunk_says_where_its_scanner_stood_unless_at_the_origin_as_merged_clouds(tmp_path):
    source = PtxSource.open(write_ptx(tmp_path / "a.ptx", (CELLS, QUARTER_TURN), CELLS[2:]))
    chunks = source.chunks(np.array([100.0, 0, 0]), Progress(), 1000)
    first, merged = (chunk.station for chunk in chunks)
    np.testing.assert_array_equal(first, [0, 200, 300])
    assert merged is None


def test_colour_is_brought_to_16_bits(tmp_path):
    cells = np.column_stack([CELLS, [[255, 0, 1], [9, 9, 9], [0, 128, 0]]])
    _, _, rgb = read(write_ptx(tmp_path / "a.ptx", cells))
    np.testing.assert_array_equal(rgb, [[65535, 0, 257], [0, 128 * 257, 0]])


def test_a_scan_without_the_colour_of_the_first_is_black(tmp_path):
    cells = np.column_stack([CELLS, [[255, 0, 1], [9, 9, 9], [0, 128, 0]]])
    xyz, _, rgb = read(write_ptx(tmp_path / "a.ptx", cells, CELLS))
    assert (len(xyz), rgb[2:].max()) == (4, 0)


def test_a_scan_that_begins_with_empty_cells_is_read(tmp_path):
    cells = np.vstack([np.tile([0, 0, 0, 0.5], (20_000, 1)), CELLS])
    source = PtxSource.open(write_ptx(tmp_path / "a.ptx", cells))
    np.testing.assert_array_equal(source.middle, [2.75, 3.625, 4.5])


@settings(deadline=None, max_examples=20)
@given(size=st.integers(1, 60))
def test_chunks_do_not_change_a_bit(tmp_path_factory, size):
    cells = np.random.default_rng(1).uniform(-30, 30, (25, 4))
    path = write_ptx(tmp_path_factory.mktemp("ptx") / "a.ptx", (cells, QUARTER_TURN), cells)
    np.testing.assert_array_equal(read(path, size)[0], read(path)[0])


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ("4 5 6 1\n", "", "a scan announces 3 cells and has 2"),
        ("1 0 0\n", "", "has no header of a PTX scan from line 1 on"),
        ("4 5 6 1\n", "4 5 6 1\n9 9 9\n", "has no header of a PTX scan from line 14 on"),
        ("4 5 6 1", "4 5 six 1", "Line 13 of .* holds something that is not a number"),
        ("4 5 6 1", "4 5 6", "Line 13 of .* has 3 numbers instead of 4"),
        ("4 5 6 1", "4 5 6 1 9", "Line 13 of .* has 5 numbers instead of 4"),
        ("1.5 2.25 3 0.25", "1.5 2.25", "Line 11 of .* has 2 numbers instead of 4"),
    ],
)
def test_what_cannot_be_read_is_refused_in_one_sentence(tmp_path, old, new, sentence):
    path = write_ptx(tmp_path / "a.ptx", CELLS)
    path.write_text(path.read_text().replace(old, new))
    with pytest.raises(InputError, match=sentence) as caught:
        read(path)
    assert str(path) in str(caught.value)


def test_intensity_of_8_bits_is_brought_to_16(tmp_path):
    cells = np.array([[1.5, 2.25, 3, 0], [4, 5, 6, 128], [7, 8, 9, 255]])
    np.testing.assert_array_equal(read(write_ptx(tmp_path / "a.ptx", cells))[1], [0, 128 * 257, 65535])


@pytest.mark.parametrize("mark", ["", "\ufeff"])
@pytest.mark.parametrize("blank", ["", "\n", "  \n\n"])
def test_blank_lines_and_a_byte_order_mark_do_not_matter(tmp_path, mark, blank):
    path = write_ptx(tmp_path / "a.ptx", CELLS)
    scan = path.read_text()
    path.write_text(
        f"{mark}{blank}{scan}{blank}{scan.replace('4 5 6 1', blank + '4 5 6 1')}{blank}", encoding="utf-8"
    )
    np.testing.assert_array_equal(read(path, 2)[0], [[1.5, 2.25, 3], [4, 5, 6]] * 2)


@pytest.mark.parametrize(
    ("pose", "problem"),
    [
        (np.zeros((4, 4)), "is all zero, so that every point would lie in one position"),
        (np.diag([-1.0, 1, 1, 1]), "mirrors the points"),
        (np.diag([np.nan, 1, 1, 1]), "holds something that is not a number"),
        (np.diag([1, 1, 0.0, 1]), "presses or blows up the points"),
        (
            np.array([[1, 0, 0, 1e300], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]),
            r"moves the points by 1e\+300 m",
        ),
        (
            np.array([[1, 0, 0, 5], [0, 1, 0, 6], [0, 0, 1, 7], [3, 0, 0, 1]]),
            "does not end in the column 0 0 0 1",
        ),
    ],
)
def test_a_pose_that_moves_no_points_is_refused(tmp_path, pose, problem):
    with pytest.raises(InputError, match=f"pose of the scan in line 1 of .*a.ptx {problem}"):
        PtxSource.open(write_ptx(tmp_path / "a.ptx", (CELLS, pose)))


@pytest.mark.parametrize(
    ("pose", "doubt"),
    [
        (np.diag([2.0, 2, 2, 1]), "scales the points by 2"),
        (np.diag([1.0, 1, 2, 1]), "distorts the points because its rotation is not orthogonal"),
    ],
)
def test_a_pose_that_does_more_than_turn_and_shift_is_said(tmp_path, pose, doubt):
    (warning,) = PtxSource.open(write_ptx(tmp_path / "a.ptx", (CELLS, pose))).warnings
    assert doubt in warning


def test_a_number_of_cells_beyond_any_scanner_is_refused(tmp_path):
    path = write_ptx(tmp_path / "a.ptx", CELLS)
    path.write_text("1" * 5000 + path.read_text()[1:])
    with pytest.raises(InputError, match="has no header of a PTX scan"):
        PtxSource.open(path)


def test_a_last_number_that_is_cut_off_is_refused(tmp_path):
    path = write_ptx(tmp_path / "a.ptx", np.round(np.random.default_rng(0).random((9, 4)) + 1, 3))
    text = "\n".join(" ".join(f"{float(item):.3f}" for item in line.split()) if number > 9 else line
                     for number, line in enumerate(path.read_text().splitlines()))  # fmt: skip
    path.write_text(text[:-2])
    with pytest.raises(InputError, match="the number at the end of its last line 19 is cut off"):
        read(path)


def test_a_scan_of_empty_cells_is_refused(tmp_path):
    with pytest.raises(InputError, match="holds no points"):
        PtxSource.open(write_ptx(tmp_path / "a.ptx", 0 * CELLS))


@pytest.mark.parametrize(
    ("name", "count"),
    [
        ("1.2-with-color.ptx", 1065),
        ("no-color.ptx", 15),
        ("complex-transform.ptx", 4),
        ("multiple-and-transform.ptx", 8),
    ],
)
def test_files_of_other_programs(name, count):
    path = DATA / "format_ptx_pts_pdal" / name
    if not path.exists():
        pytest.skip("the shared data are not here")
    assert len(read(path)[0]) == count


def test_both_scans_of_a_file_come_to_the_same_place():
    path = DATA / "format_ptx_pts_pdal" / "multiple-and-transform.ptx"
    if not path.exists():
        pytest.skip("the shared data are not here")
    xyz, _, _ = read(path)
    np.testing.assert_allclose(xyz[:4], xyz[4:], atol=1e-9)


def test_a_real_scan_has_the_points_of_its_pts(tmp_path):
    folder = DATA / "e57_pump_room"
    if not folder.exists():
        pytest.skip("the shared data are not here")
    for kind in ("ptx", "pts"):
        packed = folder / f"pump_derived.{kind}.gz"
        (tmp_path / f"pump.{kind}").write_bytes(gzip.decompress(packed.read_bytes()))
    xyz, _, rgb = read(tmp_path / "pump.ptx")
    chunks = list(TextSource.open(tmp_path / "pump.pts").chunks(np.zeros(3), Progress(), 1_000_000))
    np.testing.assert_allclose(xyz, np.concatenate([chunk.xyz for chunk in chunks]), atol=1e-9)
    np.testing.assert_array_equal(rgb, np.concatenate([chunk.rgb for chunk in chunks]))


@pytest.mark.parametrize(("widths", "word"), [((7, 4), "is 0 there"), ((4, 7), "is left out there")])
def test_scans_of_unlike_columns_are_said(tmp_path, widths, word):
    cells = np.column_stack([CELLS, CELLS[:, :3]])
    path = write_ptx(tmp_path / "a.ptx", *(cells[:, :width] for width in widths))
    said = []
    list(PtxSource.open(path).chunks(np.zeros(3), Progress(lambda _, message: said.append(message)), 1000))
    assert [word in message for message in said if "unlike columns" in message] == [True]


def test_a_line_of_any_blanks_is_blank(tmp_path):
    path = write_ptx(tmp_path / "a.ptx", CELLS)
    path.write_text(path.read_text() + "\x0b\x1a\n")
    assert len(read(path)[0]) == 2


def with_header(path, first, lines):
    """Replace lines of a file, from number `first`, counted from 0."""
    written = path.read_text().splitlines()
    written[first : first + len(lines)] = lines
    path.write_text("\n".join(written) + "\n")
    return path


def test_a_position_of_the_scanner_that_contradicts_the_pose_is_said(tmp_path):
    path = with_header(write_ptx(tmp_path / "a.ptx", (CELLS, QUARTER_TURN)), 2, ["100 200 290"])

    assert (
        "differs from the position and axes of the scanner above it, by 10 m"
        in PtxSource.open(path).warnings[0]
    )


@pytest.mark.parametrize("axes", ["0 0 0", "1 0 0"])
def test_a_position_of_the_scanner_that_is_left_out_says_nothing(tmp_path, axes):
    lines = ["0 0 0", axes, axes.replace("1 0", "0 1"), "0 0 1" if "1" in axes else "0 0 0"]
    path = with_header(write_ptx(tmp_path / "a.ptx", (CELLS, QUARTER_TURN)), 2, lines)

    assert PtxSource.open(path).warnings == ()


def test_axes_of_the_scanner_that_contradict_the_pose_are_said_by_their_angle(tmp_path):
    lines = ["100 200 300", "1 0 0", "0 1 0", "0 0 1"]
    path = with_header(write_ptx(tmp_path / "a.ptx", (CELLS, QUARTER_TURN)), 2, lines)

    (warning,) = PtxSource.open(path).warnings
    assert "differs from the axes of the scanner above it, by up to 90 degrees" in warning


@pytest.mark.parametrize("axes", [["0 -1 0", "1 0 0", "0 0 1"], ["0 1 0", "-1 0 0", "0 0 1"], ["0 0 0"] * 3])
def test_axes_in_lines_or_columns_or_left_out_beside_the_position_of_the_pose_are_sound(tmp_path, axes):
    path = with_header(write_ptx(tmp_path / "a.ptx", (CELLS, QUARTER_TURN)), 2, ["100 200 300", *axes])

    assert PtxSource.open(path).warnings == ()
