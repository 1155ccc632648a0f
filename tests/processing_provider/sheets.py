"""A building of known size, and how far it is off on paper."""

import fiona
import numpy as np
from ichnograph.tests.processing_provider.pdf import paths_of
from rasterio.crs import CRS
from shapely.geometry import box, mapping

WIDTH, HEIGHT = 7.3, 4.1
"""Of the building, in metres."""

CORNER = (412_300.25, 5_812_300.75)


def write_building(path):
    """Write the walls of the building as a layer, in UTM; return the path as text."""
    outer = box(*CORNER, CORNER[0] + WIDTH, CORNER[1] + HEIGHT)
    schema = {"geometry": "Polygon", "properties": {"kind": "str"}}
    with fiona.open(path, "w", "GPKG", schema, crs_wkt=CRS.from_epsg(25833).to_wkt()) as layer:
        outline = outer.difference(outer.buffer(-0.365, join_style=2))
        layer.write({"geometry": mapping(outline), "properties": {"kind": "straight"}})
    return str(path)


def errors_of_outline(pdf, scale):
    """Return how much too wide and too high is what is drawn about as large as the building, in mm."""
    expected = 1000 * np.array([WIDTH, HEIGHT]) / scale
    sizes = [np.ptp(path, axis=0) for path in paths_of(pdf) if len(path) >= 4]
    return min((size - expected for size in sizes), key=lambda error: np.abs(error).max())


def error_of_scale_bar(pdf, segment):
    """Return how much too wide is what is drawn about as a segment of the scale bar, in mm."""
    sizes = [np.ptp(path, axis=0) for path in paths_of(pdf)]
    return min((width - segment for width, height in sizes if height < 3), key=abs)
