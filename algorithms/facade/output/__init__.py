"""The files of a facade: layers, orthoimage, schedule and drawing.

Public names: `elevation_layers.write_elevation`, `elevation_layers.write_details`,
`plane_layers.write_planes`, `orthoimage.write_orthoimage`, `orthoimage.automatic_pixel_size`,
`schedule.write_schedule`, `drawing.write_drawing`.
"""
