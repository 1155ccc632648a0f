"""Registrations made by hand: what layers and reports show, without any computation."""

from dataclasses import replace

import numpy as np
from ichnograph.algorithms.registration.results import (
    REGISTERED,
    ControlPoint,
    Correspondence,
    Estimate,
    GlobalTest,
    Registration,
    ScaleTest,
    ScanRegistration,
)
from ichnograph.algorithms.registration.settings import Settings
from rasterio.crs import CRS

CORNER = np.array([412_300.0, 5_812_300.0, 70.0])
PARAMETERS = ("shift_x", "shift_y", "shift_z", "rotation_x", "rotation_y", "rotation_z")
NO_VALUES = np.full(3, np.nan)


def correspondence(target, control, position, residual=(0.001, -0.002, 0.0005), **changes):
    made = Correspondence(
        target=target,
        control=control,
        surveyed=True,
        used=True,
        position=np.asarray(position, dtype=float),
        residual=np.asarray(residual, dtype=float),
        redundancy=np.array([0.6, 0.7, 0.65]),
        normalized=np.asarray(residual) / 0.0024,
        studentized=np.asarray(residual) / 0.0027,
        detectable=np.array([0.016, 0.015, 0.0155]),
        covariance=np.diag([4e-6, 9e-6, 1e-6]),
    )
    return replace(made, **changes)


def rejected(target, control, position, residual):
    return correspondence(
        target,
        control,
        position,
        residual,
        used=False,
        redundancy=NO_VALUES,
        studentized=NO_VALUES,
        detectable=NO_VALUES,
    )


def scan(name, correspondences, station, **changes):
    matrix = np.eye(4)
    matrix[:3, 3] = station
    made = ScanRegistration(
        name=name,
        status=REGISTERED,
        reason="",
        targets=len(correspondences),
        matrix=matrix,
        scale=1.0,
        estimates=tuple(Estimate(item, 1.5, 0.0012) for item in PARAMETERS),
        correlations=np.eye(6),
        correspondences=tuple(correspondences),
        test=GlobalTest(9.1, 12.0, 0.87, 0.69),
        scale_test=ScaleTest(12.0, 45.0, False, "The scale does not differ from 1: leave it out."),
        chance=3e-7,
        round=1,
    )
    return replace(made, **changes)


def refused(name="S99", status="ambiguous", reason="Two solutions fit: measure another target.", **changes):
    return ScanRegistration(name=name, status=status, reason=reason, targets=8, **changes)


def registration(scans=2, targets=6, seed=0, more=()):
    """Return scans in a row of rooms; every scan has an appended point and, but for the first, an outlier."""
    random = np.random.default_rng(seed)
    points, registered = [], []
    for number in range(1, scans + 1):
        station = CORNER + (12.0 * ((number - 1) % 10), 12.0 * ((number - 1) // 10), 1.5)
        places = station + random.uniform((-6, -6, -1.5), (6, 6, 3), (targets + 1, 3))
        names = [f"P{number * 100 + place}" for place in range(targets)]
        name = f"S{number:02d}"
        seen = [
            correspondence(f"T{place + 1}", control, xyz, random.normal(0, 0.002, 3))
            for place, (control, xyz) in enumerate(zip(names, places))
        ]
        if number > 1:
            seen[-1] = rejected(f"T{targets}", names[-1], places[targets - 1], (0.071, -0.02, 0.004))
        points += [
            ControlPoint(control, xyz, np.zeros((3, 3)), "surveyed", (name,))
            for control, xyz in zip(names, places)
        ]
        points.append(ControlPoint(f"{name}:T9", places[targets], np.diag([4e-6, 9e-6, 1e-6]), name, (name,)))
        registered.append(scan(name, seen, station, unmatched=("T9",), targets=targets + 1))
    return Registration(
        settings=Settings(),
        tolerance=0.0148,
        scans=(*registered, *more),
        points=tuple(sorted(points, key=lambda point: not point.surveyed)),
        test=GlobalTest(20.4, 24.0, 0.92, 0.67),
        crs=CRS.from_epsg(25833),
    )
