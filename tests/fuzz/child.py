"""Run one reader on a number of damaged files; the parent learns of each case before it is run."""

import argparse
import json
import resource
import shutil
import signal
import sys
import tempfile
import time
import traceback
from pathlib import Path

import numpy as np

from ...algorithms.errors import IchnographError
from .mutations import mutate, with_checksums
from .readers import READERS

MEMORY = 2**30
"""Bytes that a damaged file of some kilobytes may claim beyond those of the program."""

SECONDS = 20
"""Of the processor that a damaged file of some kilobytes may take."""


def main() -> None:
    """Write a line of JSON for each case: what is run, and what was found."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("reader", choices=READERS)
    parser.add_argument("first", type=int)
    parser.add_argument("seconds", type=float)
    parser.add_argument("findings", type=Path)
    chosen = parser.parse_args()
    signal.signal(signal.SIGPROF, _too_long)
    with tempfile.TemporaryDirectory(prefix="ichnograph-fuzz-") as folder:
        _run(chosen.reader, chosen.first, chosen.seconds, Path(folder), chosen.findings)


def _run(name: str, first: int, seconds: float, folder: Path, findings: Path) -> None:
    reader = READERS[name]
    sound = folder / "sound"
    sound.mkdir()
    seeds = reader.write(sound)
    for seed in seeds:
        # A sound file must be read; this also loads what counts as memory of the program.
        reader.read(_copied(seed, folder / "warm"))
    claimed = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (claimed + MEMORY, claimed + MEMORY))
    end, number = time.monotonic() + seconds, first
    while time.monotonic() < end:
        rng = np.random.default_rng([number, len(name), ord(name[0]), ord(name[-1])])
        seed = seeds[rng.integers(len(seeds))]
        path = _copied(seed, folder / "case")
        data = mutate(seed.read_bytes(), rng, reader.is_text)
        path.write_bytes(with_checksums(data) if name == "e57" else data)
        _say(case=number)
        _keep(path, findings / f"{name}_running{path.suffix}")
        found = _read(reader.read, path)
        if found:
            _keep(path, findings / f"{name}_{number}{path.suffix}")
            _say(case=number, found=found)
        number += 1


def _copied(seed: Path, folder: Path) -> Path:
    """Return a copy of a sound file, with the files that belong to it, in an empty folder."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    for file in seed.parent.glob(f"{seed.stem}.*"):
        shutil.copy(file, folder)
    return folder / seed.name


def _read(read: object, path: Path) -> str:
    """Return what is wrong with how a file is answered; nothing if it is read, or refused in one sentence."""
    signal.setitimer(signal.ITIMER_PROF, SECONDS)
    try:
        read(path)  # type: ignore[operator]
    except IchnographError as error:
        if isinstance(error.__cause__, MemoryError):
            return traceback.format_exc()
        is_sentence = "\n" not in str(error) and str(error).endswith((".", "?"))
        return "" if is_sentence else f"not one sentence: {error}"
    except BaseException:
        return traceback.format_exc()
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
    return ""


def _keep(path: Path, target: Path) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(path, target)


def _too_long(*_: object) -> None:
    raise TimeoutError(f"it takes more than {SECONDS} s")


def _say(**line: object) -> None:
    sys.stdout.write(json.dumps(line) + "\n")
    sys.stdout.flush()


if __name__ == "__main__":
    main()
