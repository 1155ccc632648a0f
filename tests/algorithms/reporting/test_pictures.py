"""Pictures within a page."""

import base64
import io

import numpy as np
from ichnograph.algorithms.reporting.pictures import embedded, grey, shrunk
from PIL import Image


def test_a_picture_comes_back_from_its_address():
    rgb = np.random.default_rng(0).integers(0, 256, (7, 5, 3), dtype=np.uint8)
    kind, content = embedded(rgb).split(",")

    assert kind == "data:image/png;base64"
    np.testing.assert_array_equal(np.asarray(Image.open(io.BytesIO(base64.b64decode(content)))), rgb)


def test_grey_goes_from_white_to_black_and_nothing_is_white():
    shades = grey(np.array([[0.0, 1.0, 2.0, 5.0, np.nan]]), 2.0)

    assert shades.shape == (1, 5, 3)
    assert shades[0, :, 0].tolist() == [255, 127, 0, 0, 255]


def test_shrinking_keeps_the_largest_of_each_block():
    values = np.array([[1, 2, 3], [4, 0, 9], [5, 6, 7]], dtype=np.uint8)

    np.testing.assert_array_equal(shrunk(values, 2), [[4, 9], [6, 7]])
    np.testing.assert_array_equal(shrunk(values, 1), values)
