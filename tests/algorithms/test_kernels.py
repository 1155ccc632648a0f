"""Compiled functions are kept on disk, and run where that is not possible."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from ichnograph.algorithms import kernels
from ichnograph.algorithms.kernels import ForgivingCache, kernel

PROGRAM = """
import sys
sys.path.insert(0, {folder!r})
import adding
print(adding.add(2, 3), adding.add._cache_hits)
"""
MODULE = "from ichnograph.algorithms.kernels import kernel\n\n\n@kernel\ndef add(a, b):\n    return a + b\n"


@pytest.fixture
def run(tmp_path):
    """Return a function that calls a kernel in a new process, with a cache of its own."""
    (tmp_path / "adding.py").write_text(MODULE)

    def run():
        return subprocess.run(
            [sys.executable, "-c", PROGRAM.format(folder=str(tmp_path))],
            env={**os.environ, "NUMBA_CACHE_DIR": str(tmp_path / "cache")},
            capture_output=True, text=True, check=True,
        ).stdout  # fmt: skip

    return run


def test_a_damaged_cache_is_compiled_and_written_again(run, tmp_path):
    assert run().startswith("5 Counter()")
    kept = [path for path in (tmp_path / "cache").rglob("*") if path.suffix in (".nbi", ".nbc")]
    assert kept
    for path in kept:
        path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
    assert run().startswith("5 Counter()")
    assert run().startswith("5 Counter({")


def test_without_a_folder_for_the_cache_functions_are_compiled_in_every_run(monkeypatch):
    def refusing(**options):
        if options.get("cache"):
            raise RuntimeError("cannot cache function: no locator available")
        return lambda function: function

    monkeypatch.setattr(kernels, "njit", refusing)
    assert kernel(max)(2, 3) == 3


class FullDisk:
    cache_path = Path("cache")

    def save_overload(self, *arguments):
        raise OSError(28, "No space left on device")


def test_a_full_disk_does_not_stop_the_run():
    cache = ForgivingCache(FullDisk())
    cache.save_overload("signature", "compiled")
    assert cache.cache_path == Path("cache")
