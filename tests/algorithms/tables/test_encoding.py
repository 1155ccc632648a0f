"""The encoding of a text is that of its byte-order mark, or the one that its bytes allow."""

from pathlib import Path

import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.tables.encoding import encoding_of, read_lines

TEXT = "Höhe 1,5\nTür 2\n"


@pytest.mark.parametrize(
    ("written", "found"),
    [
        ("utf-8", "utf-8"),
        ("utf-8-sig", "utf-8-sig"),
        ("utf-16", "utf-16"),
        ("utf-16-le", "utf-16-le"),
        ("utf-16-be", "utf-16-be"),
        ("utf-32", "utf-32"),
        ("cp1252", "cp1252"),
        ("latin-1", "cp1252"),
    ],
)
def test_the_encoding_is_found_with_and_without_a_mark(tmp_path, written, found):
    path = tmp_path / "list.txt"
    path.write_bytes(TEXT.encode(written))

    assert encoding_of(path, path.read_bytes()) == found
    assert read_lines(path, 10, "a list") == ["Höhe 1,5\n", "Tür 2\n"]


def test_a_sample_may_end_within_a_letter():
    assert encoding_of(Path("a"), "Höhe ü".encode()[:-1]) == "utf-8"


def test_bytes_without_a_letter_in_the_encoding_remain_different(tmp_path):
    path = tmp_path / "list.txt"
    path.write_bytes(b"\xe4\x81\n\xe4\x8d\n")

    first, second = read_lines(path, 10, "a list")
    assert first != second
    assert (first + second).encode()


@pytest.mark.parametrize(
    ("content", "problem"),
    [
        (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", "is not a text file"),
        ("1 2\n".encode("utf-16")[:-1], "cannot be read as text in UTF-16 because it is cut off or damaged"),
        (b"\xff\xfe\0\xd8\n\0", "cannot be read as text in UTF-16"),
        (b"1\n" * 11, "has 11 lines, too many for a list, of which 10 are read at most"),
    ],
)
def test_what_is_no_list_is_refused(tmp_path, content, problem):
    path = tmp_path / "list.txt"
    path.write_bytes(content)
    with pytest.raises(InputError, match=problem):
        read_lines(path, 10, "a list")
