"""The parts of a scene: ground, prisms, plants. Lengths are in metres, z is upwards."""

from dataclasses import dataclass

import numpy as np
from shapely.geometry import Polygon

REFLECTANCE = {
    "wall": 0.7,
    "lintel": 0.7,
    "slab": 0.8,
    "furniture": 0.45,
    "fitted": 0.45,
    "rubble": 0.6,
    "trunk": 0.3,
    "person": 0.35,
    "glass": 0.1,
    "cloth": 0.4,
    "mirror": 0.0,
}
PLAN_HEIGHT = 1.3
"""Height above the ground at which the footprint of a leaning prism is true (m)."""
GROUND_REFLECTANCE = 0.4
PLANT_REFLECTANCE = 0.5


@dataclass(frozen=True)
class Ground:
    """A sloping plane through the origin, rough, over a smooth undulation.

    Rays are cast in a world whose ground is the plane; the undulation then shifts every return
    vertically, whatever it hit, so that walls and plants move with the ground below them.

    Parameters
    ----------
    slope_x, slope_y : float
        Rise per metre.
    undulation : float
        Amplitude (m).
    wavelength : float
        Of the undulation (m).
    roughness : float
        Standard deviation of a ground point's height (m).
    terrace, terrace_from : float
        Everything north of y = `terrace_from` is `terrace` higher (m). As with the undulation, rays are
        cast without it; a wall should stand there and hide the step.
    """

    slope_x: float = 0.0
    slope_y: float = 0.0
    undulation: float = 0.0
    wavelength: float = 15.0
    roughness: float = 0.005
    terrace: float = 0.0
    terrace_from: float = 0.0

    @property
    def is_plane(self) -> bool:
        """Whether undulation and terrace are zero."""
        return not (self.undulation or self.terrace)

    def height(self, x, y):
        """Return the height of the plane."""
        return self.slope_x * x + self.slope_y * y

    def lift(self, x, y):
        """Return the height that undulation and terrace add to the plane."""
        turns = 2 * np.pi / self.wavelength
        waves = self.undulation * np.sin(turns * (x + 0.3 * y)) * np.cos(turns * (y - 0.4 * x))
        return waves + self.terrace * (y > self.terrace_from)


@dataclass(frozen=True)
class Prism:
    """A vertical prism.

    Parameters
    ----------
    footprint : Polygon
        May have holes.
    top : float
        Height of the upper face.
    bottom : float
        Height of the lower face; minus infinity for objects on the ground.
    material : str
        A key of `REFLECTANCE`; only walls belong to the truth.
    follows_ground : bool
        Whether `top` and `bottom` are heights above the ground below.
    relief : float
        Standard deviation of the masonry about its faces (m), smooth over some decimetres. The truth is
        the mean face.
    lean : (float, float)
        Lean of the prism to the east and to the north, in metres per metre of height. The footprint is
        that at `PLAN_HEIGHT` above the ground, where plans are cut.
    passing : float
        Share of the rays that pass through, as through glass or curtains.
    """

    footprint: Polygon
    top: float
    bottom: float = -np.inf
    material: str = "wall"
    follows_ground: bool = False
    relief: float = 0.0
    lean: tuple[float, float] = (0.0, 0.0)
    passing: float = 0.0

    def rise(self, ground: Ground) -> float:
        """Return the height of the top above the ground at the middle of the footprint."""
        if self.follows_ground:
            return self.top
        middle = self.footprint.representative_point()
        return self.top - ground.height(middle.x, middle.y)


@dataclass(frozen=True)
class Plant:
    """An ellipsoid of foliage that a ray crosses with probability ``exp(-density * length)``.

    Parameters
    ----------
    centre, radii : tuple of three floats
        In x, y, z.
    density : float
        Extinction coefficient (1/m).
    """

    centre: tuple
    radii: tuple
    density: float


@dataclass(frozen=True)
class Mirror:
    """The front of a mirror on a wall; it returns no point of its own, but those of the room, reflected.

    Parameters
    ----------
    start, end : (float, float)
        Ends of its front in plan, the room on the left.
    bottom, top : float
    """

    start: tuple[float, float]
    end: tuple[float, float]
    bottom: float
    top: float

    def reflected(self, points: np.ndarray) -> np.ndarray:
        """Return `points`, shape (n, 3), on the other side of the mirror."""
        start, along = np.array(self.start), np.subtract(self.end, self.start)
        left = np.array([-along[1], along[0]]) / np.hypot(*along)
        moved = points.copy()
        moved[:, :2] -= 2 * ((points[:, :2] - start) @ left)[:, None] * left
        return moved

    def images(self, scanner: np.ndarray, points: np.ndarray) -> np.ndarray:
        """Return which of `points`, shape (n, 3), a scanner also sees in the mirror, and where."""
        start, along = np.array(self.start), np.subtract(self.end, self.start)
        left = np.array([-along[1], along[0]]) / np.hypot(*along)
        before = float((scanner[:2] - start) @ left)
        images = self.reflected(points[(points[:, :2] - start) @ left > 0])
        if before <= 0 or not len(images):
            return np.empty((0, 3))
        share = before / (before - (images[:, :2] - start) @ left)
        crossing = scanner + share[:, None] * (images - scanner)
        station = (crossing[:, :2] - start) @ along / (along @ along)
        inside = (station >= 0) & (station <= 1) & (crossing[:, 2] >= self.bottom)
        return images[inside & (crossing[:, 2] <= self.top)]
