"""Kinds of output files: their QGIS definitions, the extensions that can be written, and what is refused."""

import html
import tempfile
from abc import abstractmethod
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, ClassVar, Optional

from qgis.core import (
    QgsProcessing,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingOutputDefinition,
    QgsProcessingOutputHtml,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterRasterDestination,
    QgsProcessingParameterVectorDestination,
    QgsProcessingUtils,
)

from ...algorithms.clouds.formats import FORMATS
from ...algorithms.errors import InputError, MissingPackageError
from ..dependencies import lacking
from ..desktop import on_desktop
from ..labels import with_labels
from ..language import translated, translated_page
from ..pages import page_of_table, page_of_text
from .parameter import Parameter

DRAWING_MODULES = ("ezdxf",)

Writer = Callable[[Path], Any]
"""Writes one file."""

FolderWriters = Mapping[str, Writer]
"""Writers of the files of a folder, by the names of the files."""
PAGE_MODULES = ("jinja2", "matplotlib")


@dataclass(frozen=True)
class Destination(Parameter):
    """An output file.

    Attributes
    ----------
    style : str or None
        Name of its style in the folder styles.
    optional : bool
        Whether the user may leave it empty.
    by_default : bool
        Whether an optional file is made unless the user switches it off.
    focus : bool
        Whether the canvas of an empty project opens on it.
    is_layer : bool
        Whether QGIS can show it as a layer.
    """

    style: Optional[str] = None
    optional: bool = False
    by_default: bool = True
    focus: bool = False
    is_layer: ClassVar[bool] = False

    @property
    @abstractmethod
    def extensions(self) -> tuple[str, ...]:
        """Endings that can be written."""

    def files(self, path: Path, writer: Any) -> dict[Path, Writer]:
        """Return the writers of the files of this output, by path."""
        return {path: writer}

    def style_of(self, path: Path) -> Optional[str]:
        """Return the name of the style of one of its files."""
        return self.style

    def revise(self, path: Path, labels: Mapping[str, str]) -> None:
        """Change a file that was written for the person who reads it; data are not changed.

        Parameters
        ----------
        path : Path
        labels : dict of str to str
            The labels of the parameters by their ids.
        """

    def further_outputs(self) -> list[QgsProcessingOutputDefinition]:
        """Return the definitions of outputs besides the file itself."""
        return []

    def warnings(self, path: Path, writer: Any) -> list[str]:
        """Return what the user should know about what was there before, in sentences."""
        return []

    def results(self, path: Path, writer: Any) -> dict[str, Any]:
        """Return the values of all outputs of this destination, by name."""
        return {self.name: str(path)}

    def check(self, path: Path) -> None:
        """Refuse a path that cannot be written; see `check_outputs`."""
        if path.suffix not in self.extensions or path.name.endswith(".copc.laz"):
            endings = " or ".join(self.extensions)
            case = ", in lower case" if path.suffix.lower() in self.extensions else ""
            raise InputError(f"{self.name} {path} cannot be written; end the name in {endings}{case}.")
        self.check_folder(path)
        if path.is_dir() or not is_writable(path.parent):
            raise InputError(f"{self.name} {path} cannot be written; choose another name or folder.")

    def check_folder(self, path: Path) -> None:
        """Refuse a path in a folder that does not exist."""
        if not path.parent.is_dir():
            raise InputError(
                f"{self.name} {path} cannot be written because the folder {path.parent} does not exist; "
                "create it first."
            )

    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> Optional[Path]:
        """Return the path; None if the user leaves it empty.

        To be called once a run: QGIS makes up a temporary name and lists a layer to load at each call.
        """
        text = self._path(algorithm, parameters, context)
        if text:
            return Path(text)
        if not self.optional:
            raise InputError(f"{self.name} is empty; choose a file to write.")
        return None

    def _path(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> str:
        return algorithm.parameterAsOutputLayer(parameters, self.name, context)


@dataclass(frozen=True)
class RasterDestination(Destination):
    """A GeoTIFF."""

    is_layer: ClassVar[bool] = True
    extensions = (".tif", ".tiff")

    def _definition(self) -> QgsProcessingParameterRasterDestination:
        return QgsProcessingParameterRasterDestination(
            self.name, self.description, optional=self.optional, createByDefault=self.by_default
        )


@dataclass(frozen=True)
class VectorDestination(Destination):
    """A GeoPackage or shapefile; a subclass sets its geometry."""

    is_layer: ClassVar[bool] = True
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
    """A file that is not a layer; a subclass sets its kind."""

    filters = ""

    def _definition(self) -> QgsProcessingParameterFileDestination:
        return QgsProcessingParameterFileDestination(
            self.name,
            self.description,
            translated(self.filters),
            optional=self.optional,
            createByDefault=self.by_default,
        )

    def _path(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> str:
        return algorithm.parameterAsFileOutput(parameters, self.name, context)


@dataclass(frozen=True)
class CloudDestination(FileDestination):
    """A point cloud."""

    extensions = tuple(item.extension for item in FORMATS if item.is_written)
    filters = ";;".join(f"{item.name} files (*{item.extension})" for item in FORMATS if item.is_written)


@dataclass(frozen=True)
class ListedDestination(FileDestination):
    """A file that the results viewer of the desktop shows as a page; a subclass makes the page."""

    @abstractmethod
    def page(self, path: Path) -> str:
        """Return the file as HTML."""

    def further_outputs(self) -> list[QgsProcessingOutputDefinition]:
        """Return the definition of the page."""
        return [QgsProcessingOutputHtml(f"{self.name}_PAGE", translated(self.label))]

    def results(self, path: Path, writer: Any) -> dict[str, Any]:
        """Return the file, and on the desktop its page."""
        results = super().results(path, writer)
        if on_desktop():
            page = Path(QgsProcessingUtils.generateTempFilename(f"{path.stem}.html"))
            page.write_text(self.page(path), encoding="utf-8")
            results[f"{self.name}_PAGE"] = str(page)
        return results


@dataclass(frozen=True)
class JsonDestination(ListedDestination):
    """A JSON file."""

    extensions = (".json",)
    filters = "JSON files (*.json)"

    def page(self, path: Path) -> str:
        """Return the text of the file."""
        return page_of_text(path, translated(self.label))


@dataclass(frozen=True)
class TableDestination(ListedDestination):
    """A table."""

    extensions = (".csv",)
    filters = "CSV files (*.csv)"

    def page(self, path: Path) -> str:
        """Return the rows of the file as a table."""
        return page_of_table(path, translated(self.label))


@dataclass(frozen=True)
class DrawingDestination(FileDestination):
    """A drawing; made only on request, because it needs a package that QGIS may lack."""

    by_default: bool = False
    extensions = (".dxf",)
    filters = "DXF files (*.dxf)"

    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> Optional[Path]:
        """Return the path, or refuse it before anything is computed if drawings cannot be written."""
        path = super().value(algorithm, parameters, context)
        if path and lacking(DRAWING_MODULES):
            raise MissingPackageError(self.name, DRAWING_MODULES, "written")
        return path


@dataclass(frozen=True)
class PdfDestination(FileDestination):
    """A sheet to print."""

    extensions = (".pdf",)
    filters = "PDF files (*.pdf)"


@dataclass(frozen=True)
class SvgDestination(FileDestination):
    """A sheet for drawing programs."""

    extensions = (".svg",)
    filters = "SVG files (*.svg)"


@dataclass(frozen=True)
class HtmlDestination(FileDestination):
    """A page, which QGIS lists in its results viewer; made by default unless QGIS lacks its packages."""

    extensions = (".html", ".htm")
    filters = "HTML files (*.html *.htm)"

    def value(
        self, algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> Optional[Path]:
        """Return the path, or refuse it before anything is computed if pages cannot be written."""
        path = super().value(algorithm, parameters, context)
        if path and lacking(PAGE_MODULES):
            raise MissingPackageError(self.name, PAGE_MODULES, "written")
        return path

    def revise(self, path: Path, labels: Mapping[str, str]) -> None:
        """Translate the page, and name the parameters by their labels."""
        revise_page(path, labels)

    def _definition(self) -> QgsProcessingParameterFileDestination:
        definition = super()._definition()
        definition.setCreateByDefault(self.by_default and not lacking(PAGE_MODULES))
        return definition


def check_outputs(outputs: dict[Destination, Path], sources: Iterable[str]) -> None:
    """Refuse files that cannot be written, before anything is computed.

    Parameters
    ----------
    outputs : dict of Destination to Path
        The files to write.
    sources : iterable of str
        The files that are read.

    Raises
    ------
    InputError
        If an extension is unknown, if a folder does not exist or is not writable, or if a file is written
        twice or read as well.
    """
    taken = {Path(source).resolve(): "an input" for source in sources}
    for output, path in outputs.items():
        output.check(path)
        other = taken.setdefault(path.resolve(), output.name)
        if other != output.name:
            raise InputError(f"{output.name} {path} is {other} as well; choose another name.")


def revise_page(page: Path, labels: Mapping[str, str]) -> None:
    """Translate a page, and write the labels of parameters into it in place of their names."""
    escaped = {name: html.escape(label) for name, label in labels.items()}
    text = translated_page(page.read_text(encoding="utf-8"))
    page.write_text(with_labels(text, escaped), encoding="utf-8")


def is_writable(folder: Path) -> bool:
    """Whether a file can be made there; permissions alone do not say so on every system."""
    try:
        with tempfile.TemporaryFile(dir=folder):
            return True
    except OSError:
        return False
