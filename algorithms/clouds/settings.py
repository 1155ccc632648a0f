"""The constants of clouds, each with its reason; see `algorithms.settings`."""

from dataclasses import dataclass

from ..settings import judged, physical, statistical


@dataclass(frozen=True)
class TextSettings:
    """How much of a text cloud is looked into before it is read, and how its columns are recognised."""

    sample_bytes: int = judged(
        65_536, "A thousand lines or more show what the columns are; more delay the opening."
    )
    runs: int = judged(
        64, "Spread over the file to find the ranges of colour and intensity, because its start may be dark."
    )
    numeric_share: float = judged(
        0.5, "A column holds numbers if most of its fields are, since single values may be missing."
    )
    unit_length: float = physical(
        0.01, "Normals of two decimals differ by less from the length of 1; other triples of numbers by more."
    )
    fewest_for_agreement: int = statistical(100, "Correlations of fewer values scatter by more than a tenth.")
    clearer_agreement: float = judged(
        0.1, "Correlations of colours exceed those with intensity by more, or the order stays in doubt."
    )


@dataclass(frozen=True)
class PrecisionSettings:
    """Which steps of coordinates are said."""

    coarsest_step_m: float = physical(
        1e-3, "Scanners measure to a millimetre or two; coarser steps move the faces of walls."
    )
    single_share: float = statistical(
        0.999, "Nearly all points of a file in single precision have its steps, of others a quarter."
    )
    fewest_points: int = statistical(
        10, "The chance that as many points of full precision lie near steps is below one in a million."
    )


@dataclass(frozen=True)
class PoseSettings:
    """Which poses of scans are possible."""

    farthest_m: float = physical(1e8, "Farther than any two points of the earth, by a factor of five.")
    smallest_volume: float = physical(
        1e-12, "The cube of 0.1 mm in a metre; no unit of length of scanners is smaller, and none 10 km."
    )
    orthogonal: float = judged(
        2e-3, "Rotations of three decimals differ by less from orthogonal ones; damage and units by more."
    )


@dataclass(frozen=True)
class ReadingSettings:
    """How much of a file is looked into before it is read, and how much of it is in memory at a time."""

    sample_points: int = judged(
        10_000,
        "Enough to show the ranges of colour and intensity and the middle of the site; more delay opening.",
    )
    runs: int = judged(
        8, "Spread over the file, because its first points alone may all be dark or lie in one corner."
    )
    run_points: int = judged(
        1000, "A run costs one seek and the decoding of a compressed chunk, whatever its length."
    )
    whole_points: int = judged(
        100_000, "Read in a tenth of a second, so that a small file is examined as a whole."
    )
    text: TextSettings = TextSettings()
    chunk_points: int = judged(
        1_000_000, "Smaller chunks spend time between them, larger ones take memory and gain nothing."
    )


@dataclass(frozen=True)
class TileSettings:
    """Which points are stray."""

    max_height_m: float = physical(
        20_000.0, "No site is so high or deep: such points are stray, or the coordinates geocentric."
    )
    max_distance_m: float = physical(
        1e9, "Farther than any point of one site; the integers of the lattice end not much later."
    )
    max_stray_share: float = judged(
        0.01, "More are no stray measurements: the coordinates of the whole cloud are of another kind."
    )


@dataclass(frozen=True)
class ThinningSettings:
    """How thinning divides its work."""

    tile_edge_m: float = judged(
        4.0, "Small enough for a tile to stay in the processor's cache; which points are kept depends on it."
    )
    waiting_tiles: int = judged(
        2, "For each processor: fewer leave processors idle, more hold points in memory without gain."
    )


@dataclass(frozen=True)
class WritingSettings:
    """How finely coordinates are stored, and how many points are written at a time."""

    coarsest_step_m: float = judged(1e-4, "A tenth of a millimetre is finer than any scanner measures.")
    finest_step_m: float = physical(
        1e-5,
        "At this step the 32 bits of LAS span 43 km; finer ones could not hold a site with distant points.",
    )
    least_rounding_m: float = physical(1e-3, "Scanners measure to a millimetre or two.")
    text_decimals: int = judged(5, "Ten micrometres: coordinates of LAS files of a finest step survive.")
    normal_decimals: int = judged(6, "A direction to a millionth, finer than normals are estimated.")
    chunk_points: int = judged(
        1_000_000, "Smaller chunks spend time between them, larger ones take memory and gain nothing."
    )
    text_lines: int = judged(
        100_000, "As lists of fields, lines take about ten times the memory that their numbers do."
    )


@dataclass(frozen=True)
class CloudSettings:
    """The constants of all stages."""

    reading: ReadingSettings = ReadingSettings()
    tiles: TileSettings = TileSettings()
    thinning: ThinningSettings = ThinningSettings()
    writing: WritingSettings = WritingSettings()
