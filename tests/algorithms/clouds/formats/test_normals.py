"""Normals are found among the attributes, whatever programs call them."""

import pytest
from ichnograph.algorithms.clouds.formats.normals import find_normals


@pytest.mark.parametrize(
    ("names", "found"),
    [
        (("nx", "ny", "nz"), (0, 1, 2)),
        (("quality", "NormalZ", "NormalX", "NormalY"), (2, 3, 1)),
        (("Normals:0", "Normals:1", "Normals:2"), (0, 1, 2)),
        (("scalar_Nx", "scalar_Ny", "scalar_Nz"), (0, 1, 2)),
    ],
)
def test_components_are_found_in_any_order_and_convention(names, found):
    assert find_normals(names) == found


@pytest.mark.parametrize("names", [(), ("nx", "ny"), ("x", "y", "z")])
def test_two_components_or_coordinates_are_not_normals(names):
    assert find_normals(names) is None
