"""Where things are on a sheet of paper; millimetres from its upper left corner."""

from dataclasses import dataclass

from ...algorithms.errors import InputError

SIZES = {"A4": (297, 210), "A3": (420, 297), "A2": (594, 420), "A1": (841, 594), "A0": (1189, 841)}
"""Names of the sheets, and their width and height in landscape, millimetres."""

MARGIN = 10.0
"""Free of print on all sides; the larger half of what plotters leave."""

ANNOTATION = 7.0
"""Beside the map, for the coordinates of the grid."""

COLUMN = 62.0
"""Width of the column at the right with legend, scale bar, north and title block."""

BLOCK = 58.0
"""Height of the title block."""

GAP = 4.0

POINT = 25.4 / 72
"""The unit of a PDF. Qt rounds pages to whole points and stretches the drawing to them, by 0.2 mm on A4."""


@dataclass(frozen=True)
class Box:
    """A rectangle on the paper."""

    x: float
    y: float
    width: float
    height: float


@dataclass(frozen=True)
class Sheet:
    """A sheet of paper with its boxes.

    Attributes
    ----------
    name : str
        As in `SIZES`.
    width, height : float
        Whole points, which differ from the size of the paper by less than 0.2 mm.
    """

    name: str
    width: float
    height: float

    @property
    def map(self) -> Box:
        """The drawing."""
        width = self.width - 2 * MARGIN - 2 * ANNOTATION - COLUMN
        return Box(MARGIN + ANNOTATION, MARGIN + ANNOTATION, width, self.height - 2 * MARGIN - 2 * ANNOTATION)

    @property
    def block(self) -> Box:
        """The title block, at the lower right."""
        return Box(self._column, self.height - MARGIN - BLOCK, COLUMN, BLOCK)

    @property
    def bar(self) -> Box:
        """The scale bar, above the title block."""
        return Box(self._column, self.block.y - 14 - GAP, COLUMN, 14)

    @property
    def north(self) -> Box:
        """The north arrow, above the scale bar."""
        return Box(self._column, self.bar.y - 18 - GAP, 18, 18)

    @property
    def legend(self) -> Box:
        """The legend, at the upper right."""
        return Box(self._column, MARGIN, COLUMN, self.north.y - MARGIN - GAP)

    @property
    def _column(self) -> float:
        return self.width - MARGIN - COLUMN


def choose_sheet(name: str, scale: float, width_m: float, height_m: float) -> Sheet:
    """Return a sheet in the orientation that holds the drawing.

    Parameters
    ----------
    name : str
        As in `SIZES`.
    scale : float
        Denominator.
    width_m, height_m : float
        What is drawn, metres.

    Raises
    ------
    InputError
        If the drawing is larger than the sheet.
    """
    across, up = (POINT * round(side / POINT) for side in SIZES[name])
    needed = (1000 * width_m / scale, 1000 * height_m / scale)
    sheets = [Sheet(name, across, up), Sheet(name, up, across)]
    for sheet in sheets:
        if needed[0] <= sheet.map.width and needed[1] <= sheet.map.height:
            return sheet
    raise InputError(
        f"At 1:{scale:g} the drawing needs {needed[0]:.0f} x {needed[1]:.0f} mm, and {name} has "
        f"{sheets[0].map.width:.0f} x {sheets[0].map.height:.0f} mm for it; choose a larger SHEET or SCALE."
    )


def grid_interval(scale: float) -> float:
    """Return the distance of the lines of the grid in metres: about 100 mm on paper, 1, 2 or 5 times ten."""
    wanted, step = scale / 10, 0.001
    steps = [factor * 10**power for power in range(-3, 6) for factor in (1, 2, 5)]
    for candidate in steps:
        if candidate <= wanted:
            step = candidate
    return step


def scale_bar_segment(scale: float) -> float:
    """Return the length of a segment of the scale bar in metres: about 20 mm on paper."""
    return grid_interval(scale) / 5
