"""From the density image to regions of wall (Mueller et al. 2012, section 2.2).

The steps of the paper are in `thresholds`, `regions` and `closing`.

Public names: `extraction.extract_wall_pixels`, `extraction.WallParameters`, `extraction.WallImage`,
`height_gate.make_gate`, `height_gate.Heights`, `pixel_outlines.trace_outlines`, `wall.describe_walls`,
`wall.Wall`, `settings.WallSettings`.
"""
