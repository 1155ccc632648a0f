"""The parameters of the facade chapter, with the symbols of the paper."""

from dataclasses import dataclass
from typing import Optional


@dataclass(frozen=True)
class Settings:
    """How the details of a facade are found.

    Attributes
    ----------
    distance : float
        ds, the largest distance of a point from its plane (m).
    seed_radius : float
        td, the largest radius of a seed surface (m).
    seed_colour : float
        tr, the largest distance of the colour of a seed to the mean of its surface.
    seed_variance : float, optional
        Vr, the largest sum of the variances of red, green and blue in a seed surface; derived from the
        noise of the colours if not given.
    grow_colour : float
        tr2, the largest distance of the colour of a point to the mean of the region it joins.
    intensity : float, optional
        f, regions whose mean intensities differ by less, relative to the wall's, are one; derived from the
        noise of the intensity if not given.
    triangle_factor : float
        delta over the mean area of the triangles.
    triangle_count : int
        eta, the number of larger triangles that a point may belong to.
    noise_iterations : int
        Rounds in which noise is removed, at most.
    alpha : float, optional
        Of the alpha shape (m); follows the spacing of the points if not given.
    min_area : float, optional
        Of a detail (m2); the square of `seed_radius` if not given.
    regularise : bool
        Whether outlines become rectangles and arches where they are some.
    """

    distance: float = 0.05
    seed_radius: float = 0.2
    seed_colour: float = 30.0
    seed_variance: Optional[float] = None
    grow_colour: float = 60.0
    intensity: Optional[float] = None
    triangle_factor: float = 3.0
    triangle_count: int = 5
    noise_iterations: int = 10
    alpha: Optional[float] = None
    min_area: Optional[float] = None
    regularise: bool = True

    @property
    def smallest_area(self) -> float:
        """The area of the smallest detail (m2)."""
        return self.seed_radius**2 if self.min_area is None else self.min_area
