"""Regions of one colour and one intensity in the plane of a wall.

Regions grow from seeds (`seeds`, `region_growing`) over points of similar appearance (`appearance`). Those
of one intensity are fused (`intensity_scale`, `intensity_fusion`), and what differs from the wall is a
detail (`coloured_details`). Its border divides mixed laser spots (`mixed_points`), and a clear step of colour
there shows that it was made (`steps`).

Public names: `coloured_details.find_coloured`, `mixed_points.divide_at_half`,
`steps.reason_against_colour`, `intensity_scale.make_relative`, `appearance.Appearance`,
`settings.ColourSettings`.
"""
