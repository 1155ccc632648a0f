"""What the algorithms for facades have in common, with the symbols of the paper in the help."""

from .parameter import Flag, Number

DISTANCE = Number(
    "DISTANCE",
    "Distance from a plane",
    "Points up to this far from a plane can belong to it (ds of the paper). What lies further behind the "
    "wall is an opening or a recess, what lies further before it a projection. Decrease it for shallow "
    "recesses, increase it for rough or bulging walls.",
    unit="m",
    default=0.05,
    minimum=0.001,
    maximum=10,
)

MIN_POINTS = Number(
    "MIN_POINTS",
    "Points of the smallest plane",
    "Planes with fewer points are left out. If not set, 1 % of the points of the main plane.",
    unit="points",
    minimum=3,
    whole=True,
)

MAX_PLANES = Number(
    "MAX_PLANES",
    "Largest number of planes",
    "The main plane counts as one; of the others those with most points are kept.",
    unit="planes",
    default=10,
    minimum=1,
    maximum=1000,
    whole=True,
)

SEED_RADIUS = Number(
    "SEED_RADIUS",
    "Radius of a seed surface",
    "A region of one colour begins with a surface of at most this radius (td of the paper); on small "
    "details it is smaller.",
    unit="m",
    default=0.2,
    minimum=0.005,
    maximum=10,
)

SEED_COLOUR = Number(
    "SEED_COLOUR",
    "Colour distance of a seed",
    "Largest distance of the colour of a seed from the mean of its surface (tr of the paper).",
    unit="0 to 255",
    default=30,
    minimum=0,
    maximum=442,
)

SEED_VARIANCE = Number(
    "SEED_VARIANCE",
    "Colour variance of a seed surface",
    "Largest sum of the variances of red, green and blue in a seed surface (Vr of the paper, 200). If not "
    "set, 200, or more where the noise of the colours asks for it.",
    unit="0 to 255, squared",
    minimum=0,
)

GROW_COLOUR = Number(
    "GROW_COLOUR",
    "Colour distance of a region",
    "A region grows over points whose colour is this near to its mean (tr2 of the paper). Decrease it to "
    "tell similar colours apart.",
    unit="0 to 255",
    default=60,
    minimum=0,
    maximum=442,
)

INTENSITY = Number(
    "INTENSITY",
    "Intensity difference of surfaces",
    "Regions whose mean intensities differ by less are one surface, so that shadows do not count (f of the "
    "paper), as a share of the intensity of the wall. If not set, twice the noise of the intensity.",
    unit="share",
    minimum=0,
    maximum=10,
)

TRIANGLE_FACTOR = Number(
    "TRIANGLE_FACTOR",
    "Large triangles",
    "Triangles between points of a region that are larger than this many times the mean are large (delta "
    "of the paper).",
    unit="mean areas",
    default=3,
    minimum=1,
    advanced=True,
)

TRIANGLE_COUNT = Number(
    "TRIANGLE_COUNT",
    "Large triangles of a point",
    "A point with more large triangles is noise (eta of the paper).",
    unit="triangles",
    default=5,
    minimum=0,
    whole=True,
    advanced=True,
)

NOISE_ITERATIONS = Number(
    "NOISE_ITERATIONS",
    "Rounds of noise removal",
    "Noise is removed in rounds until none is left, at most this often; 0 removes none.",
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
    "Radius of the disc that the outline of the wall is excavated with. Decrease it for finer gaps, increase "
    "it if the outline frays. If not set, it follows the spacing of the points.",
    unit="m",
    minimum=0.0001,
    decimals=4,
    advanced=True,
)

MIN_AREA = Number(
    "MIN_AREA",
    "Area of the smallest detail",
    "Smaller details are left out. If not set, the square of the radius of a seed surface.",
    unit="m2",
    minimum=0.0001,
    decimals=4,
    advanced=True,
)

REGULARISE = Flag(
    "REGULARISE",
    "Rectangles and arches",
    "Outlines become rectangles or arches, level and plumb, where the points allow; all others stay as "
    "they were seen. Off, all stay so.",
    default=True,
)

PIXEL_SIZE = Number(
    "PIXEL_SIZE",
    "Pixel size of the orthoimage",
    "If not set, 1, 2 or 5 times a power of ten, not less than the spacing of the points.",
    unit="m",
    minimum=0.0001,
    maximum=10,
    decimals=4,
    advanced=True,
)

FILL_HOLES = Flag(
    "FILL_HOLES",
    "Fill holes of the orthoimage",
    "Pixels without points take the colour of the nearest. Off, they are transparent.",
    default=False,
)

SETTINGS = {
    "distance_m": DISTANCE,
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
}
"""The parameters, by the settings of the core that they are."""
