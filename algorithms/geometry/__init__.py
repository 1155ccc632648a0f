"""Lines, arcs, circles, polygons and triangulations in the plane."""
