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
    rows_of_run: int = judged(100, "Of each run, to see which columns are colour; more take time.")
    numeric_share: float = judged(
        0.5, "A column holds numbers if most of its fields are, since single values may be missing."
    )
    unit_length: float = physical(
        0.01, "Normals of two decimals differ by less from the length of 1; other triples of numbers by more."
    )
    fewest_for_agreement: int = statistical(100, "Correlations of fewer values scatter by more than a tenth.")
    clearer_agreement: float = judged(
        0.1, "Correlations of colours exceed those with intensity by more, or the order remains in doubt."
    )
    most_classes: int = physical(
        32, "Classes of LAS without extension, and more than the scans or returns of most clouds."
    )


@dataclass(frozen=True)
class PrecisionSettings:
    """Which steps of coordinates are said."""

    coarsest_step_m: float = physical(
        1e-3, "Scanners measure to a millimetre or two; coarser steps move the faces of walls."
    )
    coarsest_scale_m: float = physical(
        5e-3, "Half of it is the noise of scanners; the usual 1 mm of LAS files is finer."
    )
    single_share: float = statistical(
        0.999, "Nearly all points of a file in single precision have its steps, of others a quarter."
    )
    odd_share: float = statistical(
        0.05, "Half of the numbers of single precision are odd multiples of its step; among 10, one at least."
    )
    fewest_points: int = statistical(
        10, "The chance that as many points of full precision lie near steps is below one in a million."
    )
    fewest_rounded: int = judged(100, "Fewer points are an example rather than a scan.")
    fewest_steps: int = statistical(
        10, "Different values of rounded coordinates; fewer are slices, which are cut at round numbers."
    )
    largest_local_m: float = judged(
        10_000.0, "Local coordinates are smaller; few different ones of larger systems were rounded."
    )
    least_lost_share: float = judged(
        1e-3, "Fewer points at the origin are strays, of which any scan has some."
    )
    fewest_whole: int = statistical(
        3, "Nine coordinates; all are whole by chance once in 10^27, at millimetres."
    )
    widest_whole_m: float = physical(
        100.0, "Whole metres within less are models or examples; 100 mm are smaller than any site."
    )
    highest_m: float = physical(1000.0, "No building is higher; millimetres of a room of 2.5 m are 2500.")


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
        16, "Spread over the file, because its first points alone may all be dark or lie in one corner."
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
class UprightSettings:
    """How a cloud that does not stand upright is found out."""

    largest_tilt_deg: float = judged(
        1.0, "Leans a wall of 3 m by 5 cm, half a pixel; levelled scanners are better by a hundred times."
    )
    most_files: int = judged(4, "Files of one site stand alike.")
    chunk_points: int = judged(1_000_000, "The beginning of a scan reaches from floor to ceiling.")
    most_points: int = judged(300_000, "Show a building's directions; more delay the run by seconds.")
    edges_m: tuple[float, ...] = judged(
        (0.2, 0.4, 0.8), "Cubes are smaller than walls are long, and hold enough points of sparser clouds."
    )
    fewest_points: int = statistical(10, "A plane through fewer points leans by their noise.")
    thickest: float = judged(
        0.2, "A face is thinner than this part of its width, with the roughness of masonry."
    )
    widest: float = judged(0.1, "Points along a line have no normal; those of a face spread over its cube.")
    fewest_faces: int = statistical(300, "Directions of fewer faces are not significant.")
    enough_faces: int = judged(3000, "Larger cubes would be used for sparser clouds only.")
    most_normals: int = judged(1500, "Show the vertical to a tenth of a degree; more cost time.")
    search_deg: tuple[tuple[float, float], ...] = judged(
        ((20.0, 1.0), (1.0, 0.25), (0.25, 0.05)),
        "Reach and step of the search: beyond 20 degrees floors are ramps or roofs, or another axis is up.",
    )
    width_deg: float = judged(1.2, "How far normals of floors and walls scatter in cubes of rough masonry.")
    clearer: float = judged(
        1.25,
        "Real scans that stand upright agree up to 1.1 times better with another vertical than with z, scans "
        "tilted by 2 degrees at least 1.3 times.",
    )
    fewest_floors: float = judged(0.05, "Part of the faces; without a ground nothing hangs from it.")
    fewest_walls: float = judged(0.04, "Part of the faces; without walls a slope is a slope.")
    facing_deg: float = judged(15.0, "Faces that lean less are level, or plumb.")
    lowest_m: float = physical(2.2, "Rooms are higher; corridors are often narrower.")
    flat: float = judged(0.75, "Of a storey, the height is clearly smaller than length and width.")
    more_floor: float = judged(1.3, "Floors and ceilings cover more than the walls of one direction.")
    much_more_floor: float = judged(2.0, "So much more that a house as high as wide shows it.")
    end: float = judged(0.3, "Part of the height at either end in which floor and ceiling lie.")
    least_end: float = judged(0.15, "A facade seen from one side has nothing at the other end.")
    hanging: float = judged(0.9, "Part of the level faces in the upper half if the ground is above.")
    below: float = judged(0.6, "Part of the plumb faces in the lower half if walls hang from the ground.")


@dataclass(frozen=True)
class StraySettings:
    """Which points are far from the site."""

    part_gap_m: float = judged(20.0, "Parts of a site lie nearer to each other; reflections lie farther off.")
    stray_share: float = judged(1e-3, "A part with a smaller share of the points is left out.")
    sparse_share: float = judged(0.02, "A part with a larger share of the points is kept however thin it is.")
    sparse_cover: float = judged(
        0.1, "Reflections are thin: fewer points per tile than this share of the main part's."
    )


@dataclass(frozen=True)
class TileSettings:
    """Which points cannot be sorted into tiles, and how many are kept in memory."""

    max_height_m: float = physical(
        20_000.0, "No site is so high or deep: such points are stray, or the coordinates geocentric."
    )
    max_distance_m: float = physical(
        1e9, "Farther than any point of one site; the integers of the lattice end not much later."
    )
    memory_bytes: int = judged(
        2**28, "At 12 bytes a point 22 million, more than most scans of a building; the rest is on disk."
    )
    max_stray_share: float = judged(
        0.01, "Strays are fewer; with more, the coordinates of the whole cloud are of another kind."
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
class ClusterSettings:
    """How work is divided among the workers of a cluster, and how long is waited for them."""

    run_points: int = judged(
        10_000_000, "Read by one task, 120 MB on its worker: seconds that a lost worker costs, and few tasks."
    )
    block_tiles: int = judged(
        16,
        "Columns and rows of tiles that one task works on. Smaller blocks thin more tiles around them twice, "
        "larger ones take more memory: 64 m of a dense street hold 1 GB. If odd, still more are.",
    )
    waiting_tasks: int = judged(
        2, "For each thread of the workers: fewer leave workers idle, more hold results without gain."
    )
    connect_s: float = judged(5.0, "A scheduler in the same network answers at once; a cancel has to wait.")
    poll_s: float = judged(0.1, "A cancel is noticed after so many seconds at most.")
    patience_s: float = judged(
        60.0, "A cluster without any worker for longer has stopped; workers are started again within less."
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
    cluster: ClusterSettings = ClusterSettings()
    writing: WritingSettings = WritingSettings()
