"""Outputs that are folders of files."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingOutputDefinition,
    QgsProcessingOutputMultipleLayers,
    QgsProcessingParameterFolderDestination,
)

from ...algorithms.errors import InputError
from ..language import translated
from .destinations import Destination, FolderWriters, HtmlDestination, Writer, is_writable, revise_page


@dataclass(frozen=True)
class FolderDestination(Destination):
    """A folder of files; it is made if its parent folder exists.

    Attributes
    ----------
    listing : str
        Name of a further output, the list of the files; models cannot pass folders on.
    parts : str
        Pattern of the names of the folders in it, of which a run may make fewer than one before.
    styles : tuple of (str, str)
        The styles of its layers by their names without extensions.
    """

    listing: str = ""
    parts: str = ""
    styles: tuple[tuple[str, str], ...] = ()
    extensions = ()

    def style_of(self, path: Path) -> Optional[str]:
        """Return the name of the style of a file of the folder."""
        return dict(self.styles).get(path.stem)

    def _definition(self) -> QgsProcessingParameterFolderDestination:
        return QgsProcessingParameterFolderDestination(
            self.name, self.description, optional=self.optional, createByDefault=self.by_default
        )

    def files(self, path: Path, writer: FolderWriters) -> dict[Path, Writer]:
        """Return the writers of the files of the folder, by path."""
        return {path / name: write for name, write in writer.items()}

    def revise(self, path: Path, labels: Mapping[str, str]) -> None:
        """Translate pages, and name the parameters in them by their labels."""
        if path.suffix in HtmlDestination.extensions:
            revise_page(path, labels)

    def further_outputs(self) -> list[QgsProcessingOutputDefinition]:
        """Return the definition of the list of files."""
        return [QgsProcessingOutputMultipleLayers(self.listing, translated(f"{self.label}, one by one"))]

    def warnings(self, path: Path, writer: FolderWriters) -> list[str]:
        """Return a sentence on folders of an earlier run, which this one does not write."""
        written = {Path(name).parts[0] for name in writer}
        names = sorted(item.name for item in path.glob(self.parts)) if self.parts else []
        old = [name for name in names if name not in written]
        if not old:
            return []
        return [
            f"{self.name} {path} still holds {', '.join(old)} of an earlier run; this one did not write it. "
            "Remove it, or choose a new folder."
        ]

    def results(self, path: Path, writer: FolderWriters) -> dict[str, Any]:
        """Return the folder and the list of its new files."""
        return {self.name: str(path), self.listing: [str(file) for file in self.files(path, writer)]}

    def check(self, path: Path) -> None:
        """Refuse a folder that cannot be made or written to."""
        self.check_folder(path)
        if path.is_file() or not is_writable(path if path.is_dir() else path.parent):
            raise InputError(f"{self.name} {path} cannot be written to; choose another folder.")

    def _path(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> str:
        return algorithm.parameterAsFileOutput(parameters, self.name, context)
