"""Settings of the search for openings."""

from dataclasses import dataclass

from ...settings import judged, physical, statistical


@dataclass(frozen=True)
class SurfaceSettings:
    """The surface of a wall, which leans and bulges."""

    cell_m: float = judged(0.25, "Squares whose median depths the surface is fitted to, so that area counts.")
    fewest_points: int = judged(5, "Squares with fewer points have no reliable median.")
    fewest_cells: int = judged(30, "A surface has 6 coefficients; with fewer squares it is a plane.")
    rounds: int = judged(20, "Rounds of the robust fit; its weights change little after them.")
    sigmas: float = statistical(3.0, "Points within three standard deviations of the surface are wall.")
    least_m: float = physical(0.015, "Plaster, joints and the noise of scanners scatter by at least this.")


@dataclass(frozen=True)
class LayerSettings:
    """Parallel parts of a facade in front of its main wall and behind it."""

    smallest_m2: float = judged(1.5, "Smaller surfaces are leaves of doors, panes, blocks and signs.")
    cube_m: float = judged(0.1, "Side of the cubes whose normals show which points face as the wall does.")
    cosine: float = physical(0.94, "Normals of single cubes are not sharp: up to 20 degrees off the wall's.")
    steepest: float = physical(0.12, "Parts that are more oblique, 7 degrees, are not parallel to the wall.")
    reach_cubes: float = judged(2.2, "Cubes are neighbours up to this distance, in sides of a cube.")
    step: float = judged(0.35, "Neighbours differ in depth by at most this part of the side of a cube.")
    before_m: float = physical(1.6, "Bays and balconies project up to this; what is farther is the street.")
    bay_m: float = physical(
        0.4, "Bays project more, and have windows; pilasters and friezes frame the wall itself."
    )
    behind_m: float = physical(3.0, "Storeys are set back up to this; what is farther is another building.")
    covered: float = judged(
        0.3, "Over a part of the facade less of the main wall is seen; over a car or a room more."
    )
    piece: float = judged(
        0.02, "A part of the main wall that is smaller than this share of it encloses nothing."
    )
    enclosed: float = judged(
        0.5,
        "With the main wall on both sides of this part, and above or below, it was seen in an opening.",
    )


@dataclass(frozen=True)
class StateSettings:
    """What is seen in each pixel of an elevation."""

    pixel_spacings: float = judged(
        1.5, "Side of a pixel in the usual spacing; smaller ones have gaps, larger ones blur the edges."
    )
    fullest: float = judged(
        0.08, "Squares with a smaller part of the median number of points are at the border of the wall."
    )
    highest_percent: float = judged(99.5, "Above the main wall, single points do not make a facade higher.")
    square_m: float = judged(0.25, "Squares in which points are counted, to know how far apart they are.")
    full: float = judged(
        0.7, "Squares with a smaller part of the points of one beside them are not all wall."
    )
    finest_m: float = physical(0.004, "No opening is so small that smaller pixels are needed.")
    most_pixels: int = physical(4_000_000, "More pixels need more memory and time than they are worth.")
    farthest_m: float = physical(
        3.0, "What is farther behind is seen at a slant and does not project into the opening it is seen in."
    )
    jamb_m: float = physical(0.5, "Jambs reach this far behind the wall, and less where its inner face is.")
    sill_m: float = physical(0.3, "Sills project by less.")
    sill_height_m: float = physical(0.25, "Sills are lower; shutters, pipes and surrounds are higher.")
    sill_gap_m: float = judged(
        0.15, "Between the points of one sill there are narrower gaps, between two shutters wider ones."
    )
    bar_m: float = physical(0.05, "The bars of a railing are thinner, sills are not.")
    before_m: float = physical(4.0, "What is farther in front is the street; nearer things hide the wall.")
    ground_m: tuple[float, float] = physical(
        (0.3, 1.0), "The ground at the foot of a wall is farther before it than sills, and nearer than kerbs."
    )


@dataclass(frozen=True)
class RegionSettings:
    """Regions of the elevation that may be openings."""

    speck_pixels: int = judged(2, "Narrower strips of the state `behind` are noise, and edges of the wall.")
    jambs: float = judged(
        0.1, "Something close behind the wall is seen along this part of the rim of an opening."
    )
    rim_pixels: int = judged(2, "The rim of a region is uncertain by a pixel, and so are its jambs.")
    hidden: float = judged(0.3, "It is hidden by something in front if this part of its rim is in front.")
    pier: float = judged(
        0.02, "A smaller share of the wall that stands alone in a hole is a frame, and no pier."
    )
    shown: float = judged(0.05, "A column of pixels with a smaller part behind the wall shows nothing.")
    shadow: float = judged(
        0.6, "What shows nothing is a shadow if it is lower than this part of what is beside it."
    )
    post_m: float = physical(0.3, "Posts between the lights of one window are narrower.")
    alike: float = judged(0.8, "Lights of one window share this part of their heights.")
    filled: float = judged(0.65, "A region that fills less of its box may be two openings, joined at a neck.")
    clear_neck: float = judged(0.3, "A neck narrower than this part divides a region however full it is.")
    neck: float = judged(0.5, "A neck is narrower than this part of what it joins.")
    narrowest_m: float = physical(0.15, "Openings are not narrower; gaps between boards and slats are.")
    most_front: float = judged(0.5, "An opening is not hidden by more than this part.")


@dataclass(frozen=True)
class FloorSettings:
    """Floors between the openings of two storeys."""

    reach_m: float = physical(
        0.2, "Floors reach this far before a wall and behind it; rails and transoms less."
    )
    steps: int = judged(2, "Divisions of this reach, each of which must have points; a rail has one.")
    thickness_m: float = physical(0.4, "A floor, with the threshold on it, is no thicker.")
    covered: float = judged(0.6, "A floor is seen over this part of the width.")
    lowest_m: float = physical(0.5, "The openings above and below a floor are not lower.")


@dataclass(frozen=True)
class ContentSettings:
    """What is seen in an opening."""

    filled: float = judged(0.5, "A recess has a surface behind at least this part of it; an opening has not.")
    near_m: float = physical(1.0, "Panes, doors and the backs of niches are not deeper in the wall.")
    lowest_door_m: float = physical(1.6, "Doors and passages are not lower.")
    step_m: float = physical(0.2, "Thresholds and steps below a door are not higher.")
    threshold_m: float = physical(
        0.05, "Thresholds alone are not higher; where no ground was seen, so little wall is below a door."
    )
    beside_m: float = judged(0.05, "The wall beside an opening, where a rounded edge has ended.")
    bend: float = judged(
        0.5, "A wall that bends is beside the opening as deep as this part of what is in it."
    )


@dataclass(frozen=True)
class NicheSettings:
    """Openings with nothing but wall in them."""

    even_m: float = physical(0.02, "The back of a niche is as even as the wall, and no less than plaster.")
    behind: float = judged(0.05, "Through glass and slats, more of the points are behind the surface.")
    covered: float = judged(
        0.75, "The surface fills this part of the opening; above the street, the sill hides the rest."
    )
    around_m: float = judged(0.3, "The wall up to this far around is compared with it.")
    sigmas: float = statistical(2.0, "Its intensity is that of the wall within the scatter of its points.")
    alike: float = judged(0.2, "Or within this part of it; panes, paint and wood differ by more.")
    colour: float = judged(20.0, "Without intensity, its mean colour differs by less, of 0 to 255.")


@dataclass(frozen=True)
class OpeningSettings:
    """From points to openings."""

    surface: SurfaceSettings = SurfaceSettings()
    layers: LayerSettings = LayerSettings()
    states: StateSettings = StateSettings()
    regions: RegionSettings = RegionSettings()
    floors: FloorSettings = FloorSettings()
    content: ContentSettings = ContentSettings()
    niches: NicheSettings = NicheSettings()
