"""Maps for reports."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Optional

import numpy as np

from .html import Markup, element, join
from .svg import LETTER, LINE, WIDTH, drawing, round_step, stroke, text


@dataclass(frozen=True)
class Map:
    """A map: puts world coordinates, metres, into a drawing of equal scales with north up.

    Attributes
    ----------
    west, north : float
        World coordinates of the upper left corner.
    scale : float
        Pixels per metre.
    height : float
        Of the drawing, pixels; its width is `WIDTH`.
    """

    west: float
    north: float
    scale: float
    height: float

    @classmethod
    def around(cls, points: np.ndarray, tallest: float = 620.0) -> "Map":
        """Return the map that shows all points, shape (n, 2), with a margin for their names."""
        margin = 45.0
        low, high = points.min(axis=0), points.max(axis=0)
        span = np.maximum(high - low, 1e-3 * max(1.0, float(np.max(high - low))))
        scale = float(min((WIDTH - 2 * margin) / span[0], (tallest - 2 * margin) / span[1]))
        height = max(float(span[1]) * scale + 2 * margin, 160.0)
        centre = (low + high) / 2
        return cls(float(centre[0]) - WIDTH / 2 / scale, float(centre[1]) + height / 2 / scale, scale, height)

    @property
    def diagonal(self) -> float:
        """Of the drawing, metres."""
        return math.hypot(WIDTH, self.height) / self.scale

    def place(self, points: np.ndarray) -> np.ndarray:
        """Return the pixels of points, both of shape (n, 2)."""
        return (np.asarray(points, dtype=float).reshape(-1, 2) - (self.west, self.north)) * (
            self.scale,
            -self.scale,
        )

    def shows(self, points: np.ndarray) -> np.ndarray:
        """Tell which points, shape (n, 2), lie in the drawing."""
        places = self.place(points)
        return np.all((places >= 0) & (places <= (WIDTH, self.height)), axis=1)

    def dots(self, points: np.ndarray, colour: str, diameter: float = 5.0) -> Markup:
        """Return dots."""
        path = "".join(f"M{x:.1f} {y:.1f}h.01" for x, y in self.place(points))
        return stroke(path, colour, diameter, stroke_linecap="round")

    def triangles(self, points: np.ndarray, colour: str) -> Markup:
        """Return triangles, the sign of a station."""
        path = "".join(f"M{x:.1f} {y - 8:.1f}l7 12h-14z" for x, y in self.place(points))
        return element("path", d=path, fill=colour, stroke="#fff")

    def crosses(self, points: np.ndarray, colour: str) -> Markup:
        """Return crosses."""
        path = "".join(f"M{x - 5:.1f} {y - 5:.1f}l10 10m0-10l-10 10" for x, y in self.place(points))
        return stroke(path, colour, 2.0)

    def rays(self, start: np.ndarray, ends: np.ndarray, colour: str, width: float = 1.0) -> Markup:
        """Return lines from one point, shape (2,), to others, shape (n, 2)."""
        return self.lines(np.broadcast_to(start, ends.shape), ends, colour, width)

    def lines(self, starts: np.ndarray, ends: np.ndarray, colour: str, width: float = 1.0) -> Markup:
        """Return lines from point to point; both arrays have shape (n, 2)."""
        pairs = zip(self.place(starts), self.place(ends))
        path = "".join(f"M{x:.1f} {y:.1f}L{u:.1f} {v:.1f}" for (x, y), (u, v) in pairs)
        return stroke(path, colour, width)

    def arrows(self, starts: np.ndarray, ends: np.ndarray, colour: str) -> Markup:
        """Return arrows from point to point; both arrays have shape (n, 2)."""
        starts, ends = self.place(starts), self.place(ends)
        along = ends - starts
        length = np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-9)
        head = along / length * np.minimum(7.0, length)
        aside = np.column_stack([-head[:, 1], head[:, 0]]) * 0.4
        path = "".join(
            "M{:.1f} {:.1f}L{:.1f} {:.1f}M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}".format(*numbers)
            for numbers in np.column_stack([starts, ends, ends - head + aside, ends, ends - head - aside])
        )
        return stroke(path, colour, 1.6)

    def ellipse(self, point: np.ndarray, covariance: np.ndarray, factor: float, colour: str) -> Markup:
        """Return an ellipse of `factor` standard deviations about a point; covariance of shape (2, 2), m2."""
        variances, axes = np.linalg.eigh(covariance)
        (x, y), (minor, major) = self.place(point)[0], factor * np.sqrt(np.maximum(variances, 0)) * self.scale
        turn = -math.degrees(math.atan2(axes[1, 1], axes[0, 1]))
        return element(
            "ellipse",
            rx=f"{major:.1f}",
            ry=f"{minor:.1f}",
            transform=f"translate({x:.1f} {y:.1f}) rotate({turn:.1f})",
            fill="none",
            stroke=colour,
        )

    def names(
        self, points: np.ndarray, texts: Sequence[str], kinds: Sequence[str], leading: int = 0
    ) -> Markup:
        """Return the names of points, the first ones first, as far as there is room.

        Parameters
        ----------
        points : ndarray, shape (n, 2)
        texts : sequence of str, length n
        kinds : sequence of str, length n
            Classes of the stylesheet.
        leading : int
            So many of the first names may hide points.
        """
        places = self.place(points)
        taken = np.column_stack([places - 3, places + 3])
        hidden = np.s_[leading : len(places)]
        shown = []
        for number, (place, name, kind) in enumerate(zip(places, texts, kinds)):
            in_the_way = np.delete(taken, hidden, axis=0) if number < leading else taken
            box = self._room(place, LETTER * len(name), in_the_way)
            if box is not None:
                taken = np.vstack([taken, box])
                shown.append(text(box[0], box[3] - 2, name, kind or None))
        return join(shown)

    def _room(self, place: np.ndarray, wide: float, taken: np.ndarray) -> Optional[np.ndarray]:
        """Return a box (left, top, right, bottom) for a name beside its point, or None if there is none."""
        x, y = place
        corners = ((x + 6, y + 4), (x - 6 - wide, y + 4), (x - wide / 2, y - 7), (x - wide / 2, y + 16))
        for left, base in corners:
            box = np.array([left, base - LINE + 3, left + wide, base + 2])
            inside = box[0] >= 0 and box[1] >= 0 and box[2] <= WIDTH and box[3] <= self.height
            if inside and not np.any(np.all((taken[:, :2] < box[2:]) & (taken[:, 2:] > box[:2]), axis=1)):
                return box
        return None

    def sheet(self, *parts: Markup) -> Markup:
        """Return the whole map, with a frame, a bar of scale and north."""
        length = round_step(WIDTH / 5 / self.scale)
        x, y = WIDTH - 20 - length * self.scale, self.height + 16
        bar = element("path", d=f"M{x:.1f} {y - 4:.1f}v8m0-4h{length * self.scale:.1f}m0-4v8", class_="axis")
        frame = element("rect", x=0.5, y=0.5, width=WIDTH - 1, height=f"{self.height - 1:.1f}", class_="grid")
        north = element("path", d=f"M22 {self.height + 22:.1f}v-16m-4 6l4-6l4 6", class_="axis")
        return drawing(
            self.height + 28,
            frame,
            *parts,
            bar,
            text(x - 8, y + 4, f"{length:g} m", "end"),
            north,
            text(32, y + 4, "N", None),
        )
