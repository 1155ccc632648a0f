"""A Dask cluster of processes on this computer: a scheduler, and workers that can be killed."""

import json
import os
import subprocess
import sys
import time
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from ichnograph.algorithms.clouds.cluster.connection import OLDEST
from ichnograph.algorithms.progress import Progress

START_S = 120
"""A busy computer imports Dask slowly."""

ENDING = ("--death-timeout", "60")
"""Workers whose scheduler is gone end by themselves."""


@dataclass
class Workers:
    """A scheduler at `address`, and the processes of its workers."""

    folder: Path
    address: str = ""
    processes: list = field(default_factory=list)

    def start(self, **environment):
        """Start one more worker of one thread, and wait until the scheduler knows it."""
        count = self.count()
        started = _start("worker", self.folder, "--nthreads", "1", "--no-nanny", *ENDING, **environment)
        self.processes.append(started)
        until(lambda: self.count() > count)
        return started

    def kill(self, worker):
        """End a worker at once, as a failing computer would."""
        worker.kill()
        worker.wait()
        self.processes.remove(worker)

    def count(self):
        """Return how many workers the scheduler knows."""
        return len(self.ask(lambda dask_scheduler: [*dask_scheduler.workers]))

    def tasks(self):
        """Return how many results and tasks the cluster holds."""
        return len(self.ask(lambda dask_scheduler: [*dask_scheduler.tasks]))

    def ask(self, question):
        """Return what the scheduler answers."""
        from distributed import Client

        with Client(self.address, set_as_default=False) as client:
            return client.run_on_scheduler(question)


@contextmanager
def workers(folder, count):
    """Start a scheduler and workers in processes of their own; they end with the block."""
    distributed = pytest.importorskip("distributed", reason="Dask is not installed (`make setup`)")
    if tuple(int(part) for part in distributed.__version__.split(".")[:2]) < OLDEST:
        pytest.skip(f"distributed {distributed.__version__} is too old (`make setup`)")
    cluster = Workers(folder)
    scheduler = _start("scheduler", folder, "--port", "0", "--host", "127.0.0.1", "--no-show")
    try:
        described = folder / "scheduler.json"
        until(lambda: described.exists() and described.read_text().strip().endswith("}"))
        cluster.address = json.loads(described.read_text())["address"]
        for _ in range(count):
            cluster.start()
        yield cluster
    finally:
        for process in (*cluster.processes, scheduler):
            process.kill()
            process.wait()


def _start(what, folder, *options, **environment):
    command = [sys.executable, "-m", f"distributed.cli.dask_{what}", "--scheduler-file"]
    command += [str(folder / "scheduler.json"), "--no-dashboard", *options]
    with (folder / f"{what}.log").open("a") as log:
        return subprocess.Popen(
            command, cwd=folder, env={**os.environ, **environment}, stdout=log, stderr=subprocess.STDOUT
        )


def until(happened):
    """Wait until something has happened."""
    end = time.monotonic() + START_S
    while not happened():
        assert time.monotonic() < end, "it does not happen"
        time.sleep(0.05)


def in_time(report):
    """Return a progress that cancels what takes too long, so that a test fails and does not hang."""
    end = time.monotonic() + START_S
    return Progress(report, lambda: time.monotonic() > end)
