"""Searches and stations for the tests of targets."""

import numpy as np
from ichnograph.algorithms.targets.range_image.range_image import RangeImage, image_of
from ichnograph.algorithms.targets.range_image.station import Station
from ichnograph.algorithms.targets.results import Kind, StationTargets, Target, TargetSearch, View
from ichnograph.tests.scenes.stations.caster import Scanner
from ichnograph.tests.scenes.stations.layout import Station as Simulated
from ichnograph.tests.scenes.stations.layout import target_station

SCANNER = Scanner(step=0.0006)
"""6 mm at 10 m."""


def image_of_simulated(simulated: Simulated, intensity: bool = True) -> RangeImage:
    """Return the range image of a simulated scan."""
    xyz = simulated.xyz.astype(np.float32)
    return image_of(Station(np.zeros(3), xyz, simulated.intensity if intensity else None), "scan")


def one_target(kind: str, size: float, distance: float, incidence: float = 20.0, **others) -> Simulated:
    """Return a scan of a single target."""
    return target_station(SCANNER, [(kind, size, distance, incidence)], seed=3, **others)


def target(xyz=(4.0, 0.0, 0.0), kind=Kind.CHECKERBOARD, doubt="") -> Target:
    """Return a target that is certain to 1, 2 and 3 mm along the axes."""
    return Target(
        kind=kind,
        xyz=np.array(xyz, float),
        covariance=np.diag([1e-6, 4e-6, 9e-6]),
        size=0.15,
        points=400,
        incidence_deg=12.0 if kind is Kind.CHECKERBOARD else None,
        quality=0.9,
        doubt=doubt,
    )


def view() -> View:
    """Return a picture, dark on the left, bright on the right."""
    picture = np.repeat(np.linspace(0, 255, 20).astype(np.uint8)[None, :], 20, axis=0)
    return View(picture, (9.5, 9.5), 0.24)


def station(name: str, *targets: Target, rejections=()) -> StationTargets:
    """Return the targets of a station at 100, 200, 10."""
    return StationTargets(
        name=name,
        position=np.array([100.0, 200.0, 10.0]),
        step=0.0006,
        points=1000,
        has_intensity=True,
        targets=targets,
        views=tuple(view() for _ in targets),
        rejections=tuple(rejections),
    )


def search(*stations: StationTargets) -> TargetSearch:
    """Return a search of stations."""
    return TargetSearch(tuple(stations))
