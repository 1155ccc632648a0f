"""Settings of the files of a facade."""

from dataclasses import dataclass

from ...settings import judged, physical


@dataclass(frozen=True)
class OrthoimageSettings:
    """The orthoimage."""

    most_pixels: int = physical(
        100_000_000, "A facade of 100 m by 100 m at a centimetre; it takes about 3 GB of memory."
    )
    layer_m: float = judged(
        0.05,
        "A pixel shows the mean of its points up to so far behind the foremost; the rest is hidden.",
    )
    darkest_percent: float = judged(
        1.0, "This percentile of the intensity becomes black; single dark points would brighten the rest."
    )
    brightest_percent: float = judged(
        99.0, "This percentile of the intensity becomes white; single reflectors would darken the rest."
    )


@dataclass(frozen=True)
class DrawingSettings:
    """The drawing: lines, arcs, levels and dimensions."""

    exact_m: float = physical(
        0.001, "Arcs and lines are as far from the outline at most: a tape reads no less."
    )
    fewest_edges: int = judged(4, "Fewer edges than these on a circle are corners cut off, not an arc.")
    patience: int = judged(16, "If so many more vertices make no arc, none begins there.")
    sagitta_m: float = judged(0.005, "Edges that leave the circle by more are lines.")
    uneven: float = judged(4.0, "The edges of an arc differ in length by less.")
    most_vertices: int = judged(16, "An outline with more vertices was not regular, and is simplified.")
    ragged_spacings: float = judged(
        2.0, "The points at a broken edge scatter by this, in point spacings; its corners are no more exact."
    )
    text_m: float = physical(0.1, "Height of texts: 2 mm at 1:50.")
    room_m: float = physical(0.35, "A narrower detail has no room for its dimensions.")
    beside_m: float = physical(
        0.4, "Distance of the outer dimensions and the levels from the wall: 8 mm at 1:50."
    )
    apart_m: float = judged(
        0.15, "Levels nearer to each other are one mark, so that their texts can be read."
    )
    decimals: int = judged(3, "Of the dimensions: millimetres, which are their standard deviations.")
