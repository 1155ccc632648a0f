"""Maps for reports."""

import math
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Ellipse, PathPatch, Rectangle
from matplotlib.path import Path
from shapely.geometry import Polygon
from shapely.geometry.polygon import orient

from .figures import AXIS, GRID, INK, RED, WIDTH, canvas, plain, svg
from .labels import place_labels
from .numbers import round_step

MARGIN = 45.0
"""Around the points, for their names; pixels."""

BELOW = 28.0
"""Strip under the map, for the bar of scale and the arrow to the north; pixels."""

LOWEST = 160.0
"""Height of the map of a row of points, pixels."""

NAMES = {"": {}, "strong": {"color": INK, "fontweight": "semibold"}, "red": {"color": RED}}
"""How names are written, by kind."""


@dataclass(frozen=True)
class Map:
    """A map: draws what is given in world coordinates, metres, to one scale with north up.

    Attributes
    ----------
    west, north : float
        World coordinates of the upper left corner.
    scale : float
        Pixels per metre.
    height : float
        Of the map, pixels; its width is `WIDTH`.
    axes : Axes
        In pixels from the upper left corner.
    """

    west: float
    north: float
    scale: float
    height: float
    axes: Axes

    @classmethod
    @contextmanager
    def around(cls, points: np.ndarray, tallest: float = 620.0) -> Iterator["Map"]:
        """Give the map that shows all points, shape (n, 2); to be drawn and written in the body."""
        low, high = points.min(axis=0), points.max(axis=0)
        span = np.maximum(high - low, 1e-3 * max(1.0, float(np.max(high - low))))
        scale = float(min((WIDTH - 2 * MARGIN) / span[0], (tallest - 2 * MARGIN) / span[1]))
        height = round(max(float(span[1]) * scale + 2 * MARGIN, LOWEST))
        x, y = (low + high) / 2
        with canvas(height + BELOW) as figure:
            share = BELOW / (height + BELOW)
            axes = figure.add_axes((0.0, share, 1.0, 1 - share), xlim=(0, WIDTH), ylim=(height, 0))
            axes.set_axis_off()
            frame = Rectangle((0.5, 0.5), WIDTH - 1, height - 1, fill=False, edgecolor=GRID, linewidth=1)
            axes.add_patch(frame)
            yield cls(float(x) - WIDTH / 2 / scale, float(y) + height / 2 / scale, scale, height, axes)

    @property
    def diagonal(self) -> float:
        """Of the map, metres."""
        return math.hypot(WIDTH, self.height) / self.scale

    def place(self, points: np.ndarray) -> np.ndarray:
        """Return the pixels of points, both of shape (n, 2)."""
        away = np.asarray(points, dtype=float).reshape(-1, 2) - (self.west, self.north)
        return away * (self.scale, -self.scale)

    def shows(self, points: np.ndarray) -> np.ndarray:
        """Return whether each of the points, shape (n, 2), lies on the map."""
        places = self.place(points)
        return np.all((places >= 0) & (places <= (WIDTH, self.height)), axis=1)

    def dots(self, points: np.ndarray, colour: str, diameter: float = 5.0) -> None:
        """Draw dots."""
        self._signs(points, "o", colour, markersize=diameter, markeredgewidth=0)

    def triangles(self, points: np.ndarray, colour: str) -> None:
        """Draw triangles, the sign of a station."""
        self._signs(points, "^", colour, markersize=13, markeredgecolor="white", markeredgewidth=1)

    def crosses(self, points: np.ndarray, colour: str) -> None:
        """Draw crosses."""
        self._signs(points, "x", colour, markersize=10, markeredgewidth=2)

    def _signs(self, points: np.ndarray, marker: str, colour: str, **style: object) -> None:
        self.axes.plot(*self.place(points).T, marker, color=colour, **style)

    def rays(self, start: np.ndarray, ends: np.ndarray, colour: str, width: float = 1.0) -> None:
        """Draw lines from one point, shape (2,), to others, shape (n, 2)."""
        self.lines(np.broadcast_to(start, ends.shape), ends, colour, width)

    def lines(self, starts: np.ndarray, ends: np.ndarray, colour: str, width: float = 1.0) -> None:
        """Draw lines from point to point; both arrays have shape (n, 2)."""
        starts, ends = self.place(starts), self.place(ends)
        # One line that is broken is written much shorter than many.
        broken = np.stack([starts, ends, np.full(starts.shape, np.nan)], axis=1)
        self.axes.plot(*broken.reshape(-1, 2).T, color=colour, linewidth=width)

    def arrows(self, starts: np.ndarray, ends: np.ndarray, colour: str) -> None:
        """Draw arrows from point to point; both arrays have shape (n, 2)."""
        starts, ends = self.place(starts), self.place(ends)
        size = {"units": "dots", "width": 1.6, "headwidth": 5, "headlength": 5, "headaxislength": 4.5}
        self.axes.quiver(
            *starts.T,
            *(ends - starts).T,
            color=colour,
            angles="xy",
            scale_units="xy",
            scale=1,
            zorder=2,
            **size,
        )

    def ellipse(self, point: np.ndarray, covariance: np.ndarray, factor: float, colour: str) -> None:
        """Draw an ellipse of `factor` standard deviations about a point; covariance of shape (2, 2), m2."""
        variances, axes = np.linalg.eigh(covariance)
        minor, major = 2 * factor * np.sqrt(np.maximum(variances, 0)) * self.scale
        angle = -math.degrees(math.atan2(axes[1, 1], axes[0, 1]))
        centre = self.place(point)[0]
        self.axes.add_patch(Ellipse(centre, major, minor, angle=angle, fill=False, edgecolor=colour))

    def areas(self, outlines: Iterable[Polygon], colour: str, opacity: float) -> None:
        """Draw polygons, filled and bordered in a colour."""
        # The borders of holes run the other way, so that they stay empty.
        polygons = [orient(outline) for outline in outlines]
        rings = [ring for polygon in polygons for ring in (polygon.exterior, *polygon.interiors)]
        if not rings:
            return
        paths = [Path(self.place(np.asarray(ring.coords)[:, :2]), closed=True) for ring in rings]
        whole = Path.make_compound_path(*paths)
        self.axes.add_patch(PathPatch(whole, facecolor=colour, alpha=opacity, linewidth=0))
        self.axes.add_patch(PathPatch(whole, fill=False, edgecolor=colour, linewidth=1))

    def picture(self, rgb: np.ndarray, corners: np.ndarray) -> None:
        """Draw a picture, uint8 of shape (rows, columns, 3), with its pixels as squares.

        Parameters
        ----------
        rgb : ndarray
        corners : ndarray, shape (2, 2)
            World coordinates of its north-west and south-east corners.
        """
        (left, top), (right, bottom) = self.place(corners)
        self.axes.imshow(rgb, extent=(left, right, bottom, top), aspect="auto", interpolation="none")

    def names(self, points: np.ndarray, texts: Sequence[str], kinds: Sequence[str], leading: int = 0) -> None:
        """Write the names of points, the first ones first, as far as there is room.

        Parameters
        ----------
        points : ndarray, shape (n, 2)
        texts : sequence of str, length n
        kinds : sequence of str, length n
            Keys of `NAMES`.
        leading : int
            So many of the first names may hide points.
        """
        boxes = place_labels(self.place(points), texts, (WIDTH, self.height), leading)
        for box, text, kind in zip(boxes, texts, kinds):
            if box is not None:
                left, _top, _right, bottom = box
                self.axes.text(left, bottom - 2, plain(text), **NAMES[kind])

    def svg(self) -> str:
        """Return the map with a bar of scale and an arrow to the north."""
        metres = round_step(WIDTH / 5 / self.scale)
        right, y = WIDTH - 20, self.height + 16
        left = right - metres * self.scale
        pen = {"color": AXIS, "linewidth": 1}
        self.axes.plot([left, left, left, right, right, right], [y - 4, y + 4, y, y, y - 4, y + 4], **pen)
        self.axes.text(left - 8, y + 4, f"{metres:g} m", ha="right")
        self.axes.plot([22, 22, 18, 22, 26], [y + 6, y - 10, y - 4, y - 10, y - 4], **pen)
        self.axes.text(32, y + 4, "N")
        return svg(self.axes.figure)
