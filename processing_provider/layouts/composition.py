"""The layout of a sheet: map, grid, legend, scale bar, north and title block."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from qgis.core import (
    QgsFillSymbol,
    QgsLayoutItem,
    QgsLayoutItemLabel,
    QgsLayoutItemLegend,
    QgsLayoutItemMap,
    QgsLayoutItemMapGrid,
    QgsLayoutItemPicture,
    QgsLayoutItemScaleBar,
    QgsLayoutItemShape,
    QgsLayoutPoint,
    QgsLayoutSize,
    QgsLegendStyle,
    QgsMapLayer,
    QgsPrintLayout,
    QgsProject,
    QgsRectangle,
    QgsTextFormat,
    QgsUnitTypes,
)
from qgis.PyQt.QtCore import QSizeF
from qgis.PyQt.QtGui import QFont

from ..language import translated
from ..layers import is_on_earth
from .sheet import Box, Sheet, grid_interval, scale_bar_segment

NORTH = str(Path(__file__).parent / "north.svg")

LINE_MM = 0.2
"""Width of frames."""


@dataclass(frozen=True)
class Contents:
    """What a sheet shows.

    Attributes
    ----------
    name : str
        Of the layout.
    layers : sequence of QgsMapLayer
        From top to bottom.
    extent : QgsRectangle
        What is drawn, in the coordinates of the map.
    scale : float
        Denominator.
    block : sequence of (str, str)
        Rows of the title block.
    has_north : bool
        An elevation has none.
    """

    name: str
    layers: Sequence[QgsMapLayer]
    extent: QgsRectangle
    scale: float
    block: Sequence[tuple[str, str]]
    has_north: bool


def compose(project: QgsProject, sheet: Sheet, contents: Contents) -> QgsPrintLayout:
    """Return a layout, which is not yet part of the project."""
    layout = QgsPrintLayout(project)
    layout.initializeDefaults()
    layout.setName(contents.name)
    layout.pageCollection().page(0).setPageSize(QgsLayoutSize(sheet.width, sheet.height))
    shown = _map(layout, sheet, contents)
    _legend(layout, sheet, contents, shown)
    _scale_bar(layout, sheet, contents, shown)
    if contents.has_north:
        _north(layout, sheet, shown)
    _title_block(layout, sheet, contents)
    return layout


def _map(layout: QgsPrintLayout, sheet: Sheet, contents: Contents) -> QgsLayoutItemMap:
    shown = QgsLayoutItemMap(layout)
    _place(layout, shown, sheet.map)
    shown.setFrameEnabled(True)
    if is_on_earth(contents.layers[0]):
        shown.setCrs(contents.layers[0].crs())
    shown.setLayers(list(contents.layers))
    shown.setKeepLayerSet(True)
    shown.setKeepLayerStyles(True)
    # From the size on paper, and not by setScale, which needs a reference system.
    half = QSizeF(sheet.map.width, sheet.map.height) * (contents.scale / 2000)
    centre = contents.extent.center()
    shown.setExtent(
        QgsRectangle(
            centre.x() - half.width(),
            centre.y() - half.height(),
            centre.x() + half.width(),
            centre.y() + half.height(),
        )
    )
    _grid(shown, contents.scale)
    return shown


def _grid(shown: QgsLayoutItemMap, scale: float) -> None:
    """Cross the map where coordinates are round, and name them at its edges."""
    grid = QgsLayoutItemMapGrid(translated("Coordinates"), shown)
    interval = grid_interval(scale)
    grid.setIntervalX(interval)
    grid.setIntervalY(interval)
    grid.setStyle(QgsLayoutItemMapGrid.GridStyle.Cross)
    grid.setCrossLength(2)
    grid.setAnnotationEnabled(True)
    grid.setAnnotationPrecision(0 if interval >= 1 else 1 if interval >= 0.1 else 2)
    grid.setAnnotationFont(_font(6))
    grid.setAnnotationFrameDistance(1)
    sides = QgsLayoutItemMapGrid.BorderSide
    for side in (sides.Left, sides.Right):
        grid.setAnnotationDirection(QgsLayoutItemMapGrid.AnnotationDirection.Vertical, side)
    shown.grids().addGrid(grid)


def _legend(layout: QgsPrintLayout, sheet: Sheet, contents: Contents, shown: QgsLayoutItemMap) -> None:
    legend = QgsLayoutItemLegend(layout)
    legend.setTitle("")
    legend.setLinkedMap(shown)
    legend.setAutoUpdateModel(False)
    for style in (
        QgsLegendStyle.Style.Group,
        QgsLegendStyle.Style.Subgroup,
        QgsLegendStyle.Style.SymbolLabel,
    ):
        legend.setStyleFont(style, _font(8))
    tree = legend.model().rootGroup()
    tree.clear()
    for layer in contents.layers:
        # Of an image, the legend would name its bands.
        if layer.type() != QgsMapLayer.LayerType.RasterLayer:
            tree.addLayer(layer)
    # Kinds that are not on the sheet are not in its legend.
    legend.setLegendFilterByMapEnabled(True)
    _place(layout, legend, sheet.legend)
    legend.adjustBoxSize()


def _scale_bar(layout: QgsPrintLayout, sheet: Sheet, contents: Contents, shown: QgsLayoutItemMap) -> None:
    bar = QgsLayoutItemScaleBar(layout)
    bar.setLinkedMap(shown)
    bar.setStyle("Single Box")
    # In map units, because a length on the ellipsoid is not the one on paper.
    bar.setUnits(QgsUnitTypes.DistanceUnit.DistanceUnknownUnit)
    bar.setMapUnitsPerScaleBarUnit(1)
    bar.setUnitLabel("m")
    bar.setNumberOfSegments(2)
    bar.setNumberOfSegmentsLeft(0)
    bar.setUnitsPerSegment(scale_bar_segment(contents.scale))
    bar.setHeight(2)
    bar.setTextFormat(QgsTextFormat.fromQFont(_font(8)))
    _place(layout, bar, sheet.bar)
    bar.update()


def _north(layout: QgsPrintLayout, sheet: Sheet, shown: QgsLayoutItemMap) -> None:
    arrow = QgsLayoutItemPicture(layout)
    arrow.setPicturePath(NORTH)
    arrow.setLinkedMap(shown)
    arrow.setNorthMode(QgsLayoutItemPicture.NorthMode.GridNorth)
    _place(layout, arrow, sheet.north)


def _title_block(layout: QgsPrintLayout, sheet: Sheet, contents: Contents) -> None:
    box = sheet.block
    frame = QgsLayoutItemShape(layout)
    frame.setShapeType(QgsLayoutItemShape.Shape.Rectangle)
    outline = {"color": "0,0,0,0", "outline_color": "0,0,0", "outline_width": str(LINE_MM)}
    frame.setSymbol(QgsFillSymbol.createSimple(outline))
    _place(layout, frame, box)
    (_, title), *rows = contents.block
    _label(layout, title, Box(box.x + 2, box.y + 2, box.width - 4, 14), 12, bold=True)
    height = (box.height - 20) / max(len(rows), 1)
    for number, (name, value) in enumerate(rows):
        y = box.y + 18 + number * height
        _label(layout, name, Box(box.x + 2, y, 18, height), 7)
        _label(layout, value, Box(box.x + 21, y, box.width - 23, height), 7)


def _label(layout: QgsPrintLayout, text: str, box: Box, points: float, bold: bool = False) -> None:
    label = QgsLayoutItemLabel(layout)
    label.setText(text)
    label.setFont(_font(points, bold))
    _place(layout, label, box)


def _font(points: float, bold: bool = False) -> QFont:
    font = QFont("Sans Serif")
    font.setPointSizeF(points)
    font.setBold(bold)
    return font


def _place(layout: QgsPrintLayout, item: QgsLayoutItem, box: Box) -> None:
    layout.addLayoutItem(item)
    item.attemptMove(QgsLayoutPoint(box.x, box.y))
    item.attemptResize(QgsLayoutSize(box.width, box.height))
