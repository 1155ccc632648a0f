"""The lattice of integers on which tiles hold coordinates.

Its step is 10 micrometres, and it is fixed to the coordinate system's origin. A tile's border, a pixel's
edge and a distance are then the same however the cloud is cut into files or chunks, and at any size of the
coordinates.
"""

LATTICE = 1e-5
"""Step of the lattice, in metres: a tenth of the finest step that scanners' files use."""

FINE = 1e-7
"""Step of the integers that coordinates are rounded from, in metres; finer than files are written."""

PER_METRE, FINE_STEPS = round(1 / FINE), round(LATTICE / FINE)
"""Fine integers in a metre, and in a step of the lattice."""


def to_lattice(metres: float) -> int:
    """Return a length in steps of the lattice."""
    return round(metres / LATTICE)
