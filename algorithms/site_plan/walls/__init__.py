"""From the density image to regions of wall (Mueller et al. 2012, section 2.2).

Public names, by module
    extraction: extract_wall_pixels, WallParameters, WallImage. height_gate: make_gate, Heights.
    thresholds, regions, closing: the steps of the paper. pixel_outlines: trace_outlines.
    wall: describe_walls, Wall. settings: WallSettings.
"""
