"""The encoding of a text file, with or without a byte-order mark, and its lines."""

import codecs
import io
import re
from pathlib import Path

from ..errors import InputError

BYTE_ORDER_MARKS = {
    codecs.BOM_UTF32_LE: "utf-32",
    codecs.BOM_UTF32_BE: "utf-32",
    codecs.BOM_UTF8: "utf-8-sig",
    codecs.BOM_UTF16_LE: "utf-16",
    codecs.BOM_UTF16_BE: "utf-16",
}
"""The longer marks first, because that of UTF-16 begins that of UTF-32."""

WIDE = ("utf-16", "utf-16-le", "utf-16-be", "utf-32")
"""Encodings of several bytes a letter, in which other bytes than text cannot be kept."""

WESTERN = "cp1252"
"""What programs of Windows write in western Europe; its letters include those of Latin 1."""

LARGEST_LIST = 64 * 2**20
"""Bytes of a file that is read as a whole; a list of so many points has rows of over 3 kB."""


def encoding_of(path: Path, sample: bytes) -> str:
    """Return the encoding of a file that begins with `sample`.

    Without a byte-order mark it is UTF-8 if the bytes allow it, UTF-16 if every second byte is 0 as in Latin
    letters, and otherwise that of Windows.

    Raises
    ------
    InputError
        If the file is not text.
    """
    marked = next((name for mark, name in BYTE_ORDER_MARKS.items() if sample.startswith(mark)), None)
    if marked:
        return marked
    if b"\0" in sample:
        even, odd = sample[::2], sample[1::2]
        for name, zeros, letters in (("utf-16-le", odd, even), ("utf-16-be", even, odd)):
            if b"\0" not in letters and zeros.count(b"\0") > 0.9 * len(zeros):
                return name
        raise InputError(f"{path} is not a text file; give it the extension of its format.")
    try:
        # The sample may end within a letter.
        codecs.getincrementaldecoder("utf-8")().decode(sample)
    except UnicodeDecodeError:
        return WESTERN
    return "utf-8"


def read_lines(path: Path, most_lines: int, what: str) -> list[str]:
    """Return all lines of a short text file.

    Parameters
    ----------
    path : Path
    most_lines : int
    what : str
        What the file should hold, for messages.

    Raises
    ------
    InputError
        If the file is not text, is damaged or is too long.
    OSError
        If the system refuses to read it.
    """
    with path.open("rb") as stream:
        content = stream.read(LARGEST_LIST + 1)
    if len(content) > LARGEST_LIST:
        raise InputError(f"{path} is too large for {what}; choose the list, not a cloud.")
    encoding = encoding_of(path, content)
    try:
        text = content.decode(encoding, errors="strict" if encoding in WIDE else "surrogateescape")
    except UnicodeDecodeError as error:
        raise damaged(path, encoding) from error
    if "\0" in text:
        raise InputError(f"{path} is not a text file; export {what} as text.")
    lines = list(io.StringIO(_KEPT.sub(_letter, text), newline=None))
    if len(lines) > most_lines:
        raise InputError(
            f"{path} has {len(lines)} lines, too many for {what}, of which {most_lines} are read at most; "
            "choose the list, not a cloud."
        )
    return lines


_KEPT = re.compile("[\udc80-\udcff]")


def _letter(kept: "re.Match[str]") -> str:
    # Latin 1 has a letter for every byte, so that different names remain different.
    return chr(ord(kept[0]) - 0xDC00)


def damaged(path: Path, encoding: str) -> InputError:
    """Return the error for text that cannot be decoded."""
    return InputError(
        f"{path} cannot be read as text in {encoding.upper()} because it is cut off or damaged; "
        "export it again."
    )
