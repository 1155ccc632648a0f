"""A storehouse: a wide gate, arched windows without glass, painted fields, and one station only."""

import numpy as np
from shapely.geometry import Polygon, box

from .building import Builder, arched
from .scene import FacadeScene, Light

BROWN, GREY = (110.0, 75.0, 50.0), (105.0, 110.0, 115.0)


def storehouse(seed: int = 0) -> FacadeScene:
    """Build a facade of one high storey, about 7.5 x 5 m."""
    generator = np.random.default_rng(seed + 2000)

    def about(value: float, spread: float = 0.06) -> float:
        return float(value + generator.uniform(-spread, spread))

    house = Builder(about(7.5), about(5.2))
    house.street(0.0)
    left, width = about(2.6), about(2.1)
    house.door(arched(left, 0.0, width, about(2.9)), about(0.35, 0.04))
    for middle in (1.3, 6.2):
        width = about(0.9)
        left, bottom = about(middle) - width / 2, about(1.6)
        house.opening(arched(left, bottom, width, about(1.5)), about(0.3, 0.04))
    for middle in (1.3, 3.7, 6.1):
        left, bottom = about(middle), about(3.75)
        house.painted(box(left - 0.45, bottom, left + about(0.45), bottom + about(0.75)), BROWN, 0.3)
    house.painted(box(about(5.3), 0.4, about(6.9), about(1.0, 0.03)), GREY, 0.4)
    house.moulding(box(0.2, 4.75, house.width - 0.2, 4.75 + about(0.16, 0.02)), about(0.12, 0.02))
    house.tree(about(0.2), 2.3, 3.1, 0.5)
    shadow = Polygon([(-1, 2.2), (-1, 0.8), (9, 3.0), (9, 4.4)])
    stations = [(about(3.0, 0.7), 1.6, about(8, 0.5))]
    return house.build("storehouse", Light(shadow, 0.03, 0.25), stations, (1.0,))
