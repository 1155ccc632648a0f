"""Kinds of output files: what QGIS asks for, which extensions can be written, and what is refused."""

import tempfile
from abc import abstractmethod
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

from qgis.core import (
    QgsProcessing,
    QgsProcessingOutputMultipleLayers,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterRasterDestination,
    QgsProcessingParameterVectorDestination,
)

from ...algorithms.errors import InputError, MissingPackageError
from ..dependencies import lacking
from .parameter import Parameter

DRAWING_MODULES = ("ezdxf",)

PAGE_MODULES = ("jinja2", "matplotlib")


@dataclass(frozen=True)
class Destination(Parameter):
    """An output file.

    Attributes
    ----------
    style : str or None
        Name of the style, in the folder styles, with which QGIS shows it.
    optional : bool
        Whether the user may do without it.
    by_default : bool
        Whether an optional file is made unless the user says otherwise.
    """

    style: Optional[str] = None
    optional: bool = False
    by_default: bool = True

    @property
    @abstractmethod
    def extensions(self) -> tuple:
        """Endings that can be written."""

    def files(self, path: Path, writer) -> dict:
        """Return what writes each file of this output, by path."""
        return {path: writer}

    def further_outputs(self) -> list:
        """Return definitions of outputs besides the file itself."""
        return []

    def results(self, path: Path, writer) -> dict:
        """Return the values of all outputs of this destination, by name."""
        return {self.name: str(path)}

    def check(self, path: Path) -> None:
        """Refuse a path that cannot be written; see `check_outputs`."""
        if path.suffix not in self.extensions or path.name.endswith(".copc.laz"):
            endings = " or ".join(self.extensions)
            case = ", in lower case" if path.suffix.lower() in self.extensions else ""
            raise InputError(f"{self.name} {path} cannot be written; end the name in {endings}{case}.")
        self._check_place(path)
        if path.is_dir() or not _is_writable(path.parent):
            raise InputError(f"{self.name} {path} cannot be written; choose another name or folder.")

    def _check_place(self, path: Path) -> None:
        if not path.parent.is_dir():
            raise InputError(f"{self.name} {path}: there is no folder {path.parent}; create it first.")

    def value(self, algorithm, parameters, context) -> Optional[Path]:
        """Return the path; None if the user does without the file.

        To be asked once for a run: QGIS invents temporary names and lists layers to load when asked.
        """
        text = self._path(algorithm, parameters, context)
        if text:
            return Path(text)
        if not self.optional:
            raise InputError(f"{self.name} is empty; choose a file to write.")
        return None

    def _path(self, algorithm, parameters, context) -> str:
        return algorithm.parameterAsOutputLayer(parameters, self.name, context)


@dataclass(frozen=True)
class RasterDestination(Destination):
    """A GeoTIFF."""

    extensions = (".tif", ".tiff")

    def _definition(self) -> QgsProcessingParameterRasterDestination:
        return QgsProcessingParameterRasterDestination(
            self.name, self.description, optional=self.optional, createByDefault=self.by_default
        )


@dataclass(frozen=True)
class VectorDestination(Destination):
    """A GeoPackage or shapefile; a subclass says of which geometry."""

    extensions = (".gpkg", ".shp")
    geometry = QgsProcessing.SourceType.TypeVectorAnyGeometry

    def _definition(self) -> QgsProcessingParameterVectorDestination:
        return QgsProcessingParameterVectorDestination(
            self.name,
            self.description,
            self.geometry,
            optional=self.optional,
            createByDefault=self.by_default,
        )


@dataclass(frozen=True)
class PolygonDestination(VectorDestination):
    """A GeoPackage or shapefile of polygons."""

    geometry = QgsProcessing.SourceType.TypeVectorPolygon


@dataclass(frozen=True)
class LineDestination(VectorDestination):
    """A GeoPackage or shapefile of lines."""

    geometry = QgsProcessing.SourceType.TypeVectorLine


@dataclass(frozen=True)
class PointDestination(VectorDestination):
    """A GeoPackage or shapefile of points."""

    geometry = QgsProcessing.SourceType.TypeVectorPoint


@dataclass(frozen=True)
class FileDestination(Destination):
    """A file that is no layer; a subclass says of which kind."""

    filters = ""

    def _definition(self) -> QgsProcessingParameterFileDestination:
        return QgsProcessingParameterFileDestination(
            self.name, self.description, self.filters, optional=self.optional, createByDefault=self.by_default
        )

    def _path(self, algorithm, parameters, context) -> str:
        return algorithm.parameterAsFileOutput(parameters, self.name, context)


@dataclass(frozen=True)
class CloudDestination(FileDestination):
    """A point cloud."""

    extensions = (".laz", ".las", ".xyz", ".csv", ".txt")
    filters = "LAZ files (*.laz);;LAS files (*.las);;Text (*.xyz *.txt);;CSV (*.csv)"


@dataclass(frozen=True)
class JsonDestination(FileDestination):
    """A json file."""

    extensions = (".json",)
    filters = "JSON files (*.json)"


@dataclass(frozen=True)
class TableDestination(FileDestination):
    """A table."""

    extensions = (".csv",)
    filters = "CSV files (*.csv)"


@dataclass(frozen=True)
class DrawingDestination(FileDestination):
    """A drawing, not made unless asked for, since it needs a package that QGIS may lack."""

    by_default: bool = False
    extensions = (".dxf",)
    filters = "DXF files (*.dxf)"

    def value(self, algorithm, parameters, context) -> Optional[Path]:
        """Return the path; refuse it if it cannot be written, before anything is computed."""
        path = super().value(algorithm, parameters, context)
        if path and lacking(DRAWING_MODULES):
            raise MissingPackageError(self.name, DRAWING_MODULES, "written")
        return path


@dataclass(frozen=True)
class HtmlDestination(FileDestination):
    """A page, which QGIS lists in its results viewer; not made by default where its packages are missing."""

    extensions = (".html", ".htm")
    filters = "HTML files (*.html *.htm)"

    def value(self, algorithm, parameters, context) -> Optional[Path]:
        """Return the path; refuse it if it cannot be written, before anything is computed."""
        path = super().value(algorithm, parameters, context)
        if path and lacking(PAGE_MODULES):
            raise MissingPackageError(self.name, PAGE_MODULES, "written")
        return path

    def _definition(self) -> QgsProcessingParameterFileDestination:
        definition = super()._definition()
        definition.setCreateByDefault(self.by_default and not lacking(PAGE_MODULES))
        return definition


@dataclass(frozen=True)
class FolderDestination(Destination):
    """A folder of files; it is made if only itself is missing.

    Attributes
    ----------
    listing : str
        Name of a further output, the list of the files: the model designer hands on no folders.
    """

    listing: str = ""
    extensions = ()

    def _definition(self) -> QgsProcessingParameterFolderDestination:
        return QgsProcessingParameterFolderDestination(self.name, self.description, optional=self.optional)

    def files(self, path: Path, writer: dict) -> dict:
        """Return what writes each file of the folder; `writer` holds it by the name of the file."""
        return {path / name: write for name, write in writer.items()}

    def further_outputs(self) -> list:
        """Return the definition of the list of files."""
        return [QgsProcessingOutputMultipleLayers(self.listing, f"{self.label}, one by one")]

    def results(self, path: Path, writer: dict) -> dict:
        """Return the folder and the list of its new files."""
        return {self.name: str(path), self.listing: [str(file) for file in self.files(path, writer)]}

    def check(self, path: Path) -> None:
        """Refuse a folder that cannot be made or written to."""
        self._check_place(path)
        if path.is_file() or not _is_writable(path if path.is_dir() else path.parent):
            raise InputError(f"{self.name} {path} cannot be written to; choose another folder.")

    def _path(self, algorithm, parameters, context) -> str:
        return algorithm.parameterAsFileOutput(parameters, self.name, context)


def check_outputs(outputs: dict, sources: Iterable) -> None:
    """Refuse, before any work is done, files that cannot be written.

    Parameters
    ----------
    outputs : dict of Destination to Path
        Where to write.
    sources : iterable of str
        Files that are read.

    Raises
    ------
    InputError
        If an extension is unknown, a folder is missing or not writable, or a file is written twice
        or read as well.
    """
    taken = {Path(source).resolve(): "an input" for source in sources}
    for output, path in outputs.items():
        output.check(path)
        other = taken.setdefault(path.resolve(), output.name)
        if other != output.name:
            raise InputError(f"{output.name} {path} is {other} as well; choose another name.")


def _is_writable(folder: Path) -> bool:
    """Try, for permissions do not tell on every system."""
    try:
        with tempfile.TemporaryFile(dir=folder):
            return True
    except OSError:
        return False
