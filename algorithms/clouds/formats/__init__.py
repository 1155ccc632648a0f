"""The formats of point clouds: which there are, and one module for each reader.

`FORMATS` is the only list of them. Readers, messages, file filters and helps take it from here; a new
format is one more row. It loads no reader, so that the provider can use it before packages are checked.

Public names: `Format`, `FORMATS`, `E57_PACKAGES`, `format_of`, `readable_formats`, `writable_formats`.
"""

from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any, Optional

E57_PACKAGES = ("pye57", "pyquaternion")
"""The optional packages without which E57 files cannot be read."""


@dataclass(frozen=True)
class Format:
    """A format that clouds are read from.

    Attributes
    ----------
    name : str
    extension : str
        In lower case, with its dot.
    module, source : str
        Where its reader stands: a module of this package, and a subclass of Source in it.
    packages : tuple of str
        Optional packages that it needs.
    is_text : bool
        Whether it is lines of numbers.
    may_be_list : bool
        Whether lists of points are files of the same extension.
    separator : str
        Between the columns of the text files that are written; empty if it is not written as text.
    is_written : bool
        Whether clouds are written in it.
    """

    name: str
    extension: str
    module: str
    source: str
    packages: tuple[str, ...] = ()
    is_text: bool = False
    may_be_list: bool = False
    separator: str = ""
    is_written: bool = False

    def open(self, path: Path, *settings: Any) -> Any:
        """Return the Source of a file; see there."""
        return getattr(import_module(f".{self.module}", __name__), self.source).open(path, *settings)


def _text(name: str, separator: str = "", may_be_list: bool = False) -> Format:
    return Format(
        name=name,
        extension=f".{name.lower()}",
        module="text",
        source="TextSource",
        is_text=True,
        may_be_list=may_be_list,
        separator=separator,
        is_written=bool(separator),
    )


FORMATS = (
    Format("LAZ", ".laz", "las", "LasSource", is_written=True),
    Format("LAS", ".las", "las", "LasSource", is_written=True),
    Format("COPC", ".copc.laz", "las", "LasSource"),
    Format("E57", ".e57", "e57", "E57Source", packages=E57_PACKAGES),
    Format("PTX", ".ptx", "ptx", "PtxSource"),
    Format("PLY", ".ply", "ply", "PlySource"),
    _text("XYZ", separator=" "),
    _text("TXT", separator=" ", may_be_list=True),
    _text("CSV", separator=",", may_be_list=True),
    _text("PTS"),
    _text("ASC"),
)


def format_of(path: Path) -> Optional[Format]:
    """Return the format that the extension of a file stands for, in any case; None if it is unknown."""
    return next((item for item in FORMATS if item.extension == path.suffix.lower()), None)


def readable_formats() -> str:
    """Return the names of all formats that are read, for messages and helps."""
    return _enumeration(FORMATS)


def writable_formats() -> str:
    """Return the names of all formats that are written, for messages and helps."""
    return _enumeration(tuple(item for item in FORMATS if item.is_written))


def _enumeration(formats: tuple[Format, ...]) -> str:
    binary = ", ".join(item.name for item in formats if not item.is_text)
    text = ", ".join(item.name for item in formats if item.is_text)
    return f"{binary} or text ({text})"
