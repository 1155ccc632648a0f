"""Parameters of the algorithms for facades, with the symbols of the paper in the help."""

from .drawn_shapes import DrawnShapes
from .parameter import Choice, Flag, Number, Place

DISTANCE = Number(
    "DISTANCE",
    "Distance from a plane",
    "Largest distance of a point from its plane (ds of the paper). Points further behind the wall belong to "
    "an opening or a recess, points further in front of it to a projection. Decrease it for shallow "
    "recesses, increase it for rough or bulging walls.",
    unit="m",
    default=0.05,
    minimum=0.001,
    maximum=10,
)

FACADE = Number(
    "FACADE",
    "Number of the facade",
    "Which facade of a building or a street is measured. 0 takes the one that most points see from the "
    "stations, or that most points lie on if no position of a scanner is known. The report lists all with "
    "their numbers.",
    unit="0: the one most seen",
    default=0,
    minimum=0,
    maximum=10_000,
    whole=True,
)

FACADE_NEAR = Place(
    "FACADE_NEAR",
    "Point near the facade",
    "Measures the facade nearest to this point, in the coordinates of the cloud; FACADE is then ignored.",
)

FACADE_ALONG = DrawnShapes(
    "FACADE_ALONG",
    "Lines or walls along the facade",
    "Measures the facade along a line that is drawn near to it, or along a wall of a plan, for example of "
    "siteplan, in the coordinates of the cloud. Of several, selected features only if you choose so, the "
    "facade that the most runs along. A folder of every facade then has those along the lines: a polygon of "
    "a building chooses its facades among those of a street. FACADE and FACADE_NEAR choose among all.",
)

SIDE = Choice(
    "SIDE",
    "Side of the facade",
    "The side from which the facade is seen; seen from the other side, an elevation is mirrored. Automatic "
    "uses the position of the scanner where the files state it, otherwise what is seen through the openings. "
    "The log says which side was taken, why, and how certain that is. In a folder of every facade, it "
    "applies to the chosen one; the side of the others is found.",
    options=("Automatic", "Facing east (azimuth 0 to 180)", "Facing west (azimuth 180 to 360)"),
    optional=True,
)

MIN_POINTS = Number(
    "MIN_POINTS",
    "Points of the smallest plane",
    "Planes with fewer points are left out. If not set: 1 % of the points of the main plane, at least 100.",
    unit="count",
    minimum=3,
    whole=True,
)

MAX_PLANES = Number(
    "MAX_PLANES",
    "Largest number of planes",
    "Includes the main plane. Of the others, the largest are kept.",
    unit="count",
    default=10,
    minimum=1,
    maximum=1000,
    whole=True,
)

SEED_RADIUS = Number(
    "SEED_RADIUS",
    "Radius of a seed surface",
    "A region of one colour starts from a surface of this radius (td of the paper), or of half or a quarter "
    "of it on small details.",
    unit="m",
    default=0.2,
    minimum=0.005,
    maximum=10,
    advanced=True,
)

SEED_COLOUR = Number(
    "SEED_COLOUR",
    "Colour distance of a seed",
    "Largest distance of the colour of a seed from the mean of its surface (tr of the paper).",
    unit="0 to 255",
    default=30,
    minimum=0,
    maximum=442,
    advanced=True,
)

SEED_VARIANCE = Number(
    "SEED_VARIANCE",
    "Colour variance of a seed surface",
    "Largest sum of the variances of red, green and blue in a seed surface (Vr of the paper). If not set: "
    "200 as in the paper, or twice the measured colour noise, if larger.",
    unit="0 to 255, squared",
    minimum=0,
    advanced=True,
)

GROW_COLOUR = Number(
    "GROW_COLOUR",
    "Colour distance of a region",
    "Largest distance of the colour of a point from the mean of the region that it joins (tr2 of the paper). "
    "Decrease it to separate similar colours.",
    unit="0 to 255",
    default=60,
    minimum=0,
    maximum=442,
    advanced=True,
)

INTENSITY = Number(
    "INTENSITY",
    "Intensity difference of surfaces",
    "Regions whose mean intensities differ by less are one surface (f of the paper), so that shadows do not "
    "become details. A share of the intensity of the wall. If not set: twice the measured intensity noise.",
    unit="share",
    minimum=0,
    maximum=10,
    advanced=True,
)

TRIANGLE_FACTOR = Number(
    "TRIANGLE_FACTOR",
    "Large triangles",
    "A triangle between points of a plane is large if its area exceeds the mean by this factor (delta of the "
    "paper).",
    unit="mean areas",
    default=3,
    minimum=1,
    advanced=True,
)

TRIANGLE_COUNT = Number(
    "TRIANGLE_COUNT",
    "Large triangles of a point",
    "A point that belongs to more large triangles is noise (eta of the paper).",
    unit="triangles",
    default=5,
    minimum=0,
    whole=True,
    advanced=True,
)

NOISE_ITERATIONS = Number(
    "NOISE_ITERATIONS",
    "Rounds of noise removal",
    "Largest number of rounds; they end when no noise is left. 0 keeps all points.",
    unit="rounds",
    default=10,
    minimum=0,
    maximum=1000,
    whole=True,
    advanced=True,
)

ALPHA = Number(
    "ALPHA",
    "Alpha of the outline",
    "Alpha-shape radius. Smaller keeps finer gaps, larger closes frayed outlines. If not set, it follows the "
    "spacing of the points.",
    unit="m",
    minimum=0.0001,
    decimals=4,
    advanced=True,
)

MIN_AREA = Number(
    "MIN_AREA",
    "Area of the smallest detail",
    "Smaller details are left out. If not set: the square of SEED_RADIUS.",
    unit="m²",
    minimum=0.0001,
    decimals=4,
    advanced=True,
)

REGULARISE = Flag(
    "REGULARISE",
    "Rectangles and arches",
    "Outlines become level and plumb rectangles, arches or circles where the points agree with such a shape. "
    "All other outlines follow the points. If off, all outlines follow the points.",
    default=True,
)

UNROLL = Choice(
    "UNROLL",
    "Facades that turn",
    "A flat facade has one plane. Sides: the sides of a canted bay or a polygonal tower that meet at the "
    "facade are drawn beside each other, each in its own plane. Round: a round tower is rolled out, so that "
    "u runs along the arc of its outer face; the log states the radius. In a folder of every facade, those "
    "that do not turn are drawn flat.",
    options=("Flat", "Sides of a bay or a tower", "Round tower"),
    optional=True,
)

COLOURED = Choice(
    "COLOURED",
    "Coloured details",
    "Which regions of another colour become details. Those with a clear step: they are regular, and their "
    "colour changes sharply along the border, which the intensity confirms if there is one; stains, joints, "
    "shadows and lamplight are left out, and LEFT_OUT shows them. All regions: the chain of the paper, "
    "together with REGULARISE off. None: faster.",
    options=("Those with a clear step", "All regions", "None"),
    optional=True,
)

PIXEL_SIZE = Number(
    "PIXEL_SIZE",
    "Pixel size of the orthoimage",
    "If not set: the spacing of the points, rounded up to 1, 2 or 5 times a power of ten.",
    unit="m",
    minimum=0.0001,
    maximum=10,
    decimals=4,
    advanced=True,
)

FILL_HOLES = Flag(
    "FILL_HOLES",
    "Fill holes of the orthoimage",
    "Pixels without points take the colour of the nearest pixel with points. If off, they are transparent.",
    default=False,
)

SETTINGS = {
    "distance_m": DISTANCE,
    "side": SIDE,
    "seed_radius_m": SEED_RADIUS,
    "seed_colour": SEED_COLOUR,
    "seed_variance": SEED_VARIANCE,
    "grow_colour": GROW_COLOUR,
    "intensity": INTENSITY,
    "triangle_factor": TRIANGLE_FACTOR,
    "triangle_count": TRIANGLE_COUNT,
    "noise_iterations": NOISE_ITERATIONS,
    "alpha_m": ALPHA,
    "min_area_m2": MIN_AREA,
    "regularise": REGULARISE,
    "unroll": UNROLL,
    "coloured": COLOURED,
}
"""The parameters by the names of their settings in the core."""
