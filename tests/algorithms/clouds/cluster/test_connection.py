"""A cluster that cannot be used is refused in a sentence that names SCHEDULER and what to do."""

import os
import socket
import threading
import time
from pathlib import Path

import numpy as np
import pytest
from ichnograph.algorithms.clouds.cluster import connection
from ichnograph.algorithms.clouds.cluster.connection import connected
from ichnograph.algorithms.clouds.settings import ClusterSettings
from ichnograph.algorithms.errors import CancelledError, InputError, MissingPackageError
from ichnograph.algorithms.progress import Progress
from ichnograph.tests.algorithms.clouds.cluster.jobs import fail, slow


def refused(address, settings=ClusterSettings()):
    """Return why an address is refused."""
    with pytest.raises(InputError) as error, connected(address, settings):
        pass
    return str(error.value)


def test_without_dask_the_missing_package_is_named(monkeypatch):
    monkeypatch.setattr(connection, "find_spec", lambda name: None)
    with (
        pytest.raises(MissingPackageError, match="SCHEDULER cannot be used without distributed"),
        connected("x"),
    ):
        pass


@pytest.mark.parametrize(
    "address", ["nonsense://1", "tcp://", "127.0.0.1", "tcp://127.0.0.1:port", "tcp://127..0.1:8786"]
)
def test_what_is_no_address_is_refused_with_an_example(cluster, address):
    assert f"SCHEDULER {address} is not an address; write it like tcp://192" in refused(address)


def test_without_certificates_an_address_of_tls_is_refused(cluster):
    address = cluster.address.replace("tcp", "tls")
    assert f"SCHEDULER {address}: Dask has no certificates" in refused(address)


def test_an_address_at_which_nothing_answers_is_refused_soon(cluster):
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        address = f"tcp://127.0.0.1:{free.getsockname()[1]}"
    begin = time.monotonic()
    assert f"SCHEDULER {address}: no scheduler answers there" in refused(
        address, ClusterSettings(connect_s=0.5)
    )
    assert time.monotonic() - begin < 5


@pytest.mark.parametrize(("where", "found"), [("scheduler", "1.0"), ("worker", "None")])
def test_other_versions_are_refused_by_name(cluster, monkeypatch, where, found):
    from distributed import Client

    real = Client.get_versions

    def versions(self, **options):
        every = real(self, **options)
        if where == "scheduler":
            every["scheduler"]["packages"]["distributed"] = found
        else:
            every["workers"][min(every["workers"])]["packages"]["numba"] = None
        return every

    monkeypatch.setattr(Client, "get_versions", versions)
    name = "distributed" if where == "scheduler" else "numba"
    sentence = refused(cluster.address)
    assert f"the {where} " in sentence and f" has {name} {found}, this computer " in sentence
    assert sentence.endswith("install the same version on all.")


def test_another_version_of_the_toolbox_is_refused(cluster, monkeypatch):
    from distributed import Client

    monkeypatch.setattr(Client, "run", lambda self, function: {"tcp://a": function(), "tcp://b": "0.0.1"})
    assert "the worker tcp://b has ichnograph 0.0.1, this computer " in refused(cluster.address)


def test_workers_that_cannot_import_the_toolbox_are_refused_with_the_remedy(cluster):
    folders = os.environ.get("PYTHONPATH", "").split(os.pathsep)
    others = [folder for folder in folders if not Path(folder, "ichnograph").exists()]
    worker = cluster.start(PYTHONPATH=os.pathsep.join(others))
    try:
        sentence = refused(cluster.address)
    finally:
        cluster.kill(worker)
    assert "workers cannot import ichnograph (" in sentence
    assert sentence.endswith("put the folder that holds the plugin's folder on their PYTHONPATH.")


def test_a_cluster_without_workers_is_refused(cluster, monkeypatch):
    from distributed import Client

    real = Client.get_versions
    monkeypatch.setattr(Client, "get_versions", lambda self, **names: {**real(self, **names), "workers": {}})
    assert refused(cluster.address).endswith("the cluster has no workers; start some (`dask worker`).")


def test_results_come_in_order_and_progress_with_them(cluster):
    fractions = []
    tasks = [(1.0, slow, (0.2 if number == 0 else 0.0,)) for number in range(6)]
    with connected(cluster.address) as open_cluster:
        progress = Progress(lambda fraction, _: fractions.append(fraction))
        assert list(open_cluster.results(tasks, 6, progress, "Working")) == [0.2, 0, 0, 0, 0, 0]
    np.testing.assert_allclose(fractions, np.arange(7) / 6)


def test_a_cancel_is_noticed_within_a_second(cluster):
    cancelled = threading.Event()
    with connected(cluster.address) as open_cluster:
        threading.Timer(0.3, cancelled.set).start()
        begin = time.monotonic()
        with pytest.raises(CancelledError):
            open_cluster.result(open_cluster.submit(slow, 20), Progress(is_cancelled=cancelled.is_set))
        assert time.monotonic() - begin < 1.3
        begin = time.monotonic()
    assert time.monotonic() - begin < 1.0


@pytest.mark.parametrize(
    "error", [InputError("Too bad."), MissingPackageError("a.e57", ("pye57",)), MemoryError()]
)
def test_what_a_task_raises_is_raised_here(cluster, error):
    with connected(cluster.address) as open_cluster, pytest.raises(type(error)) as raised:
        open_cluster.result(open_cluster.submit(fail, error), Progress())
    assert str(raised.value) == str(error)


def test_a_cluster_that_has_lost_all_workers_is_not_waited_for_for_ever(cluster, monkeypatch):
    with connected(cluster.address, ClusterSettings(patience_s=0.3)) as open_cluster:
        monkeypatch.setattr(open_cluster, "_workers", dict)
        with pytest.raises(InputError, match="the cluster has no worker any more; start some"):
            open_cluster.result(open_cluster.submit(slow, 5), Progress())
