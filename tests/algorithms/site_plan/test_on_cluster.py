"""A plan made on a cluster is the same bytes as on one computer."""

from functools import partial

import numpy as np
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.clouds.cluster.sorting import sort_on_cluster
from ichnograph.algorithms.clouds.settings import ClusterSettings
from ichnograph.algorithms.site_plan.density.density_image import density_image
from ichnograph.algorithms.site_plan.density.height_range import HeightRange
from ichnograph.algorithms.site_plan.settings import SitePlanSettings
from ichnograph.algorithms.site_plan.site_plan import make_site_plan
from ichnograph.tests.algorithms.clouds.cluster.workers import in_time
from ichnograph.tests.algorithms.site_plan.house import points_under_ceiling
from ichnograph.tests.algorithms.site_plan.surfaces import ORIGIN, SHIFT, box
from ichnograph.tests.algorithms.site_plan.test_site_plan import bytes_of

SMALL = ClusterSettings(run_points=20_000, block_tiles=2)


def opened(folder):
    """Return a storey with a piece of furniture, in two files."""
    points = points_under_ceiling(box((1.0, 1.6), (2.0, 2.6), 0.0, 0.8)) + ORIGIN + SHIFT
    points += np.random.default_rng(0).normal(0, 0.002, points.shape)
    paths = [folder / "a.xyz", folder / "b.xyz"]
    for path, part in zip(paths, np.array_split(points, 2)):
        np.savetxt(path, part, "%.4f")
    return open_cloud(paths)


def test_a_plan_with_its_storey_is_the_same_bytes(cluster, tmp_path):
    cloud = opened(tmp_path)
    settings = SitePlanSettings(with_axes=True, with_rooms=True)
    there = make_site_plan(cloud, settings, sort=partial(sort_on_cluster, cluster.address, settings=SMALL))
    assert there.storey is not None
    assert bytes_of(there) == bytes_of(make_site_plan(cloud, settings))


def test_an_image_of_a_range_of_heights_is_the_same_bytes_though_a_worker_is_killed(cluster, tmp_path):
    cloud = opened(tmp_path)
    heights = HeightRange(0.2, 1.5, above_ground=True)
    killed = []

    def report(fraction, message):
        if message == "Cutting by height" and not killed:
            killed.append(cluster.processes[0])
            cluster.kill(killed[0])

    sort = partial(sort_on_cluster, cluster.address, settings=SMALL)
    there = density_image(cloud, heights=heights, progress=in_time(report), sort=sort)
    assert killed and cluster.count() == 1
    assert bytes_of(there) == bytes_of(density_image(cloud, heights=heights))
    cluster.start()
