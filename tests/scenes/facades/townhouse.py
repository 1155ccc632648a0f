"""A town house: tall windows with painted surrounds, a string course, and a car in front of it."""

import numpy as np
from shapely.geometry import Polygon, box

from .building import Builder
from .scene import FacadeScene, Light

BLUE, RED = (60.0, 85.0, 140.0), (150.0, 60.0, 50.0)


def townhouse(seed: int = 0) -> FacadeScene:
    """Build a facade of two storeys, about 9 x 7 m."""
    generator = np.random.default_rng(seed + 1000)

    def about(value: float, spread: float = 0.06) -> float:
        return float(value + generator.uniform(-spread, spread))

    house = Builder(about(9.0), about(6.8))
    house.street(0.02)
    house.corner(left=True, length=1.2)
    for middle in (1.6, 4.5, 7.4):
        width, height = about(1.0), about(1.7)
        left, bottom = about(middle) - width / 2, about(3.9)
        house.window(box(left, bottom, left + width, bottom + height), about(0.12, 0.02))
        house.painted(
            box(left - 0.02, bottom - 0.5, left + width + 0.02, bottom - about(0.12, 0.02)), BLUE, 0.4
        )
    for middle in (1.6, 7.4):
        width = about(1.1)
        left, bottom = about(middle) - width / 2, about(1.1)
        house.window(box(left, bottom, left + width, bottom + about(1.4)), about(0.15, 0.03))
    left, width = about(4.0), about(1.1)
    house.door(box(left, 0.0, left + width, about(2.3)), about(0.3, 0.03))
    left = about(2.75)
    house.painted(box(left, 1.3, left + about(0.6), about(2.2)), RED, 0.45)
    house.moulding(box(0.0, 3.05, house.width, 3.05 + about(0.15, 0.02)), about(0.08, 0.01))
    car = about(6.6, 0.1)
    house.box(box(car, -0.2, car + 1.6, 0.9), 1.5, 2.4, (150.0, 30.0, 30.0), 0.5)
    shadow = Polygon([(5.6, -1), (8.2, -1), (7.2, 8), (6.0, 8)])
    stations = [(about(4.5, 0.5), 1.6, about(10, 0.5)), (about(9.5, 0.5), 1.6, about(8, 0.5)),
                (about(0.5, 0.5), 1.7, about(7.5, 0.5))]  # fmt: skip
    return house.build("townhouse", Light(shadow, 0.02, 0.2), stations, (1.0, 0.7, 1.0))
