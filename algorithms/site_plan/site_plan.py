"""From a density image to the walls of a site."""

from dataclasses import dataclass
from typing import Optional

import numpy as np
from affine import Affine

from ..progress import Progress
from .walls.extraction import WallImage, WallParameters, extract_wall_pixels
from .walls.height_gate import Heights
from .walls.wall import Wall, describe_walls


@dataclass(frozen=True)
class SitePlan:
    """The walls of a site.

    Attributes
    ----------
    image : WallImage
        Wall pixels and how they were found.
    walls : tuple of Wall
    foliage : int
        Number of walls that were left out, for their points lie on no face.
    """

    image: WallImage
    walls: tuple[Wall, ...]
    foliage: int = 0

    @property
    def area(self) -> float:
        """Total area of the walls in m2."""
        return float(sum(wall.outline.area for wall in self.walls))

    @property
    def length(self) -> float:
        """Total length of the centrelines in metres."""
        return float(sum(wall.length for wall in self.walls))

    @property
    def coverage(self) -> float:
        """Share of the outlines on which there are points; 0 as long as the faces are not known."""
        covered = sum((wall.coverage or 0.0) * wall.outline.length for wall in self.walls)
        return float(covered / sum(wall.outline.length for wall in self.walls))


def extract_walls(
    density: np.ndarray,
    heights: Optional[Heights],
    transform: Affine,
    parameters: WallParameters,
    progress: Progress = Progress(),
) -> SitePlan:
    """Extract the walls from a density image.

    Parameters
    ----------
    density : ndarray of float, shape (rows, columns)
        Nan where there is none.
    heights : Heights or None
        None if only the density is known.
    transform : Affine
        From (column, row) to world coordinates; square pixels, north up.
    parameters : WallParameters
        What counts as wall.
    progress : Progress
        Reports and cancels.

    Raises
    ------
    NothingFoundError
        If no wall is found.
    """
    pixel_size = transform.a
    image = extract_wall_pixels(density, heights, pixel_size, parameters, progress.part(0.0, 0.8))
    progress.update(0.8, "Tracing outlines")
    walls = describe_walls(image, heights, transform)
    return SitePlan(image, walls)
