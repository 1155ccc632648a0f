"""Lines of text from all over a file, in which ranges of values show that its beginning may lack."""

import io
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from ..settings import TextSettings


def sample_lines(
    path: Path, encoding: str, start: int = 0, settings: TextSettings = TextSettings()
) -> Iterator[list[str]]:
    """Yield runs of whole lines from all over a file; a small file as a whole.

    Parameters
    ----------
    path : Path
    encoding : str
    start : int
        Byte from which on there are lines.
    settings : TextSettings

    Raises
    ------
    OSError
        If the system refuses to read it.
    """
    size, run = path.stat().st_size, settings.sample_bytes
    with path.open("rb") as stream:
        if size - start <= settings.runs * run:
            stream.seek(start)
            yield _lines(stream.read().decode(encoding, errors="replace") + "\n")
            return
        # Within the file, no byte-order mark says which byte comes first.
        if encoding in ("utf-16", "utf-32"):
            encoding += "-le" if stream.read(2) == b"\xff\xfe" else "-be"
        # Letters have one, two or four bytes.
        for position in np.linspace(start, size - run, settings.runs).astype(np.int64) // 4 * 4:
            stream.seek(int(position))
            # The first and the last line of a run are parts of lines.
            yield _lines(stream.read(run).decode(encoding, errors="replace"))[1:-1]


def _lines(text: str) -> list[str]:
    return list(io.StringIO(text, newline=None))
