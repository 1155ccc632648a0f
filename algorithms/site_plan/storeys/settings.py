"""The settings of the plan of a storey: what a person may doubt, each with its reason."""

from dataclasses import dataclass

from ...settings import judged, physical, statistical


@dataclass(frozen=True)
class VoxelSettings:
    """How points become voxels with normals, and how their spacing and noise are measured."""

    edge_m: float = physical(0.02, "A fifth of a thin partition.")
    apart_m: float = judged(10.0, "Parts of a cloud that lie farther apart may be reflections.")
    stray_share: float = judged(0.01, "Parts far from the rest that hold less of the cloud are reflections.")
    normal_radius_m: float = physical(0.05, "Wider than the profile of a skirting, narrower than a jamb.")
    normal_radius_spacings: float = physical(2.0, "About twelve neighbours lie within two spacings.")
    normal_radius_noises: float = judged(6.0, "A surface is then six times as wide as it is thick.")
    widest_normal_radius_m: float = physical(0.12, "Wider, the two faces of a thin partition become one.")
    refit_growth: float = judged(1.2, "The noise asks for a new fit only if the radius grows by a fifth.")
    fewest_neighbours: int = judged(5, "Three voxels always lie on a plane, so that five are a first check.")
    lonely_share: float = judged(0.05, "If more voxels lack neighbours, those twice as far are tried.")
    mixing_radius_m: float = physical(0.07, "A wider ball holds points of both faces of a thin partition.")
    fewest_agreeing: int = judged(7, "So many of twenty points around show a face that is partly hidden.")
    tried_points: int = physical(
        24, "Planes are tried through these, of which the point is one; a disc of three spacings holds 28."
    )
    tried_sine: float = judged(
        0.3,
        "Sine of the angle between two points, seen from a third; a plane through a thinner triangle tilts.",
    )
    agreeing_noises: float = statistical(3.0, "99.7 % of normally distributed points lie within.")
    agreeing_share: float = judged(0.2, "A surface is so thin for its width, whatever the noise seems to be.")
    least_noise_m: float = judged(0.004, "Walls are no planer over the half metre around a point.")
    flatness: float = judged(0.3, "Thickness over radius: a full ball has 0.45, a flat disc 0.")
    upright: float = judged(0.2, "The noise is that of surfaces that lean by less than 12 degrees.")
    neighbours: int = physical(6, "This neighbour is 1.4 spacings away in a square pattern on a surface.")
    sampled_points: int = judged(200_000, "So many voxels show the spacing; more take longer.")
    fewest_sampled_points: int = judged(20_000, "A smaller sample may lie in a corner of the cloud.")
    queried_points: int = judged(4000, "A median needs no more distances.")


@dataclass(frozen=True)
class LevelSettings:
    """How floor, ceiling and upright surfaces are read from voxels."""

    level_m: float = judged(
        0.10, "Finer levels have gaps between sparse points, coarser ones hide how much was seen."
    )
    layer_m: float = judged(
        0.05, "Two layers of this height hold a floor or ceiling that is not quite level."
    )
    pixel_m: float = physical(0.02, "As the voxels: a larger pixel would mix the faces of thin things.")
    upright: float = judged(
        0.30, "Vertical part of the normal: an upright surface leans by at most 17 degrees."
    )
    flat: float = judged(
        0.80, "Vertical part of the normal: floors and ceilings slope by at most 37 degrees."
    )
    lowest_storey_m: float = physical(1.9, "People cannot stand under a lower ceiling.")
    eye_m: tuple[float, float] = physical((1.0, 1.7), "Between sills and lintels, an opening is open.")
    storey_share: float = judged(0.25, "A floor or a ceiling holds this share of the largest flat layer.")
    largest_frame_px: int = physical(200_000_000, "A square of 280 m; more pixels exhaust the memory.")


@dataclass(frozen=True)
class SheetSettings:
    """How upright surfaces become straight sheets."""

    band_m: float = judged(0.012, "Half width of the band of a sheet on a face that is not quite plane.")
    band_noises: float = statistical(2.5, "99 % of normally distributed points lie within.")
    band_spacings: float = judged(0.2, "Sparse points do not show a face any better.")
    widest_band_m: float = physical(0.03, "Half of the thinnest partition, so that its faces stay apart.")
    gap_m: float = physical(0.25, "A socket, a pipe or a shadow in a face is narrower.")
    gap_spacings: float = judged(2.5, "Between sparse points there are wider gaps by chance.")
    turn_deg: float = judged(25.0, "Normals in corners are askew by so much.")
    begin_m: float = judged(0.3, "A line over so much each way shows the direction of a sheet.")
    begin_bands: float = judged(2.0, "A first line is askew, so that its band is twice as wide.")
    begin_turns_deg: tuple[float, ...] = judged(
        (-20.0, -12.0, -6.0, 0.0, 6.0, 12.0, 20.0), "A normal near a corner is askew by up to 20 degrees."
    )
    rounds: int = judged(8, "Most sheets stop growing after fewer fits.")
    robust_bands: float = judged(1.5, "Points beyond the band by half do not move the line.")
    struck_bands: float = judged(
        1.6, "Pixels so close to a sheet would begin a second sheet on the same face."
    )
    struck_turn: float = judged(
        0.8, "Pixels close to a sheet belong to it even if their normals are more askew."
    )
    fewest_pixels: int = judged(4, "Fewer pixels show no direction.")
    shortest_m: float = physical(0.10, "The reveal of a door in a thin partition.")
    fewest_levels: float = judged(3.0, "What fills fewer levels on average is a skirting or a cable.")
    shared_offset_m: float = judged(0.010, "Sheets this near to one line lie on one face.")
    shared_gap_m: float = judged(2.0, "Sheets farther apart, as beyond a wide window, may lie on two faces.")
    shared_turn_deg: float = judged(3.0, "Sheets whose directions differ by more are not on one line.")
    long_m: float = judged(0.8, "The direction of a sheet so long is sure.")
    square_within_m: float = judged(1.0, "A short sheet follows a long one only if this is near.")
    square_deg: float = judged(4.0, "A short sheet that is square up to this is meant to be square.")


@dataclass(frozen=True)
class FootprintSettings:
    """How sure it is that a pixel belongs to a room."""

    pixel_m: float = physical(0.04, "Half the thinnest partition.")
    ceiling_weight: float = judged(1.0, "A ceiling spans a room, and nothing hides it.")
    floor_weight: float = judged(0.8, "A floor, a sill or a low top may also lie in the depth of a wall.")
    soffit_weight: float = judged(0.3, "A beam, a lintel or a shelf says little about what is below.")
    top_m: float = physical(1.4, "Tables and cupboards that stand in a room are lower.")
    riser_m: float = physical(0.22, "Steps of stairs are lower.")
    tread_m: float = physical(0.32, "The next step of a stair lies within the depth of a tread.")
    drop_m: float = judged(0.3, "A surface farther below the highest around is a soffit.")
    around_m: float = physical(0.5, "Most walls are thinner, so that the ceiling beside a lintel is reached.")
    upright_levels: int = judged(5, "Pixels with so many levels are faces, of which no side is known.")
    neighbours: int = physical(6, "This neighbour is 1.4 spacings away in a square pattern on a surface.")
    closed_spacings: float = judged(1.5, "Points leave gaps of up to three spacings by chance.")
    closed_m: float = judged(0.16, "Wider gaps, as between sparse points, may be walls.")
    barrier_m: float = judged(0.5, "A wall may continue, hidden, beyond the end of its sheet.")
    touching_m: float = judged(0.08, "A point without a normal lies on the floor or the ceiling if so near.")


@dataclass(frozen=True)
class CutSettings:
    """How cells become room or solid."""

    extension_m: float = judged(0.5, "Lines of sheets reach corners that are hidden by furniture.")
    extension_lengths: float = judged(
        1.5, "The direction of a short sheet is too uncertain for a longer extension."
    )
    outline_m: float = judged(0.05, "The outline of floor and ceiling is ragged by a pixel or so.")
    outline_weight: float = judged(0.5, "A floor or a ceiling was seen; soffits do not outline a room.")
    smallest_outline_m2: float = judged(0.05, "Smaller spots of floor or ceiling divide nothing.")
    core_seen_share: float = judged(0.2, "A cell of which less of what is known was seen is a core.")
    core_known_share: float = judged(0.4, "The faces of a partition hide up to 60 % of its core.")
    beside_outline_m: float = judged(0.10, "A sheet so near to the outline is the better line.")
    beside_border: float = judged(3.0, "A border on the outline costs so many times more beside a sheet.")
    border_m: float = judged(0.06, "A border without a face costs, in m2 for a metre, half a partition.")
    seen_border: float = judged(0.05, "Share of the cost of a border that remains on a full face.")
    full_levels: float = judged(12.0, "A face with so many levels is full: furniture is lower.")
    full_share: float = judged(0.6, "In sparse points, a face with this share of the usual levels is full.")
    fewest_levels: float = judged(4.0, "A border with fewer levels of surface is the limit of the scan.")
    beside_m: float = physical(0.04, "Upright surface on the pixels beside a border belongs to it.")
    station_m: float = judged(0.05, "Distance along a border at which surface is looked up.")
    corner_m: float = judged(0.08, "In corners normals are askew, so that surface is seen from so far.")
    section_m: float = physical(1.1, "Plans are drawn as cut at this height over the floor.")
    cut_levels: float = judged(1.0, "A balustrade has no surface above the cut, a wall has.")
    body_levels: float = judged(1.0, "A beam has no surface below the heads of people, a wall has.")
    off_sheet_levels: float = judged(8.0, "Clutter has rough outlines that lie on no sheet, and is low.")
    shadow_share: float = judged(0.35, "What has tall faces on less of its rim is furniture or a shadow.")
    unexplained_m: float = judged(
        0.10, "A tall face with the same on both sides costs a partition's thickness."
    )
    closed_share: float = judged(0.8, "A wall is full up to the ceiling, and the leaf of a door ends below.")
    between_share: float = judged(0.6, "A cell within a partition has little else around it than its faces.")
    partition_m: float = physical(0.3, "Pieces of partitions between two doors are longer.")
    thinnest_m: float = physical(0.06, "Partitions of boards are 7 cm thick; a face found twice is thinner.")
    thickest_m: float = physical(0.3, "Floor and ceiling are not mistaken within thicker walls.")
    filled_core: float = judged(0.5, "Noise shows floor or ceiling on less of the core of a partition.")
    parting: float = judged(0.3, "A border so full above furniture parts furniture from a wall.")
    tall_m: float = physical(1.9, "Most furniture is lower, and columns and cores are higher.")
    tall_levels: float = judged(2.0, "A single level above furniture may be what lies on top of it.")


@dataclass(frozen=True)
class RoomSettings:
    """Where rooms end at openings, and what is a room."""

    widest_opening_m: float = judged(2.5, "Wider passages under a lintel join two parts of one room.")
    widest_window_m: float = judged(4.0, "Windows over a sill are seldom wider.")
    head_m: float = physical(1.9, "Lintels are above the heads of people.")
    lintel_levels: float = judged(1.5, "A lintel is at least so many levels high.")
    parapet_levels: float = judged(5.0, "A parapet is at least so many levels high.")
    open_share: float = judged(0.5, "An opening with surface on more of its levels at eye height is shut.")
    screen_reach_m: float = judged(0.2, "A screen is measured to 12 cm before a wall that it meets.")
    widest_leaf_m: float = physical(2.0, "Doors of two leaves are narrower.")
    before_edge_m: float = judged(0.4, "A roof that ends here covers the room so far before its edge.")
    beyond_edge_m: float = judged(1.0, "A thick wall and the ragged edge of what was seen lie within.")
    edge_share: float = judged(0.8, "In corners the roof goes on beside the line along which it ends.")
    walled_share: float = judged(0.5, "Outdoors, the scan ends without a wall on most sides.")
    roofed_share: float = judged(0.5, "A space of which more lies under a roof is a room.")
    surely_wide: float = judged(10.0, "A space so many times the smallest room is not measured further.")
    neck_m: float = judged(1.2, "Doors without a lintel are narrower.")
    narrowing: float = judged(0.8, "A door is narrower than the spaces on both its sides.")
    throat_m: float = judged(0.3, "The corners of a door lie within this of where a space is narrow.")
    shortest_chord_m: float = physical(0.05, "A wall is wider, so that nothing nearer is across a door.")
    smallest_m2: float = physical(0.8, "A toilet is larger; smaller parts are niches and openings.")
    narrowest_m: float = physical(0.7, "People cannot pass where it is narrower.")
    sill_m: float = physical(0.5, "A window sill is higher above the floor than a threshold.")
    sill_share: float = judged(0.6, "A sill fills most of its niche, and shelves do not.")
    sill_off_m: float = judged(0.06, "The heights of a sill scatter by less.")
    deepest_parapet_m: float = physical(0.6, "Few walls are thicker.")


@dataclass(frozen=True)
class FreeFaceSettings:
    """Which sheets are walls though they bound no room."""

    run_m: float = physical(0.3, "A pier between two windows is wider.")
    from_m: float = physical(0.3, "Skirtings and steps end below.")
    to_m: float = physical(2.3, "Lintels and eaves begin above.")
    filled: float = judged(0.5, "A wall fills half of the levels, and a railing or a fence does not.")
    apart_m: float = judged(0.12, "A face nearer to a border of a room is that border.")
    front_m: float = judged(0.3, "Before a face it is clear so far, and no wall.")
    thickest_m: float = physical(0.6, "The other face of the wall is nearer.")
    parallel_cosine: float = judged(
        0.98, "The two faces of a wall differ in direction by 11 degrees at most."
    )
    screen_m: float = physical(1.3, "A thin wall that stands free is longer than the leaf of a door.")
    head_m: float = physical(1.9, "A thin wall rises above the heads of people.")
    head_levels: float = judged(1.0, "A single level above heads shows that a thin wall rises so high.")
    furniture_m: float = physical(0.7, "Furniture and curtains before a wall are less deep.")
    shortest_overlap_m: float = judged(0.2, "A face that runs along a line for less is not behind it.")


@dataclass(frozen=True)
class WallSettings:
    """How borders of rooms become walls."""

    thickest_m: float = physical(0.6, "Two faces farther apart are two walls, or the outsides of a core.")
    strip_m: float = physical(0.025, "Half of the thinnest partition: the back of such a wall is not known.")
    crack_m: float = judged(0.002, "Cracks up to twice as wide come from faces that do not quite meet.")
    shortest_m: float = physical(0.005, "Nobody draws a shorter edge of a wall.")
    straight_m: float = physical(0.001, "A corner so little off the line of its neighbours says nothing.")
    parapet_edge_m: float = judged(0.005, "A face so near to the edge of a parapet is that edge.")
    smallest_m2: float = judged(0.002, "A strip of 10 cm is the shortest wall that one face shows.")
    longest_cut_m: float = physical(0.9, "A cut slantwise across a thick wall is shorter.")
    shortest_piece_m: float = physical(0.1, "A shorter piece is an end of a wall: partitions are as thick.")
    junction_sine: float = judged(
        0.25, "Walls that differ in direction by less than 15 degrees are one wall."
    )
    two_corners: float = judged(0.7, "A cut that ends in a second corner is better, as if it were shorter.")
    column_m2: float = physical(1.5, "A larger body that stands free is a wall or a core.")
    column_coverage: float = judged(0.5, "A column is seen from most of its sides.")
    column_slenderness: float = judged(3.0, "A body longer than that for its width is a wall.")
    column_fill: float = judged(0.5, "Walls that meet in a corner fill less of the rectangle around them.")
    opposite_deg: float = judged(5.0, "The two faces of a wall are parallel up to this.")


@dataclass(frozen=True)
class RoofSettings:
    """Where a storey lies under a roof."""

    cell_m: float = judged(0.2, "In cells so wide, a ceiling has few gaps between its points.")
    closed_m: float = physical(0.6, "Lamps, beams and the walls below a ceiling leave gaps up to this wide.")
    smallest_m2: float = judged(2.0, "Canopies, lintels and reflections are smaller than rooms.")
    around_m: float = judged(
        3.0, "Outer walls, reveals and facades of a storey stand within this of its ceiling."
    )


@dataclass(frozen=True)
class JoiningSettings:
    """How the plan of a storey meets that of the density image."""

    wall_reach_m: float = judged(1.0, "Walls farther from every room under a ceiling stand outside.")
    margin_m: float = physical(0.5, "Half a thick wall: the density image would draw its other half again.")
    shortest_rest_m: float = judged(0.5, "Shorter ends are what the margin left of walls of the storey.")
    column_m2: float = judged(1.0, "Larger things that stand free are furniture, or walls of the storey.")
    column_slenderness: float = judged(3.0, "What is longer for its width is the front of a cupboard.")
    column_coverage: float = judged(0.4, "Two of the four sides of a column are seen from one station.")
    column_levels: float = judged(12.0, "Furniture and railings fill fewer levels.")
    column_face_m: float = physical(0.05, "The outline of pixels lies so near to the faces of a column.")
    own_share: float = judged(0.5, "A closed space belongs to the side on which most of it lies.")
    roomy_share: float = judged(
        0.25,
        "Rooms fill most of what lies under a ceiling, and hardly any of what lies under crowns of trees.",
    )


@dataclass(frozen=True)
class DoubtSettings:
    """What is so much that the user should look at it."""

    much_left_out: float = judged(0.15, "Wardrobes, curtains and door leaves of a furnished flat are less.")
    many_limits: float = judged(0.33, "Doors, windows and passages alone are a quarter of an outline.")


@dataclass(frozen=True)
class StoreySettings:
    """The settings of the plan of a storey, by stage."""

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
    doubts: DoubtSettings = DoubtSettings()
    margin_m: float = judged(1.0, "Width of the rim around the points, which is outside for certain.")
    shortest_limit_m: float = judged(0.1, "Shorter limits are gaps in a face.")
