"""Pictures for reports, embedded as PNG."""

import base64
import io

import numpy as np
from PIL import Image


def embedded(rgb: np.ndarray) -> str:
    """Return a picture, uint8 of shape (rows, columns, 3), as an address that holds it."""
    file = io.BytesIO()
    Image.fromarray(rgb).save(file, "PNG", optimize=True)
    return f"data:image/png;base64,{base64.b64encode(file.getvalue()).decode('ascii')}"


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
