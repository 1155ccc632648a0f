"""The outlines of details, and of the wall.

The points of a plane become a surface with an outline (`surface`, `alpha_shape`, `denoising`). The border of
a detail is the mean of its two sides; that of an opening is where the wall ends, or its jambs (`border`,
`jambs`, `details`). Its edges are fitted one by one (`edges`), then its head (`heads`), and together they are
a regular outline where the border allows (`regular_outlines`). Holes with too few straight sides are left out
(`acceptance`). The wall is completed behind what hides it
(`wall_extent`).

Public names: `surface.make_surface`, `jambs.divide_behind`, `edges.fit_edge`, `heads.fit_head`,
`border.trace_border`, `regular_outlines.make_outline`, `wall_extent.complete`, `alpha_shape.alpha_shape`,
`settings.OutlineSettings`, and the generators of `details`.
"""
