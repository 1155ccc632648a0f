"""The settings of geometry that chapters share, each with its reason."""

from dataclasses import dataclass

from ..settings import judged, physical


@dataclass(frozen=True)
class WallSizeSettings:
    """The sizes of walls."""

    thickest_m: float = physical(3.0, "Opposite faces farther apart are not those of one wall.")


@dataclass(frozen=True)
class CurveSettings:
    """How arcs are drawn."""

    chord_m: float = judged(0.002, "Chords lie no farther from their arc: less than the noise of a face.")


@dataclass(frozen=True)
class OutlineMeshSettings:
    """The triangles inside walls and around them."""

    spacing_m: float = judged(0.1, "Between samples of an outline: shorter than walls are thick.")
    margin_m: float = judged(1.0, "The space beyond the walls is so wide, or twice as wide as a door.")
    shortest_m: float = judged(
        0.001,
        "Shorter pieces are not halved: faces so near each other cross, and more pieces do not part them.",
    )
    rounds: int = judged(20, "Pieces of outlines are halved so often at most, until thin walls are tight.")


@dataclass(frozen=True)
class BridgeSettings:
    """The parts of a wall whose faces cross."""

    overlap_m: float = judged(0.002, "Bridges overlap both parts, so that rounding does not separate them.")
    farthest_m: float = judged(0.2, "Parts farther from each other are walls of their own.")
    shortest_m: float = judged(0.5, "Parts with a shorter outline are chips and are left out.")
