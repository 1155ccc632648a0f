"""Damage of every kind: bits, numbers, pieces and ends of files, fields of texts; checksums are repaired."""

import struct

import numpy as np

EXTREMES = (
    *(
        b"\0" * 4,
        b"\xff" * 4,
        b"\xff\xff\xff\x7f",
        b"\0\0\0\x80",
        b"\0" * 8,
        b"\xff" * 8,
        b"\1\0\0\0",
        b"\xff\xff",
    ),
    *(struct.pack("<d", value) for value in (float("nan"), float("inf"), 1e300, -1e300, 1e-300, 0.0)),
    *(struct.pack("<f", value) for value in (float("nan"), float("inf"), 1e38)),
)
WORDS = (
    *(
        b"nan",
        b"inf",
        b"-1",
        b"0",
        b"1e999",
        b"1e308",
        b"999999999999",
        b"9" * 400,
        b"",
        b" ",
        b",",
        b";",
        b"\t",
    ),
    *(
        b"\n",
        b"\r",
        b"\0",
        b'"',
        b"[",
        b"{",
        b"-",
        b"1,5",
        b"1.234,5",
        b"\xff",
        b"\xc3",
        b"#",
        b"x",
        b"[mm]",
        b"[ft]",
    ),
)
PAGE, CHECKSUM = 1024, 4


def mutate(data: bytes, rng: np.random.Generator, is_text: bool) -> bytes:
    """Return data with one to four damages."""
    damages = (word, piece_gone, piece_twice, end_gone, byte) if is_text else (
        byte, word, extreme, extreme, piece_gone, piece_twice, end_gone
    )  # fmt: skip
    for _ in range(rng.integers(1, 5)):
        if data:
            data = damages[rng.integers(len(damages))](data, rng)
    return data


def position_in(data: bytes, rng: np.random.Generator) -> int:
    """Return a position; every other one is in the beginning, where headers are."""
    return int(rng.integers(min(len(data), 600) if rng.random() < 0.5 else len(data)))


def byte(data: bytes, rng: np.random.Generator) -> bytes:
    """Change a byte."""
    position = position_in(data, rng)
    return data[:position] + bytes([rng.integers(256)]) + data[position + 1 :]


def extreme(data: bytes, rng: np.random.Generator) -> bytes:
    """Overwrite some bytes by an extreme number."""
    position, value = position_in(data, rng), EXTREMES[rng.integers(len(EXTREMES))]
    return data[:position] + value + data[position + len(value) :]


def word(data: bytes, rng: np.random.Generator) -> bytes:
    """Replace or insert a field of a text."""
    start, value = position_in(data, rng), WORDS[rng.integers(len(WORDS))]
    return data[:start] + value + data[start + int(rng.integers(8)) :]


def piece_gone(data: bytes, rng: np.random.Generator) -> bytes:
    """Leave out a piece."""
    start = position_in(data, rng)
    return data[:start] + data[start + int(rng.integers(1, 200)) :]


def piece_twice(data: bytes, rng: np.random.Generator) -> bytes:
    """Write a piece twice."""
    start = position_in(data, rng)
    stop = start + int(rng.integers(1, 200))
    return data[:stop] + data[start:]


def end_gone(data: bytes, rng: np.random.Generator) -> bytes:
    """Cut the end off."""
    return data[: int(rng.integers(len(data)))]


def with_checksums(data: bytes) -> bytes:
    """Return an E57 whose pages have the checksums of what they hold now."""
    pages = [data[start : start + PAGE] for start in range(0, len(data), PAGE)]
    return b"".join(
        page[:-CHECKSUM] + struct.pack(">I", crc32c(page[:-CHECKSUM])) if len(page) == PAGE else page
        for page in pages
    )


def crc32c(data: bytes) -> int:
    """Return the Castagnoli checksum that E57 uses."""
    value = 0xFFFFFFFF
    for item in data:
        value = TABLE[(value ^ item) & 0xFF] ^ (value >> 8)
    return value ^ 0xFFFFFFFF


def _row(value: int) -> int:
    for _ in range(8):
        value = (value >> 1) ^ (0x82F63B78 if value & 1 else 0)
    return value


TABLE = tuple(_row(value) for value in range(256))
