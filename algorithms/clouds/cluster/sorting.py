"""Sorting a cloud on a cluster: workers read the files, and each keeps some blocks of tiles."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from ...progress import Progress
from ..cloud import Cloud, names_of
from ..settings import ClusterSettings
from ..tiles.lattice import to_lattice
from ..tiles.tile_store import refuse_strays, sort_here
from ..tiles.tiles import Key, SortedTiles, Sorter, by_block
from .connection import Cluster, connected
from .remote_tiles import RemoteTiles
from .tasks import Run, Summary, block_of, part_of, sort_run, summary_of


def sorter_at(address: str) -> Sorter:
    """Return what sorts clouds on the cluster with this scheduler; without an address, on this computer."""
    return partial(sort_on_cluster, address) if address else sort_here


@contextmanager
def sort_on_cluster(
    address: str,
    cloud: Cloud,
    edge: float,
    is_numbered: bool,
    progress: Progress,
    settings: ClusterSettings = ClusterSettings(),
) -> Iterator[SortedTiles]:
    """Sort a cloud into tiles on a cluster; see `tiles.Sorter`.

    Parameters
    ----------
    address : str
        Of the scheduler.
    cloud : Cloud
        Of files that all workers find by the same path.
    edge : float
        Of a tile, in metres.
    is_numbered : bool
        Whether tiles know the numbers of their points.
    progress : Progress
    settings : ClusterSettings

    Raises
    ------
    MissingPackageError, InputError
        As `connected`, or if a worker cannot read a file, or too many points are stray.
    """
    progress.update(0.0, f"Connecting to {address}")
    with connected(address, settings) as cluster:
        yield _sorted(cluster, cloud, to_lattice(edge), is_numbered, progress)


def _sorted(cluster: Cluster, cloud: Cloud, edge: int, is_numbered: bool, progress: Progress) -> RemoteTiles:
    runs = [
        Run(replace(run, path=run.path.absolute()), run.path.stat().st_size, cloud.origin, edge, is_numbered)
        for source in cloud.sources
        for run in source.runs(cluster.settings.run_points)
    ]
    futures = [cluster.submit(sort_run, run) for run in runs]
    summaries = _summaries(cluster, names_of(cloud.sources), runs, futures, progress)
    points = [summary.point_count for summary in summaries]
    stray = sum(summary.stray_count for summary in summaries)
    refuse_strays(cloud, stray, sum(points))
    counts: dict[Key, int] = {}
    for summary in summaries:
        for key, count in summary.counts.items():
            counts[key] = counts.get(key, 0) + count
    blocks = _blocks(cluster, futures, summaries, edge)
    return RemoteTiles(cluster, edge, blocks, counts, sum(points), stray)


def _summaries(
    cluster: Cluster, names: str, runs: list[Run], futures: list[Any], progress: Progress
) -> list[Summary]:
    """Wait until all runs are sorted."""
    weights = [run.source.expected_points or run.size for run in runs]
    tasks = [(weight, summary_of, (future,)) for weight, future in zip(weights, futures)]
    summaries: list[Summary] = list(cluster.results(tasks, sum(weights), progress, f"Reading {names}"))
    for message in dict.fromkeys(message for summary in summaries for message in summary.messages):
        progress.update(1.0, message)
    return summaries


def _blocks(cluster: Cluster, futures: list[Any], summaries: list[Summary], edge: int) -> dict[Key, Any]:
    """Return the futures of the blocks of tiles."""
    parts: dict[Key, tuple[list[Any], list[int]]] = {}
    firsts = np.cumsum([0, *(summary.point_count for summary in summaries)])
    for future, summary, first in zip(futures, summaries, firsts.tolist()):
        for block, keys in by_block(summary.counts, cluster.settings.block_tiles).items():
            own, numbers = parts.setdefault(block, ([], []))
            own.append(cluster.submit(part_of, future, keys))
            numbers.append(first)
    return {block: cluster.submit(block_of, own, numbers, edge) for block, (own, numbers) in parts.items()}
