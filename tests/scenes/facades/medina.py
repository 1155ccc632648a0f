"""A house of an old town: green shutters, an arched door, a cornice, and a tree in front of it."""

import numpy as np
from shapely.geometry import Polygon, box

from .building import Builder, arched
from .scene import FacadeScene, Light

GREEN, OCHRE = (70.0, 105.0, 85.0), (176.0, 120.0, 60.0)


def medina(seed: int = 0) -> FacadeScene:
    """Build a facade of two storeys, about 8 x 6 m."""
    generator = np.random.default_rng(seed)

    def about(value: float, spread: float = 0.06) -> float:
        return float(value + generator.uniform(-spread, spread))

    house = Builder(about(8.2), about(6.2))
    house.street(0.01)
    house.corner(left=False, length=1.5)
    for number, middle in enumerate((1.7, 4.1, 6.5)):
        width, height = about(0.95), about(1.35)
        left, bottom = about(middle) - width / 2, about(3.3)
        hole = box(left, bottom, left + width, bottom + height)
        if number == 1:
            house.opening(hole, about(0.2, 0.03))
        else:
            house.window(hole, about(0.15, 0.03))
        leaf = 0.5 * width
        for edge in (left - leaf - 0.03, left + width + 0.03):
            house.painted(box(edge, bottom - 0.02, edge + leaf, bottom + height + 0.02), GREEN, 0.35)
    door = about(4.3)
    house.door(arched(door, 0.0, about(1.2), about(2.4)), about(0.25, 0.03))
    left, width = about(1.5), about(1.0)
    house.window(box(left, 1.0, left + width, about(2.1)), about(0.15, 0.03))
    sign = about(6.3)
    house.painted(box(sign, 1.5, sign + about(0.9), about(2.1)), OCHRE, 0.5)
    house.moulding(box(0.0, 5.5, house.width, 5.5 + about(0.2, 0.03)), about(0.22, 0.03))
    house.tree(about(0.4), 2.6, 2.6, 0.7)
    shadow = Polygon([(2.6, -1), (3.6, -1), (6.1, 8), (4.9, 8)])
    stations = [(about(4.5, 0.5), 1.6, about(9, 0.5)), (about(0.5, 0.5), 1.6, about(8, 0.5))]
    return house.build("medina", Light(shadow, 0.025, 0.3), stations, (1.0, 1.0))
