"""The step of the lattice."""

from ichnograph.algorithms.clouds.tiles.lattice import LATTICE, to_lattice


def test_a_step_is_10_micrometres():
    assert to_lattice(1.0) == 100_000
    assert to_lattice(0.05) == 5_000
    assert to_lattice(LATTICE) == 1
