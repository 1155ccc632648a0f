"""Text files: the rows of a cloud under one header line."""

from pathlib import Path
from typing import TextIO

import numpy as np
import pandas as pd

from ...tables.spreadsheet import safe_cell
from ..cloud import Cloud
from ..formats import format_of
from ..settings import WritingSettings
from ..source import Chunk


def table_of(cloud: Cloud, chunk: Chunk) -> pd.DataFrame:
    """Return points as rows of what all text files of a cloud have."""
    table = pd.DataFrame(chunk.xyz + cloud.origin, columns=["x", "y", "z"])
    if any(source.has_intensity for source in cloud.sources):
        table["intensity"] = 0 if chunk.intensity is None else chunk.intensity
    if any(source.has_rgb for source in cloud.sources):
        colour = 0 if chunk.rgb is None else np.rint(chunk.rgb / 257).astype(np.uint8)
        table[["red", "green", "blue"]] = colour
    return table


def append_rows(
    table: pd.DataFrame, stream: TextIO, path: Path, settings: WritingSettings = WritingSettings()
) -> None:
    """Write rows to a text file, after a header if they are its first."""
    known = format_of(path)
    table.to_csv(
        stream,
        sep=known.separator if known else " ",
        header=[safe_cell(name) for name in table.columns] if stream.tell() == 0 else False,
        index=False,
        float_format=f"%.{settings.text_decimals}f",
    )
