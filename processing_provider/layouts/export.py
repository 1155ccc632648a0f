"""Files of a layout: PDF and SVG, with all geometry as it is."""

from pathlib import Path
from typing import Any

from qgis.core import QgsLayoutExporter, QgsPrintLayout, QgsRenderContext

from ...algorithms.errors import InputError

DPI = 600
"""Of what a printer cannot draw as lines, such as an orthoimage: a pixel is 0.04 mm."""


def write_pdf(path: Path, layout: QgsPrintLayout) -> None:
    """Write the sheet as PDF.

    Raises
    ------
    InputError
        If it cannot be written.
    """
    settings = _exact(QgsLayoutExporter.PdfExportSettings())
    _require(QgsLayoutExporter(layout).exportToPdf(str(path), settings), path)


def write_svg(path: Path, layout: QgsPrintLayout) -> None:
    """Write the sheet as SVG.

    Raises
    ------
    InputError
        If it cannot be written.
    """
    settings = _exact(QgsLayoutExporter.SvgExportSettings())
    _require(QgsLayoutExporter(layout).exportToSvg(str(path), settings), path)


def _exact(settings: Any) -> Any:
    """Return the settings of a format so that geometry keeps its vertices, and texts remain texts."""
    settings.dpi = DPI
    settings.simplifyGeometries = False
    settings.textRenderFormat = QgsRenderContext.TextRenderFormat.AlwaysText
    return settings


def _require(result: QgsLayoutExporter.ExportResult, path: Path) -> None:
    if result != QgsLayoutExporter.ExportResult.Success:
        raise InputError(f"{path} cannot be written; choose another name or folder.")
