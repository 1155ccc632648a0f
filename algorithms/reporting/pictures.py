"""Pictures for reports, embedded as PNG."""

import base64
import warnings

import numpy as np
from rasterio.errors import NotGeoreferencedWarning
from rasterio.io import MemoryFile

from .html import Markup, element


def embedded(rgb: np.ndarray) -> str:
    """Return a picture, uint8 of shape (rows, columns, 3), as an address that holds it."""
    rows, columns, bands = rgb.shape
    profile = {"driver": "PNG", "height": rows, "width": columns, "count": bands, "dtype": "uint8"}
    with MemoryFile() as memory, warnings.catch_warnings():
        warnings.simplefilter("ignore", NotGeoreferencedWarning)
        with memory.open(**profile) as picture:
            picture.write(np.moveaxis(rgb, 2, 0))
        content = memory.read()
    return f"data:image/png;base64,{base64.b64encode(content).decode('ascii')}"


def image(rgb: np.ndarray, x: float, y: float, width: float, height: float) -> Markup:
    """Return a picture as a part of a drawing; places and sizes in pixels of the drawing."""
    return element(
        "image",
        href=embedded(rgb),
        x=f"{x:.2f}",
        y=f"{y:.2f}",
        width=f"{width:.2f}",
        height=f"{height:.2f}",
        preserveAspectRatio="none",
        style="image-rendering:pixelated",
    )


def grey(values: np.ndarray, darkest: float) -> np.ndarray:
    """Return values from 0 to `darkest` as shades from white to black, shape (rows, columns, 3)."""
    shade = 255 - np.clip(255 * np.nan_to_num(values) / darkest, 0, 255)
    return np.repeat(shade.astype(np.uint8)[:, :, None], 3, axis=2)


def shrunk(values: np.ndarray, factor: int) -> np.ndarray:
    """Return the largest value of each block of `factor` by `factor` pixels."""
    rows, columns = (-(-size // factor) for size in values.shape)
    padded = np.zeros((rows * factor, columns * factor), values.dtype)
    padded[: values.shape[0], : values.shape[1]] = np.nan_to_num(values)
    return padded.reshape(rows, factor, columns, factor).max(axis=(1, 3))
