"""The rows of a text cloud as numbers: fast where all lines are regular, line by line where not."""

import io
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

import numpy as np
import pandas as pd

from ...errors import InputError
from ...tables.dialect import LOST, ends_cut_off, is_comment, is_count, is_number, is_remark
from ..source import truncated
from .text_layout import Layout


@dataclass(frozen=True)
class RowParser:
    """Turns lines of a text cloud into the numbers of its used columns.

    Attributes
    ----------
    path : Path
        For messages.
    layout : Layout
    """

    path: Path
    layout: Layout

    def is_point(self, line: str) -> bool:
        """Whether a line after the header is a point: no remark, no count, and not without coordinates."""
        if self._is_remark(line) or (self.layout.announced is not None and is_count(line)):
            return False
        return not self.is_row_without_coordinates(line)

    def is_row_without_coordinates(self, line: str) -> bool:
        """Whether a program wrote a row for a point that it did not measure, as nan or infinite."""
        return LOST.search(line) is not None and self._is_lost(self.layout.dialect.split(line))

    def parse(self, lines: list[str], number: int) -> tuple[np.ndarray, int]:
        """Return the used columns of the lines that are points, and how many points the lines announce.

        Parameters
        ----------
        lines : list of str
        number : int
            Of the first line in the file.

        Raises
        ------
        InputError
            Naming the first line that is neither a point nor a remark.
        """
        self._check_end(lines, number)
        values, announced = self.table(lines), 0
        if values is None:
            lines, announced = self._regular_lines(lines, number)
            values = self.table(lines, regular=True)
        if values is None:
            raise InputError(
                f"{self.path} cannot be read between the lines {number} and "
                f"{number + len(lines)}; look for unusual characters there."
            )
        return values, announced

    def table(self, lines: list[str], regular: bool = False) -> Optional[np.ndarray]:
        """Return the used columns, shape (n, used), coordinates in metres; None if any line is irregular.

        Parameters
        ----------
        lines : list of str
        regular : bool
            Whether each line is known to have the right number of fields, and coordinates that are numbers.
        """
        dialect, used = self.layout.dialect, self.layout.columns.used
        if not lines:
            return np.empty((0, len(used)))
        text = "".join(lines)
        by_blanks = dialect.delimiter == " "
        if '"' in text or "\0" in text or regular:
            return self._slow_table(lines) if regular else None
        if not by_blanks and text.count(dialect.delimiter) != len(lines) * (dialect.width - 1):
            return None
        try:
            table = pd.read_csv(
                io.BytesIO(text.encode(errors="replace")),
                header=None,
                sep=r"\s+" if by_blanks else dialect.delimiter,
                decimal=dialect.decimal,
                thousands=dialect.thousands or None,
                skipinitialspace=True,
                dtype=dict.fromkeys(used, np.float64),
                low_memory=False,
            )
        except (ValueError, OverflowError):
            return None
        if table.shape != (len(lines), dialect.width):
            return None
        # Where blanks separate, a line that is too short shows as a missing last field.
        if by_blanks and table[dialect.width - 1].isna().any():
            return None
        values = table[list(used)].to_numpy()
        return self._in_metres(values) if np.isfinite(values).all() else None

    def _slow_table(self, lines: list[str]) -> np.ndarray:
        number, used = self.layout.dialect.number, self.layout.columns.used
        rows = (self.layout.dialect.split(line) for line in lines)
        values = np.array([[number(fields[column]) for column in used] for fields in rows])
        return self._in_metres(values)

    def _in_metres(self, values: np.ndarray) -> np.ndarray:
        if self.layout.metres != (1.0, 1.0, 1.0):
            values[:, :3] *= self.layout.metres
        return values

    def _check_end(self, lines: list[str], number: int) -> None:
        if lines and not lines[-1].endswith("\n"):
            last = [line for line in lines[-50:] if self.is_point(line)]
            if last and last[-1] is lines[-1] and ends_cut_off(last, self.layout.dialect.delimiter):
                raise truncated(
                    self.path, f"the number at the end of its last line {number + len(lines) - 1} is cut off"
                )

    def _regular_lines(self, lines: list[str], number: int) -> tuple[list[str], int]:
        """Return the lines that hold points, and how many points the others announce."""
        regular, announced = [], 0
        for position, line in enumerate(lines, start=number):
            if "\0" in line:
                raise InputError(
                    f"Line {position} of {self.path} holds a character 0, so the file is damaged; copy or "
                    "export it again."
                )
            if self._is_remark(line):
                continue
            if self.layout.announced is not None and is_count(line):
                announced += int(line)
                continue
            fields = self.layout.dialect.split(line)
            problem = self._problem(fields)
            if problem and not line.endswith("\n"):
                raise truncated(self.path, f"its last line {position} is cut off")
            if problem:
                raise InputError(f"Line {position} of {self.path} {problem}; correct or remove that line.")
            if not self._is_lost(fields):
                regular.append(line)
        return regular, announced

    def _is_remark(self, line: str) -> bool:
        """Whether a line is a remark; a row can begin like one only where its first field is not a number."""
        if 0 in self.layout.columns.used:
            return is_comment(line)
        return is_remark(line, self.layout.dialect.delimiter, self.layout.dialect.width)

    def _is_lost(self, fields: list[str]) -> bool:
        """Whether a program wrote that one of the coordinates is not a number."""
        return len(fields) == self.layout.dialect.width and any(
            LOST.fullmatch(fields[column]) for column in self.layout.columns.xyz
        )

    def _problem(self, fields: list[str]) -> str:
        dialect = self.layout.dialect
        if len(fields) != dialect.width:
            return f"has {len(fields)} columns instead of {dialect.width}"
        for column in self.layout.columns.used:
            field = fields[column]
            if not (is_number(field) and (LOST.fullmatch(field) or np.isfinite(dialect.number(field)))):
                return f"has '{field}' where a number is expected"
        return ""
