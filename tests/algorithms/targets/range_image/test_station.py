"""The points of a station."""

from dataclasses import dataclass

import numpy as np
import pytest
from ichnograph.algorithms.clouds.source import Chunk
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.targets.range_image.station import read_stations


@dataclass(frozen=True)
class Made:
    """A source of given chunks."""

    parts: tuple
    path: str = "hall.e57"

    def chunks(self, origin, progress, size):
        yield from self.parts


def chunk(xyz, scan=None, station=None, intensity=None):
    return Chunk(
        np.array([xyz], float),
        None if intensity is None else np.array([intensity], np.uint16),
        None,
        scan=None if scan is None else np.array([scan]),
        station=None if station is None else np.array(station, float),
    )


def test_chunks_of_one_scan_are_joined():
    source = Made((chunk([1, 0, 0], 0, [0, 0, 0], 7), chunk([2, 0, 0], 0, [0, 0, 0], 8)))
    (station,) = read_stations(source)

    assert station.xyz[:, 0].tolist() == [1.0, 2.0]
    assert station.intensity.tolist() == [7, 8]


def test_scans_with_positions_are_stations_of_their_own():
    source = Made((chunk([11, 0, 0], 0, [10, 0, 0]), chunk([22, 0, 0], 1, [20, 0, 0])))
    stations = list(read_stations(source))

    assert [station.xyz[0, 0] for station in stations] == [1.0, 2.0]
    assert [station.position[0] for station in stations] == [10.0, 20.0]


def test_numbers_of_scans_without_positions_do_not_divide_a_cloud():
    source = Made((chunk([1, 0, 0], 3), chunk([2, 0, 0], 4)))

    assert len(list(read_stations(source))) == 1


def test_national_coordinates_lose_nothing():
    far = np.array([412345.67891, 5812345.67891, 71.23456])
    (station,) = read_stations(Made((chunk(far + [3, 4, 0]),)), far)

    np.testing.assert_allclose(station.xyz[0], [3, 4, 0], atol=1e-6)
    np.testing.assert_array_equal(station.position, far)


def test_a_chosen_position_does_not_overrule_a_stated_one():
    with pytest.raises(InputError, match=r"hall\.e57 states where its scanner stood"):
        list(read_stations(Made((chunk([1, 0, 0], 0, [0, 0, 0]),)), np.zeros(3)))
