"""What the reader of every format offers, and the sentences that all of them refuse a file with."""

import errno
import os
import pickle
from dataclasses import FrozenInstanceError, dataclass
from pathlib import Path

import numpy as np
import pytest
from ichnograph.algorithms.clouds.cloud import open_cloud
from ichnograph.algorithms.clouds.source import Chunk, Source, no_points, truncated, unreadable
from ichnograph.algorithms.errors import CancelledError, InputError
from ichnograph.algorithms.progress import Progress
from ichnograph.tests.algorithms.clouds.sample_files import write_e57, write_ply, write_ptx

SCAN = Path("west.laz")
POINTS = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]]
WRITERS = {
    "e57": write_e57,
    "ply": write_ply,
    "ptx": lambda path, points: write_ptx(path, [[*point, 0.5] for point in points]),
    "xyz": np.savetxt,
}


@dataclass(frozen=True)
class Column(Source):
    """Points above each other."""

    def chunks(self, origin, progress, size):
        yield Chunk(self.middle - origin, None, None)


def test_a_reader_must_stream_its_points():
    with pytest.raises(TypeError, match="chunks"):
        Source(SCAN, None, (), np.zeros(3), False, False)


def test_a_reader_without_further_attributes_need_not_name_them():
    column = Column(SCAN, None, (), np.zeros(3), False, False)
    (chunk,) = column.chunks(np.ones(3), Progress(), 10)

    assert column.attributes == ()
    assert (chunk.attributes, chunk.scan) == ({}, None)
    np.testing.assert_array_equal(chunk.xyz, [-1, -1, -1])
    with pytest.raises(FrozenInstanceError):
        column.path = Path("east.laz")


@pytest.fixture(params=WRITERS)
def source(request, tmp_path):
    path = tmp_path / f"scan.{request.param}"
    WRITERS[request.param](path, np.array(POINTS))
    (source,) = open_cloud([path]).sources
    return source


@pytest.mark.parametrize("size", [1, 2, 100])
def test_positions_alone_are_those_of_the_chunks(source, size):
    positions = np.concatenate(list(source.positions(np.ones(3), Progress(), size)))
    np.testing.assert_array_equal(positions, np.array(POINTS) - 1)
    assert source.expected_points in (0, len(POINTS))


def test_an_open_file_can_be_sent_to_another_process_and_read_there_twice(source):
    sent = pickle.loads(pickle.dumps(source))

    for _ in range(2):
        chunks = list(sent.chunks(np.zeros(3), Progress(), 2))
        assert [len(chunk.xyz) for chunk in chunks] == [2, 1]
        np.testing.assert_allclose(np.concatenate([chunk.xyz for chunk in chunks]), POINTS)


def test_cancelling_stops_between_chunks(source):
    seen = []
    progress = Progress(is_cancelled=lambda: len(seen) >= 2)
    with pytest.raises(CancelledError):
        seen.extend(source.chunks(np.zeros(3), progress, 1))
    assert len(seen) == 2


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (truncated(SCAN, "3 of 5 points"), ("west.laz is truncated", "3 of 5 points", "export it again")),
        (no_points(SCAN), ("west.laz holds no points", "leave it out")),
        (unreadable(SCAN, OSError("the disk is gone")), ("west.laz cannot be read", "the disk is gone")),
        (
            unreadable(SCAN, PermissionError(errno.EACCES, os.strerror(errno.EACCES), "west.laz")),
            ("west.laz cannot be read (Permission denied)", "check that it exists"),
        ),
    ],
)
def test_a_file_is_refused_in_one_sentence_with_a_remedy(error, words):
    assert isinstance(error, InputError)
    for part in words:
        assert part in str(error)
    assert str(error).count("west.laz") == 1
    assert str(error).endswith(".")
