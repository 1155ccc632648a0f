"""What tests of several chapters share."""

import pytest
from ichnograph.tests.algorithms.clouds.cluster.workers import workers


@pytest.fixture(scope="session")
def cluster(tmp_path_factory):
    """Start a Dask cluster of two worker processes, which tests may kill and start again."""
    with workers(tmp_path_factory.mktemp("cluster"), 2) as cluster:
        yield cluster
