"""What the plan of a storey is made with: lengths with a meaning, and factors of spacing and noise."""

from dataclasses import dataclass


@dataclass(frozen=True)
class VoxelSettings:
    """How points become voxels with normals."""

    edge_m: float = 0.02
    """A fifth of a thin partition."""
    apart_m: float = 10.0
    """Parts of a cloud farther apart than this ..."""
    stray_share: float = 0.01
    """... are stray if they hold less than this share of it."""
    normal_radius_m: float = 0.05
    """Wider than the profile of a skirting, narrower than a jamb."""
    normal_radius_spacings: float = 2.0
    """So far reach about twelve neighbours."""
    normal_radius_noises: float = 6.0
    """A surface is then six times as wide as it is thick."""
    widest_normal_radius_m: float = 0.12
    """Wider, the two faces of a thin partition become one."""
    lonely_share: float = 0.05
    """If more points than this have too few neighbours, these are looked for twice as far."""
    flatness: float = 0.3
    """Standard deviation across a surface over its radius; a ball has 0.45, a flat disc 0."""


@dataclass(frozen=True)
class LevelSettings:
    """How floor, ceiling and upright surfaces are read from voxels."""

    level_m: float = 0.10
    """Height of a level, of which the upright surfaces are counted."""
    pixel_m: float = 0.02
    """Pixels of the upright surfaces: as the voxels."""
    upright: float = 0.30
    """Largest vertical part of the normal of an upright surface: it leans by 17 degrees at most."""
    flat: float = 0.80
    """Smallest vertical part of the normal of floors and ceilings: a slope of 37 degrees at most."""
    lowest_storey_m: float = 1.9
    """A ceiling is at least so far above the floor."""
    storey_share: float = 0.25
    """A floor or a ceiling holds at least this share of what the largest flat layer holds."""


@dataclass(frozen=True)
class FootprintSettings:
    """How sure it is that a pixel belongs to a room."""

    pixel_m: float = 0.04
    """Half the thinnest partition."""
    ceiling_weight: float = 1.0
    """The ceiling was seen."""
    floor_weight: float = 0.8
    """The floor, a sill or the top of something below `top_m` was seen."""
    soffit_weight: float = 0.3
    """Only something lower than the ceiling around was seen from below: a beam, a lintel, a shelf."""
    top_m: float = 1.4
    """Things whose top is lower stand in a room."""
    drop_m: float = 0.3
    """A ceiling is no farther below the highest around."""
    around_m: float = 0.5
    """Where the highest ceiling is looked for: wider than most walls are thick."""
    upright_levels: int = 5
    """Pixels with so many levels of upright surface say nothing: they are the faces of partitions."""
    closed_spacings: float = 1.5
    """Gaps between points are closed by so many spacings on each side, but not across sheets ..."""
    closed_m: float = 0.16
    """... and not farther than this."""
    barrier_m: float = 0.5
    """Nor across the lines of sheets so far beyond their ends, where walls are hidden."""
    touching_m: float = 0.08
    """A point without a normal belongs to the floor or the ceiling if it is so near."""


@dataclass(frozen=True)
class SheetSettings:
    """How upright surfaces become straight sheets."""

    band_m: float = 0.012
    """Half width of the band that belongs to a sheet, on a perfect face ..."""
    band_noises: float = 2.5
    """... and so many standard deviations of the points more."""
    band_spacings: float = 0.2
    """Sparse points cannot show a face any better."""
    widest_band_m: float = 0.03
    """Half of the thinnest partition, so that its faces stay apart."""
    gap_m: float = 0.25
    """A sheet goes on over gaps up to this width: a socket, a pipe, a shadow."""
    gap_spacings: float = 2.5
    """Sparse points have wider gaps."""
    turn_deg: float = 25.0
    """Largest angle between the normals of a sheet and of its pixels."""
    shortest_m: float = 0.10
    """Shortest sheet: the reveal of a door in a thin partition."""
    fewest_levels: float = 3.0
    """Fewest levels that a sheet fills on average along its length."""
    shared_offset_m: float = 0.010
    """Sheets that lie so near to each other's line ..."""
    shared_gap_m: float = 2.0
    """... and so near to each other share one line."""
    shared_turn_deg: float = 3.0
    """Sheets on one line differ in direction by less."""
    long_m: float = 0.8
    """The direction of a sheet so long is sure."""
    square_within_m: float = 1.0
    """A shorter sheet is turned square to a long one so near ..."""
    square_deg: float = 4.0
    """... if it is square up to this already, or up to what its length leaves open."""


@dataclass(frozen=True)
class CutSettings:
    """How cells become room or solid."""

    extension_m: float = 0.5
    """Lines go on so far beyond their sheets, to corners that are hidden ..."""
    extension_lengths: float = 1.5
    """... but not by more than this times the sheet's length: the direction of a short one is uncertain."""
    outline_m: float = 0.05
    """The footprint's outline is straightened by at most this."""
    smallest_outline_m2: float = 0.05
    """Smaller spots of floor or ceiling divide nothing."""
    beside_outline_m: float = 0.10
    """Where a sheet lies so near to the outline, the sheet is the better line ..."""
    beside_border: float = 3.0
    """... and a border on the outline costs so many times more."""
    border_m: float = 0.06
    """What a border without a face costs, in m2 for a metre: half a partition."""
    seen_border: float = 0.05
    """Share of it that a border on a full face costs."""
    full_levels: float = 12.0
    """A face is full with so many levels ..."""
    full_share: float = 0.6
    """... or with this share of what is usual in sparse points."""
    fewest_levels: float = 4.0
    """A border with fewer levels of upright surface is not a wall but the limit of the scan."""
    beside_m: float = 0.04
    """Upright surface within this of a border belongs to it."""
    station_m: float = 0.05
    """Distance of the stations along a border at which the surface is looked up."""
    corner_m: float = 0.08
    """So far along a border from each station: in corners the normals are askew."""
    section_m: float = 1.1
    """Height over the floor that the plan is cut at."""
    cut_levels: float = 1.0
    """A wall has surface on so many levels above the cut: a balustrade has none."""
    body_levels: float = 1.0
    """The sheet of a wall has surface on so many levels below `tall_m`: a beam has none."""
    off_sheet_levels: float = 8.0
    """A border that lies on no sheet needs so many: clutter has rough outlines."""
    shadow_share: float = 0.35
    """An enclosed solid with tall faces on less of its rim is furniture, or a shadow of the scan."""
    tall_m: float = 1.9
    """A face of a column or a core has surface above this height over the floor; furniture has not."""
    tall_levels: float = 2.0
    """So many levels of it."""


@dataclass(frozen=True)
class RoomSettings:
    """Where rooms end at openings, and what is a room."""

    widest_opening_m: float = 2.5
    """Widest door or passage under a lintel."""
    widest_window_m: float = 4.0
    """Widest window over a sill."""
    head_m: float = 1.9
    """A lintel is above this height over the floor."""
    eye_m: tuple[float, float] = (1.0, 1.7)
    """Between these heights over the floor an opening is open, and its sill is below."""
    lintel_levels: float = 1.5
    """Fewest levels of surface above an opening ..."""
    parapet_levels: float = 5.0
    """... or below it, if there is also one above."""
    open_share: float = 0.5
    """Largest share of the levels at eye height that hold surface in an opening; with more it is shut ..."""
    widest_leaf_m: float = 2.0
    """... and then no wider than this."""
    neck_m: float = 1.2
    """A narrow place up to this width is a door without a lintel ..."""
    narrowing: float = 0.8
    """... if it is narrower than this share of the spaces on both sides."""
    smallest_m2: float = 0.8
    """Smallest room; smaller parts are niches and openings."""
    narrowest_m: float = 0.7
    """Narrowest room."""
    sill_m: float = 0.5
    """A niche whose floor is higher is a window: below it stands a parapet ..."""
    sill_share: float = 0.6
    """The sill lies over at least this share of the niche; shelves do not ..."""
    sill_off_m: float = 0.06
    """... up to this."""
    deepest_parapet_m: float = 0.6
    """... unless it is deeper than walls are thick."""


@dataclass(frozen=True)
class WallSettings:
    """How borders of rooms become walls."""

    thickest_m: float = 0.6
    """Two faces farther apart are two walls, or the outsides of a core."""
    strip_m: float = 0.02
    """Width of a wall that one face was seen of: its back is not known, and should not seem to be."""
    shortest_m: float = 0.005
    """Outlines have no shorter edges."""
    straight_m: float = 0.001
    """Corners that are no farther off the line of their neighbours are dropped."""
    smallest_m2: float = 0.01
    """Smaller scraps are not walls."""
    longest_cut_m: float = 0.9
    """Longest cut between two walls: across a thick wall, slantwise."""
    column_m2: float = 1.5
    """A free-standing body is a column up to this area."""
    opposite_deg: float = 5.0
    """Two faces of one wall are parallel up to this."""


@dataclass(frozen=True)
class FreeFaceSettings:
    """Which sheets are walls though they bound no room."""

    run_m: float = 0.3
    """Shortest face."""
    from_m: float = 0.3
    """Levels between this and ..."""
    to_m: float = 2.3
    """... this above the floor count: between skirtings and lintels."""
    filled: float = 0.5
    """Share of these levels that hold surface."""
    apart_m: float = 0.12
    """A face nearer to a border of a room is that border."""
    front_m: float = 0.3
    """So far before a face it is clear."""
    thickest_m: float = 0.6
    """The other face of the wall is not farther."""
    screen_m: float = 1.3
    """Shortest thin wall that stands free in a room: longer than the leaf of a door."""
    head_m: float = 1.9
    """It rises above the heads of people, ..."""
    head_levels: float = 1.0
    """... by so many levels, ..."""
    furniture_m: float = 0.7
    """... and stands farther from walls than furniture is deep."""


@dataclass(frozen=True)
class RoofSettings:
    """Where a storey lies under a roof."""

    cell_m: float = 0.2
    """Cells in which a ceiling was seen or not."""
    closed_m: float = 0.6
    """Gaps in the ceiling that are closed: lamps, beams, and walls on which it rests."""
    smallest_m2: float = 2.0
    """Smaller patches are not rooms: canopies, lintels, reflections."""


@dataclass(frozen=True)
class JoiningSettings:
    """How the plan of a storey meets that of the density image."""

    wall_reach_m: float = 1.0
    """Walls farther from every room under a ceiling stand outside."""
    margin_m: float = 0.5
    """So far around rooms and walls of a storey the density image decides nothing: half a thick wall."""
    shortest_rest_m: float = 0.5
    """Shorter ends of walls of the density image are what the margin left of walls of the storey."""
    own_share: float = 0.5
    """A closed space with more of its area in the region of a storey is a room of the storey."""


@dataclass(frozen=True)
class StoreySettings:
    """All that the plan of a storey is made with."""

    voxels: VoxelSettings = VoxelSettings()
    levels: LevelSettings = LevelSettings()
    sheets: SheetSettings = SheetSettings()
    footprint: FootprintSettings = FootprintSettings()
    cut: CutSettings = CutSettings()
    rooms: RoomSettings = RoomSettings()
    free_faces: FreeFaceSettings = FreeFaceSettings()
    walls: WallSettings = WallSettings()
    roof: RoofSettings = RoofSettings()
    joining: JoiningSettings = JoiningSettings()
    margin_m: float = 1.0
    """Width of the rim around the points."""
    shortest_limit_m: float = 0.1
    """Shorter limits are gaps in a face."""
