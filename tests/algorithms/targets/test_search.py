"""The search in files."""

import numpy as np
import pytest
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.errors import InputError
from ichnograph.algorithms.targets.search import find_targets
from ichnograph.algorithms.targets.settings import TargetSettings, Wanted
from ichnograph.tests.algorithms.targets.made_targets import one_target

SHIFT = np.array([50.0, -20.0, 3.0])


@pytest.fixture(scope="module")
def scan():
    return one_target("black and white", 0.15, 4.0)


def write_xyz(path, scan, intensity=True, shift=(0.0, 0.0, 0.0)):
    columns = [scan.xyz + shift]
    if intensity:
        columns.append(scan.intensity[:, None])
    header = "x y z intensity" if intensity else "x y z"
    np.savetxt(path, np.hstack(columns), "%.5f", header=header, comments="")
    return path


def write_ptx(path, scan, *shifts):
    lines = []
    for shift in shifts:
        pose = np.eye(4)
        pose[3, :3] = shift
        lines += [str(len(scan.xyz)), "1", " ".join(map(str, shift)), "1 0 0", "0 1 0", "0 0 1"]
        lines += [" ".join(map(str, row)) for row in pose]
        shades = scan.intensity / 65535
        lines += [f"{x:.5f} {y:.5f} {z:.5f} {i:.5f}" for (x, y, z), i in zip(scan.xyz, shades)]
    path.write_text("\n".join(lines) + "\n")
    return path


def test_a_scan_in_its_own_frame_is_seen_from_the_origin(scan, tmp_path):
    search = find_targets(open_cloud([write_xyz(tmp_path / "hall.xyz", scan)]))
    (station,) = search.stations

    assert station.name == "hall"
    assert np.linalg.norm(station.place(station.sure[0]) - scan.targets[0].centre) < 0.001


def test_a_georeferenced_scan_is_seen_from_the_chosen_station(scan, tmp_path):
    path = write_xyz(tmp_path / "hall.xyz", scan, shift=SHIFT)
    (station,) = find_targets(open_cloud([path]), TargetSettings(station=SHIFT)).stations

    assert np.linalg.norm(station.place(station.sure[0]) - SHIFT - scan.targets[0].centre) < 0.001


def test_each_scan_of_a_ptx_file_is_seen_from_its_own_position(scan, tmp_path):
    path = write_ptx(tmp_path / "hall.ptx", scan, SHIFT, SHIFT + [10.0, 0.0, 0.0])
    search = find_targets(open_cloud([path]))

    assert [station.name for station in search.stations] == ["hall_1", "hall_2"]
    places = [station.place(station.sure[0]) for station in search.stations]
    np.testing.assert_allclose(places[1] - places[0], [10.0, 0.0, 0.0], atol=1e-4)


def test_a_position_that_the_file_states_is_not_overruled(scan, tmp_path):
    path = write_ptx(tmp_path / "hall.ptx", scan, SHIFT)

    with pytest.raises(InputError, match="leave STATION empty"):
        find_targets(open_cloud([path]), TargetSettings(station=SHIFT))


def test_a_cloud_without_intensity_is_searched_for_spheres_with_a_warning(scan, tmp_path):
    search = find_targets(open_cloud([write_xyz(tmp_path / "hall.xyz", scan, intensity=False)]))

    assert any("hall.xyz has no intensity" in sentence for sentence in search.warnings)


def test_black_and_white_targets_are_refused_without_intensity(scan, tmp_path):
    path = write_xyz(tmp_path / "hall.xyz", scan, intensity=False)

    with pytest.raises(InputError, match="export it with intensity, or set KIND to spheres"):
        find_targets(open_cloud([path]), TargetSettings(wanted=Wanted.CHECKERBOARDS))
