"""The results of the facade chapter and of its steps. Lengths are in metres, angles in degrees."""

from dataclasses import dataclass, field, replace
from typing import Optional, Union

import numpy as np
from shapely.geometry import MultiPolygon, Polygon

from .development.curves import Circle, Curve
from .planes.front import Side

OPENING, RECESS, COLOURED, PROJECTION = "opening", "recess", "coloured detail", "projection"
KINDS = (OPENING, RECESS, COLOURED, PROJECTION)
"""A hole through which nothing near is seen; a hole with a surface close behind; another colour in the
plane of the wall; and a surface in front of it."""

FREE, RECTANGLE, TRAPEZIUM, ARCH, CIRCLE = "free", "rectangle", "trapezium", "arch", "circle"


EDGES = ("left", "right", "bottom", "top")


@dataclass(frozen=True)
class WallPart:
    """A part of a facade, parallel to its main wall.

    Attributes
    ----------
    depth : float
        How far it is in front of the main wall; negative behind it (m).
    area : float
        Of its surface as it was seen (m2).
    """

    depth: float
    area: float


@dataclass(frozen=True)
class LeftOut:
    """A region that is not drawn.

    Attributes
    ----------
    shape : Polygon or MultiPolygon
        In u, v.
    kind : str
        One of `KINDS`, which it was thought to be, or surface.
    reason : str
    area : float
        Of the region; of an oblique surface in its own plane (m2).
    """

    shape: Union[Polygon, MultiPolygon]
    kind: str
    reason: str
    area: float


@dataclass(frozen=True)
class Points:
    """All points of a scan.

    Attributes
    ----------
    xyz : ndarray of float64, shape (n, 3)
        Relative to `origin`.
    origin : ndarray of float64, shape (3,)
        In the coordinates of the site.
    rgb : ndarray of float32, shape (n, 3), or None
        0..255.
    intensity : ndarray of float32, shape (n,), or None
        0..65535, as in the file.
    scan : ndarray of int32, shape (n,)
        The scan of each point, from 0.
    stations : ndarray of float64, shape (k, 3), or None
        Position of the scanner of each scan, relative to `origin`; nan where it is not known.
    kept : ndarray of int64, shape (n,), or None
        Positions of the points in the sequence of all points of the cloud; None if there are no others.
    warnings : tuple of str
        On points and attributes that are left out.
    """

    xyz: np.ndarray
    origin: np.ndarray
    rgb: Optional[np.ndarray]
    intensity: Optional[np.ndarray]
    scan: np.ndarray
    stations: Optional[np.ndarray] = None
    kept: Optional[np.ndarray] = None
    warnings: tuple[str, ...] = ()

    def subset(self, rows: np.ndarray) -> "Points":
        """Return some of the points, by their rows."""
        return replace(
            self,
            xyz=self.xyz[rows],
            rgb=None if self.rgb is None else self.rgb[rows],
            intensity=None if self.intensity is None else self.intensity[rows],
            scan=self.scan[rows],
            kept=rows if self.kept is None else self.kept[rows],
        )


@dataclass(frozen=True)
class Plane:
    """A plane of a facade (M of the paper, equation 1).

    Attributes
    ----------
    normal : ndarray of float64, shape (3,)
        Of length 1, towards the scanner.
    centre : ndarray of float64, shape (3,)
        The mean of its points, relative to the origin of the points.
    rms : float
        Of the distances of its points.
    points : int
    """

    normal: np.ndarray
    centre: np.ndarray
    rms: float
    points: int

    def distances(self, xyz: np.ndarray) -> np.ndarray:
        """Return signed distances of points, shape (n, 3), positive on the scanner's side."""
        return (xyz - self.centre) @ self.normal


@dataclass(frozen=True)
class Segmentation:
    """The planes of a facade and their points.

    Attributes
    ----------
    planes : tuple of Plane
        The main plane first, the others by falling number of points.
    labels : ndarray of int16, shape (n,)
        1 for points of the first plane and so on, 0 for points outside all planes, -1 for points of a plane
        in front of the facade, such as the street or a side wall.
    side : Side
        From which the facade is seen, to which the normals of the planes point.
    """

    planes: tuple[Plane, ...]
    labels: np.ndarray
    side: Side


@dataclass(frozen=True)
class Frame:
    """The coordinates of an elevation: u to the right, v up, w out of the wall towards the viewer.

    Attributes
    ----------
    origin : ndarray of float64, shape (3,)
        Where u, v and w are 0, in the coordinates of the site.
    azimuth : float
        Of w, clockwise from grid north (degrees).
    tilt : float
        Of w above the horizon (degrees); 0 for a plumb wall.
    """

    origin: np.ndarray
    azimuth: float
    tilt: float

    @property
    def axes(self) -> np.ndarray:
        """The directions of u, v and w in the site, as rows, shape (3, 3)."""
        azimuth, tilt = np.radians([self.azimuth, self.tilt])
        east, north = np.sin(azimuth), np.cos(azimuth)
        out = np.array([east * np.cos(tilt), north * np.cos(tilt), np.sin(tilt)])
        right = np.array([-north, east, 0.0])
        return np.array([right, np.cross(out, right), out])

    def local(self, xyz: np.ndarray, origin: np.ndarray) -> np.ndarray:
        """Return u, v, w, shape (n, 3), of points that are relative to `origin`."""
        return (xyz - (self.origin - origin)) @ self.axes.T

    def world(self, uvw: np.ndarray) -> np.ndarray:
        """Return the coordinates in the site, shape (n, 3), of points (u, v, w)."""
        return self.origin + np.asarray(uvw) @ self.axes


def frame_of(plane: Plane, origin: np.ndarray) -> Frame:
    """Return the frame of a plane: u, v, w are 0 at its centre, which is relative to `origin`."""
    east, north, up = plane.normal
    azimuth = float(np.degrees(np.arctan2(east, north)) % 360)
    tilt = float(np.degrees(np.arctan2(up, np.hypot(east, north))))
    return Frame(plane.centre + origin, azimuth, tilt)


@dataclass(frozen=True)
class Edges:
    """Standard deviations of the positions of the four sides of a detail (m); nan where nothing was seen.

    Attributes
    ----------
    left, right, bottom, top : float
    """

    left: float
    right: float
    bottom: float
    top: float


@dataclass(frozen=True)
class Detail:
    """A detail of a facade, in its elevation.

    Attributes
    ----------
    number : int
        From 1.
    kind : str
        One of `KINDS`.
    shape : str
        `RECTANGLE`, `TRAPEZIUM`, `ARCH`, `CIRCLE` or `FREE`.
    outline : Polygon
        In u, v; a rectangle or an arch if `shape` says so.
    raw : Polygon
        As the points show it.
    edges : Edges
    rms : float
        Of the points of the raw outline against the final one (m).
    depth : float
        Of openings and recesses, the median distance of what was seen in them from the wall around; of
        others, w of their surface. Negative behind the wall, nan where nothing was seen.
    points : int
        Their number, on its surface.
    colour : tuple of 3 float, or None
        Mean, 0..255.
    intensity : float or None
        Mean, as in the file.
    head : str or None
        flat, sloped, segmental, round or pointed; None of a circle and of a free shape.
    use : str or None
        Of an opening or a recess: window, door, passage or niche.
    open_sides : tuple of str
        left, right, bottom, top: where no wall bounds an opening.
    layer : float
        How far the wall around it is in front of the main wall; negative behind (m).
    completed : tuple of str
        Edges that were not seen, and are where the openings of the same row have theirs.
    """

    number: int
    kind: str
    shape: str
    outline: Polygon
    raw: Polygon
    edges: Edges
    rms: float
    depth: float
    points: int
    colour: Optional[tuple[float, float, float]]
    intensity: Optional[float]
    head: Optional[str] = None
    use: Optional[str] = None
    open_sides: tuple[str, ...] = ()
    layer: float = 0.0
    completed: tuple[str, ...] = ()

    @property
    def measured(self) -> tuple[str, ...]:
        """The edges that were seen: left, right, bottom, top."""
        edges = vars(self.edges)
        return tuple(name for name in EDGES if np.isfinite(edges[name]))

    @property
    def width(self) -> float:
        """From the leftmost to the rightmost point of the outline (m)."""
        left, _, right, _ = self.outline.bounds
        return right - left

    @property
    def height(self) -> float:
        """From the lowest to the highest point of the outline (m)."""
        _, bottom, _, top = self.outline.bounds
        return top - bottom

    @property
    def sill(self) -> float:
        """The height of the lowest point of the outline above the foot of the wall (m)."""
        return self.outline.bounds[1]

    @property
    def area(self) -> float:
        """The area within the outline (m2)."""
        return self.outline.area

    @property
    def width_std(self) -> float:
        """The standard deviation of the width (m); nan where a side was not seen."""
        return float(np.hypot(self.edges.left, self.edges.right))

    @property
    def height_std(self) -> float:
        """The standard deviation of the height (m); nan where a side was not seen."""
        return float(np.hypot(self.edges.bottom, self.edges.top))


@dataclass(frozen=True)
class Elevation:
    """A facade, measured.

    Attributes
    ----------
    frame : Frame
        u is 0 at the left end of the wall, v at its foot.
    wall : MultiPolygon
        In u, v; openings and recesses are holes in it.
    details : tuple of Detail
        By number.
    unseen : tuple of Polygon
        Areas of the wall that something in front hides, or from which no laser pulse came back.
    spacing : float
        Median distance between neighbouring points of the wall (m).
    rows : ndarray of int64, shape (k,)
        The points of the facade and close behind it, without those of objects in front of it.
    warnings : tuple of str
        What the user should know, in sentences.
    left_out : tuple of LeftOut
        Holes of the wall, regions of another colour, and surfaces that are not drawn, the largest first.
    side : Side, optional
        From which the facade is seen, how sure that is, and why.
    parts : tuple of WallPart
        The main wall first.
    curve : Circle or Chain, or None
        Along which the facade was rolled out, in the coordinates of the site; None of a flat one. The frame
        is then that of the plane that touches it.
    """

    frame: Frame
    wall: MultiPolygon
    details: tuple[Detail, ...]
    unseen: tuple[Polygon, ...]
    spacing: float
    rows: np.ndarray = field(default_factory=lambda: np.empty(0, np.int64))
    warnings: tuple[str, ...] = ()
    left_out: tuple[LeftOut, ...] = ()
    side: Optional[Side] = None
    parts: tuple[WallPart, ...] = ()
    curve: Optional[Curve] = None

    @property
    def radius(self) -> Optional[float]:
        """Of a round tower that is rolled out (m)."""
        return self.curve.radius if isinstance(self.curve, Circle) else None

    def world(self, uvw: np.ndarray) -> np.ndarray:
        """Return the coordinates in the site, shape (n, 3), of points (u, v, w)."""
        flat = self.frame.world(uvw)
        if self.curve is None:
            return flat
        return np.column_stack([self.curve.site(flat[:, :2]), flat[:, 2]])
