"""What the points show of a storey: its floor, its ceiling, and its upright surfaces.

The points become voxels with normals (`voxels`), which show floor, ceiling and upright surfaces (`levels`).
Upright surfaces become straight sheets (`sheets`) on common lines (`regular`). Where floor or ceiling was
seen is in `footprint`, and where a storey lies under a roof in `roof`. How much upright surface stands along
a line is in `uprights_along`.

Public names: `voxels.make_voxels`, `levels.find_storey`, `levels.find_uprights`, `sheets.find_sheets`,
`regular.square_up`, `regular.share_lines`, `footprint.find_footprint`, `roof.roofed`, `roof.near_roof`,
`uprights_along.UprightsAlong`.
"""
