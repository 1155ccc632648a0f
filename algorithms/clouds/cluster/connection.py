"""The connection to a Dask cluster: checked at the beginning, watched while waiting, released at the end."""

import asyncio
import concurrent.futures
import socket
import time
import warnings
from collections import deque
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from importlib.util import find_spec
from typing import Any, Callable

from ...errors import InputError, MissingPackageError
from ...progress import Progress
from ..settings import ClusterSettings
from .tasks import plugin_version

PACKAGES = ("numpy", "numba", "laspy", "lazrs")
"""Packages besides those of Dask on whose versions results, or the sending of them, depend."""

SCHEMES = ("tcp", "tls", "ws", "wss")
"""Protocols of Dask by which a scheduler is reached."""

OLDEST = (2024, 8)
"""Version of Dask; older ones may never get what a lost worker was sending."""

Task = tuple[float, Callable[..., Any], tuple[Any, ...]]
"""What part of the progress a task is, its function, and the arguments."""


class Cluster:
    """An open connection to a cluster.

    Parameters
    ----------
    client : distributed.Client
    address : str
        Of the scheduler.
    settings : ClusterSettings
    """

    def __init__(self, client: Any, address: str, settings: ClusterSettings) -> None:
        self._client, self._address, self.settings = client, address, settings
        self._seen = time.monotonic()

    def submit(self, function: Callable[..., Any], *arguments: Any) -> Any:
        """Return the future of a result, which remains on its worker; it is dropped with the future."""
        # A key of its own, because hashing points costs as much as sending them.
        return self._client.submit(function, *arguments, pure=False)

    def result(self, future: Any, progress: Progress) -> Any:
        """Fetch a result; see `results` for what it raises."""
        return self._waited(self._fetched(future), progress)

    def results(self, tasks: Iterable[Task], total: float, progress: Progress, message: str) -> Iterator[Any]:
        """Yield the results of tasks in order; only some are begun before they are asked for.

        Raises
        ------
        CancelledError
            If the caller asked to stop.
        InputError
            If the cluster is lost, or loses its workers one by one.
        IchnographError
            What a task raised.
        """
        waiting: deque[tuple[float, Any, concurrent.futures.Future[Any]]] = deque()
        done = 0.0
        progress.update(0.0, message)
        try:
            for weight, function, arguments in tasks:
                future = self.submit(function, *arguments)
                waiting.append((weight, future, self._fetched(future)))
                if len(waiting) > self.settings.waiting_tasks * self._threads():
                    done += waiting[0][0]
                    yield self._waited(waiting.popleft()[2], progress)
                    progress.update(done / max(total, 1), message)
            while waiting:
                done += waiting[0][0]
                yield self._waited(waiting.popleft()[2], progress)
                progress.update(done / max(total, 1), message)
        finally:
            for _, _, running in waiting:
                running.cancel()

    def _fetched(self, future: Any) -> "concurrent.futures.Future[Any]":
        """Begin to wait for a result and to fetch it, in the thread of the connection."""

        async def fetched() -> Any:
            return await future

        return asyncio.run_coroutine_threadsafe(fetched(), self._client.loop.asyncio_loop)

    def _waited(self, running: "concurrent.futures.Future[Any]", progress: Progress) -> Any:
        from distributed import KilledWorker

        try:
            while not running.done():
                progress.check()
                self._check_workers()
                concurrent.futures.wait([running], self.settings.poll_s)
            return running.result()
        except KilledWorker as error:
            raise InputError(
                f"SCHEDULER {self._address}: workers were lost one after another at the same work; give them "
                "more memory, and see their logs for the reason."
            ) from error
        except concurrent.futures.CancelledError as error:
            raise InputError(
                f"SCHEDULER {self._address}: the connection was lost; check that the scheduler runs, and "
                "start again."
            ) from error
        finally:
            running.cancel()

    def _workers(self) -> dict[str, Any]:
        return dict(self._client.scheduler_info().get("workers", {}))

    def _threads(self) -> int:
        return max(sum(worker.get("nthreads", 1) for worker in self._workers().values()), 1)

    def _check_workers(self) -> None:
        """Refuse to wait for a cluster that has no worker any more."""
        if self._workers():
            self._seen = time.monotonic()
        elif time.monotonic() - self._seen > self.settings.patience_s:
            raise InputError(
                f"SCHEDULER {self._address}: the cluster has no worker any more; start some, and start again."
            )


@contextmanager
def connected(address: str, settings: ClusterSettings = ClusterSettings()) -> Iterator[Cluster]:
    """Connect to the scheduler at an address; what was sent to the cluster is released at the end.

    Raises
    ------
    MissingPackageError
        If Dask is not installed.
    InputError
        If the address is not valid, nothing answers there, or workers lack what they need.
    """
    if find_spec("distributed") is None:
        raise MissingPackageError("SCHEDULER", ("distributed",), "used")
    _check_age()
    with warnings.catch_warnings():
        # Dask warns of what its own checks find, and of arguments of a megabyte.
        warnings.simplefilter("ignore")
        client = _client(address, settings)
        try:
            _check(client, address)
            yield Cluster(client, address, settings)
        finally:
            with suppress(OSError, TimeoutError):
                client.close()


def _check_age() -> None:
    """Refuse a version of Dask that does not bear the loss of a worker."""
    from distributed import __version__

    if tuple(int(part) for part in __version__.split(".")[:2]) < OLDEST:
        raise InputError(
            f"SCHEDULER needs distributed {'.'.join(map(str, OLDEST))} or newer on all computers, because "
            f"older ones do not bear the loss of a worker; this computer has {__version__}."
        )


def _client(address: str, settings: ClusterSettings) -> Any:
    from distributed import Client
    from distributed.comm.addressing import parse_address, parse_host_port

    try:
        scheme, location = parse_address(address)
        place = parse_host_port(location)
    except ValueError as error:
        raise _no_address(address) from error
    if scheme not in SCHEMES:
        raise _no_address(address)
    try:
        # A client that does not reach its scheduler may hang when it is disposed of.
        socket.create_connection(place, settings.connect_s).close()
        return Client(address, timeout=settings.connect_s, set_as_default=False, name="ichnograph")
    except UnicodeError as error:
        raise _no_address(address) from error
    except TypeError as error:
        raise InputError(
            f"SCHEDULER {address}: Dask has no certificates; state them in its configuration "
            "(distributed.comm.tls)."
        ) from error
    except (OSError, TimeoutError, asyncio.TimeoutError) as error:
        raise InputError(
            f"SCHEDULER {address}: no scheduler answers there within {settings.connect_s:g} s; check the "
            "address, the network, and that it runs (`dask scheduler`)."
        ) from error


def _no_address(address: str) -> InputError:
    return InputError(f"SCHEDULER {address} is not an address; write it like tcp://192.168.0.10:8786.")


def _check(client: Any, address: str) -> None:
    """Refuse a cluster without workers, or whose versions differ from those of this computer."""
    versions = client.get_versions(packages=list(PACKAGES))
    own = _compared(versions["client"])
    _compare(address, "the scheduler", versions["scheduler"], own, ("distributed",))
    if not versions["workers"]:
        raise InputError(f"SCHEDULER {address}: the cluster has no workers; start some (`dask worker`).")
    for worker, found in versions["workers"].items():
        _compare(address, f"the worker {worker}", found, own, tuple(own))
    package = __name__.split(".")[0]
    try:
        plugins = client.run(plugin_version)
    except Exception as error:
        # Of what fails outside of a task, Dask passes on no more than the text.
        if not isinstance(error, ImportError) and "ModuleNotFoundError" not in str(error):
            raise
        raise InputError(
            f"SCHEDULER {address}: workers cannot import {package} ({error}); put the folder that holds the "
            "plugin's folder on their PYTHONPATH."
        ) from error
    for worker, version in plugins.items():
        if version != plugin_version():
            raise InputError(_unlike(address, f"the worker {worker}", package, version, plugin_version()))


def _compared(found: dict[str, Any]) -> dict[str, str]:
    packages = found["packages"]
    python = ".".join(str(found["host"]["python"]).split(".")[:2])
    return {"Python": python, **{name: str(packages[name]) for name in ("distributed", *PACKAGES)}}


def _compare(
    address: str, where: str, found: dict[str, Any], own: dict[str, str], names: tuple[str, ...]
) -> None:
    versions = _compared(found)
    for name in names:
        if versions[name] != own[name]:
            raise InputError(_unlike(address, where, name, versions[name], own[name]))


def _unlike(address: str, where: str, name: str, found: str, own: str) -> str:
    return (
        f"SCHEDULER {address}: {where} has {name} {found}, this computer {own}; install the same version "
        "on all."
    )
