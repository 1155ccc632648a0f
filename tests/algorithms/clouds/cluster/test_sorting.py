"""A cluster of worker processes gives the same bytes as one computer, even if it loses a worker."""

import subprocess
import sys
from functools import partial

import numpy as np
import pytest
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.clouds.cluster.sorting import sort_on_cluster, sorter_at
from ichnograph.algorithms.clouds.settings import ClusterSettings
from ichnograph.algorithms.clouds.thinning.thinning import thin_cloud
from ichnograph.algorithms.clouds.tiles.tile_store import sort_here
from ichnograph.algorithms.errors import CancelledError, InputError
from ichnograph.algorithms.progress import Progress
from ichnograph.tests.algorithms.clouds.cluster.workers import in_time, until
from ichnograph.tests.algorithms.clouds.sample_files import las_records, write_las

SMALL = ClusterSettings(run_points=3000, block_tiles=2)
"""So that a few thousand points make many tasks."""


@pytest.fixture(scope="module")
def cloud(tmp_path_factory):
    """Return a cloud of two files, one of them only readable from its beginning, with a stray point."""
    folder = tmp_path_factory.mktemp("clouds")
    header, points = las_records(8000)
    points["X"], points["Y"], points["Z"] = (
        np.random.default_rng(3).integers(0, (20_000, 20_000, 1000), (8000, 3)).T
    )
    write_las(folder / "a.laz", header, points)
    xyz = np.random.default_rng(4).uniform((5, 5, 0), (30, 12, 2), (4000, 3))
    xyz += [*header.offsets[:2], 0]
    xyz[17, 2] = 50_000.0
    np.savetxt(folder / "b.xyz", xyz, "%.3f")
    return open_cloud([folder / "a.laz", folder / "b.xyz"])


def test_without_an_address_the_work_is_done_here_and_nothing_of_dask_is_imported():
    assert sorter_at("") is sort_here
    code = (
        "import sys; from ichnograph.algorithms.clouds.cluster.sorting import sorter_at; sorter_at('');"
        "import ichnograph.algorithms.site_plan.site_plan;"
        "sys.exit(any(name.split('.')[0] in ('dask', 'distributed') for name in sys.modules))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_a_cloud_is_thinned_to_the_same_points(cluster, cloud):
    here = thin_cloud(cloud, 0.3)
    there = thin_cloud(cloud, 0.3, sort=partial(sort_on_cluster, cluster.address, settings=SMALL))
    np.testing.assert_array_equal(there.kept, here.kept)
    assert (there.points_in, there.warnings) == (here.points_in, here.warnings)
    assert cluster.tasks() == 0


@pytest.mark.parametrize("step", ["Reading", "Thinning"])
def test_a_worker_that_is_killed_costs_time_but_changes_nothing(cluster, cloud, step):
    killed = []

    def report(fraction, message):
        if message.startswith(step) and fraction > 0.05 and not killed:
            killed.append(cluster.processes[0])
            cluster.kill(killed[0])

    there = thin_cloud(
        cloud, 0.3, in_time(report), sort=partial(sort_on_cluster, cluster.address, settings=SMALL)
    )
    assert killed and cluster.count() == 1
    np.testing.assert_array_equal(there.kept, thin_cloud(cloud, 0.3).kept)
    cluster.start()


def test_progress_moves_and_a_cancel_releases_what_is_on_the_cluster(cluster, cloud):
    fractions = []

    def report(fraction, message):
        fractions.append(fraction)

    progress = Progress(report, lambda: len(fractions) > 8)
    with pytest.raises(CancelledError):
        thin_cloud(cloud, 0.3, progress, sort=partial(sort_on_cluster, cluster.address, settings=SMALL))
    assert fractions == sorted(fractions) and fractions[-1] > 0.1
    # What has begun on a worker is finished there.
    until(lambda: cluster.tasks() == 0)


def test_what_a_worker_refuses_is_the_sentence_of_one_computer(cluster, tmp_path):
    path = tmp_path / "a.las"
    header, points = las_records(100)
    cloud = open_cloud([write_las(path, header, points)])
    path.write_bytes(path.read_bytes()[:1000])
    with (
        pytest.raises(InputError, match=r"a\.las is truncated"),
        sort_on_cluster(cluster.address, cloud, 4.0, False, Progress()),
    ):
        pass


def test_points_that_are_no_site_are_refused_as_on_one_computer(cluster, tmp_path):
    np.savetxt(tmp_path / "a.xyz", np.random.default_rng(0).uniform(0, 9, (50, 3)) + [0, 0, 5e6], "%.3f")
    with (
        pytest.raises(InputError, match="geocentric"),
        sort_on_cluster(cluster.address, open_cloud([tmp_path / "a.xyz"]), 4.0, False, Progress()),
    ):
        pass
