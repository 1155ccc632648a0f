"""The algorithm `planlayout`."""

from functools import partial
from typing import Any, Optional

from qgis.core import (
    QgsMapLayer,
    QgsPrintLayout,
    QgsProcessing,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProject,
    QgsRectangle,
)
from qgis.PyQt.QtCore import QDate, QLocale

from ..algorithm import Algorithm, Outcome
from ..language import translated
from ..layers import forget_system, is_on_earth
from ..layouts.composition import Contents, compose
from ..layouts.export import write_pdf, write_svg
from ..layouts.sheet import choose_sheet
from ..log import Log
from ..parameters.destinations import PdfDestination, SvgDestination
from ..parameters.map_layers import ShownLayer, ShownRaster
from ..parameters.parameter import Choice, Number, Text

SHEETS = ("A3", "A4", "A2", "A1", "A0")
KINDS = ("Plan", "Elevation")
POLYGONS, LINES = QgsProcessing.SourceType.TypeVectorPolygon, QgsProcessing.SourceType.TypeVectorLine


class PlanLayoutAlgorithm(Algorithm):
    """Make the printed sheet of a plan or an elevation."""

    key = "planlayout"
    title = "Sheet of a plan or an elevation"
    chapter = "Site plan"
    summary = "Makes a print layout that is true to scale, with legend, grid and title block, and its PDF."
    about = (
        "The layers are drawn in their styles at the scale of the sheet, with a grid of coordinates, scale "
        "bar, north, legend and title block. Author and title come from the properties of the project. The "
        "layout joins the project, where it can be changed; nothing else in the project changes."
    )
    words = ("print", "layout", "sheet", "plan", "pdf", "scale", "drawing", "map", "title block")
    inputs = (
        ShownLayer("WALLS", "Walls, or elevation", "Polygons of the walls, or of a facade.", kind=POLYGONS),
        ShownLayer("ROOMS", "Rooms", "Drawn below the walls.", kind=POLYGONS, optional=True),
        ShownLayer("AXES", "Axes", "Drawn above the walls.", kind=LINES, optional=True),
        ShownRaster(
            "IMAGE",
            "Image",
            "Drawn below all else: a density image or an orthoimage.",
            kind=QgsProcessing.SourceType.TypeRaster,
            optional=True,
        ),
        Choice("KIND", "Drawing", "A plan has a north arrow, an elevation has none.", options=KINDS),
        Number(
            "SCALE",
            "Scale",
            "50 for rooms, 100 for houses. A metre is 20 mm on paper at 1:50.",
            unit="denominator",
            default=50,
            minimum=1,
            maximum=10_000,
            decimals=0,
        ),
        Choice("SHEET", "Sheet", "The paper; upright if the drawing fits only so.", options=SHEETS),
        Text("TITLE", "Title", "If not set, the title of the project, or the name of the walls layer."),
    )
    destinations = (
        PdfDestination(
            "PDF", "Sheet as PDF", "PDF file; print it at 100 %, not fitted to the page.", optional=True
        ),
        SvgDestination(
            "SVG", "Sheet as SVG", "SVG file, for drawing programs.", optional=True, by_default=False
        ),
    )
    numbers = ()
    needs = ()

    def __init__(self) -> None:
        super().__init__()
        self._layout: Optional[QgsPrintLayout] = None

    def flags(self) -> QgsProcessingAlgorithm.Flag:
        """Return the flags; layouts belong to the main thread."""
        return super().flags() | QgsProcessingAlgorithm.Flag.FlagNoThreading

    def compute(self, values: dict[str, Any], log: Log) -> Outcome:
        """Make the layout; the files are exported when they are written."""
        layers = [values[name] for name in ("AXES", "WALLS", "ROOMS", "IMAGE") if values[name]]
        for layer in layers:
            # The layers of the project are as the user has styled them.
            if not self.project.mapLayer(layer.id()):
                _prepare(layer)
        walls, scale = values["WALLS"], values["SCALE"]
        extent = _extent(layers[: -1 if values["IMAGE"] else None])
        sheet = choose_sheet(SHEETS[values["SHEET"]], scale, extent.width(), extent.height())
        title = values["TITLE"] or self.project.metadata().title() or self.project.title() or walls.name()
        contents = Contents(
            name=self._free_name(f"{title} 1:{scale:g}"),
            layers=layers,
            extent=extent,
            scale=scale,
            block=_block(self.project, title, scale, sheet.name, walls),
            has_north=KINDS[values["KIND"]] == "Plan",
        )
        self._layout = compose(self.project, sheet, contents)
        log.info(f"{contents.name}: {sheet.name}, {sheet.width:g} x {sheet.height:g} mm.")
        return Outcome(
            {"PDF": partial(write_pdf, layout=self._layout), "SVG": partial(write_svg, layout=self._layout)},
            {},
        )

    def postProcessAlgorithm(  # noqa: N802 - QGIS's name
        self, context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        """Add the layout to the project."""
        self.project.layoutManager().addLayout(self._layout)
        return {}

    def _free_name(self, name: str) -> str:
        """Return a name that no layout of the project has."""
        manager, number, free = self.project.layoutManager(), 1, name
        while manager.layoutByName(free):
            number += 1
            free = f"{name} ({number})"
        return free


def _prepare(layer: QgsMapLayer) -> None:
    """Show the layer of a file as QGIS does when a user adds it: in the style that is saved beside it."""
    layer.loadDefaultStyle()
    if not is_on_earth(layer):
        forget_system(layer)


def _extent(layers: list[QgsMapLayer]) -> QgsRectangle:
    extent = QgsRectangle()
    for layer in layers:
        extent.combineExtentWith(layer.extent())
    return extent


def _block(
    project: QgsProject, title: str, scale: float, sheet: str, walls: QgsMapLayer
) -> list[tuple[str, str]]:
    """Return the rows of the title block, the title first."""
    system = walls.crs().authid() or walls.crs().description()
    rows = [
        ("Title", title),
        ("Author", project.metadata().author()),
        ("Date", QLocale().toString(QDate.currentDate(), QLocale.FormatType.ShortFormat)),
        ("Scale", translated(f"1:{scale:g} on {sheet}")),
        ("System", system or translated("local, metres")),
    ]
    return [(translated(name), value) for name, value in rows if value]
