"""Reading the lines of a PDF that Qt has written, where they are on paper."""

import re
import zlib

import numpy as np

MM = 25.4 / 72
TOKEN = re.compile(rb"[^\s]+")


def paths_of(path):
    """Yield the corners of every path of the only page, shape (n, 2), in mm from the lower left corner."""
    for stream in re.findall(rb"stream\r?\n(.*?)endstream", path.read_bytes(), re.S):
        try:
            content = zlib.decompress(stream)
        except zlib.error:
            continue
        if re.search(rb"\bcm\b", content) and re.search(rb"\b(m|re)\b", content):
            yield from _paths(content)


def size_of(path):
    """Return the width and the height of the page in mm."""
    boxes = re.findall(rb"/MediaBox \[([^\]]*)\]", path.read_bytes())
    ((left, bottom, right, top),) = {tuple(map(float, box.split())) for box in boxes}
    return (right - left) * MM, (top - bottom) * MM


def _paths(content):
    matrix, saved, numbers, corners = np.eye(3), [], [], []

    def on_paper(x, y):
        return (np.array([x, y, 1.0]) @ matrix)[:2] * MM

    for token in TOKEN.findall(content):
        try:
            numbers.append(float(token))
            continue
        except ValueError:
            pass
        if token == b"q":
            saved.append(matrix)
        elif token == b"Q":
            matrix = saved.pop()
        elif token == b"cm":
            a, b, c, d, e, f = numbers[-6:]
            matrix = np.array([[a, b, 0], [c, d, 0], [e, f, 1]]) @ matrix
        elif token == b"m":
            if corners:
                yield np.array(corners)
            corners = [on_paper(*numbers[-2:])]
        elif token == b"l":
            corners.append(on_paper(*numbers[-2:]))
        elif token == b"re":
            x, y, width, height = numbers[-4:]
            yield np.array([on_paper(x, y), on_paper(x + width, y + height)])
        elif token in (b"S", b"f", b"f*", b"B", b"B*", b"n") and corners:
            yield np.array(corners)
            corners = []
        numbers = []
