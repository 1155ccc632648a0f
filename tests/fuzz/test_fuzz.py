"""The fuzzer damages files of every reader, and notices what is wrong with an answer."""

import signal
from itertools import count

import numpy as np
import pytest
from ichnograph.algorithms.errors import InputError
from ichnograph.tests.fuzz import child
from ichnograph.tests.fuzz.mutations import crc32c, mutate, with_checksums
from ichnograph.tests.fuzz.readers import READERS


@pytest.mark.parametrize("name", READERS)
def test_the_files_that_are_damaged_are_sound(tmp_path, name):
    if name == "e57":
        pytest.importorskip("pye57", reason="pye57 is not installed")
    reader = READERS[name]
    (tmp_path / "sound").mkdir()
    for path in reader.write(tmp_path / "sound"):
        reader.read(path)


@pytest.mark.parametrize("is_text", [True, False])
def test_the_same_number_gives_the_same_damage(is_text):
    data = bytes(range(256)) * 4
    damaged = [mutate(data, np.random.default_rng(number), is_text) for number in (1, 1, 2)]
    assert damaged[0] == damaged[1] != damaged[2]
    assert data not in damaged


def test_checksums_of_an_e57_fit_its_pages_again():
    assert crc32c(b"123456789") == 0xE3069283
    damaged = with_checksums(bytes(1024) + b"end")
    assert damaged[:1020] == bytes(1020)
    assert int.from_bytes(damaged[1020:1024], "big") == crc32c(bytes(1020))
    assert damaged[1024:] == b"end"


def raising(error):
    def read(path):
        raise error

    return read


@pytest.mark.parametrize(
    ("read", "word"),
    [
        (lambda path: None, ""),
        (raising(InputError("This file is damaged.")), ""),
        (raising(InputError("This\nfile.")), "not one sentence"),
        (raising(InputError("no sentence")), "not one sentence"),
        (raising(ValueError("odd")), "ValueError: odd"),
        (raising(MemoryError()), "MemoryError"),
    ],
)
def test_any_answer_but_one_sentence_is_a_finding(tmp_path, read, word):
    found = child._read(read, tmp_path / "a")
    assert bool(found) == bool(word)
    assert word in found


def test_too_much_memory_is_a_finding_behind_a_sentence_too(tmp_path):
    def read(path):
        try:
            raise MemoryError
        except MemoryError as error:
            raise InputError("This file is damaged.") from error

    assert "MemoryError" in child._read(read, tmp_path / "a")


def test_a_reader_that_does_not_end_is_a_finding(tmp_path, monkeypatch):
    monkeypatch.setattr(child, "SECONDS", 1)
    previous = signal.signal(signal.SIGPROF, child._too_long)
    try:
        assert "TimeoutError" in child._read(lambda path: all(True for _ in count()), tmp_path / "a")
    finally:
        signal.signal(signal.SIGPROF, previous)
