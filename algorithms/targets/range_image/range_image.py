"""The range image of a station: its points by direction."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from ...errors import InputError
from ...kernels import kernel
from .angular_step import angular_step
from .settings import RangeImageSettings
from .station import Station


@dataclass(frozen=True)
class RangeImage:
    """What a scanner saw, as an image in azimuth (columns) and elevation (rows, from below).

    Attributes
    ----------
    position : ndarray of float64, shape (3,)
        Of the scanner, in the coordinates of the file.
    step : float
        Side of a pixel, and the angle between neighbouring points, radians.
    cut : float
        Azimuth of the edge of the first column, radians.
    floor : float
        Elevation of the edge of the first row, radians.
    period : int
        Number of columns of a full circle; the image may have fewer.
    xyz : ndarray of float32, shape (n, 3)
        The points, sorted by their pixel, relative to the scanner.
    intensity : ndarray of uint16, shape (n,), or None
    starts : ndarray of uint32, shape (rows * columns + 1,)
        The points of pixel i are those from starts[i] to starts[i + 1].
    ranges : ndarray of float32, shape (rows, columns)
        Of the first point of each pixel, metres; 0 where there is none.
    brightness : ndarray of float32, shape (rows, columns)
        Mean intensity of each pixel.
    """

    position: np.ndarray
    step: float
    cut: float
    floor: float
    period: int
    xyz: np.ndarray
    intensity: Optional[np.ndarray]
    starts: np.ndarray
    ranges: np.ndarray
    brightness: np.ndarray

    def direction(self, row: float, column: float) -> np.ndarray:
        """Return the unit vector from the scanner to the middle of a pixel."""
        azimuth = self.cut + (column + 0.5) * self.step_of_azimuth
        elevation = self.floor + (row + 0.5) * self.step
        level = np.cos(elevation)
        return np.array([level * np.cos(azimuth), level * np.sin(azimuth), np.sin(elevation)])

    @property
    def step_of_azimuth(self) -> float:
        """Width of a column, radians; a whole number of them is a full circle."""
        return 2.0 * np.pi / self.period

    def pixel(self, xyz: np.ndarray) -> tuple[float, float]:
        """Return row and column, with fractions, of a position relative to the scanner."""
        azimuth = np.mod(np.arctan2(xyz[1], xyz[0]) - self.cut, 2.0 * np.pi)
        elevation = np.arctan2(xyz[2], np.hypot(xyz[0], xyz[1]))
        return (elevation - self.floor) / self.step - 0.5, azimuth / self.step_of_azimuth - 0.5

    def around(self, xyz: np.ndarray, radius: float) -> np.ndarray:
        """Return the numbers of the points that are seen within `radius`, metres, of a position.

        They are in a cone: their own ranges do not matter.
        """
        distance = float(np.linalg.norm(xyz))
        angle = np.arcsin(min(radius / distance, 1.0))
        row, column = self.pixel(xyz)
        tall = angle / self.step + 1.0
        level = np.cos(min(abs(np.arcsin(xyz[2] / distance)) + angle, 1.5))
        wide = min(angle / (self.step_of_azimuth * level) + 1.0, self.period / 2 - 1)
        rows = np.arange(int(max(row - tall, 0)), int(min(row + tall + 1, self.ranges.shape[0] - 1)) + 1)
        columns = np.arange(int(np.floor(column - wide)), int(column + wide + 1) + 1) % self.period
        columns = columns[columns < self.ranges.shape[1]]
        cells = (rows[:, None] * self.ranges.shape[1] + columns).ravel()
        found = _points_of(self.starts, cells)
        rays = self.xyz[found].astype(np.float64)
        cosine = rays @ (xyz / distance) / np.linalg.norm(rays, axis=1)
        return found[cosine > np.cos(angle)]


def image_of(station: Station, name: str, settings: RangeImageSettings = RangeImageSettings()) -> RangeImage:
    """Sort the points of a station into its range image.

    Parameters
    ----------
    station : Station
    name : str
        Of the scan, for messages.
    settings : RangeImageSettings

    Raises
    ------
    InputError
        If the points cannot have been seen from the station.
    """
    xyz, intensity = station.xyz, station.intensity
    distance = np.sqrt(np.einsum("ij,ij->i", xyz, xyz))
    outside = distance < settings.nearest_m
    if np.any(outside):
        xyz, distance = xyz[~outside], distance[~outside]
        intensity = None if intensity is None else intensity[~outside]
    if len(xyz) <= settings.neighbours:
        raise _too_few(name)
    azimuth = np.arctan2(xyz[:, 1], xyz[:, 0])
    cut = _cut(azimuth, settings.azimuth_bins)
    azimuth = np.mod(azimuth - np.float32(cut), np.float32(2.0 * np.pi))
    elevation = np.arcsin(np.clip(xyz[:, 2] / distance, -1.0, 1.0))
    step = angular_step(azimuth, elevation, settings)
    if step <= 0:
        raise _too_few(name)
    period = max(round(2.0 * np.pi / step), 1)
    columns = min(int(azimuth.max() / (2.0 * np.pi / period)) + 1, period)
    floor = float(elevation.min())
    rows = int((elevation.max() - floor) / step) + 1
    if rows * columns > settings.most_pixels_per_point * max(len(xyz), 10_000):
        raise _not_one_station(name, station.position, f"its {len(xyz)} points fill too few directions")
    kind = np.int32 if rows * columns < 2**31 else np.int64
    # numpy 1 keeps single precision here, unlike for `rows`.
    pixel = np.minimum((elevation - floor) / step, rows - 1).astype(kind)
    pixel *= columns
    pixel += np.minimum((azimuth * (period / (2.0 * np.pi))).astype(np.int32), columns - 1)
    # Tens of millions of points: what is no longer needed makes room.
    del azimuth, elevation
    starts, order = _sorted(pixel, rows * columns)
    del pixel
    ranges, brightness = _grids(starts, order, distance, intensity, (rows, columns))
    jumps = jump_share(ranges, settings.jump)
    if jumps > settings.most_jumps:
        raise _not_one_station(name, station.position, f"ranges jump between {jumps:.0%} of its neighbours")
    return RangeImage(
        position=station.position,
        step=step,
        cut=cut,
        floor=floor,
        period=period,
        xyz=xyz[order],
        intensity=None if intensity is None else intensity[order],
        starts=starts,
        ranges=ranges,
        brightness=brightness,
    )


def _too_few(name: str) -> InputError:
    return InputError(f"{name} has too few points in which to search for targets; choose a denser scan.")


def _not_one_station(name: str, position: np.ndarray, reason: str) -> InputError:
    place = " ".join(f"{value:.2f}" for value in position)
    return InputError(
        f"{name} is not the scan of one station at {place}: {reason}. Choose the scans of single stations, "
        "in the scanner's own frame or with STATION, the position of the scanner."
    )


def jump_share(ranges: np.ndarray, jump: float) -> float:
    """Return the share of neighbours in a row whose ranges differ by more than the part `jump`."""
    jumps, pairs = 0, 0
    # Row by row, because copies of tens of millions of pixels need as much memory as the points.
    for left, right in zip(ranges[:, :-1], ranges[:, 1:]):
        both = (left > 0) & (right > 0)
        pairs += np.count_nonzero(both)
        jumps += np.count_nonzero(both & (np.abs(left - right) > jump * np.minimum(left, right)))
    return jumps / pairs if pairs else 1.0


def _cut(azimuth: np.ndarray, bins: int) -> float:
    """Return the azimuth at the end of the largest sector without points; -pi of a full circle."""
    taken = np.flatnonzero(np.histogram(azimuth, bins, (-np.pi, np.pi))[0])
    gaps = np.diff(np.append(taken, taken[0] + bins))
    widest = int(np.argmax(gaps))
    if gaps[widest] < 2:
        return -np.pi
    return float((taken[widest] + gaps[widest]) % bins * (2.0 * np.pi / bins) - np.pi)


@kernel
def _sorted(pixel: np.ndarray, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the first point of each pixel, and the order of the points by pixel."""
    starts = np.zeros(count + 1, np.uint32)
    for value in pixel:
        starts[value + 1] += 1
    for number in range(count):
        starts[number + 1] += starts[number]
    filled = starts[:-1].copy()
    order = np.empty(len(pixel), np.uint32)
    for number in range(len(pixel)):
        order[filled[pixel[number]]] = number
        filled[pixel[number]] += 1
    return starts, order


@kernel
def _points_of(starts: np.ndarray, cells: np.ndarray) -> np.ndarray:
    count = 0
    for cell in cells:
        count += int(starts[cell + 1]) - int(starts[cell])
    points = np.empty(count, np.int64)
    count = 0
    for cell in cells:
        for point in range(int(starts[cell]), int(starts[cell + 1])):
            points[count] = point
            count += 1
    return points


def _grids(
    starts: np.ndarray,
    order: np.ndarray,
    distance: np.ndarray,
    intensity: Optional[np.ndarray],
    shape: tuple[int, int],
) -> tuple[np.ndarray, np.ndarray]:
    counts = np.diff(starts)
    full = counts > 0
    ranges = np.zeros(len(counts), np.float32)
    ranges[full] = distance[order[starts[:-1][full]]]
    brightness = np.zeros(len(counts), np.float32)
    if intensity is not None:
        brightness[full] = np.add.reduceat(intensity[order].astype(np.float32), starts[:-1][full])
        brightness[full] /= counts[full]
    return ranges.reshape(shape), brightness.reshape(shape)
