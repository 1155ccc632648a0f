"""The outlines of details, and of the wall.

The points of a plane become a surface with an outline (`surface`, `alpha_shape`, `denoising`). Its holes are
openings, recesses or shadows (`holes`). The border of a detail is the mean of its two sides (`border`,
`jambs`, `details`) and becomes a rectangle or an arch where it has that shape (`regular_outlines`). The wall
is completed behind what hides it (`wall_extent`).

Public names: `surface.make_surface`, `holes.find_gaps`, `holes.classify`, `border.trace_border`,
`regular_outlines.make_outline`, `wall_extent.complete`, `alpha_shape.alpha_shape`,
`settings.OutlineSettings`, and the generators of `details`.
"""
